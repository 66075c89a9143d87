#include "renderer/studies/lobe_figure.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/reflectance/brdf_instance.h"
#include "renderer/studies/angles.h"
#include "tests/support/svg_reading.h"

namespace {

using studies::HemisphereView;

constexpr plot::Rectangle Place = {{100, 50}, 230, 230};

// From above, the disc is a circle, with y to the left of x for an eye that looks from the positive x axis.
TEST(HemisphereView, ShowsTheDiscFromAbove) {
  const HemisphereView view(0, 90, Place);
  const plot::Point middle = view.point({0, 0, 0});
  const plot::Point x = view.point({1, 0, 0});
  const plot::Point y = view.point({0, 1, 0});
  EXPECT_NEAR(x.x, middle.x, 1e-3);
  EXPECT_GT(x.y, middle.y) << "the side of the eye is below";
  EXPECT_GT(y.x, middle.x) << "a right-handed frame, seen from above";
  EXPECT_NEAR(y.y, middle.y, 1e-3);
  EXPECT_NEAR((x - middle).length(), (y - middle).length(), 1e-3);
  EXPECT_NEAR((view.point({0, 0, 1}) - middle).length(), 0, 1e-3);
}

TEST(HemisphereView, ShowsTheNormalUpwardsFromTheSide) {
  const HemisphereView view(30, 0, Place);
  const plot::Point middle = view.point({0, 0, 0});
  const plot::Point top = view.point({0, 0, 1});
  EXPECT_NEAR(top.x, middle.x, 1e-3);
  EXPECT_LT(top.y, middle.y);
  const float degree = 3.14159265F / 180;
  EXPECT_GT(view.nearness({std::cos(30 * degree), std::sin(30 * degree), 0}), 0.99);
  EXPECT_LT(view.nearness({-std::cos(30 * degree), -std::sin(30 * degree), 0}), -0.99);
}

TEST(HemisphereView, FitsItsPlaceFromAllSides) {
  for (int azimuth = -180; azimuth <= 180; azimuth += 15) {
    for (int elevation = 0; elevation <= 90; elevation += 10) {
      const HemisphereView view(azimuth, elevation, Place);
      for (int i = 0; i <= 15; ++i) {
        const double theta = 0.1 * i;
        for (int k = 0; k <= 62; ++k) {
          const double phi = 0.1 * k;
          const reflectance::Vec3f v(
              Imath::V3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)));
          const plot::Point at = view.point(v);
          ASSERT_GE(at.x, Place.corner.x) << azimuth << ' ' << elevation;
          ASSERT_LE(at.x, Place.corner.x + Place.width);
          ASSERT_GE(at.y, Place.corner.y) << azimuth << ' ' << elevation;
          ASSERT_LE(at.y, Place.corner.y + Place.height);
        }
      }
    }
  }
}

// f of a diffuse BRDF is kd / pi.
constexpr double DiffuseValue = 0.5 / std::numbers::pi;

/// The lobe of a BRDF seen along the normal, with one sample of this value there.
studies::SampledLobe lobe_of(const std::string& instance, double value) {
  grf::Diagnostics diagnostics;
  const auto reflector = reflectance::read_instance(instance, diagnostics);
  if (!reflector) throw std::runtime_error(diagnostics.to_text());
  return {reflector->brdf(), {0, 0, 1}, {plot::Channel::Mean}, {{{{0, 0, 1}}, {value}, "#123456"}}};
}

TEST(SampledLobe, HasTheLongestSampleAtRadius1) {
  const studies::SampledLobe lobe = lobe_of("diffuse kd=0.5", 2 * DiffuseValue);
  EXPECT_NEAR(lobe.position({0, 0, 1}, 2 * DiffuseValue).z, 1, 1e-6);
  EXPECT_NEAR(lobe.position({0.6F, 0, 0.8F}, DiffuseValue).length(), 0.5, 1e-6);
  EXPECT_EQ(lobe.scale_text(), "radius 1 is 0.3183 1/sr");
}

// A lobe that is a little longer than its samples is drawn whole.
TEST(SampledLobe, IsCutWhereItIsMuchLongerThanTheSamples) {
  EXPECT_EQ(lobe_of("diffuse kd=0.5", DiffuseValue / 1.1).scale_text(), "radius 1 is 0.1447 1/sr");
  const studies::SampledLobe cut = lobe_of("diffuse kd=0.5", DiffuseValue / 2);
  EXPECT_EQ(cut.scale_text(), "radius 1 is 0.07958 1/sr; cut: the lobe reaches 0.1592");
  const float longest = cut.position({0, 0, 1}, DiffuseValue).length();
  EXPECT_GT(longest, 1);
  EXPECT_LT(longest, 1.3);
}

TEST(SampledLobe, ShowsTheSpecularPart) {
  const studies::SampledLobe lobe = lobe_of("specular ks=0.4", 0);
  EXPECT_THAT(lobe.scale_text(), testing::EndsWith("; blue line: the specular part, 40 %"));
  const HemisphereView view(60, 25, Place);
  plot::Svg svg(400, 400);
  lobe.draw(view, svg);
  double length = 0;
  for (const auto& line : test::elements(test::svg_of(svg.str()), "line")) {
    if (line.get<std::string>("<xmlattr>.stroke") != "#2b7bba") continue;
    length = line.get<double>("<xmlattr>.y1") - line.get<double>("<xmlattr>.y2");
  }
  EXPECT_NEAR(length, 0.4 * (view.point({0, 0, 0}).y - view.point({0, 0, 1}).y), 0.1);
}

TEST(ViewedText, HasAnAzimuthWithinHalfATurn) {
  const auto text = [](double theta, double phi) {
    return studies::viewed_text({theta * studies::Degree, phi * studies::Degree});
  };
  EXPECT_EQ(text(40, -40), "viewed at \u03B8 = 40\u00B0, \u03C6 = \u221240\u00B0");
  EXPECT_EQ(text(0, 270), "viewed at \u03B8 = 0\u00B0, \u03C6 = \u221290\u00B0");
  // Pi in float is more than pi.
  EXPECT_EQ(studies::viewed_text({0, double(std::numbers::pi_v<float>)}),
            "viewed at \u03B8 = 0\u00B0, \u03C6 = 180\u00B0");
}

}  // namespace
