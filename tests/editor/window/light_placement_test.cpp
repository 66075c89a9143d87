// Lights are aimed and placed by pointing at surfaces in the 3D view of the whole window.
#include <QPushButton>

#include <gtest/gtest.h>

#include "editor/controls/number_box.h"
#include "editor/document/lamp.h"
#include "editor/panels/light_panel.h"
#include "editor/view/scene_view.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

/// A ramp, z = y, under a level light, and what is hit on it.
class LightPlacement : public Authoring {
 protected:
  LightPlacement() {
    folder_.add(
        "ramp.grf",
        "light begin rgb (5, 5, 5) (-0.5, 4, -0.25) (1, 0, 0) (0, 0, 0.5) end\n"
        "begin mesh \"ramp\"\nbegin vertices (-2, -2, 2) (2, -2, 2) (2, 2, -2) (-2, 2, -2) end vertices\n"
        "begin faces (0, 1, 2, 3) end faces\nend mesh\n");
    open(path("ramp.grf"));
    panel().choose(document().objects().lights.front().path);
  }

  LightPanel& panel() { return *window_.findChild<LightPanel*>(); }
  const grf::AreaLight& light() { return document().objects().lights.front().light; }
  grf::Vec3d centre() {
    return grf::Vec3d(light().corner) + (grf::Vec3d(light().edge1) + grf::Vec3d(light().edge2)) / 2;
  }
  grf::Vec3d normal() { return grf::Vec3d(light().edge1).cross(grf::Vec3d(light().edge2)).normalized(); }
  QPoint pixel(double x, double y) {
    return {static_cast<int>(x * window_.view().width()), static_cast<int>(y * window_.view().height())};
  }
  /// The ray of a pixel meets the plane y + z = 0 there.
  grf::Vec3d point_at(QPoint at) {
    const ViewRay ray = ray_at(at);
    return ray.at(-(ray.origin.y + ray.origin.z) / (ray.direction.y + ray.direction.z));
  }
  ViewRay ray_at(QPoint at) {
    const double width = window_.view().width(), height = window_.view().height();
    return window_.view().camera().ray({2 * at.x() / width - 1, 1 - 2 * at.y() / height}, width / height);
  }
  void click_button(const QString& name) {
    QTest::mouseClick(&test::named<QPushButton>(panel(), name), Qt::LeftButton);
  }
  void expect_near(const grf::Vec3d& vector, const grf::Vec3d& expected) {
    EXPECT_LT((vector - expected).length(), 1e-5) << vector << " is not " << expected;
  }
};

TEST_F(LightPlacement, AimsAtAClickedPoint) {
  const grf::Vec3d before = centre();
  const FaceSelection selection = document().selection();
  click_button("Aim");
  const QPoint at = pixel(0.45, 0.55);
  const grf::Vec3d point = point_at(at);
  QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, at);
  expect_near(centre(), before);
  expect_near(normal(), (point - before).normalized());
  EXPECT_EQ(light().edge1.y, 0);
  EXPECT_EQ(document().undo_stack().count(), 1);
  EXPECT_EQ(document().selection(), selection);
  // The next click selects again.
  QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, at);
  EXPECT_EQ(document().undo_stack().count(), 1);
  EXPECT_FALSE(document().selection().empty());
}

TEST_F(LightPlacement, HighlightsFollowADrag) {
  click_button("Highlight");
  const QPoint from = pixel(0.5, 0.5), to = pixel(0.56, 0.44);
  const double distance = (centre() - point_at(from)).length();
  const grf::Scene before = document().scene();
  QTest::mousePress(&window_.view(), Qt::LeftButton, {}, from);
  for (const QPoint at : {from, (from + to) / 2, to}) {
    QTest::mouseMove(&window_.view(), at);
    const grf::Vec3d point = point_at(at);
    // The law of reflection, with the ramp's normal (0, 1, 1) / sqrt(2): y and z swap and change sign.
    const grf::Vec3d view = ray_at(at).direction.normalized();
    const grf::Vec3d mirrored(view.x, -view.z, -view.y);
    expect_near(centre(), point + mirrored * distance);
    expect_near(normal(), -mirrored);
    EXPECT_NEAR(light().edge1.y, 0, 1e-7);
  }
  QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, to);
  EXPECT_EQ(document().undo_stack().count(), 1);
  EXPECT_TRUE(document().selection().empty());
  document().undo_stack().undo();
  EXPECT_EQ(document().scene(), before);
}

TEST_F(LightPlacement, HighlightsReflectAtInterpolatedNormals) {
  folder_.add("smooth.grf",
              "light begin rgb (5, 5, 5) (-0.5, 4, -0.25) (1, 0, 0) (0, 0, 0.5) end\n"
              "begin mesh\nbegin vertices\nnormal (0, 0, 1) (-2, -2, 2)\nnormal (0, 0, 1) (2, -2, 2)\n"
              "normal (0, 1, 0) (2, 2, -2)\nnormal (0, 1, 0) (-2, 2, -2)\nend vertices\n"
              "begin faces (0, 1, 2, 3) end faces\nend mesh\n");
  open(path("smooth.grf"));
  panel().choose(document().objects().lights.front().path);
  click_button("Highlight");
  const QPoint at = pixel(0.47, 0.53);
  const grf::Vec3d point = point_at(at);
  const double distance = (centre() - point).length();
  QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, at);
  // Linear from the lower edge to the upper one.
  const double t = (point.y + 2) / 4;
  const grf::Vec3d normal_there = grf::Vec3d(0, t, 1 - t).normalized();
  const grf::Vec3d to_lamp = (centre() - point).normalized();
  expect_near((to_lamp - ray_at(at).direction.normalized()).normalized(), normal_there);
  expect_near(normal(), -to_lamp);
  EXPECT_NEAR((centre() - point).length(), distance, 1e-5);
}

TEST_F(LightPlacement, EscapeCancels) {
  for (const char* name : {"Aim", "Highlight"}) {
    click_button(name);
    QTest::keyClick(&window_.view(), Qt::Key_Escape);
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, pixel(0.5, 0.5));
    EXPECT_EQ(document().undo_stack().count(), 0) << name;
  }
}

}  // namespace
}  // namespace editor
