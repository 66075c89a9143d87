// Files of the RGL data base, against the analytic BRDFs that an independent program, rgl_files.py, made them
// of.
#include <cmath>
#include <fstream>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/reflectance/brdf_maker.h"
#include "renderer/reflectance/halton.h"
#include "renderer/reflectance/rgl_data.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/rgl_cases.h"
#include "tests/statistics/chi_square.h"
#include "tests/statistics/quadrature.h"

namespace {

using Imath::V2d;
using Imath::V3d;
using nlohmann::json;
using reflectance::Rgb;
using reflectance::RglData;
using reflectance::Vec3f;

std::shared_ptr<const RglData> load(const std::string& name) {
  grf::Diagnostics diagnostics;
  auto data = RglData::load(test::rgl_path(name), diagnostics);
  EXPECT_NE(data, nullptr) << diagnostics.to_text();
  return data;
}

const json& expected_values() {
  static const json table =
      json::parse(std::ifstream(GRANADA_SOURCE_DIR "/tests/reflectance/rgl/values.json"));
  return table;
}

struct Case {
  std::string name;
  double at_nodes = 0;  ///< largest relative error of interpolation where the view is at nodes of the tables
  double between = 0;   ///< elsewhere
  /// Errors are relative to a value of at least this, in 1/sr: colours that vary over a lobe's tail, which
  /// takes few nodes, are interpolated roughly.
  double least = 0;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class Rgl : public testing::TestWithParam<Case> {
 protected:
  const std::shared_ptr<const RglData> data_ = load(GetParam().name);

  void expect_values(const json& lines, double tolerance) const {
    for (const json& line : lines) {
      const json& pair = line["pair"];
      const V3d value = data_->evaluate(test::direction_in_double(pair[0], pair[1]),
                                        test::direction_in_double(pair[2], pair[3]));
      for (int k = 0; k < 3; ++k) {
        const double expected = line["rgb"][static_cast<std::size_t>(k)];
        EXPECT_NEAR(value[k], expected, tolerance * std::max(expected, GetParam().least))
            << pair << " channel " << k;
      }
    }
  }
};

TEST_P(Rgl, HasTheValuesOfTheBrdfThatTheFileWasMadeOf) {
  expect_values(expected_values()[GetParam().name]["at_nodes"], GetParam().at_nodes);
}

TEST_P(Rgl, InterpolatesBetweenViewDirections) {
  expect_values(expected_values()[GetParam().name]["between"], GetParam().between);
}

std::vector<Vec3f> views() {
  std::vector<Vec3f> list;
  for (const double theta : {0.0, 20.0, 33.0, 60.0, 80.0, 89.0})
    list.emplace_back(test::direction_in_double(theta, 25 + 3 * theta));
  return list;
}

TEST_P(Rgl, SamplesItsDensity) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const Vec3f& u : views()) {
    const V3d in_double(u);
    const auto pdf = [&](const Vec3f& v) { return data_->pdf(in_double, V3d(v)); };
    const statistics::ChiSquareTest chi_square(pdf, reflectance::mirrored(u), 3);
    const auto sample = [&]() -> std::optional<Vec3f> {
      const double x = uniform(random);
      const Vec3f v(data_->direction(in_double, V2d(x, uniform(random))));
      return v.z > 0 ? std::optional(v) : std::nullopt;
    };
    EXPECT_GT(chi_square.p_value(sample, 50000), statistics::significance(30)) << u;
    EXPECT_LT(chi_square.mass(), 1.001);
  }
}

TEST_P(Rgl, AgreesWithItsParts) {
  std::mt19937 random(6);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (const Vec3f& u : views()) {
    for (int i = 0; i < 200; ++i) {
      const float x = uniform(random);
      const V3d v(reflectance::uniform_direction({x, uniform(random)}));
      const reflectance::Reflection both = data_->reflect(V3d(u), v);
      EXPECT_EQ(both.value, Rgb(data_->evaluate(V3d(u), v)));
      EXPECT_EQ(both.pdf, static_cast<float>(data_->pdf(V3d(u), v)));
    }
  }
}

