// The intervals of a fit hold what was planted as often as they say.
#include <array>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fit/fit_cases.h"

namespace {

struct Noisy {
  std::string brdf;
  std::vector<std::pair<std::string, std::array<double, 3>>> planted;
};

class FitIntervals : public testing::TestWithParam<Noisy> {};

// The noise is that of a goniometer: of 2 % in a measurement, whatever the channel. All parameters of a model
// count together: 95 % of them have a standard error of at most 1.1 % in 400 runs.
TEST_P(FitIntervals, HoldTheTruthIn95Percent) {
  constexpr int Runs = 400;
  const fit::Observations clean = test::observations_of(GetParam().brdf, 200);
  const std::string keyword = GetParam().brdf.substr(0, GetParam().brdf.find(' '));
  int held = 0;
  int all = 0;
  for (int run = 0; run < Runs; ++run) {
    fit::Observations data = clean;
    test::add_noise(data, 0.02, 1000 + static_cast<std::uint32_t>(run));
    const fit::Fit fit = test::fit_of(keyword, data);
    for (const auto& [name, values] : GetParam().planted) {
      for (int channel = 0; channel < 3; ++channel) {
        const fit::FittedParameter& found = test::parameter(fit, name, channel);
        if (!found.channel && channel > 0) break;
        const double value = values[static_cast<std::size_t>(channel)];
        held += found.low <= value && value <= found.high ? 1 : 0;
        ++all;
      }
    }
  }
  const double part = static_cast<double>(held) / all;

  std::cout << part << " held\n";
  EXPECT_GE(part, 0.93);
  EXPECT_LE(part, 0.97);
}

INSTANTIATE_TEST_SUITE_P(
    Models, FitIntervals,
    testing::Values(
        Noisy{"diffuse kd=(0.4, 0.3, 0.1)", {{"kd", {0.4, 0.3, 0.1}}}},
        Noisy{"phong n=30 ks=(0.3, 0.2, 0.1) kd=(0.1, 0.2, 0.4)",
              {{"n", {30, 30, 30}}, {"ks", {0.3, 0.2, 0.1}}, {"kd", {0.1, 0.2, 0.4}}}},
        Noisy{"ward sx=0.2 ks=0.4 kd=(0.3, 0.2, 0.1)", {{"sx", {0.2, 0.2, 0.2}}, {"kd", {0.3, 0.2, 0.1}}}},
        Noisy{"sheen rough=0.35 ks=0.7", {{"rough", {0.35, 0.35, 0.35}}, {"ks", {0.7, 0.7, 0.7}}}}));

}  // namespace
