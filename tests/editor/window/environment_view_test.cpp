// The environment of a scene, seen and turned through the whole window, by pointer and keyboard.
#include <QComboBox>
#include <QDockWidget>
#include <QImage>
#include <fstream>

#include <gtest/gtest.h>

#include "editor/brdf/brdf_editor.h"
#include "editor/controls/number_box.h"
#include "editor/view/environment_store.h"
#include "renderer/transport/image/image_encoders.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

const char* const GlossySquare =
    "begin mesh \"square\" brdf ward sx=0.2 ks=0.5 kd=0.3 begin vertexs (-1,-1,0) (1,-1,0) (1,1,0) (-1,1,0) "
    "end vertexs begin faces (0,1,2,3) end faces end mesh\n";

/// A map that is red on the left, towards -x, and green on the right.
std::string red_and_green() {
  transport::Image image = {64, 32, {}};
  for (int i = 0; i < 64 * 32; ++i)
    image.pixels.emplace_back(i % 64 < 32 ? reflectance::Rgb(0.5F, 0, 0) : reflectance::Rgb(0, 0.5F, 0));
  return transport::encode_pfm({image});
}

class EnvironmentInWindow : public Authoring {
 protected:
  EnvironmentInWindow() {
    folder_.add("halves.pfm", red_and_green());
    std::ofstream(folder_.path("scene.grf")) << GlossySquare;
    std::ofstream(folder_.path("scene.op"))
        << "BPT_Scene scene.grf\nBPT_Viewer 0 0 5\nBPT_VLook 0 0 0\nBPT_FieldOfView 40\n"
           "BPT_Image_Resolution 300 200\nBPT_EM_Background halves.pfm\n";
    open(path("scene.grf"));
    window_.findChild<QDockWidget*>("lights")->show();
    window_.findChild<QDockWidget*>("lights")->raise();
  }

  bool is_drawn() {
    return QTest::qWaitFor(
        [this] { return window_.environment().is_complete() && window_.view().is_complete(); }, test::Minute);
  }
  /// The colour beside the left border of the view.
  QColor on_the_left() {
    EXPECT_TRUE(is_drawn());
    QTest::qWait(50);
    EXPECT_TRUE(is_drawn());
    return window_.view().grab().toImage().pixelColor(12, window_.view().height() / 4);
  }
  void type(const QString& field, const QString& text) {
    auto& box = test::named<NumberBox>(window_, field);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
  }
};

TEST_F(EnvironmentInWindow, IsSeenAndTurnedInTheView) {
  QTest::keyClick(&window_, Qt::Key_8, Qt::AltModifier);
  ASSERT_EQ(window_.view().mode(), DisplayMode::Brdf);
  QColor colour = on_the_left();
  EXPECT_GT(colour.red(), 150);
  EXPECT_LT(colour.green(), 20);
  // Half a turn: what was on the right is on the left.
  type("Rotation of the environment", "180");
  colour = on_the_left();
  EXPECT_LT(colour.red(), 20);
  EXPECT_GT(colour.green(), 150);
  EXPECT_EQ(window_.environment().readings(), 1);
  const int bright = colour.green();
  type("Brightness of the environment", "0.3");
  EXPECT_LT(on_the_left().green(), bright - 40);
  document().undo_stack().undo();
  document().undo_stack().undo();
  EXPECT_GT(on_the_left().red(), 150);
  QTest::keyClick(&window_, Qt::Key_3, Qt::AltModifier);
  colour = on_the_left();
  EXPECT_LT(std::abs(colour.red() - colour.green()), 30) << "solid faces have a plain background";
}

TEST_F(EnvironmentInWindow, LightsTheSphereOfTheBrdfDock) {
  ASSERT_TRUE(is_drawn());
  QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, window_.view().rect().center() + QPoint(60, 60));
  ASSERT_EQ(document().selection().count(), 1U);
  LiveSphere& sphere = window_.brdf_editor().sphere();
  const auto shown = [&] {
    EXPECT_TRUE(QTest::qWaitFor([&] { return sphere.image().side > 0 && !sphere.is_busy(); }, test::Minute));
    return sphere.image();
  };
  /// The channels of a point at the sphere's left rim.
  const auto at_the_left = [&] {
    const SphereImage image = shown();
    return image.radiance[static_cast<std::size_t>(image.side / 2 * image.side + image.side / 10)];
  };
  const reflectance::Rgb in_studio = at_the_left();
  EXPECT_GT(in_studio.z, 0.05F);
  auto& light = test::named<QComboBox>(window_.brdf_editor(), "Light of the sphere");
  ASSERT_TRUE(light.isEnabled());
  light.setFocus();
  QTest::keyClick(&light, Qt::Key_Down);
  ASSERT_EQ(light.currentText(), "Environment");
  reflectance::Rgb in_map = at_the_left();
  EXPECT_GT(in_map.x, 2 * in_map.y) << "red is on the left";
  EXPECT_EQ(in_map.z, 0);
  type("Rotation of the environment", "180");
  QTest::qWait(50);
  in_map = at_the_left();
  EXPECT_GT(in_map.y, 2 * in_map.x);
  // Without a map there is nothing to choose, and the studio lights the sphere.
  auto& maps = test::named<QComboBox>(window_, "Environment map");
  maps.setFocus();
  QTest::keyClick(&maps, Qt::Key_Home);
  QTest::keyClick(&maps, Qt::Key_Return);
  ASSERT_EQ(document().options().valid_options().environment, "");
  EXPECT_FALSE(light.isEnabled());
  EXPECT_EQ(at_the_left(), in_studio);
}

}  // namespace
}  // namespace editor
