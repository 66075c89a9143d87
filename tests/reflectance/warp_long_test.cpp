// 10^8 samples of the inversion of adaptive trees.
#include <gtest/gtest.h>

#include "tests/reflectance/warp_weights.h"

TEST(WarpLong, WeightsAreNearTheAlbedo) { test::expect_even_weights(625, 10000); }
