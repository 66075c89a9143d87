#include "renderer/transport/image/image_error.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace {

using reflectance::Rgb;
using transport::error_of;
using transport::Image;
using transport::ImageError;

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr float Infinity = std::numeric_limits<float>::infinity();

Image row(std::vector<Rgb> pixels) { return {static_cast<int>(pixels.size()), 1, std::move(pixels)}; }

TEST(ImageErrorTest, IsWhatOneComputesByHand) {
  const ImageError error =
      error_of(row({Rgb(1.5F, 1, 1), Rgb(0, 0.5F, 0)}), row({Rgb(1, 1, 1), Rgb(0, 0, 0)}));
  // Differences 0.5 from 1 and 0.5 from 0, of six values.
  EXPECT_NEAR(error.rmse, std::sqrt(0.5 / 6), 1e-12);
  EXPECT_NEAR(error.relmse, (0.25 / 1.01 + 0.25 / 0.01) / 6, 1e-12);
  ASSERT_TRUE(error.average_relative_error);
  EXPECT_NEAR(*error.average_relative_error, 0.5 / 3, 1e-12) << "the black pixel does not count";
  ASSERT_TRUE(error.psnr);
  EXPECT_NEAR(*error.psnr, 10 * std::log10(1 / (0.5 / 6)), 1e-12);
  EXPECT_EQ(error.max, 0.5);
  EXPECT_EQ(error.nan_pixels, 0U);
}

TEST(ImageErrorTest, IsRelativeToTheSecondImage) {
  const Image two = row({Rgb(2)});
  const Image one = row({Rgb(1)});
  EXPECT_NEAR(*error_of(two, one).average_relative_error, 1, 1e-12);
  EXPECT_NEAR(*error_of(one, two).average_relative_error, 0.5, 1e-12);
  EXPECT_NEAR(*error_of(two, one).psnr, 0, 1e-12);
  EXPECT_NEAR(*error_of(one, two).psnr, 20 * std::log10(2), 1e-12);
  EXPECT_NEAR(error_of(one, two).relmse, 1 / 4.01, 1e-12);
}

TEST(ImageErrorTest, OfAnImageFromItselfIsZero) {
  const Image image = row({Rgb(1, 2, 3), Rgb(0)});
  const ImageError error = error_of(image, image);
  EXPECT_EQ(error.rmse, 0);
  EXPECT_EQ(error.relmse, 0);
  EXPECT_EQ(error.average_relative_error, 0);
  EXPECT_FALSE(error.psnr) << "it would be infinite";
  EXPECT_EQ(error.max, 0);
}

TEST(ImageErrorTest, HasNoRelativeErrorFromBlack) {
  const ImageError error = error_of(row({Rgb(1)}), row({Rgb(0)}));
  EXPECT_FALSE(error.average_relative_error);
  EXPECT_FALSE(error.psnr);
  EXPECT_NEAR(error.relmse, 100, 1e-9);
}

TEST(ImageErrorTest, CountsWhatIsNotFiniteAndLeavesItOut) {
  const ImageError error = error_of(row({Rgb(1.5F), Rgb(1, NaN, 1), Rgb(9), Rgb(Infinity, 0, 0)}),
                                    row({Rgb(1), Rgb(1), Rgb(1, 1, -Infinity), Rgb(1)}));
  EXPECT_EQ(error.nan_pixels, 3U);
  EXPECT_NEAR(error.rmse, 0.5, 1e-12);
  EXPECT_NEAR(*error.average_relative_error, 0.5, 1e-12);
  EXPECT_EQ(error.max, 0.5);
  const ImageError none = error_of(row({Rgb(NaN)}), row({Rgb(1)}));
  EXPECT_EQ(none.nan_pixels, 1U);
  EXPECT_EQ(none.rmse, 0);
}

TEST(ImageErrorTest, CountsFirefliesThatTheReferenceHasNot) {
  // A lamp on the left whose edge is shifted by two pixels, and a firefly.
  const Image reference = row({Rgb(8), Rgb(8), Rgb(1), Rgb(1), Rgb(1), Rgb(1), Rgb(1), Rgb(1)});
  EXPECT_EQ(
      error_of(row({Rgb(8), Rgb(8), Rgb(8), Rgb(8), Rgb(1), Rgb(1), Rgb(1), Rgb(1)}), reference).fireflies,
      0U);
  EXPECT_EQ(
      error_of(row({Rgb(8), Rgb(8), Rgb(1), Rgb(1), Rgb(1), Rgb(1), Rgb(5), Rgb(1)}), reference).fireflies,
      1U);
  EXPECT_EQ(
      error_of(row({Rgb(8), Rgb(8), Rgb(1), Rgb(1), Rgb(1), Rgb(1), Rgb(3.9F), Rgb(1)}), reference).fireflies,
      0U)
      << "that is noise";
}

TEST(ImageErrorTest, TakesNoDarkNoiseForFireflies) {
  std::vector<Rgb> dark(20, Rgb(0));
  dark.front() = Rgb(20);  // the mean is 1
  const Image reference = row(dark);
  dark[10] = Rgb(0.3F);
  dark[15] = Rgb(0.5F);
  EXPECT_EQ(error_of(row(dark), reference).fireflies, 1U);
}

// Sums in float would stop growing.
TEST(ImageErrorTest, AddsUpManySmallDifferences) {
  const std::size_t count = 1U << 20U;
  const Image image = row(std::vector<Rgb>(count, Rgb(1.001F)));
  const Image reference = row(std::vector<Rgb>(count, Rgb(1)));
  EXPECT_NEAR(error_of(image, reference).rmse, 1.001F - 1.0F, 1e-12);
}

}  // namespace
