// Makes and places cameras through the whole window, by pointer and keyboard.
#include <QDockWidget>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>
#include <fstream>

#include <gtest/gtest.h>

#include "editor/controls/number_box.h"
#include "editor/document/render_camera.h"
#include "editor/panels/camera_panel.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

const char* const Square =
    "begin mesh \"square\" begin vertexs (-1,-1,0) (1,-1,0) (1,1,0) (-1,1,0) end vertexs "
    "begin faces (0,1,2,3) end faces end mesh\n"
    "light begin rgb (5,5,5) (-1,3,-1) (2,0,0) (0,0,2) end\n";

class Cameras : public Authoring {
 protected:
  Cameras() {
    std::ofstream(folder_.path("scene.grf")) << Square;
    std::ofstream(folder_.path("scene.op"))
        << "BPT_Scene scene.grf\nBPT_Viewer 0 0 5\nBPT_VLook 0 0 0\nBPT_FieldOfView 30\n"
           "BPT_Image_Resolution 300 200\n";
    open(path("scene.grf"));
    window_.findChild<QDockWidget*>("cameras")->show();
    window_.findChild<QDockWidget*>("cameras")->raise();
  }

  CameraPanel& panel() { return *window_.findChild<CameraPanel*>(); }
  QTreeWidget& list() { return *panel().findChild<QTreeWidget*>(); }
  const options::RenderOptions& options() { return document().options().valid_options(); }

  template <class Widget>
  Widget& find(const QString& name) {
    for (Widget* widget : panel().findChildren<Widget*>()) {
      if (widget->accessibleName() == name) return *widget;
    }
    throw std::runtime_error("no control is called " + name.toStdString());
  }
  void press(const QString& button) { QTest::mouseClick(&find<QToolButton>(button), Qt::LeftButton); }
  void push(const QString& text) {
    for (QPushButton* button : panel().findChildren<QPushButton*>()) {
      if (button->text() == text) return QTest::mouseClick(button, Qt::LeftButton);
    }
    FAIL() << "no button says " << text.toStdString();
  }
  void type(const QString& field, const QString& text) {
    auto& box = find<NumberBox>(field);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
  }
  QPoint middle_of(QTreeWidgetItem* item, int column) {
    const QRect row = list().visualItemRect(item);
    return {list().columnViewportPosition(column) + 12, row.center().y()};
  }
};

TEST_F(Cameras, AreAddedNamedSelectedAndDeleted) {
  ASSERT_EQ(list().topLevelItemCount(), 1);
  EXPECT_EQ(list().topLevelItem(0)->text(0), "Render camera");
  EXPECT_EQ(find<NumberBox>("Camera: Position, z").value(), 5);
  window_.view().press(Qt::Key_3);  // from the right
  press("Add a camera");
  ASSERT_EQ(options().cameras.size(), 1U);
  EXPECT_GT(options().cameras[0].eye.x, 1);
  EXPECT_NEAR(options().cameras[0].eye.z, 0, 1e-4);
  ASSERT_EQ(list().topLevelItemCount(), 2);
  QTreeWidgetItem* item = list().topLevelItem(1);
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_F2);
  auto* editor = list().findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  QTest::keyClicks(editor, "side");
  QTest::keyClick(editor, Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor([&] { return options().cameras[0].name == "side"; }));
  EXPECT_EQ(options().camera, "");
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, middle_of(item, 1));
  EXPECT_EQ(options().camera, "side");
  EXPECT_NEAR(render_camera(document()).eye.z, 0, 1e-4);
  EXPECT_EQ(list().topLevelItem(0)->checkState(1), Qt::Unchecked);
  press("Delete the camera");
  EXPECT_TRUE(options().cameras.empty());
  EXPECT_EQ(options().camera, "");
  EXPECT_FALSE(find<QToolButton>("Delete the camera").isEnabled());
  while (document().undo_stack().canUndo()) document().undo_stack().undo();
  EXPECT_TRUE(options().cameras.empty());
  document().undo_stack().redo();
  EXPECT_EQ(list().topLevelItemCount(), 2);
}

TEST_F(Cameras, HaveLensAndFocus) {
  press("Add a camera");
  // 24 mm over twice the focal length: 53.13 degrees for a right triangle of sides 3, 4, 5.
  type("Focal length", "24");
  EXPECT_NEAR(options().cameras[0].field_of_view, 53.1301, 1e-3);
  EXPECT_NEAR(find<NumberBox>("Field of view").value(), 53.1301, 1e-3);
  EXPECT_EQ(options().field_of_view, 30) << "the other camera's";
  type("Lens radius", "0.05");
  EXPECT_EQ(options().cameras[0].lens_radius, 0.05F);
  type("Focus distance", "2.5");
  EXPECT_EQ(options().cameras[0].focus_distance, 2.5F);
  type("Camera: Position, x", "0");
  type("Camera: Position, y", "0");
  type("Camera: Position, z", "4");
  type("Camera: Look at, x", "0");
  type("Camera: Look at, y", "0");
  type("Camera: Look at, z", "0");
  press("Look through the camera");
  ASSERT_TRUE(QTest::qWaitFor([this] { return window_.view().is_complete(); }, test::Minute));
  EXPECT_NEAR(window_.view().camera().eye().z, 4, 1e-6);
  push("Focus on…");
  QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, window_.view().rect().center());
  EXPECT_NEAR(options().cameras[0].focus_distance, 4, 1e-3) << "the square is at z = 0";
  list().setCurrentItem(list().topLevelItem(0));
  type("Lens radius", "0.1");
  EXPECT_EQ(options().lens_radius, 0.1F);
  EXPECT_EQ(options().cameras[0].lens_radius, 0.05F);
}

TEST_F(Cameras, ThatAreSelectedAreMovedByTheView) {
  press("Add a camera");
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, middle_of(list().topLevelItem(1), 1));
  window_.view().press(Qt::Key_7);  // from above
  press("Move the camera to the view");
  EXPECT_GT(options().cameras[0].eye.y, 1);
  QTest::keyClick(&window_, Qt::Key_0, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(options().eye, grf::Vec3f(0, 0, 5)) << "the camera without a name stays";
  EXPECT_EQ(options().camera, "camera 1");
}

TEST_F(Cameras, AreSavedBesideTheScene) {
  press("Add a camera");
  type("Field of view", "25");
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(document().save(path("scene.grf"), diagnostics));
  open(path("scene.grf"));
  ASSERT_EQ(options().cameras.size(), 1U);
  EXPECT_EQ(options().cameras[0].name, "camera 1");
  EXPECT_EQ(options().cameras[0].field_of_view, 25);
  EXPECT_EQ(list().topLevelItemCount(), 2);
}

}  // namespace
}  // namespace editor
