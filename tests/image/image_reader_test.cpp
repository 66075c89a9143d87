// Images of each format, valid and damaged.
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>
#include <png.h>
#include <turbojpeg.h>
#include <webp/encode.h>

#include "renderer/image/image_file.h"
#include "tests/support/temporary_folder.h"

namespace {

using grf::Colour;
using image::Image;

template <class... Bytes>
std::string bytes(Bytes... values) {
  return {static_cast<char>(values)...};
}

Image gradient(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.pixels.emplace_back(float(x) / float(width), float(y) / float(height), 0.25F);
    }
  }
  return image;
}

std::string pfm_of(const Image& image) {
  std::string file = "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x) {
      const Colour& pixel = image.at(x, y);
      file.append(reinterpret_cast<const char*>(&pixel.x), sizeof(Colour));
    }
  }
  return file;
}

std::string big_endian_grey_pfm() {
  return "Pf 2 1 1.0\n" + bytes(0x3f, 0x80, 0, 0) + bytes(0x40, 0, 0, 0);  // 1 and 2
}

std::string radiance_header(int width, int height) {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
         std::to_string(width) + "\n";
}

/// Rows of 4 bytes per pixel, without run lengths: (0.5, 1, 2) everywhere.
std::string radiance_file(int width, int height) {
  std::string file = radiance_header(width, height);
  for (int i = 0; i < width * height; ++i) file += bytes(32, 64, 128, 130);
  return file;
}

/// Run-length encoded, as most files are.
std::string radiance_rle_file(int width, int height) {
  std::string file = radiance_header(width, height);
  for (int y = 0; y < height; ++y) {
    file += bytes(2, 2, width >> 8, width & 255);
    for (const int value : {32, 64, 128, 130}) file += bytes(128 + width, value);
  }
  return file;
}

/// Uncompressed, rows from the top, BGR.
std::string tga_file(int width, int height) {
  std::string file =
      bytes(0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, width & 255, width >> 8, height & 255, height >> 8, 24, 0x20);
  for (int i = 0; i < width * height; ++i) file += bytes(0, 128, 255);
  return file;
}

std::string tga_rle_file(int width, int height) {
  std::string file = bytes(0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, width & 255, width >> 8, height & 255,
                           height >> 8, 24, 0x20);
  for (int y = 0; y < height; ++y) file += bytes(127 + width, 0, 128, 255);
  return file;
}

std::string jpeg_file(int width, int height) {
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < width * height; ++i) pixels.insert(pixels.end(), {255, 128, 0});
  void* encoder = tjInitCompress();
  unsigned char* data = nullptr;
  unsigned long size = 0;
  tjCompress2(encoder, pixels.data(), width, 0, height, TJPF_RGB, &data, &size, TJSAMP_444, 100, 0);
  std::string file(reinterpret_cast<const char*>(data), size);
  tjFree(data);
  tjDestroy(encoder);
  return file;
}

std::string deep_png_file(std::uint16_t value) {
  const std::vector<std::uint16_t> pixels(3 * 6 * 4, value);
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = 6;
  png.height = 4;
  png.format = PNG_FORMAT_LINEAR_RGB;
  std::string file(10000, '\0');
  png_alloc_size_t size = file.size();
  png_image_write_to_memory(&png, file.data(), &size, 0, pixels.data(), 0, nullptr);
  file.resize(size);
  return file;
}

/// Encodes pixels of red, green, blue and opacity.
std::string webp_file(const std::vector<std::uint8_t>& pixels, int width, int height, bool is_lossless) {
  std::uint8_t* data = nullptr;
  const std::size_t size = is_lossless
                               ? WebPEncodeLosslessRGBA(pixels.data(), width, height, 4 * width, &data)
                               : WebPEncodeRGBA(pixels.data(), width, height, 4 * width, 95, &data);
  std::string file(reinterpret_cast<const char*>(data), size);
  WebPFree(data);
  return file;
}