TEST_P(Rgl, EstimatesItsAlbedo) {
  const reflectance::Rgl brdf{data_};
  for (const double theta : {0.0, 25.0, 60.0}) {
    const Vec3f u(test::direction_in_double(theta, 40));
    const double albedo =
        statistics::Quadrature(
            [&](const Vec3f& v) { return double(reflectance::mean(brdf.evaluate(u, v)) * v.z); },
            reflectance::mirrored(u), 1e-6, 3)
            .over_hemisphere();
    EXPECT_NEAR(brdf.albedo_estimate(u), std::min(1.0, albedo), 0.05 * albedo) << theta;
  }
}

TEST_P(Rgl, IsBlackBelowTheHorizonAndFiniteAnywhere) {
  for (const V3d& u : {V3d(0, 0, 1), V3d(1, 0, 0), V3d(-1, 0, 1e-9), V3d(0, 1, 1e-5).normalized(),
                       V3d(0, 0, -1), test::direction_in_double(40, 180), test::direction_in_double(40, -180),
                       test::direction_in_double(40, 90), test::direction_in_double(89.99, 0)}) {
    for (const V3d& v : {V3d(0, 0, 1), V3d(-1, 0, 0), V3d(1, 0, 1e-9), V3d(0, -1, 1e-5).normalized(),
                         V3d(0.6, 0, -0.8), V3d(-u.x, -u.y, u.z), u}) {
      const V3d value = data_->evaluate(u, v);
      const double pdf = data_->pdf(u, v);
      for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isfinite(value[k]) && value[k] >= 0) << u << v;
      EXPECT_TRUE(std::isfinite(pdf) && pdf >= 0) << u << v;
      if (u.z <= 0 || v.z <= 0) {
        EXPECT_EQ(value, V3d(0));
        EXPECT_EQ(pdf, 0);
      }
    }
  }
}

