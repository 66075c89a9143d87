#include "editor/brdf/lobe_view.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "editor/appearance/theme.h"
#include "editor/brdf/compiled_brdf.h"
#include "grf/read.h"
#include "tests/editor/brdf/brdf_of.h"

namespace editor {
namespace {

TEST(LobeMesh, HasTheValuesOverTheHemisphere) {
  const SharedBrdf ward = compiled_brdf_of("ward sx=0.2 sy=0.4");
  for (const double view : {0.0, 45.0, 85.0}) {
    const plot::LobeMesh mesh = plot::lobe_mesh(*ward, plot::direction_at(-view), {});
    ASSERT_EQ(mesh.values.size(), mesh.directions.size());
    for (std::size_t i = 0; i < mesh.directions.size(); i += 31) {
      const double expected =
          plot::channel_of(reflectance::evaluate(*ward, plot::direction_at(-view), mesh.directions[i]),
                           plot::Channel::Luminance);
      EXPECT_NEAR(mesh.values[i], expected, 1e-5 * expected);
      EXPECT_NEAR(mesh.positions[i].length(), expected / mesh.peak, 1e-4);
      EXPECT_GT(mesh.directions[i].z, 0);
    }
  }
}

TEST(LobeMesh, CoversTheHemisphere) {
  // The lobe of a diffuse BRDF is a hemisphere: its volume shows that it is complete and oriented outwards.
  const plot::LobeMesh mesh = plot::lobe_mesh(*compiled_brdf_of("diffuse"), plot::direction_at(-60), {});
  double volume = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const auto& a = mesh.positions[mesh.triangles[i]];
    const auto& b = mesh.positions[mesh.triangles[i + 1]];
    const auto& c = mesh.positions[mesh.triangles[i + 2]];
    volume += a.dot(b.cross(c)) / 6;
  }
  EXPECT_NEAR(volume, 2.0 / 3 * std::numbers::pi, 0.02);
}

TEST(LobeView, DrawsTheLobeAndIsOrbited) {
  LobeView view;
  view.resize(320, 240);
  view.set_brdf(compiled_brdf_of("phong n=20 ks=0.5"));
  view.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !view.is_busy() && view.mesh().peak > 0; }));
  const QImage picture = view.grab().toImage();
  const QColor colour = series_colour(theme_of(view.palette()), 1);
  int lobe_pixels = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const QColor pixel = picture.pixelColor(x, y);
      if (pixel.saturation() > 80 && std::abs(pixel.hue() - colour.hue()) < 12) ++lobe_pixels;
    }
  }
  EXPECT_GT(lobe_pixels, 1000);
  const double before = view.azimuth();
  QTest::mousePress(&view, Qt::LeftButton, {}, {100, 100});
  QTest::mouseMove(&view, {140, 110});
  QTest::mouseRelease(&view, Qt::LeftButton, {}, {140, 110});
  EXPECT_NE(view.azimuth(), before);
  QTest::keyClick(&view, Qt::Key_PageUp);
  EXPECT_EQ(view.view(), 50);
}

}  // namespace
}  // namespace editor