std::string orange_webp_file(bool is_lossless, int opacity = 255) {
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < 20 * 30; ++i) {
    pixels.insert(pixels.end(), {255, 128, 0, static_cast<std::uint8_t>(opacity)});
  }
  return webp_file(pixels, 20, 30, is_lossless);
}

class ImageReader : public testing::Test {
 protected:
  std::optional<Image> read(const std::string& name, const std::string& file) {
    diagnostics_ = {};
    return image::read_image(folder_.add(name, file), diagnostics_);
  }

  std::string encoded(const Image& image, const std::string& name) {
    EXPECT_TRUE(image::write_image({image}, folder_.path(name), diagnostics_));
    return test::bytes_of(folder_.path(name));
  }

  void expect_everywhere(const std::optional<Image>& image, const Colour& expected, float tolerance = 0) {
    ASSERT_TRUE(image) << diagnostics_.to_text();
    for (const Colour& pixel : image->pixels) {
      for (int k = 0; k < 3; ++k) ASSERT_NEAR(pixel[k], expected[k], tolerance);
    }
  }

  void expect_error(const std::string& name, const std::string& file, const std::string& why) {
    EXPECT_FALSE(read(name, file)) << name;
    EXPECT_EQ(diagnostics_.error_count(), 1U) << name;
    EXPECT_NE(diagnostics_.to_text().find(folder_.path(name) + ": error: cannot read the image: " + why),
              std::string::npos)
        << diagnostics_.to_text();
  }

  test::TemporaryFolder folder_;
  grf::Diagnostics diagnostics_;
};

const Colour Orange(1, 0.2158605F, 0);  // 255, 128, 0

// A code up to 128 is followed by that many bytes; a greater one by a single byte, for as many pixels less
// 128.
TEST_F(ImageReader, TakesRunsOfRadianceOfAnyLength) {
  std::string file = radiance_header(130, 1) + bytes(2, 2, 0, 130);
  file += bytes(128);
  for (int x = 0; x < 128; ++x) file += bytes(x);
  file += bytes(129, 200) + bytes(1, 100);
  file += bytes(255, 64, 131, 128) + bytes(255, 0, 131, 32) + bytes(255, 130, 131, 130);
  const auto image = read("runs.hdr", file);
  ASSERT_TRUE(image) << diagnostics_.to_text();
  // The exponent 130 makes 64 of a byte 1.
  for (int x = 0; x < 128; ++x) EXPECT_EQ(image->at(x, 0).x, static_cast<float>(x) / 64) << x;
  EXPECT_EQ(image->at(128, 0), Colour(200.0F / 64, 2, 0.5F));
  EXPECT_EQ(image->at(129, 0), Colour(100.0F / 64, 2, 0.5F));
  EXPECT_EQ(image->at(126, 0), Colour(126.0F / 64, 1, 0));
  EXPECT_EQ(image->at(127, 0), Colour(127.0F / 64, 2, 0.5F));
}

TEST_F(ImageReader, ReadsWhatTheWriterWrites) {
  const Image image = gradient(13, 7);
  EXPECT_EQ(read("a.exr", encoded(image, "image.exr"))->pixels, image.pixels);
  const auto png = read("a.png", encoded(image, "image.png"));
  ASSERT_TRUE(png);
  ASSERT_EQ(png->width, 13);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    EXPECT_NEAR((png->pixels[i] - image.pixels[i]).length(), 0, 0.01);
  }
}

TEST_F(ImageReader, ReadsPortableFloatMaps) {
  const Image image = gradient(5, 3);
  EXPECT_EQ(read("a.pfm", pfm_of(image))->pixels, image.pixels);
  EXPECT_EQ(read("b.pfm", big_endian_grey_pfm())->pixels, (std::vector<Colour>{Colour(1), Colour(2)}));
}

