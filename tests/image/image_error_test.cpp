#include "renderer/image/image_error.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace {

using grf::Colour;
using image::error_of;
using image::Image;
using image::ImageError;

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr float Infinity = std::numeric_limits<float>::infinity();

Image row(std::vector<Colour> pixels) { return {static_cast<int>(pixels.size()), 1, std::move(pixels)}; }

TEST(ImageErrorTest, IsWhatOneComputesByHand) {
  const ImageError error =
      error_of(row({Colour(1.5F, 1, 1), Colour(0, 0.5F, 0)}), row({Colour(1, 1, 1), Colour(0, 0, 0)}));
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
  const Image two = row({Colour(2)});
  const Image one = row({Colour(1)});
  EXPECT_NEAR(*error_of(two, one).average_relative_error, 1, 1e-12);
  EXPECT_NEAR(*error_of(one, two).average_relative_error, 0.5, 1e-12);
  EXPECT_NEAR(*error_of(two, one).psnr, 0, 1e-12);
  EXPECT_NEAR(*error_of(one, two).psnr, 20 * std::log10(2), 1e-12);
  EXPECT_NEAR(error_of(one, two).relmse, 1 / 4.01, 1e-12);
}

TEST(ImageErrorTest, OfAnImageFromItselfIsZero) {
  const Image image = row({Colour(1, 2, 3), Colour(0)});
  const ImageError error = error_of(image, image);
  EXPECT_EQ(error.rmse, 0);
  EXPECT_EQ(error.relmse, 0);
  EXPECT_EQ(error.average_relative_error, 0);
  EXPECT_FALSE(error.psnr) << "it would be infinite";
  EXPECT_EQ(error.max, 0);
}

TEST(ImageErrorTest, HasNoRelativeErrorFromBlack) {
  const ImageError error = error_of(row({Colour(1)}), row({Colour(0)}));
  EXPECT_FALSE(error.average_relative_error);
  EXPECT_FALSE(error.psnr);
  EXPECT_NEAR(error.relmse, 100, 1e-9);
}

TEST(ImageErrorTest, CountsWhatIsNotFiniteAndLeavesItOut) {
  const ImageError error = error_of(row({Colour(1.5F), Colour(1, NaN, 1), Colour(9), Colour(Infinity, 0, 0)}),
                                    row({Colour(1), Colour(1), Colour(1, 1, -Infinity), Colour(1)}));
  EXPECT_EQ(error.nan_pixels, 3U);
  EXPECT_NEAR(error.rmse, 0.5, 1e-12);
  EXPECT_NEAR(*error.average_relative_error, 0.5, 1e-12);
  EXPECT_EQ(error.max, 0.5);
  const ImageError none = error_of(row({Colour(NaN)}), row({Colour(1)}));
  EXPECT_EQ(none.nan_pixels, 1U);
  EXPECT_EQ(none.rmse, 0);
}

TEST(ImageErrorTest, CountsFirefliesThatTheReferenceHasNot) {
  // A lamp on the left whose edge is shifted by two pixels, and a firefly.
  const Image reference =
      row({Colour(8), Colour(8), Colour(1), Colour(1), Colour(1), Colour(1), Colour(1), Colour(1)});
  EXPECT_EQ(
      error_of(row({Colour(8), Colour(8), Colour(8), Colour(8), Colour(1), Colour(1), Colour(1), Colour(1)}),
               reference)
          .fireflies,
      0U);
  EXPECT_EQ(
      error_of(row({Colour(8), Colour(8), Colour(1), Colour(1), Colour(1), Colour(1), Colour(5), Colour(1)}),
               reference)
          .fireflies,
      1U);
  EXPECT_EQ(error_of(row({Colour(8), Colour(8), Colour(1), Colour(1), Colour(1), Colour(1), Colour(3.9F),
                          Colour(1)}),
                     reference)
                .fireflies,
            0U)
      << "that is noise";
}

TEST(ImageErrorTest, TakesNoDarkNoiseForFireflies) {
  std::vector<Colour> dark(20, Colour(0));
  dark.front() = Colour(20);  // the mean is 1
  const Image reference = row(dark);
  dark[10] = Colour(0.3F);
  dark[15] = Colour(0.5F);
  EXPECT_EQ(error_of(row(dark), reference).fireflies, 1U);
}

// Sums in float would stop growing.
TEST(ImageErrorTest, AddsUpManySmallDifferences) {
  const std::size_t count = 1U << 20U;
  const Image image = row(std::vector<Colour>(count, Colour(1.001F)));
  const Image reference = row(std::vector<Colour>(count, Colour(1)));
  EXPECT_NEAR(error_of(image, reference).rmse, 1.001F - 1.0F, 1e-12);
}

}  // namespace
