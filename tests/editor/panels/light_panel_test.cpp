#include "editor/panels/light_panel.h"

#include <QComboBox>
#include <QFileInfo>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>
#include <QtTest>

#include <gtest/gtest.h>

#include "editor/controls/number_box.h"
#include "editor/controls/scaled_slider.h"
#include "tests/editor/panels/panel_scene.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

class LightPanels : public testing::Test {
 protected:
  LightPanels() : panel_(document_) {
    document_.take(scene_of(PanelScene), {}, {});
    panel_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&panel_));
  }

  template <class Widget>
  Widget* find(const QString& name) const {
    for (Widget* widget : panel_.findChildren<Widget*>()) {
      if (widget->accessibleName() == name) return widget;
    }
    ADD_FAILURE() << "no control is called " << name.toStdString();
    return nullptr;
  }
  void type(const QString& field, const QString& text) {
    auto* box = find<NumberBox>(field);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(box, text);
    QTest::keyClick(box, Qt::Key_Return);
  }
  const grf::AreaLight& light() const { return document_.objects().lights.front().light; }
  QTreeWidget* list() const { return panel_.findChild<QTreeWidget*>(); }

  Document document_;
  LightPanel panel_;
};

TEST_F(LightPanels, ListLightsAndChangeThem) {
  ASSERT_EQ(list()->topLevelItemCount(), 1);
  EXPECT_EQ(list()->topLevelItem(0)->text(2), "3.142");
  list()->setCurrentItem(list()->topLevelItem(0));
  EXPECT_FALSE(find<NumberBox>("Corner, y")->isVisible());
  EXPECT_FALSE(find<NumberBox>("Radius")->isVisible());
  EXPECT_DOUBLE_EQ(find<NumberBox>("Position, x")->value(), 0.5);
  EXPECT_DOUBLE_EQ(find<NumberBox>("Position, y")->value(), 3);
  EXPECT_DOUBLE_EQ(find<NumberBox>("Elevation")->value(), -90);
  type("Power", "60");
  EXPECT_EQ(list()->topLevelItem(0)->text(2), "60");
  type("Width", "2");  // about the centre
  EXPECT_EQ(light().edge1, grf::Vec3f(2, 0, 0));
  EXPECT_EQ(light().corner, grf::Vec3f(-0.5F, 3, 0));
  EXPECT_NEAR(find<NumberBox>("Power")->value(), 120, 1e-3);
  type("Position, y", "4.2");
  EXPECT_EQ(light().corner, grf::Vec3f(-0.5F, 4.2F, 0));
  EXPECT_EQ(document_.undo_stack().count(), 3);
  while (document_.undo_stack().canUndo()) document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), scene_of(PanelScene));
  EXPECT_DOUBLE_EQ(find<NumberBox>("Width")->value(), 1);
}

TEST_F(LightPanels, TurnLights) {
  list()->setCurrentItem(list()->topLevelItem(0));
  type("Elevation", "0");
  type("Yaw", "90");  // toward -x, by the right-hand rule
  const grf::Vec3f normal = light().edge1.cross(light().edge2);
  EXPECT_NEAR(normal.x, -1, 1e-6);
  EXPECT_DOUBLE_EQ(find<NumberBox>("Yaw")->value(), 90);
  EXPECT_EQ(light().edge1.y, 0);
}

TEST_F(LightPanels, SetTheColourTemperatureWithTheSamePower) {
  list()->setCurrentItem(list()->topLevelItem(0));
  EXPECT_FALSE(find<NumberBox>("Colour temperature")->has_value());
  type("Power", "60");
  type("Colour temperature", "2856");
  EXPECT_NEAR(find<NumberBox>("Power")->value(), 60, 1e-3);
  EXPECT_NEAR(find<NumberBox>("Colour temperature")->value(), 2856, 1);
  // CIE illuminant A: x = 0.4476, y = 0.4074, thus X / Z = 3.087.
  const grf::Vec3d rgb(light().radiance.value());
  const double x = 0.4124 * rgb.x + 0.3576 * rgb.y + 0.1805 * rgb.z;
  const double z = 0.0193 * rgb.x + 0.1192 * rgb.y + 0.9505 * rgb.z;
  EXPECT_NEAR(x / z, 3.087, 0.1);
  while (document_.undo_stack().canUndo()) document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), scene_of(PanelScene));
}

