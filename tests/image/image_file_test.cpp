// Images written to files of each format, read by our readers and by others'.
#include "renderer/image/image_file.h"

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <random>

#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMatrixAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfVecAttribute.h>
#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>
#include <turbojpeg.h>

#include "tests/support/temporary_folder.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_TGA
#define STBI_ONLY_HDR
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace {

/// Frees the memory of stb_image.
struct FreeStb {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

using grf::Colour;
using image::Image;
using image::ImageFile;

constexpr float FloatInfinity = std::numeric_limits<float>::infinity();
constexpr float QuietNaN = std::numeric_limits<float>::quiet_NaN();

/// Odd sizes, so that rows do not align with anything else.
Image gradient() {
  Image image{23, 11, {}};
  for (int y = 0; y < 11; ++y) {
    for (int x = 0; x < 23; ++x) {
      image.pixels.emplace_back(static_cast<float>(x) / 22, static_cast<float>(y) / 10, 0.25F);
    }
  }
  return image;
}

/// Random radiance of any magnitude.
Image random_radiance() {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> exponent(-60, 60);
  Image image{40, 25, {}};
  for (int i = 0; i < 1000; ++i) {
    const float scale = std::exp2(exponent(random));
    const auto component = [&] { return scale * std::generate_canonical<float, 24>(random); };
    const float red = component();
    const float green = component();
    image.pixels.emplace_back(red, green, component());
  }
  return image;
}

class ImageFiles : public testing::Test {
 protected:
  /// Writes the file and returns its path.
  std::string write(const ImageFile& file, const std::string& name) {
    EXPECT_TRUE(image::write_image(file, folder_.path(name), diagnostics_)) << diagnostics_.to_text();
    return folder_.path(name);
  }
  Image read(const std::string& path) {
    const auto image = image::read_image(path, diagnostics_);
    EXPECT_TRUE(image) << diagnostics_.to_text();
    return image.value_or(Image());
  }

  test::TemporaryFolder folder_;
  grf::Diagnostics diagnostics_;
};

TEST_F(ImageFiles, LinearFloatsKeepEveryBit) {
  Image image = random_radiance();
  image.pixels[3] = Colour(-1, 0, 1e-40F);
  for (const char* name : {"a.exr", "a.pfm", "a.raw", "A.RAW"}) {
    const Image again = read(write({image}, name));
    EXPECT_EQ(again.width, 40) << name;
    EXPECT_EQ(again.pixels, image.pixels) << name;
  }
}

TEST_F(ImageFiles, RawIsSizeAndFloatsAndNothingElse) {
  const std::string bytes = test::bytes_of(write({{2, 1, {Colour(1, 2, 0), Colour(0, 0, -1)}}}, "a.raw"));
  EXPECT_EQ(bytes, std::string("\2\0\0\0\1\0\0\0"
                               "\0\0\x80\x3f\0\0\0\x40\0\0\0\0"
                               "\0\0\0\0\0\0\0\0\0\0\x80\xbf",
                               32));
}

TEST_F(ImageFiles, RadianceIsRoundedToTheNearest) {
  const Image image = random_radiance();
  const std::string path = write({image}, "a.hdr");
  const Image again = read(path);
  double bias = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Colour& pixel = image.pixels[i];
    const float largest = std::max({pixel.x, pixel.y, pixel.z});
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(std::abs(again.pixels[i][k] - pixel[k]), largest / 255);
      bias += (again.pixels[i][k] - pixel[k]) / largest / 3000;
    }
  }
  // Steps are at most largest / 128, errors uniform over one: 3000 of them have at most this deviation.
  EXPECT_LT(std::abs(bias), 4 * 1.0 / 128 / std::sqrt(12.0 * 3000));
  int width = 0;
  int height = 0;
  int channels = 0;
  const std::unique_ptr<float[], FreeStb> others(stbi_loadf(path.c_str(), &width, &height, &channels, 3));
  ASSERT_NE(others, nullptr) << stbi_failure_reason();
  EXPECT_EQ(width, 40);
  for (std::size_t i = 0; i < 3000; ++i) {
    EXPECT_EQ(others[i], again.pixels[i / 3][static_cast<int>(i % 3)]);
  }
}