TEST_F(ImageReader, ReadsRadianceTgaJpegAndDeepPng) {
  const Colour radiance(0.5F, 1, 2);
  expect_everywhere(read("a.hdr", radiance_file(4, 3)), radiance);
  expect_everywhere(read("b.hdr", radiance_rle_file(20, 3)), radiance);
  expect_everywhere(read("c.tga", tga_file(4, 3)), Orange, 1e-6F);
  expect_everywhere(read("d.tga", tga_rle_file(20, 3)), Orange, 1e-6F);
  expect_everywhere(read("e.jpg", jpeg_file(20, 30)), Orange, 0.01F);
  expect_everywhere(read("f.png", deep_png_file(6554)), Colour(0.100008F), 1e-4F);
}

TEST_F(ImageReader, ReadsWebP) {
  expect_everywhere(read("a.webp", orange_webp_file(true)), Orange, 1e-6F);
  expect_everywhere(read("b.webp", orange_webp_file(false)), Orange, 0.02F);
  expect_everywhere(read("c.webp", orange_webp_file(true, 51)), Orange * 0.2F, 1e-6F);
  const auto rows = read("d.webp", webp_file({255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255}, 1, 3, true));
  ASSERT_TRUE(rows) << diagnostics_.to_text();
  EXPECT_EQ(rows->pixels, (std::vector<Colour>{Colour(1, 0, 0), Colour(0, 1, 0), Colour(0, 0, 1)}));
}

TEST_F(ImageReader, KeepsAlphaIfAsked) {
  const std::vector<std::uint8_t> bytes = {255, 128, 0, 51, 255, 128, 0, 255};
  std::vector<std::uint16_t> deep = {13107, 6554, 0, 13107, 65535, 32896, 0, 65535};  // times alpha
  const auto png = [](png_uint_32 format, const void* pixels) {
    png_image header = {};
    header.version = PNG_IMAGE_VERSION;
    header.width = 2;
    header.height = 1;
    header.format = format;
    std::string file(10000, '\0');
    png_alloc_size_t size = file.size();
    png_image_write_to_memory(&header, file.data(), &size, 0, pixels, 0, nullptr);
    file.resize(size);
    return file;
  };
  // Bottom up, blue first, with 8 bits of alpha.
  const std::string tga = std::string("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\x20\x08", 18) +
                          std::string("\0\x80\xff\x33\0\x80\xff\xff", 8);
  const std::map<std::string, std::string> files = {{"a.png", png(PNG_FORMAT_RGBA, bytes.data())},
                                                    {"b.png", png(PNG_FORMAT_LINEAR_RGB_ALPHA, deep.data())},
                                                    {"c.webp", webp_file(bytes, 2, 1, true)},
                                                    {"d.tga", tga}};
  for (const auto& [name, file] : files) {
    const std::string path = folder_.add(name, file);
    const auto image = image::read_image(path, diagnostics_, {}, image::Alpha::Kept);
    ASSERT_TRUE(image) << diagnostics_.to_text();
    ASSERT_EQ(image->alpha.size(), 2U) << name;
    EXPECT_NEAR(image->alpha[0], 0.2F, 1e-6F) << name;
    EXPECT_EQ(image->alpha[1], 1) << name;
    EXPECT_NEAR(image->pixels[0].x, 0.2F, 1e-4F) << name << ": colours are multiplied by alpha";
    EXPECT_NEAR(image->pixels[1].x, 1, 1e-4F) << name;
    EXPECT_TRUE(image::read_image(path, diagnostics_)->alpha.empty()) << name;
  }
  for (const auto& [name, file] : std::map<std::string, std::string>{{"e.png", deep_png_file(6554)},
                                                                     {"f.webp", orange_webp_file(true)},
                                                                     {"g.jpg", jpeg_file(20, 30)},
                                                                     {"h.tga", tga_file(4, 3)},
                                                                     {"i.pfm", big_endian_grey_pfm()}}) {
    const auto image = image::read_image(folder_.add(name, file), diagnostics_, {}, image::Alpha::Kept);
    ASSERT_TRUE(image) << diagnostics_.to_text();
    EXPECT_TRUE(image->alpha.empty()) << name << ": it has none";
  }
}