TEST_F(LightPanels, EditCornerAndEdgesOfParallelograms) {
  document_.take(scene_of("light begin (0, 1, 0) (1, 0, 0) (1, 0, 1) end\n"), {}, {});
  list()->setCurrentItem(list()->topLevelItem(0));
  EXPECT_TRUE(find<NumberBox>("Corner, y")->isVisible());
  EXPECT_FALSE(find<NumberBox>("Width")->isVisible());
  EXPECT_FALSE(find<QPushButton>("Aim")->isVisible());
  type("Corner, y", "2");
  EXPECT_EQ(light().corner, grf::Vec3f(0, 2, 0));
  type("Power", "10");
  EXPECT_NEAR(emitters_of(document_.objects()).front().power, 10, 1e-5);
  type("Edge 2, x", "0");  // a rectangle now
  EXPECT_FALSE(find<NumberBox>("Corner, y")->isVisible());
  EXPECT_TRUE(find<NumberBox>("Width")->isVisible());
}

TEST_F(LightPanels, AddDiscsAndSpheres) {
  QMenu* menu = find<QToolButton>("Add a light")->menu();
  ASSERT_NE(menu, nullptr);
  ASSERT_EQ(menu->actions().size(), 3);
  for (const int shape : {1, 2}) {
    menu->actions()[shape]->trigger();
    EXPECT_EQ(find<NumberBox>("Elevation")->isVisible(), shape == 1);
    EXPECT_EQ(find<QPushButton>("Aim")->isVisible(), shape == 1);
    EXPECT_FALSE(find<NumberBox>("Roll")->isVisible());
    type("Radius", "0.75");
    type("Power", "40");
    type("Position, x", "-2.5");
    const MeshInstance& instance = document_.objects().instances->back();
    const grf::Matrix44d& to_world = instance.to_world;
    EXPECT_EQ(to_world[0][0], 0.75);
    EXPECT_EQ(to_world[3][0], -2.5);
    EXPECT_NEAR(emitters_of(document_.objects()).back().power, 40, 1e-4);
    EXPECT_EQ(document_.undo_stack().count(), 4);
    QTest::mouseClick(find<QToolButton>("Delete the light"), Qt::LeftButton);
    while (document_.undo_stack().canUndo()) document_.undo_stack().undo();
  }
}

TEST_F(LightPanels, AddAndDeleteLights) {
  EXPECT_FALSE(find<QToolButton>("Delete the light")->isEnabled());
  QTest::mouseClick(find<QToolButton>("Add a light"), Qt::LeftButton);
  ASSERT_EQ(document_.objects().lights.size(), 2U);
  EXPECT_EQ(list()->topLevelItemCount(), 2);
  QTest::mouseClick(find<QToolButton>("Delete the light"), Qt::LeftButton);
  EXPECT_EQ(document_.scene(), scene_of(PanelScene));
}

TEST_F(LightPanels, SelectFacesThatEmit) {
  FaceSelection faces(document_.objects());
  faces.set({1, 1});
  document_.select(faces);
  document_.edit_surfaces("Emit", emission_of_power(document_.objects(), faces, 10, grf::Colour(1)));
  document_.select(FaceSelection(document_.objects()));
  ASSERT_EQ(list()->topLevelItemCount(), 2);
  list()->setCurrentItem(list()->topLevelItem(1));
  EXPECT_EQ(document_.selection(), faces);
}

TEST_F(LightPanels, ChooseRotateAndBrightenTheEnvironment) {
  auto* maps = find<QComboBox>("Environment map");
  ASSERT_EQ(maps->currentIndex(), 0);
  EXPECT_TRUE(find<NumberBox>("Background, red")->isVisible());
  EXPECT_FALSE(find<NumberBox>("Rotation of the environment")->isVisible());
  const QStringList names = {"overcast", "sky", "studio"};
  for (const QString& name : names) EXPECT_GE(maps->findText(name), 0) << name.toStdString();
  maps->setFocus();
  QTest::keyClicks(maps, "sky");
  QTest::keyClick(maps, Qt::Key_Return);
  const options::RenderOptions& options = document_.options().valid_options();
  EXPECT_TRUE(QFileInfo::exists(QString::fromStdString(options.environment)));
  EXPECT_FALSE(find<NumberBox>("Background, red")->isVisible());
  type("Rotation of the environment", "45deg");
  EXPECT_EQ(options.environment_rotation, 45);
  type("Brightness of the environment", "2");
  EXPECT_EQ(options.environment_scale, 2);
  auto* slider = find<ScaledSlider>("Rotation of the environment, slider");
  EXPECT_EQ(slider->number(), 45);
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Home);
  QTRY_COMPARE(options.environment_rotation, -180.0F);
  EXPECT_EQ(find<NumberBox>("Rotation of the environment")->value(), -180);
  EXPECT_NE(document_.options().op_text().text().find("BPT_EM_Scale"), std::string::npos);
  while (document_.undo_stack().canUndo()) document_.undo_stack().undo();
  EXPECT_EQ(options.environment, "");
  EXPECT_EQ(options.environment_rotation, 0);
  EXPECT_TRUE(find<NumberBox>("Background, red")->isVisible());
}

}  // namespace
}  // namespace editor
