#include "grf/wording.h"

#include <gtest/gtest.h>

namespace {

TEST(Wording, CountsWithTheRightNumber) {
  EXPECT_EQ(grf::counted(0, "face", "faces"), "0 faces");
  EXPECT_EQ(grf::counted(1, "face", "faces"), "1 face");
  EXPECT_EQ(grf::counted(12, "face", "faces"), "12 faces");
}

TEST(Wording, HasSizesWithThreeDigits) {
  EXPECT_EQ(grf::bytes_text(1), "1 byte");
  EXPECT_EQ(grf::bytes_text(999), "999 bytes");
  EXPECT_EQ(grf::bytes_text(1000), "1 KB");
  EXPECT_EQ(grf::bytes_text(123'456), "123 KB");
  EXPECT_EQ(grf::bytes_text(39'000'000), "39 MB");
}

}  // namespace