TEST_F(ImageReader, RefusesDamagedWebP) {
  const std::string file = orange_webp_file(false);
  expect_error("a.webp", file.substr(0, 20), "it is damaged (unexpected end of file)");
  expect_error("b.webp", file.substr(0, file.size() / 2), "it is damaged (");
  expect_error("c.webp", std::string("RIFF\x04\0\0\0WAVEfmt ", 16), "it is damaged (");
}

TEST_F(ImageReader, ReadsWhatElseRadianceFilesSay) {
  const std::string pixels = bytes(64, 0, 0, 129) + bytes(1, 1, 1, 2) + bytes(128, 0, 0, 129);
  const auto image =
      read("a.hdr", "#?RADIANCE\nEXPOSURE=0.5\nEXPOSURE= 2\nEXPOSURE=4\n\n+Y 1 -X 4\n" + pixels);
  ASSERT_TRUE(image) << diagnostics_.to_text();
  const Colour half(0.125F, 0, 0);
  EXPECT_EQ(image->pixels, (std::vector<Colour>{half * 2, half, half, half}));
  expect_error("b.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 4\n", "it is damaged (its pixels");
  expect_error("c.hdr", "#?RADIANCE\n\n+X 1 +Y 4\n",
               "it is damaged (its resolution is not given as rows and");
}

TEST_F(ImageReader, TellsFilesByWhatTheyHold) {
  expect_everywhere(read("a.jpg", radiance_file(4, 3)), Colour(0.5F, 1, 2));
  expect_everywhere(read("without", jpeg_file(20, 30)), Orange, 0.01F);
}

