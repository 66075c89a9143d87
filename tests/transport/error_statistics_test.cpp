// Minutes of statistics: what the error estimate and adaptive sampling promise, over 200 and 1,000 seeds.
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/transport/error_study.h"

namespace {

TEST(ErrorEstimate, HoldsOver200SeedsOfFourScenes) {
  test::ErrorStudy all;
  for (const test::SampleScene& scene : test::error_scenes()) {
    test::ErrorStudy own;
    test::study_errors(scene, 200, 64, own);
    std::printf("%s: inside %.3f, stated / true %.3f, missed %.3f\n", scene.name.c_str(), own.coverage(),
                own.stated_over_true(), own.missed_share());
    all += own;
  }
  EXPECT_GE(all.coverage(), 0.93);
  EXPECT_LE(all.coverage(), 0.98);
  EXPECT_GT(all.stated_over_true(), 0.87);
  EXPECT_LT(all.stated_over_true(), 1.3);
  EXPECT_LE(all.missed_share(), 0.07);
}

// 144 blocks: one of them is off by 4.5 standard deviations in one case of 1,000.
TEST(AdaptiveSampling, HasTheMeanOfUniformSamplingOver1000Renders) {
  EXPECT_LT(test::largest_difference(test::caustic_scene(), 64, 1000), 4.5);
  EXPECT_LT(test::largest_difference(test::sun_scene(), 64, 1000), 4.5);
}

}  // namespace
