#include <cmath>

#include <gtest/gtest.h>

#include "renderer/studies/lobe_figure.h"

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
  for (double azimuth = -180; azimuth <= 180; azimuth += 15) {
    for (double elevation = 0; elevation <= 90; elevation += 10) {
      const HemisphereView view(azimuth, elevation, Place);
      for (double theta = 0; theta <= 1.58; theta += 0.1) {
        for (double phi = 0; phi < 6.3; phi += 0.1) {
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

}  // namespace