std::string exr_with(const std::string& path, const std::vector<const char*>& channels) {
  const std::vector<float> values(12, 0.5F);
  {
    Imf::Header header(4, 3);
    Imf::FrameBuffer buffer;
    for (const char* channel : channels) {
      header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
      char* data = const_cast<char*>(reinterpret_cast<const char*>(values.data()));
      buffer.insert(channel, Imf::Slice(Imf::FLOAT, data, sizeof(float), 4 * sizeof(float)));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(3);
  }
  return test::bytes_of(path);
}

TEST_F(ImageReader, ReadsOpenExrByItsChannels) {
  const std::string path = folder_.path("made.exr");
  expect_everywhere(read("a.exr", exr_with(path, {"Y"})), Colour(0.5F));
  expect_everywhere(read("b.exr", exr_with(path, {"R", "G", "B", "A", "Z"})), Colour(0.5F));
  expect_everywhere(read("c.exr", exr_with(path, {"G"})), Colour(0, 0.5F, 0));
  expect_error("d.exr", exr_with(path, {"Z"}),
               "it is damaged (its channels are neither R, G and B nor only Y)");
}

/// Writes an OpenEXR file of 4 x 3 pixels, of which channel i has the value i everywhere.
std::string numbered_exr(const std::string& path, const std::vector<std::string>& channels) {
  std::vector<std::vector<float>> values;
  for (std::size_t i = 0; i < channels.size(); ++i) values.emplace_back(12, static_cast<float>(i));
  Imf::Header header(4, 3);
  Imf::FrameBuffer buffer;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    header.channels().insert(channels[i], Imf::Channel(Imf::FLOAT));
    char* data = reinterpret_cast<char*>(values[i].data());
    buffer.insert(channels[i], Imf::Slice(Imf::FLOAT, data, sizeof(float), 4 * sizeof(float)));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(3);
  return path;
}

TEST_F(ImageReader, ReadsTheLayersOfOpenExr) {
  const auto file = image::read_image_file(
      numbered_exr(folder_.path("a.exr"), {"B", "G", "R", "albedo.B", "albedo.G", "albedo.R", "depth.Z",
                                           "normal.X", "normal.Y", "normal.Z", "samples", "pass.one.A"}),
      diagnostics_);
  ASSERT_TRUE(file) << diagnostics_.to_text();
  EXPECT_EQ(file->image.pixels, std::vector<Colour>(12, Colour(2, 1, 0)));
  std::map<std::string, std::string> letters;
  std::map<std::string, Colour> values;
  for (const image::ImageLayer& layer : file->layers) {
    letters[layer.name] = layer.channels;
    const Image image = image::image_of(layer, 4, 3);
    values[layer.name] = image.pixels.back();
    EXPECT_EQ(image.pixels, std::vector<Colour>(12, image.pixels.back())) << layer.name;
  }
  const std::map<std::string, std::string> expected_letters = {
      {"albedo", "RGB"}, {"depth", "Z"}, {"normal", "XYZ"}, {"samples", ""}, {"pass.one", "A"}};
  EXPECT_EQ(letters, expected_letters);
  const std::map<std::string, Colour> expected = {{"albedo", Colour(5, 4, 3)},
                                                  {"depth", Colour(6)},
                                                  {"normal", Colour(7, 8, 9)},
                                                  {"samples", Colour(10)},
                                                  {"pass.one", Colour(11)}};
  EXPECT_EQ(values, expected);
}

TEST_F(ImageReader, ShowsALayerOfAnOpenExrThatHasNoImage) {
  const auto passes = image::read_image_file(
      numbered_exr(folder_.path("a.exr"), {"a.Z", "view.A", "view.B", "view.G", "view.R"}), diagnostics_);
  ASSERT_TRUE(passes) << diagnostics_.to_text();
  EXPECT_EQ(passes->layers.size(), 2U);
  EXPECT_EQ(passes->image.pixels.front(), Colour(4, 3, 2)) << "the first one in colour";
  const auto depth = image::read_image_file(numbered_exr(folder_.path("b.exr"), {"W", "Z"}), diagnostics_);
  ASSERT_TRUE(depth) << diagnostics_.to_text();
  EXPECT_EQ(depth->layers.size(), 2U);
  EXPECT_EQ(depth->image.pixels.front(), Colour(0)) << "the first one";
  const auto other = image::read_image_file(folder_.add("c.pfm", pfm_of(gradient(5, 3))), diagnostics_);
  ASSERT_TRUE(other) << diagnostics_.to_text();
  EXPECT_TRUE(other->layers.empty());
}

TEST_F(ImageReader, RefusesHugeImages) {
  const std::string path = folder_.path("made.exr");
  Imf::Header header(100000, 200000);
  header.channels().insert("R", Imf::Channel(Imf::HALF));
  { const Imf::OutputFile file(path.c_str(), header); }
  expect_error("a.exr", test::bytes_of(path),
               "it is damaged (it has 100000 x 200000 pixels, expected at most 134 million)");
}

TEST_F(ImageReader, SaysWhatIsWrong) {
  expect_error("a.exr", "", "the file is empty");
  expect_error("b.bmp", "BM something",
               "unknown format, expected OpenEXR, Radiance (hdr), pfm, raw, PNG, JPEG, TGA or WebP");
  expect_error("c.pfm", "PF\n2 2\n", "it is damaged (its header is not a type, a width, a height");
  expect_error("d.pfm", "PF\n2 2\n-1\n....", "it is damaged (unexpected end of file)");
  expect_error("e.pfm", "PF\n0 2\n-1\n", "it is damaged (it has no pixels)");
  expect_error("f.pfm", "PF\n-2 2\n-1\n", "it is damaged (it has no pixels)");
  expect_error("g.pfm", "PF\n2147483647 2147483647\n-1\n", "it is damaged (unexpected end of file)");
  expect_error("h.hdr", "#?RADIANCE\n\n-Y 100000 +X 100000\n", "it is damaged (unexpected end of file)");
  expect_error("j.raw", std::string("\1\0\0", 3), "it is damaged (unexpected end of file)");
  expect_error("k.raw", std::string(8, '\0'), "it is damaged (it has no pixels)");
  expect_error("l.raw", std::string("\1\0\0\0\1\0\0\0 twelve bytes and more", 30),
               "it is damaged (it is longer than its width and height require)");
  expect_error("m.raw", std::string(40, '\xff'), "it is damaged (unexpected end of file)");
  expect_error("i.tga", "some text", "it is damaged (");
  EXPECT_FALSE(image::read_image(folder_.path("none.exr"), diagnostics_ = {}));
  EXPECT_EQ(diagnostics_.error_count(), 1U);
  EXPECT_FALSE(image::read_image(folder_.path(), diagnostics_ = {}));
  EXPECT_EQ(diagnostics_.error_count(), 1U);
}

TEST_F(ImageReader, SaysItAtThePlaceThatNamesTheFile) {
  const std::string path = folder_.add("a.exr", "\x76\x2f\x31\x01 and no more");
  const auto file = std::make_shared<grf::SourceFile>();
  file->path = "scene.op";
  EXPECT_FALSE(image::read_image(path, diagnostics_, {file, 3, 20}));
  EXPECT_TRUE(diagnostics_.to_text().starts_with("scene.op:3:20: error: cannot read the image '" + path +
                                                 "': it is damaged ("))
      << diagnostics_.to_text();
}

class BrokenImages : public ImageReader {
 protected:
  std::vector<std::pair<std::string, std::string>> files() {
    const Image image = gradient(24, 10);
    return {{"a.exr", encoded(image, "image.exr")},
            {"a.png", encoded(image, "image.png")},
            {"a.pfm", pfm_of(image)},
            {"a.raw", encoded(image, "image.raw")},
            {"a.hdr", radiance_file(4, 3)},
            {"b.hdr", radiance_rle_file(20, 9)},
            {"a.tga", tga_file(4, 3)},
            {"b.tga", tga_rle_file(20, 9)},
            {"a.jpg", jpeg_file(20, 30)},
            {"b.png", deep_png_file(6554)},
            {"a.webp", orange_webp_file(false)},
            {"b.webp", orange_webp_file(true)}};
  }
};

// A cut within a file's last bytes may be harmless: PNG's end chunk, JPEG's end marker.
TEST_F(BrokenImages, ThatEndEarlyAreRefused) {
  for (const auto& [name, file] : files()) {
    const std::size_t last = file.size() - 16;
    const std::size_t step = std::max<std::size_t>(1, last / 60);
    for (std::size_t size = 1; size < file.size(); size += size < last ? step : 1) {
      const auto image = read(name, file.substr(0, size));
      if (image && size >= last) continue;
      EXPECT_FALSE(image) << name << " " << size << " of " << file.size();
      EXPECT_EQ(diagnostics_.error_count(), 1U) << name << " " << size;
    }
  }
}

TEST_F(BrokenImages, ThatAreGarbledDoNoHarm) {
  std::mt19937 random(3);
  for (const auto& [name, file] : files()) {
    for (int i = 0; i < 80; ++i) {
      std::string garbled = file;
      for (std::uint32_t k = 0; k <= random() % 8; ++k) {
        // The first bytes matter most.
        const std::size_t range = random() % 2 == 0 ? std::min<std::size_t>(64, file.size()) : file.size();
        garbled[random() % range] = static_cast<char>(random());
      }
      const auto image = read(name, garbled);
      EXPECT_EQ(diagnostics_.error_count(), image ? 0U : 1U) << name;
      if (image) {
        EXPECT_EQ(image->pixels.size(), std::size_t(image->width) * std::size_t(image->height));
      }
    }
  }
}

}  // namespace
