#include "renderer/plot/brdf_charts.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "grf/read.h"
#include "renderer/reflectance/presets.h"

namespace plot {
namespace {

reflectance::Brdf brdf_of(const std::string& text) {
  grf::Diagnostics diagnostics;
  return *reflectance::make_brdf(*grf::read_brdf(text, "test", diagnostics));
}

std::vector<LobeCurve> curves_of(const reflectance::Brdf& brdf, const std::vector<double>& views) {
  std::vector<LobeCurve> curves;
  for (const double view : views) curves.push_back(lobe_curve(brdf, view));
  return curves;
}

TEST(LobeCurve, IsWhatTheBrdfIs) {
  for (const reflectance::Preset& preset : reflectance::thesis_models().presets) {
    const reflectance::Brdf brdf = brdf_of(std::string(preset.brdf));
    for (const LobeCurve& curve : curves_of(brdf, {0, 60})) {
      ASSERT_GT(curve.degrees.size(), 1000U);
      const reflectance::Vec3f u = direction_at(-curve.view);
      for (std::size_t i = 0; i < curve.degrees.size(); i += 37) {
        EXPECT_EQ(curve.values[i], reflectance::evaluate(brdf, u, direction_at(curve.degrees[i])));
      }
      EXPECT_EQ(curve.specular_weight, reflectance::specular_weight(brdf, u));
    }
  }
}

TEST(AlbedoCurve, IsThatOfTheModel) {
  const reflectance::Reflector diffuse(brdf_of("diffuse kd=(0.5, 0.25, 0.125)"), reflectance::OwnScheme());
  const AlbedoCurve curve = albedo_curve(diffuse, 256);
  EXPECT_TRUE(curve.along_y.empty());
  EXPECT_EQ(curve.degrees.front(), 0);
  EXPECT_EQ(curve.degrees.back(), 89);
  for (const reflectance::Rgb& albedo : curve.along_x) EXPECT_NEAR(albedo.y, 0.25, 0.005);
  EXPECT_NEAR(curve.largest.albedo, 0.5, 0.005);
  EXPECT_EQ(albedo_chart(curve).series.size(), 3U) << "a line for each channel";
  const reflectance::Reflector gains(brdf_of("minnaert k=0.8 kd=1"), reflectance::OwnScheme());
  const Chart over_one = albedo_chart(albedo_curve(gains, 256));
  EXPECT_NE(over_one.title.find("above 1"), std::string::npos);
  ASSERT_EQ(over_one.series.size(), 2U) << "the albedo, and a line at 1";
  EXPECT_EQ(over_one.series.back().points.front(), Point(0, 1));
}

TEST(LobeChart, HasTheValuesThatAreAskedFor) {
  const std::vector<LobeCurve> curves = curves_of(brdf_of("diffuse kd=(0.6, 0.3, 0)"), {30, 60});
  for (const bool with_cosine : {false, true}) {
    const Chart chart = lobe_chart(curves, {Channel::Green, with_cosine, false});
    ASSERT_EQ(chart.series.size(), 2U);
    EXPECT_EQ(chart.series[1].name, "view 60\u00B0");
    EXPECT_EQ(chart.y.label, with_cosine ? "f cos in 1/sr" : "f in 1/sr");
    for (const Point& point : chart.series[0].points) {
      const double cosine = with_cosine ? std::cos(point.x * std::numbers::pi / 180) : 1;
      EXPECT_NEAR(point.y, 0.3 / std::numbers::pi * cosine, 1e-6);
    }
    EXPECT_EQ(ends_of(chart.y, chart.series, &Point::y).low, 0);
    EXPECT_NEAR(ends_of(chart.y, chart.series, &Point::y).high, 1.08 * 0.3 / std::numbers::pi, 1e-6);
  }
}

TEST(LobeChart, HasMirrorPartsAsLines) {
  const std::vector<LobeCurve> curves = curves_of(brdf_of("specular ks=0.25"), {40});
  Chart chart = lobe_chart(curves, {Channel::Luminance, false, false});
  add_specular_lines(chart, curves, Channel::Luminance);
  const Series& line = chart.series.back();
  EXPECT_EQ(line.points.front(), Point(40, 0));
  EXPECT_NEAR(line.points.back().y, 0.25, 1e-6);
  const PolarChart polar = polar_lobe_chart(curves, {Channel::Luminance, false, false});
  ASSERT_EQ(polar.fractions.size(), 1U);
  EXPECT_NEAR(polar.fractions[0].points.back().y, 0.25, 1e-6);
}

TEST(LobeChart, HasDensitiesInTheColoursOfTheirViews) {
  const reflectance::Brdf ward = brdf_of("ward sx=0.2");
  const reflectance::Reflector reflector(ward, reflectance::OwnScheme());
  const std::vector<LobeCurve> curves = {lobe_curve(ward, 0), lobe_curve(ward, 30, &reflector)};
  const Chart chart = lobe_chart(curves, {});
  ASSERT_EQ(chart.series.size(), 3U);
  EXPECT_EQ(chart.series[2].colour, colour_of_series(1));
  EXPECT_FALSE(chart.series[2].dashes.empty());
  EXPECT_EQ(chart.series[2].points[9].y,
            reflector.pdf(direction_at(-30), direction_at(curves[1].degrees[9])));
}

TEST(SpectrumChart, IsOfBrdfsWithWavelengths) {
  EXPECT_FALSE(spectrum_chart(brdf_of("ward sx=0.2"), std::array{0.0}));
  const std::array views = {0.0, 60.0};
  const auto chart = spectrum_chart(brdf_of("he sigma=0.2 tau=2 kd=0.1"), views);
  ASSERT_TRUE(chart);
  ASSERT_EQ(chart->series.size(), 2U);
  EXPECT_EQ(chart->series[1].name, "view 60\u00B0");
  const Series& series = chart->series[1];
  EXPECT_EQ(series.points.front().x, 380);
  EXPECT_EQ(series.points.back().x, 780);
  for (const Point& point : series.points) {
    if (point.x != 500) continue;
    const auto single = brdf_of("he sigma=0.2 tau=2 kd=0.1 lambda=500");
    EXPECT_NEAR(point.y, reflectance::evaluate(single, direction_at(-60), direction_at(60)).x,
                1e-3 * point.y);
  }
}

TEST(PolarScale, HasRoundRingsUpToTheHighestValue) {
  PolarChart chart;
  chart.series = {{{}, {Point(0, 0.1), Point(10, 0.29)}, {}, {}}};
  const PolarScale linear(chart);
  ASSERT_EQ(linear.rings().size(), 3U);
  EXPECT_NEAR(linear.outermost(), 0.3, 1e-12);
  EXPECT_NEAR(linear.fraction(0.15), 0.5, 1e-12);
  EXPECT_EQ(linear.fraction(7), 1) << "cut";
  chart.series[0].points[1].y = 100;
  chart.is_logarithmic = true;
  const PolarScale logarithmic(chart);
  ASSERT_EQ(logarithmic.rings().size(), 5U);
  EXPECT_NEAR(logarithmic.rings().front(), 0.01, 1e-12);
  EXPECT_NEAR(logarithmic.fraction(1), 0.6, 1e-12);
  EXPECT_EQ(logarithmic.fraction(0), 0);
}

}  // namespace
}  // namespace plot
