#include "renderer/transport/forecast.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace {

using transport::Convergence;
using transport::ErrorCheck;
using transport::ErrorEstimate;
using transport::Forecast;
using transport::ForecastValue;

/// An estimate that is nearly certain.
ErrorEstimate certain(double error) { return {error, error / 1.001, error * 1.001}; }

/// The checks of an error c n^-a up to so many samples, without noise.
std::vector<ErrorCheck> power_law(double c, double a, int most) {
  std::vector<ErrorCheck> checks;
  for (int n = 16; n <= most; n = transport::error_check_from(n + 1)) {
    checks.push_back({static_cast<double>(n), certain(c * std::pow(n, -a))});
  }
  return checks;
}

/// The Monte Carlo error of an image of a few pixels, each a mean of normal samples of both halves, and its
/// estimate from the difference of the halves. The number of pixels is that of degrees of freedom.
class NoisyImage {
 public:
  NoisyImage(int pixels, double exponent, std::mt19937& random)
      : exponent_(exponent), random_(random), sums_(static_cast<std::size_t>(pixels)) {}

  ErrorCheck check(int samples) {
    std::normal_distribution<double> more(0, std::sqrt(samples - samples_));
    double squares = 0;
    for (double& sum : sums_) {
      sum += more(random_);
      squares += sum * sum;
    }
    samples_ = samples;
    const auto pixels = static_cast<double>(sums_.size());
    // The difference of the halves' sums has the variance n, which gives the exponent 1/2.
    const double error = std::sqrt(squares / pixels / samples) * std::pow(samples, -exponent_);
    const double width = 1.96 * std::sqrt(1 / pixels);  // of the quotient of two roots of mean squares
    return {static_cast<double>(samples), {error, error * std::exp(-width), error * std::exp(width)}};
  }

 private:
  double exponent_;
  std::mt19937& random_;
  std::vector<double> sums_;
  int samples_ = 0;
};

/// The fraction of 1,000 runs whose need of samples was in the interval that was forecast from its checks up
/// to 100 samples, for a third of the error then.
double coverage(int pixels, double exponent, Convergence convergence) {
  std::mt19937 random(7);
  int inside = 0;
  constexpr int Runs = 1000;
  for (int run = 0; run < Runs; ++run) {
    NoisyImage image(pixels, exponent, random);
    std::vector<ErrorCheck> checks;
    int samples = 16;
    for (; samples <= 100; samples = transport::error_check_from(samples + 1)) {
      checks.push_back(image.check(samples));
    }
    const double target = error_against_target(checks.back().estimate) / 3;
    const ForecastValue forecast = Forecast(checks, convergence).samples_for(target);
    while (error_against_target(image.check(samples).estimate) > target) {
      samples = transport::error_check_from(samples + 1);
    }
    inside += samples >= forecast.low && samples <= forecast.high ? 1 : 0;
  }
  return static_cast<double>(inside) / Runs;
}

TEST(Forecast, FollowsAPowerLaw) {
  for (const auto& [exponent, convergence] :
       {std::pair(0.5, Convergence::Independent), std::pair(0.5, Convergence::Sobol),
        std::pair(0.7, Convergence::Sobol), std::pair(0.85, Convergence::Sobol)}) {
    // 5 n^-a is 0.05 at 100^(1 / a) samples.
    const double exact = std::pow(100, 1 / exponent);
    const ForecastValue samples =
        Forecast(power_law(5, exponent, static_cast<int>(exact / 10)), convergence).samples_for(0.05);
    EXPECT_GT(samples.median, exact / 1.25) << exponent;
    EXPECT_LT(samples.median, exact * 1.25) << exponent;
    EXPECT_LE(samples.low, transport::error_check_from(static_cast<int>(exact)));
    EXPECT_GE(samples.high, exact);
    EXPECT_LT(samples.high / samples.low, 2.5) << exponent;
  }
}

TEST(Forecast, IsExactForWhatWasReached) {
  const ForecastValue samples = Forecast(power_law(1, 0.5, 1000), Convergence::Sobol).samples_for(0.1);
  EXPECT_EQ(samples.low, 100);  // 1 / sqrt(100) is 0.1
  EXPECT_EQ(samples.median, samples.low);
  EXPECT_EQ(samples.high, samples.low);
}

TEST(Forecast, IsLessCertainFromOneCheck) {
  const auto width = [](const std::vector<ErrorCheck>& checks) {
    const ForecastValue samples = Forecast(checks, Convergence::Sobol).samples_for(0.001);
    return samples.high / samples.low;
  };
  EXPECT_GT(width(power_law(1, 0.6, 16)), 2 * width(power_law(1, 0.6, 200)));
}

