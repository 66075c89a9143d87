#include "editor/panels/light_panel.h"

#include <QToolButton>
#include <QTreeWidget>
#include <QtTest>

#include <gtest/gtest.h>

#include "editor/controls/number_box.h"
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
  QTreeWidget* list() const { return panel_.findChild<QTreeWidget*>(); }

  Document document_;
  LightPanel panel_;
};

TEST_F(LightPanels, ListLightsAndChangeThem) {
  ASSERT_EQ(list()->topLevelItemCount(), 1);
  EXPECT_EQ(list()->topLevelItem(0)->text(2), "3.142");
  list()->setCurrentItem(list()->topLevelItem(0));
  EXPECT_DOUBLE_EQ(find<NumberBox>("Corner, y")->value(), 3);
  type("Power", "60");
  EXPECT_EQ(list()->topLevelItem(0)->text(2), "60");
  type("Edge 1, x", "2");
  EXPECT_EQ(document_.objects().lights[0].light.edge1, grf::Vec3f(2, 0, 0));
  EXPECT_NEAR(find<NumberBox>("Power")->value(), 120, 1e-3);
  EXPECT_EQ(document_.undo_stack().count(), 2);
  while (document_.undo_stack().canUndo()) document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), scene_of(PanelScene));
  EXPECT_DOUBLE_EQ(find<NumberBox>("Edge 1, x")->value(), 1);
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

}  // namespace
}  // namespace editor
