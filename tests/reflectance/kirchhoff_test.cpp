// Wave optics: the series of `he` and `westin`, and limits of the two models.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/reflectance/albedo.h"

namespace {

using reflectance::Rgb;
using reflectance::Vec3f;
using reflectance::glsl::HeFormula;
using test::direction;

long double log_of_term(long double m, long double g, long double b) {
  return m * std::log(g) - g - std::lgamma(m + 1) - std::log(m) - b / m;
}

/// Sums the series term by term, 14 widths about its largest.
double long_sum(long double g, long double b) {
  long double low = 1;
  long double high = 2 * g + 2 * std::sqrt(b) + 10;
  while (high - low > 1) {
    const long double m = std::floor((low + high) / 2);
    (m * m * std::log(m / g) < b ? low : high) = m;
  }
  const long double centre = low;
  const long double width = 14 * std::sqrt(centre) + 60;
  long double sum = 0;
  const auto last = static_cast<long>(centre + width);
  for (auto m = static_cast<long>(std::max(1.0L, centre - width)); m <= last; ++m)
    sum += std::exp(log_of_term(static_cast<long double>(m), g, b));
  return static_cast<double>(sum);
}

struct SeriesPoint {
  double g, b, sum;
};

/// Returns points from nearly smooth to very rough, on both branches of the sum, down to the smallest floats.
std::vector<SeriesPoint> series_points() {
  std::vector<SeriesPoint> points;
  for (int quarter = -24; quarter <= 24; ++quarter) {
    const double g = std::pow(10, quarter / 4.0);
    for (const double slope : {0.0, 1e-6, 1e-3, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0}) {
      const double b = slope * std::max(g, 1.0);
      const double sum = long_sum(g, b);
      if (sum > 1e-30) points.push_back({g, b, sum});
    }
  }
  return points;
}

TEST(KirchhoffSeries, IsItsTermsInDouble) {
  for (const SeriesPoint& point : series_points()) {
    const double sum = HeFormula<double>().kirchhoff_sum(point.g, point.b);
    ASSERT_NEAR(sum, point.sum, 1e-10 * point.sum) << point.g << " " << point.b;
  }
}

TEST(KirchhoffSeries, IsItsTermsInFloat) {
  for (const SeriesPoint& point : series_points()) {
    const float g = static_cast<float>(point.g);
    const float b = static_cast<float>(point.b);
    const double exact = HeFormula<double>().kirchhoff_sum(g, b);
    ASSERT_NEAR(HeFormula<float>().kirchhoff_sum(g, b), exact, 1e-4 * exact) << g << " " << b;
  }
}

TEST(KirchhoffSeries, TendsToItsAsymptotes) {
  EXPECT_EQ(HeFormula<double>().kirchhoff_sum(0, 1), 0);
  EXPECT_NEAR(HeFormula<double>().kirchhoff_sum(1e-6, 0), 1e-6, 1e-12);
  for (const double g : {1e3, 1e6, 1e12}) {
    EXPECT_NEAR(HeFormula<double>().kirchhoff_sum(g, 0) * g, 1 + 1 / g, 4 / (g * g) + 1e-12);
    EXPECT_NEAR(HeFormula<double>().kirchhoff_sum(g, g) * g, std::exp(-1), 2 / g);
  }
}

TEST(LambertW, SolvesItsEquation) {
  double x = -60;
  while (x < 1e6) {
    const double w = HeFormula<double>().lambert_w(x);
    ASSERT_NEAR(w + std::log(w), x, 1e-13 * std::max(1.0, std::abs(x))) << x;
    x += 0.37 + std::abs(x) / 50;
  }
}

// sqrt(pi/2) z = (sigma/4) (K_i + K_r) exp(-z^2/(2 sigma^2)).
TEST(He, EffectiveRoughnessIsTheRootOfThePaper) {
  const Imath::V3d u(direction(85, 0));
  const Imath::V3d v(direction(70, 200));
  const double sigma = 0.7;
  const double tau = 0.9;
  const double effective = HeFormula<double>().effective_roughness(u, v, sigma, tau);
  const double z = std::sqrt((sigma / effective) * (sigma / effective) - 1) * sigma;
  double slopes = 0;
  for (const double theta : {85 * M_PI / 180, 70 * M_PI / 180})
    slopes += std::tan(theta) * std::erfc(tau / (2 * sigma * std::tan(theta)));
  EXPECT_NEAR(std::sqrt(M_PI / 2) * z, sigma / 4 * slopes * std::exp(-z * z / (2 * sigma * sigma)), 1e-6);
}

TEST(He, ShadowingCostsNinePerCentWhereSmithsHardlyDoes) {
  const double tan = 10.0 / 3;
  const Imath::V3d w = Imath::V3d(tan, 0, 1).normalized();
  const double shadowing = w.z * HeFormula<double>().kirchhoff_shadowing_over_cosine(w, 0.05, 1);
  EXPECT_NEAR(1 - shadowing, 0.09, 0.005);
}

TEST(He, OfASmoothSurfaceIsAMirror) {
  const Vec3f u = direction(35, 10);
  for (const char* keyword : {"he", "westin"}) {
    const auto brdf = test::brdf_of(std::string(keyword) + " sigma=0 nreal=1.5 ks=(0.8, 0.5, 0.2) kd=0.1");
    EXPECT_EQ(evaluate(brdf, u, reflectance::mirrored(u)), Rgb(0.1F / reflectance::Pi));
    const float fresnel = HeFormula<float>().fresnel(u.z, 1.5F, 0);
    const Rgb weight = std::visit([&](const auto& model) { return specular_weight(model, u); }, brdf);
    EXPECT_NEAR((weight - Rgb(0.8F, 0.5F, 0.2F) * fresnel).length(), 0, 1e-6);
  }
}

TEST(He, MirrorPartFallsWithTheHeightInWavelengths) {
  const Vec3f u = direction(60, 10);
  const double g = std::pow(4 * M_PI * 0.05 * 0.5 / 0.5, 2);
  const auto brdf = std::get<reflectance::Westin>(test::brdf_of("westin sigma=0.05 tau=50 lambda=500"));
  const double shadowing = u.z * HeFormula<double>().kirchhoff_shadowing_over_cosine(Imath::V3d(u), 0.05, 50);
  EXPECT_NEAR(brdf.specular_weight(u).x, shadowing * shadowing * std::exp(-g), 1e-5);
}

// For roughness large in wavelengths it is Beckmann facets of slope 2 sigma/tau, for all wavelengths, except
// for the shadowing.
TEST(He, OfAVeryRoughSurfaceIsBeckmannFacets) {
  const auto rough = test::brdf_of("he sigma=100 tau=1000");
  const auto facets = test::brdf_of("kajiya sigma=100 taux=1000 tauy=1000");
  reflectance::glsl::KajiyaFormula<float> smith;
  HeFormula<float> he;
  for (const double angle : {0.0, 10.0, 30.0}) {
    const Vec3f u = direction(angle, 0);
    const Vec3f v = direction(angle + 4, 200);
    float shadowing = 1;
    for (const Vec3f& w : {u, v})
      shadowing *= he.kirchhoff_shadowing_over_cosine(w, 100, 1000) / smith.smith_over_cosine(w, 0.2F, 0.2F);
    const Rgb expected = evaluate(facets, u, v) * shadowing;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(evaluate(rough, u, v)[k], expected[k], 1e-3F * expected[k]);
  }
}

TEST(Westin, IsHeAwayFromGrazing) {
  const Vec3f u = direction(20, 10);
  const Vec3f v = direction(30, 170);
  const float he = evaluate(test::brdf_of("he"), u, v).x;
  EXPECT_NEAR(evaluate(test::brdf_of("westin"), u, v).x, he, 1e-4F * he);
}

TEST(He, ConservesEnergy) {
  for (const char* keyword : {"he", "westin"}) {
    for (const char* surface : {"sigma=0.02 tau=1", "sigma=0.1 tau=1", "sigma=0.5 tau=3 lambda=800",
                                "sigma=2 tau=2", "sigma=50 tau=300"}) {
      const auto brdf = test::brdf_of(std::string(keyword) + " " + surface);
      for (const double angle : {0.0, 40.0, 70.0, 85.0, 89.0}) {
        const Vec3f u = direction(angle, 25);
        const Rgb weight = std::visit([&](const auto& model) { return specular_weight(model, u); }, brdf);
        EXPECT_LT(test::albedo(brdf, u, 1e-6) + weight.x, 1.002) << keyword << " " << surface << " " << angle;
      }
    }
  }
}

}  // namespace
