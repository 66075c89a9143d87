// Residuals and derivatives of the least-squares problem.
#include "renderer/fit/problem.h"

#include <cmath>
#include <numbers>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/fit/fit_cases.h"
#include "tests/reflectance/random_models.h"

namespace {

using fit::Metric;
using fit::Problem;
using test::observations_of;

std::vector<fit::Lobe> lobes_of(const std::vector<std::string>& keywords,
                                const fit::Observations& observations) {
  grf::Diagnostics diagnostics;
  auto lobes = fit::lobes_of(keywords, {}, observations, diagnostics);
  if (!lobes) throw std::runtime_error(diagnostics.to_text());
  return *lobes;
}

struct Evaluated {
  std::vector<double> residuals;
  std::vector<double> jacobian;
};

Evaluated evaluated(const Problem& problem, const std::vector<double>& x) {
  Evaluated all{std::vector<double>(problem.residual_count()),
                std::vector<double>(problem.residual_count() * problem.unknown_count())};
  EXPECT_TRUE(problem.evaluate(x, all.residuals, all.jacobian));
  return all;
}

// kd/pi + ks (u.r)^n, whose derivatives are elementary. The coordinate of n is log(1+n)/log(1+1e6).
TEST(FitProblem, HasTheDerivativesOfPhong) {
  const fit::Observations observations = observations_of("phong n=30 ks=0.3 kd=0.4", 500);
  const auto lobes = lobes_of({"phong"}, observations);
  const Problem problem(lobes, observations, Metric::L2);
  ASSERT_EQ(problem.shape_count(), 1U);
  ASSERT_EQ(problem.unknown_count(), 3U);  // n, ks and kd: the data are grey
  const double scale = std::log(1e6 + 1);
  const std::vector<double> x = {std::log(21.0) / scale, 0.5, 0.25};
  const Evaluated all = evaluated(problem, x);
  for (std::size_t k = 0; k < observations.list.size(); ++k) {
    const fit::Observation& one = observations.list[k];
    const double cosine = std::max(0.0, one.v.z * one.u.z - one.v.x * one.u.x - one.v.y * one.u.y);
    const double lobe = std::pow(cosine, 20);
    const double f = 0.25 / std::numbers::pi + 0.5 * lobe;
    EXPECT_NEAR(all.residuals[k], (f - one.value.x) * one.v.z, 1e-5);
    const double by_n = cosine > 0 ? 0.5 * std::log(cosine) * lobe : 0;
    EXPECT_NEAR(all.jacobian[3 * k], by_n * 21 * scale * one.v.z, 1e-5);
    EXPECT_NEAR(all.jacobian[3 * k + 1], lobe * one.v.z, 1e-5);
    EXPECT_NEAR(all.jacobian[3 * k + 2], one.v.z / std::numbers::pi, 1e-12);
  }
}

TEST(FitProblem, HasTheMetricsOfTheirDefinition) {
  fit::Observations observations = observations_of("diffuse kd=0.5", 50);
  for (fit::Observation& one : observations.list) one.value = fit::Vec3d(0.3);
  const auto lobes = lobes_of({"diffuse"}, observations);
  const std::vector<double> x = {0.7};
  for (const Metric metric : fit::Metrics) {
    const Problem problem(lobes, observations, metric);
    const Evaluated all = evaluated(problem, x);
    for (std::size_t k = 0; k < observations.list.size(); ++k) {
      const double data = 0.3 * observations.list[k].v.z;
      const double value = 0.7 / std::numbers::pi * observations.list[k].v.z;
      const double expected = metric == Metric::CubeRoot ? std::cbrt(value) - std::cbrt(data)
                              : metric == Metric::Log    ? std::log(1 + value) - std::log(1 + data)
                                                         : value - data;
      EXPECT_NEAR(all.residuals[k], expected, 1e-6);
    }
  }
}

TEST(FitProblem, WeighsByRootOfWeightAndByDeviation) {
  fit::Observations observations = observations_of("diffuse kd=0.5", 2);
  const auto lobes = lobes_of({"diffuse"}, observations);
  const std::vector<double> x = {0.7};
  const Evaluated plain = evaluated(Problem(lobes, observations, Metric::L2), x);
  observations.list[0].weight = 9;
  observations.list[1].deviation = 0.02;
  const Evaluated weighed = evaluated(Problem(lobes, observations, Metric::L2), x);
  EXPECT_NEAR(weighed.residuals[0], 3 * plain.residuals[0], 1e-12);
  EXPECT_NEAR(weighed.residuals[1], (0.7 - 0.5) / std::numbers::pi / 0.02, 1e-6);
}

TEST(FitProblem, SolvesWeightsWithinTheirLimits) {
  const fit::Observations observations = observations_of("phong n=30 ks=0.3 kd=0.4", 500);
  const auto lobes = lobes_of({"phong"}, observations);
  const Problem problem(lobes, observations, Metric::CubeRoot);
  std::vector<double> x = {lobes[0].shapes[0].coordinate(30), 0, 0};
  ASSERT_TRUE(problem.solve_weights(x));
  EXPECT_NEAR(x[1], 0.3, 1e-4);
  EXPECT_NEAR(x[2], 0.4, 1e-4);
  fit::Observations bright = observations;
  for (fit::Observation& one : bright.list) one.value *= 10;
  const Problem limited(lobes, bright, Metric::CubeRoot);
  ASSERT_TRUE(limited.solve_weights(x));
  EXPECT_EQ(x[1], 1);
  EXPECT_EQ(x[2], 1);
}

template <class Model>
class FitDerivatives : public testing::Test {};
TYPED_TEST_SUITE(FitDerivatives, test::TypesOf<reflectance::FormulaBrdf>::Types, test::KeywordOf);

// What gltf transmits below a film depends on its brightest channel. Colours of films are pale, and another
// channel becomes the brightest every few nanometres: derivatives have steps there.
bool is_of_pale_film(std::string_view keyword, std::string_view parameter) {
  return keyword == "gltf" && (parameter == "iridescenceIor" || parameter == "filmThickness");
}

// Differences over two longer steps, extrapolated, with an error of the fourth order.
TYPED_TEST(FitDerivatives, AgreeWithDifferences) {
  const std::string keyword(TypeParam::table().keyword);
  if (keyword == "specular" || keyword == "glass") return;  // has values in its delta part only
  const fit::Observations observations = observations_of("ward sx=0.3 sy=0.5 ks=0.5 kd=(0.5, 0.3, 0.1)", 30);
  const auto lobes = lobes_of({keyword}, observations);
  const Problem problem(lobes, observations, Metric::L2);
  for (const double t : {0.02, 0.31, 0.57}) {
    std::vector<double> x(problem.unknown_count(), 0.5);
    for (std::size_t i = 0; i < problem.shape_count(); ++i) x[i] = t + 0.01 * static_cast<double>(i);
    if (!problem.cost(x)) continue;  // the peak of a lafortune lobe may be too high
    const Evaluated all = evaluated(problem, x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (i < problem.shape_count() && is_of_pale_film(keyword, lobes[0].shapes[i].name)) continue;
      const auto at = [&](double step) {
        std::vector<double> moved = x;
        moved[i] += step;
        // Shapes are rounded to floats: the step is the one that was made.
        if (i < problem.shape_count()) {
          const fit::ShapeParameter& shape = lobes[0].shapes[i];
          moved[i] = shape.coordinate(shape.value(moved[i]));
        }
        return std::pair(moved[i], evaluated(problem, moved).residuals);
      };
      const double step = 2e-4;
      const auto [far_high, values_far_high] = at(2 * step);
      const auto [far_low, values_far_low] = at(-2 * step);
      const auto [high, values_high] = at(step);
      const auto [low, values_low] = at(-step);
      double largest = 0;
      double worst = 0;
      for (std::size_t k = 0; k < all.residuals.size(); ++k) {
        const double wide = (values_far_high[k] - values_far_low[k]) / (far_high - far_low);
        const double narrow = (values_high[k] - values_low[k]) / (high - low);
        const double derivative = all.jacobian[k * x.size() + i];
        largest = std::max(largest, std::abs(narrow));
        worst = std::max(worst, std::abs((4 * narrow - wide) / 3 - derivative));
      }
      EXPECT_LE(worst, 1e-4 * largest + 1e-9) << keyword << " unknown " << i << " at " << t;
    }
  }
}

}  // namespace