// The seams of the azimuth, and of the mirror planes and the half turn of files that lack part of the circle.
TEST_P(Rgl, IsContinuousInTheAzimuth) {
  // Both ends of a half turn have the same tables only within the error of interpolation.
  const auto tolerance = [](double value) { return 2e-3 * value + 5e-4; };
  for (double phi = -180; phi <= 360; phi += 45) {
    const V3d v = test::direction_in_double(30, 200);
    const V3d before = data_->evaluate(test::direction_in_double(35, phi - 1e-4), v);
    const V3d after = data_->evaluate(test::direction_in_double(35, phi + 1e-4), v);
    EXPECT_NEAR(before.x, after.x, tolerance(before.x)) << phi;
    const V3d swapped = data_->evaluate(v, test::direction_in_double(35, phi - 1e-4));
    EXPECT_NEAR(swapped.x, data_->evaluate(v, test::direction_in_double(35, phi + 1e-4)).x,
                tolerance(swapped.x))
        << phi;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Rgl,
                         testing::Values(Case{"copper", 0.045, 0.03, 0.1}, Case{"matte", 0.03, 0.05, 0.1},
                                         Case{"brushed", 0.05, 0.08, 0.1},
                                         Case{"brushed_half", 0.06, 0.08, 0.1},
                                         Case{"brushed_quarter", 0.08, 0.05, 0.1}),
                         [](const auto& instance) { return instance.param.name; });

V3d turned(const V3d& w, double angle) {
  return {std::cos(angle) * w.x - std::sin(angle) * w.y, std::sin(angle) * w.x + std::cos(angle) * w.y, w.z};
}

TEST(RglFiles, HaveTheirSymmetries) {
  const V3d u = test::direction_in_double(35, 24);
  const V3d v = test::direction_in_double(50, 160);
  const auto copper = load("copper");
  const auto half = load("brushed_half");
  const auto quarter = load("brushed_quarter");
  EXPECT_TRUE(copper->is_isotropic());
  EXPECT_FALSE(half->is_isotropic());
  EXPECT_NEAR(copper->evaluate(turned(u, 1.3), turned(v, 1.3)).x, copper->evaluate(u, v).x, 1e-9);
  EXPECT_NEAR(half->evaluate(turned(u, M_PI), turned(v, M_PI)).x, half->evaluate(u, v).x, 1e-9);
  EXPECT_NEAR(quarter->evaluate({-u.x, u.y, u.z}, {-v.x, v.y, v.z}).x, quarter->evaluate(u, v).x, 1e-9);
  EXPECT_NEAR(quarter->evaluate({u.x, -u.y, u.z}, {v.x, -v.y, v.z}).x, quarter->evaluate(u, v).x, 1e-9);
  EXPECT_GT(std::abs(half->evaluate(turned(u, 1), turned(v, 1)).x - half->evaluate(u, v).x), 0.01);
}

TEST(RglFiles, HaveSpectra) {
  const auto data = load("copper");
  ASSERT_EQ(data->wavelengths().size(), 10U);
  EXPECT_EQ(data->wavelengths()[3], 500);
  EXPECT_EQ(data->description(), "copper of rgl_files.py");
  int compared = 0;
  for (const json& line : expected_values()["copper"]["at_nodes"]) {
    const json& pair = line["pair"];
    const auto spectrum = data->spectrum(test::direction_in_double(pair[0], pair[1]),
                                         test::direction_in_double(pair[2], pair[3]));
    ASSERT_EQ(spectrum.size(), 10U);
    for (std::size_t i = 0; i < spectrum.size(); ++i) {
      const double expected = line["spectrum"][i];
      if (expected < 0.05) continue;
      EXPECT_NEAR(spectrum[i], expected, 0.1 * expected) << pair;
      ++compared;
    }
  }
  EXPECT_GT(compared, 100);
  EXPECT_TRUE(load("matte")->wavelengths().empty());
  EXPECT_TRUE(load("matte")->spectrum({0, 0, 1}, {0, 0, 1}).empty());
}

// The tables' view directions are eight, and their grids coarse.
TEST(RglFiles, ReflectAllLightIfWhite) {
  const reflectance::Rgl matte{load("matte")};
  for (const double theta : {0.0, 12.0, 20.0, 38.0, 63.0}) {
    const Vec3f u(test::direction_in_double(theta, 10));
    double sum = 0;
    constexpr std::uint32_t Count = 20000;
    for (std::uint32_t i = 0; i < Count; ++i) {
      const auto sample = matte.sample(u, reflectance::halton_point(i));
      if (!sample) continue;
      EXPECT_NEAR(sample->pdf, matte.pdf(u, sample->direction), 1e-3F * sample->pdf);
      EXPECT_NEAR(sample->weight.x,
                  matte.evaluate(u, sample->direction).x * sample->direction.z / sample->pdf,
                  1e-3F * sample->weight.x);
      sum += double(sample->weight.x);
    }
    EXPECT_NEAR(sum / Count, 1, 0.02) << theta;
  }
}

TEST(RglFiles, AreLoadedOnceForAllThatNameThem) {
  grf::Diagnostics diagnostics;
  reflectance::BrdfMaker maker(diagnostics);
  grf::BrdfModel data;
  data.keyword = "rgl";
  EXPECT_FALSE(maker.make(data, {}));
  EXPECT_EQ(diagnostics.entries().back().message, "'rgl' needs the name of a data file");
  data.data_file = test::rgl_path("matte");
  const auto first = maker.make(data, {});
  const auto second = maker.make(data, {});
  ASSERT_TRUE(first && second) << diagnostics.to_text();
  EXPECT_EQ(std::get<reflectance::Rgl>(*first).data, std::get<reflectance::Rgl>(*second).data);
  EXPECT_FALSE(is_anisotropic(*first));
  data.keyword = "measured";
  EXPECT_FALSE(maker.make(data, {})) << "the same file is not a MERL file";
  EXPECT_EQ(evaluate(reflectance::Rgl(), Vec3f(0, 0, 1), Vec3f(0, 0, 1)), Rgb(0)) << "without data";
}

}  // namespace