TEST_F(ImageFiles, RadianceTakesWhatItCannotHold) {
  const Image image{
      4, 1, {Colour(QuietNaN, -1, 1), Colour(FloatInfinity, 1, 0), Colour(3e38F), Colour(1e-38F)}};
  const Image again = read(write({image}, "a.hdr"));
  EXPECT_EQ(again.pixels[0], Colour(0, 0, 1));
  EXPECT_GT(again.pixels[1].x, 1e38F);
  EXPECT_GT(again.pixels[2].y, 1e38F);
  EXPECT_EQ(again.pixels[3], Colour(0));
  // 255.6 of 256 steps: one more than a byte holds.
  EXPECT_NEAR(read(write({{1, 1, {Colour(0.9985F)}}}, "b.hdr")).pixels[0].x, 1, 1e-6);
}

TEST_F(ImageFiles, EightBitsAreWithinTheirSteps) {
  const Image image = gradient();
  for (const auto& [name, tolerance] : {std::pair("a.png", 0.005F), {"a.tga", 0.005F}, {"a.jpg", 0.06F}}) {
    const Image again = read(write({image}, name));
    ASSERT_EQ(again.pixels.size(), image.pixels.size()) << name;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(again.pixels[i][k], image.pixels[i][k], tolerance) << name << " " << i;
      }
    }
  }
  EXPECT_GT(test::bytes_of(write({image}, "a.jpeg")).size(), 100U);
}

const Image SampleImage{3, 1, {Colour(0, 1, 2), Colour(0.5F, 0.001F, 0.2F), Colour(-1, 0.25F, 0.75F)}};
const std::vector<int> SampleBytes = {0, 255, 255, 188, 3, 124, 0, 137, 225};

TEST_F(ImageFiles, PngIsEncodedInSrgb) {
  const std::string path = write({SampleImage}, "a.png");
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&png, path.c_str()), 0);
  png.format = PNG_FORMAT_RGB;
  std::vector<unsigned char> bytes(9);
  ASSERT_NE(png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr), 0);
  EXPECT_EQ(std::vector<int>(bytes.begin(), bytes.end()), SampleBytes);
}

TEST_F(ImageFiles, TgaIsEncodedInSrgb) {
  const std::string path = write({SampleImage}, "a.tga");
  int width = 0;
  int height = 0;
  int channels = 0;
  const std::unique_ptr<stbi_uc[], FreeStb> bytes(stbi_load(path.c_str(), &width, &height, &channels, 0));
  ASSERT_NE(bytes, nullptr) << stbi_failure_reason();
  EXPECT_EQ(width, 3);
  EXPECT_EQ(channels, 3);
  EXPECT_EQ(std::vector<int>(bytes.get(), bytes.get() + 9), SampleBytes);
}

TEST_F(ImageFiles, TgaOfTwoRowsHasThemFromTheTop) {
  const Image image{1, 2, {Colour(1), Colour(0)}};
  const Image again = read(write({image}, "a.tga"));
  EXPECT_GT(again.pixels[0].x, again.pixels[1].x);
}

// Sizes are two bytes each, little-endian (Truevision 1991, fields 5.3 and 5.4).
TEST_F(ImageFiles, TgaHoldsSizesOver255) {
  const std::string bytes =
      test::bytes_of(write({{300, 515, std::vector<Colour>(300 * 515, Colour(1))}}, "a.tga"));
  EXPECT_EQ(bytes.substr(12, 4), std::string("\x2c\x01\x03\x02", 4));
  EXPECT_EQ(bytes.size(), 18U + 3 * 300 * 515);
}