TEST(Forecast, SaysThatNoRenderReachesZero) {
  const ForecastValue samples = Forecast(power_law(1, 0.5, 100), Convergence::Sobol).samples_for(0);
  EXPECT_TRUE(std::isinf(samples.low));
}

TEST(Forecast, HoldsAsOftenAsStatedForMonteCarloErrors) {
  const double inside = coverage(30, 0.5, Convergence::Independent);
  EXPECT_GT(inside, 0.87);
  EXPECT_LT(inside, 0.995);
}

TEST(Forecast, HoldsAsOftenAsStatedForSobolErrors) {
  double inside = 0;
  const std::array exponents = {0.55, 0.65, 0.75, 0.85};
  for (const double exponent : exponents)
    inside += coverage(50, exponent, Convergence::Sobol) / exponents.size();
  EXPECT_GT(inside, 0.87);
  EXPECT_LT(inside, 0.995);
}

TEST(Forecast, WidensWithTheTilesThatWereNotRendered) {
  std::vector<ErrorCheck> checks = power_law(1, 0.5, 200);
  const ForecastValue whole = Forecast(checks, Convergence::Independent).samples_for(0.02);
  for (ErrorCheck& check : checks) check.sampling_deviation = 0.2;
  const ForecastValue part = Forecast(checks, Convergence::Independent).samples_for(0.02);
  // With a = 1/2, an error that is larger by exp(1.645 x 0.2) needs the square of that factor.
  EXPECT_NEAR(std::log(part.high / whole.median), 2 * 1.645 * 0.2, 0.25);
  EXPECT_NEAR(std::log(part.low / whole.median), -2 * 1.645 * 0.2, 0.25);
}

TEST(ErrorChecks, GrowByAFifth) {
  int before = 16;
  EXPECT_EQ(transport::error_check_from(1), 16);
  for (int i = 0; i < 60; ++i) {
    const int next = transport::error_check_from(before + 1);
    EXPECT_EQ(transport::error_check_from(next), next);
    EXPECT_NEAR(static_cast<double>(next) / before, 1.2, before < 40 ? 0.06 : 0.03) << before;
    before = next;
  }
}

TEST(RenderCost, GrowsWithSamplesAndChecks) {
  transport::RenderCost cost;
  cost.samples = 100;
  cost.seconds = 10;
  cost.seconds_per_sample = 0.2;  // more than so far: adaptive samples go where paths are long
  cost.deviation = 0;
  const ForecastValue seconds = cost.seconds_for({300, 200, 500});
  EXPECT_NEAR(seconds.median, 10 + 0.2 * 200, 1e-9);
  EXPECT_NEAR(seconds.low, 10 + 0.2 * 100, 1e-9);
  EXPECT_NEAR(seconds.high, 10 + 0.2 * 400, 1e-9);
  EXPECT_NEAR(cost.seconds_for({50, 50, 50}).median, 5, 1e-9);
  cost.deviation = 0.1;
  EXPECT_NEAR(cost.seconds_for({300, 300, 300}).high, 50 * std::exp(0.1645), 1e-6);
  cost.seconds_per_check = 1;
  EXPECT_NEAR(cost.seconds_for({16, 16, 16}).median, 1.6 + 1, 1e-9);
}

TEST(RenderCost, ScalesThatOfAProbe) {
  std::vector<ErrorCheck> checks;
  for (const double samples : {16, 34, 70})
    checks.push_back({samples, certain(0.1), 0, samples * 0.01, samples * 0.001});
  const transport::RenderCost cost = cost_of_image(checks, 25, 0.25);
  EXPECT_NEAR(cost.seconds, 0.7 * 4, 1e-9);
  EXPECT_NEAR(cost.seconds_per_sample, 0.04, 1e-9);
  EXPECT_GT(cost.deviation, 1.1 * cost_of_image(checks, 100, 1).deviation) << "tiles differ";
}

TEST(ForecastTargets, HaveTheRendersOwnOne) {
  EXPECT_EQ(transport::forecast_targets({}), (std::vector{0.05, 0.02, 0.01}));
  EXPECT_EQ(transport::forecast_targets(static_cast<double>(0.02F)), (std::vector{0.05, 0.02, 0.01}));
  EXPECT_EQ(transport::forecast_targets(static_cast<double>(0.03F)), (std::vector{0.05, 0.03, 0.02, 0.01}));
}

}  // namespace
