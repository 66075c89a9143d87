// The intervals of a fit hold what was planted as often as they say.
#include <gtest/gtest.h>

#include "tests/fit/fit_cases.h"

namespace {

using test::parameter;

struct Noisy {
  std::string brdf;
  std::vector<std::pair<std::string, double>> planted;
};

class FitIntervals : public testing::TestWithParam<Noisy> {};

// Noise of 2 % in 200 runs. All parameters of a model count together.
TEST_P(FitIntervals, HoldTheTruthIn95Percent) {
  constexpr int Runs = 200;
  const fit::Observations clean = test::observations_of(GetParam().brdf, 400);
  const std::string keyword = GetParam().brdf.substr(0, GetParam().brdf.find(' '));
  double held = 0;
  for (int run = 0; run < Runs; ++run) {
    fit::Observations data = clean;
    test::add_noise(data, 0.02, 1000 + static_cast<std::uint32_t>(run));
    const fit::Fit fit = test::fit_of(keyword, data);
    for (const auto& [name, value] : GetParam().planted) {
      const fit::FittedParameter& found = parameter(fit, name);
      held += found.low <= value && value <= found.high ? 1 : 0;
    }
  }
  const double part = held / (Runs * static_cast<double>(GetParam().planted.size()));
  EXPECT_GE(part, 0.93);
  EXPECT_LE(part, 0.97);
}

INSTANTIATE_TEST_SUITE_P(
    Models, FitIntervals,
    testing::Values(Noisy{"diffuse kd=0.4", {{"kd", 0.4}}},
                    Noisy{"phong n=30 ks=0.3 kd=0.4", {{"n", 30}, {"ks", 0.3}, {"kd", 0.4}}},
                    Noisy{"ward sx=0.2 ks=0.4 kd=0.3", {{"sx", 0.2}, {"ks", 0.4}, {"kd", 0.3}}},
                    Noisy{"oren s=0.4 r=0.6", {{"s", 0.4}, {"r", 0.6}}},
                    Noisy{"ashikhmin ex=45 Rs=0.3 Rd=0.5", {{"ex", 45}, {"Rs", 0.3}, {"Rd", 0.5}}},
                    Noisy{"sheen rough=0.35 ks=0.7", {{"rough", 0.35}, {"ks", 0.7}}}));

}  // namespace