TEST_F(ImageFiles, JpegKeepsColourAtFullResolution) {
  Image image{16, 16, {}};
  for (int i = 0; i < 256; ++i) image.pixels.push_back(i % 2 == 0 ? Colour(1, 0, 0) : Colour(0, 0, 1));
  const std::string file = test::bytes_of(write({image}, "a.jpg"));
  void* decoder = tjInitDecompress();
  int width = 0;
  int height = 0;
  int subsampling = 0;
  int colours = 0;
  const auto* data = reinterpret_cast<const unsigned char*>(file.data());
  EXPECT_EQ(tjDecompressHeader3(decoder, data, file.size(), &width, &height, &subsampling, &colours), 0);
  EXPECT_EQ(width, 16);
  EXPECT_EQ(subsampling, TJSAMP_444);
  tjDestroy(decoder);
}

TEST_F(ImageFiles, ExposureBrightensWhatScreensShowAlone) {
  const Image image{1, 1, {Colour(0.05F, 0.1F, 0.25F)}};
  for (const char* name : {"a.png", "a.tga", "a.jpg"}) {
    ImageFile file{image};
    file.exposure = 2;
    const Colour brighter = read(write(file, name)).pixels[0];
    EXPECT_NEAR(brighter.x, 0.2F, 0.01F) << name;
    EXPECT_NEAR(brighter.y, 0.4F, 0.01F) << name;
    EXPECT_NEAR(brighter.z, 1, 0.01F) << name;
    file.exposure = -1;
    EXPECT_NEAR(read(write(file, name)).pixels[0].y, 0.05F, 0.005F) << name;
  }
  ImageFile file{image};
  file.exposure = 2;
  for (const char* name : {"a.exr", "a.pfm", "a.raw"}) {
    EXPECT_EQ(read(write(file, name)).pixels, image.pixels) << name;
  }
}

TEST_F(ImageFiles, WhatIsNoNumberIsBlackOnScreens) {
  const Image image{3, 1, {Colour(QuietNaN), Colour(FloatInfinity), Colour(-FloatInfinity)}};
  for (const char* name : {"a.png", "a.tga"}) {
    EXPECT_EQ(read(write({image}, name)).pixels, (std::vector<Colour>{Colour(0), Colour(1), Colour(0)}))
        << name;
  }
}

TEST_F(ImageFiles, ExrHoldsLayersAndAttributes) {
  ImageFile file{gradient()};
  const std::size_t count = file.image.pixels.size();
  file.layers.push_back(image::layer_of("normal", "XYZ", file.image));
  file.layers.push_back({"depth", "Z", std::vector<float>(count, FloatInfinity)});
  file.layers.push_back({"samples", "", std::vector<float>(count, 7)});
  file.attributes = {{"BPT_Depth", "5"}, {"renderSeconds", 1.5F}, {"eye", grf::Vec3f(1, 2, 3)}};
  file.attributes.push_back({"worldToCamera", Imath::M44f(2)});
  file.screen_width = 0.75F;
  const std::string path = write(file, "a.exr");
  EXPECT_EQ(read(path).pixels, file.image.pixels) << "the image is not hidden by its layers";
  Imf::InputFile input(path.c_str());
  const Imf::Header& header = input.header();
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("BPT_Depth").value(), "5");
  EXPECT_EQ(header.typedAttribute<Imf::FloatAttribute>("renderSeconds").value(), 1.5F);
  EXPECT_EQ(header.typedAttribute<Imf::V3fAttribute>("eye").value(), Imath::V3f(1, 2, 3));
  EXPECT_EQ(header.typedAttribute<Imf::M44fAttribute>("worldToCamera").value(), Imath::M44f(2));
  EXPECT_EQ(header.screenWindowWidth(), 0.75F);
  std::vector<std::string> channels;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
    channels.emplace_back(it.name());
  EXPECT_EQ(channels, (std::vector<std::string>{"B", "G", "R", "depth.Z", "normal.X", "normal.Y", "normal.Z",
                                                "samples"}));
  std::vector<float> values(2 * count);
  Imf::FrameBuffer buffer;
  const auto add = [&](const char* name, std::size_t first) {
    char* at = reinterpret_cast<char*>(values.data() + first);
    buffer.insert(name, Imf::Slice(Imf::FLOAT, at, sizeof(float), 23 * sizeof(float)));
  };
  add("normal.Y", 0);
  add("samples", count);
  input.setFrameBuffer(buffer);
  input.readPixels(0, 10);
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(values[i], file.image.pixels[i].y);
    ASSERT_EQ(values[count + i], 7);
  }
}

