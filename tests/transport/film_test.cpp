#include "renderer/transport/film.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <random>

#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>
#include <png.h>

namespace {

using transport::Film;
using transport::Image;
using transport::Rgb;

std::string temporary(const std::string& name) { return testing::TempDir() + "/" + name; }

TEST(Film, KeepsMeanAndVarianceOfTwoHalves) {
  Film film(2, 1);
  film.add(0, 0, 0, Rgb(1, 2, 3));
  film.add(0, 0, 1, Rgb(3, 2, 1));
  EXPECT_EQ(film.mean().at(0, 0), Rgb(2, 2, 2));
  EXPECT_EQ(film.variance().at(0, 0), Rgb(1, 0, 1));
  EXPECT_EQ(film.mean().at(1, 0), Rgb(0));
  EXPECT_EQ(film.sample_count(0, 0), 2U);
}

TEST(Film, KnowsNoErrorFromOneHalf) {
  Film film(1, 1);
  film.add(0, 0, 0, Rgb(1));
  EXPECT_FALSE(film.estimated_error());
}

TEST(Film, EstimatesTheTrueError) {
  constexpr int Side = 100;
  constexpr int Samples = 20;
  std::mt19937 random(1);
  std::exponential_distribution<float> radiance(1);
  Film film(Side, Side);
  for (int y = 0; y < Side; ++y) {
    for (int x = 0; x < Side; ++x) {
      for (int i = 0; i < Samples; ++i) film.add(x, y, i % 2, Rgb(radiance(random), 1, 1));
    }
  }
  // The first channel has mean 1 and variance 1 / Samples, the others have no error.
  double expected = 0;
  const Image mean = film.mean();
  for (const Rgb& pixel : mean.pixels) expected += (pixel.x - 1) * (pixel.x - 1) / 1.01;
  expected = std::sqrt(expected / (3 * Side * Side));
  ASSERT_TRUE(film.estimated_error());
  EXPECT_NEAR(*film.estimated_error(), expected, 0.05 * expected);
}

TEST(Film, TakesNothingThatIsNotFinite) {
  Film film(1, 1);
  EXPECT_TRUE(film.add(0, 0, 0, Rgb(1)));
  EXPECT_FALSE(film.add(0, 0, 1, Rgb(std::numeric_limits<float>::quiet_NaN())));
  EXPECT_FALSE(film.add(0, 0, 1, Rgb(std::numeric_limits<float>::infinity())));
  EXPECT_TRUE(std::isfinite(film.mean().at(0, 0).x));
}

TEST(Film, LosesNothingOverAMillionSamples) {
  Film film(1, 1);
  for (int i = 0; i < 1'000'000; ++i) film.add(0, 0, i % 2, Rgb(0.1F));
  EXPECT_EQ(film.mean().at(0, 0), Rgb(0.1F));
}

Image gradient() {
  Image image{4, 3, {}};
  for (int i = 0; i < 12; ++i) image.pixels.emplace_back(static_cast<float>(i) * 0.3F, 1e-4F, 1e5F);
  return image;
}

TEST(ImageFile, ExrKeepsEveryBit) {
  const Image image = gradient();
  const std::string path = temporary("image.exr");
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(transport::write_image(image, path, diagnostics)) << diagnostics.to_text();
  Imf::InputFile file(path.c_str());
  EXPECT_EQ(file.header().dataWindow().max, Imath::V2i(3, 2));
  std::vector<Rgb> pixels(12);
  Imf::FrameBuffer buffer;
  std::size_t offset = 0;
  for (const char* channel : {"R", "G", "B"}) {
    buffer.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()) + offset,
                                      sizeof(Rgb), 4 * sizeof(Rgb)));
    offset += sizeof(float);
  }
  file.setFrameBuffer(buffer);
  file.readPixels(0, 2);
  EXPECT_EQ(pixels, image.pixels);
}

TEST(ImageFile, PngIsEncodedInSrgb) {
  const Image image{3, 1, {Rgb(0, 1, 2), Rgb(0.5F, 0.001F, 0.2F), Rgb(-1, 0.25F, 0.75F)}};
  const std::string path = temporary("image.png");
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(transport::write_image(image, path, diagnostics));
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&png, path.c_str()), 0);
  png.format = PNG_FORMAT_RGB;
  std::vector<int> bytes(9);
  std::vector<unsigned char> raw(9);
  ASSERT_NE(png_image_finish_read(&png, nullptr, raw.data(), 0, nullptr), 0);
  bytes.assign(raw.begin(), raw.end());
  EXPECT_EQ(bytes, (std::vector<int>{0, 255, 255, 188, 3, 124, 0, 137, 225}));
}

TEST(ImageFile, RefusesATypeThatItDoesNotKnow) {
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(transport::write_image(gradient(), temporary("image.bmp"), diagnostics));
  EXPECT_NE(diagnostics.to_text().find("exr, png"), std::string::npos) << diagnostics.to_text();
}

}  // namespace
