#include "grf/srgb.h"

#include <gtest/gtest.h>

namespace {

TEST(Srgb, IsTheStandardsCurve) {
  EXPECT_EQ(grf::srgb_encoded(0.0), 0);
  EXPECT_NEAR(grf::srgb_encoded(1.0), 1, 1e-15);
  EXPECT_NEAR(grf::srgb_encoded(0.214041140482232), 0.5, 1e-12);
  EXPECT_NEAR(grf::srgb_encoded(0.0031308), 0.04045, 1e-6);
}

TEST(Srgb, DecodesColours) {
  const grf::Colour colour = grf::srgb_decoded(grf::Colour(0, 0.5F, 1));
  EXPECT_TRUE(colour.equalWithAbsError({0, 0.21404114F, 1}, 1e-6F));
}

TEST(Srgb, IsUndoneByItsInverse) {
  for (int step = 0; step <= 1024; ++step) {
    const double linear = step / 1024.0;
    EXPECT_NEAR(grf::srgb_decoded(grf::srgb_encoded(linear)), linear, 1e-7);
    const auto single = static_cast<float>(linear);
    EXPECT_NEAR(grf::srgb_decoded(grf::srgb_encoded(single)), single, 1e-6);
  }
}

}  // namespace