TEST_F(ImageFiles, RefusesATypeThatItDoesNotKnow) {
  EXPECT_FALSE(image::write_image({gradient()}, folder_.path("image.bmp"), diagnostics_));
  EXPECT_NE(diagnostics_.to_text().find("exr, hdr, pfm, raw, png, jpg, tga"), std::string::npos)
      << diagnostics_.to_text();
}

TEST_F(ImageFiles, SaysWhatNoLibraryTakes) {
  const Image wide{70000, 1, std::vector<Colour>(70000)};
  EXPECT_FALSE(image::write_image({wide}, folder_.path("a.jpg"), diagnostics_));
  EXPECT_NE(diagnostics_.to_text().find("a.jpg: error: cannot encode the image: turbojpeg: "),
            std::string::npos)
      << diagnostics_.to_text();
  EXPECT_TRUE(folder_.names().empty());
}

class LostFolders : public ImageFiles {
 protected:
  bool keep(const std::vector<std::string>& fallbacks, const std::string& path) {
    return image::keep_image({gradient()}, path, fallbacks, diagnostics_);
  }
  std::string last_message() const { return diagnostics_.entries().back().message; }

  std::string gone_ = folder_.path("gone/image.pfm");
};

TEST_F(LostFolders, LeaveTheImageInAnother) {
  EXPECT_FALSE(keep({folder_.path()}, gone_));
  ASSERT_EQ(diagnostics_.entries().size(), 2U);
  const std::string start = "the image was saved as '" + folder_.path("granada-");
  EXPECT_TRUE(last_message().starts_with(start)) << last_message();
  const std::size_t quote = last_message().find('\'');
  const std::string kept = last_message().substr(quote + 1, last_message().rfind('\'') - quote - 1);
  EXPECT_TRUE(kept.ends_with("/image.pfm")) << kept;
  EXPECT_EQ(read(kept).pixels, gradient().pixels);
}

TEST_F(LostFolders, TakeTheFirstThatIsThere) {
  const std::string home = folder_.path("home");
  std::filesystem::create_directory(home);
  EXPECT_FALSE(keep({folder_.path("none"), home, folder_.path()}, gone_));
  EXPECT_NE(last_message().find(home + "/granada-"), std::string::npos) << last_message();
}

TEST_F(LostFolders, LeaveNothingButAnErrorIfAllAreLost) {
  EXPECT_FALSE(keep({folder_.path("none"), folder_.path("neither")}, gone_));
  EXPECT_EQ(diagnostics_.error_count(), 2U);
  EXPECT_TRUE(last_message().starts_with("the image could not be saved in ")) << last_message();
  EXPECT_TRUE(folder_.names().empty());
}

/// Limits the size of files during its lifetime, as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    before_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, before_handler_);
  }

 private:
  rlimit before_ = {};
  void (*before_handler_)(int) = nullptr;
};

TEST_F(LostFolders, LeaveAnOlderImageWhole) {
  const std::string path = folder_.add("image.pfm", "the older one");
  {
    const FileSizeLimit limit(1000);
    EXPECT_FALSE(keep({folder_.path()}, path));
  }
  EXPECT_NE(diagnostics_.to_text().find(path + ": error: cannot write the file: File too large"),
            std::string::npos)
      << diagnostics_.to_text();
  EXPECT_EQ(test::bytes_of(path), "the older one");
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"image.pfm"})) << "nothing half-written is left";
  EXPECT_FALSE(keep({}, gone_));
  EXPECT_TRUE(keep({}, path)) << "once there is room";
  EXPECT_EQ(read(path).pixels, gradient().pixels);
}

}  // namespace
