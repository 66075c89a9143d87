// Tests of tools that are opened from the editor: the BRDF of the selected faces goes there and comes back.
#include <QApplication>
#include <QComboBox>
#include <QLabel>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/controls/notice_bar.h"
#include "editor/controls/number_box.h"
#include "editor/tools/study_window.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

using testing::HasSubstr;

constexpr const char* Scene =
    "begin mesh \"plane\" brdf ward sx=0.2 sy=0.3\n"
    "begin vertexs (-1,0,1) (1,0,1) (1,0,-1) (-1,0,-1) end begin faces (0,1,2) (0,2,3) end end\n";

class ToolWindows : public Authoring {
 protected:
  void TearDown() override {
    std::vector<QWidget*> windows;  // which own others of the list
    for (QWidget* window : QApplication::topLevelWidgets()) {
      if (qobject_cast<StudyWindow*>(window) != nullptr) windows.push_back(window);
    }
    for (QWidget* window : windows) delete window;
  }

  /// Opens a tool from the menu and returns its window.
  StudyWindow& opened(const QString& title) {
    test::action(window_, title).trigger();
    for (QWidget* window : QApplication::topLevelWidgets()) {
      auto* study = qobject_cast<StudyWindow*>(window);
      if (study != nullptr && study->isVisible()) return *study;
    }
    throw std::runtime_error("no tool was opened");
  }
  const grf::Surface& surface(std::size_t face) {
    return document().objects().meshes.front().mesh->surface(face);
  }
  grf::BrdfModel brdf(std::size_t face) { return std::get<grf::BrdfModel>(*surface(face).brdf); }
  static float sx(const grf::BrdfModel& model) { return std::get<float>(model.arguments.front().value); }
  void open_scene() { open(QString::fromStdString(folder_.add("a.grf", Scene))); }
};

TEST_F(ToolWindows, ShowTheBrdfOfTheSelectedFacesAndApplyIt) {
  open_scene();
  test::action(window_, "All").trigger();
  StudyWindow& tool = opened("Mini bpt");
  ASSERT_FALSE(tool.state().brdfs.empty());
  EXPECT_EQ(tool.state().brdfs.front(), brdf(0));
  auto& box = test::named<NumberBox>(tool, "sx");
  box.setFocus();
  QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(&box, "0.7");
  QTest::keyClick(&box, Qt::Key_Return);
  EXPECT_FLOAT_EQ(sx(tool.state().brdfs.front()), 0.7F);
  EXPECT_FLOAT_EQ(sx(brdf(0)), 0.2F) << "not before it is applied";
  QAction& apply = test::action(tool, "Apply to the faces");
  ASSERT_TRUE(apply.isEnabled());
  apply.trigger();
  EXPECT_FLOAT_EQ(sx(brdf(0)), 0.7F);
  EXPECT_FLOAT_EQ(sx(brdf(1)), 0.7F);
  test::action(window_, "Undo Apply the BRDF").trigger();
  EXPECT_FLOAT_EQ(sx(brdf(0)), 0.2F) << "in one step";
}

TEST_F(ToolWindows, KnowTheTermsOfASum) {
  open(QString::fromStdString(folder_.add(
      "sum.grf",
      "def paint = brdf ward sx=0.2 sy=0.3 def coat = brdf combine 0.5 paint begin\n"
      "begin mesh \"plane\" brdf combine 0.25 paint 0.5 coat\n"
      "begin vertexs (-1,0,1) (1,0,1) (1,0,-1) (-1,0,-1) end begin faces (0,1,2) (0,2,3) end end end\n")));
  test::action(window_, "All").trigger();
  StudyWindow& tool = opened("Mini bpt");
  EXPECT_EQ(tool.state().brdfs.front().terms.size(), 2U);
  EXPECT_EQ(tool.state().definitions.size(), 2U);
  EXPECT_TRUE(QTest::qWaitFor([&] { return tool.study().has_value(); }, test::Minute));
  EXPECT_FALSE(tool.notice().isVisible()) << tool.notice().text().toStdString();
  EXPECT_THAT(studies::to_text(tool.state()), HasSubstr("def paint = brdf ward sx=0.2 sy=0.3\n"));
}

TEST_F(ToolWindows, ApplyNothingWithoutASelection) {
  open_scene();
  StudyWindow& tool = opened("Mini bpt");
  test::action(tool, "Apply to the faces").trigger();
  EXPECT_FLOAT_EQ(sx(brdf(0)), 0.2F);
  EXPECT_THAT(window_.findChild<NoticeBar*>()->text().toStdString(), HasSubstr("No faces are selected"));
}

TEST_F(ToolWindows, StayWithoutTheEditor) {
  const std::vector<studies::StudyTool> tools = studies::study_tools();
  StudyWindow alone(tools.front());
  EXPECT_FALSE(test::action(alone, "Apply to the faces").isEnabled());
  EXPECT_THAT(test::action(alone, "Apply to the faces").toolTip().toStdString(),
              HasSubstr("from the editor"));
}

}  // namespace
}  // namespace editor
