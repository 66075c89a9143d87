// 10^8 samples of the BRDFs of the thesis' table 5.5: by all schemes together, and by only `adaptive`.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/reflectance/reflector.h"
#include "tests/reflectance/scheme_cases.h"
#include "tests/reflectance/warp_weights.h"

namespace {

constexpr std::array<const char*, 11> Schemes = {"own",         "diffuse",
                                                 "hemisphere",  "sphere",
                                                 "anisotropic", "reject res=100",
                                                 "adaptive",    "adaptive mode=reject res=100",
                                                 "factored",    "factored half=true J=2 K=2",
                                                 "cascadeCDF"};

class WeightsLong : public testing::TestWithParam<test::ThesisCase> {};

TEST_P(WeightsLong, AreFiniteAndNotNegative) {
  constexpr int Samples = 570000;  // 10^8 over all BRDFs and schemes
  const reflectance::Brdf brdf = test::brdf_of(GetParam().brdf);
  for (const char* scheme : Schemes) {
    const reflectance::Reflector reflector(brdf, test::scheme_of(scheme));
    test::Pairs random(7);
    for (int i = 0; i < Samples; ++i) {
      const reflectance::Vec3f u = reflectance::uniform_direction(random.next_pair());
      const auto drawn = reflector.sample(u, {random.next_pair(), random.next()});
      if (!drawn) continue;
      for (int k = 0; k < 3; ++k) {
        ASSERT_TRUE(std::isfinite(drawn->weight[k]) && drawn->weight[k] >= 0)
            << scheme << u << drawn->direction;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, WeightsLong, testing::ValuesIn(test::thesis_cases()),
                         [](const auto& one) { return std::to_string(one.index); });

TEST(WarpLong, WeightsAreNearTheAlbedo) { test::expect_even_weights(625, 10000); }

}  // namespace
