// Tests of the study of adaptive subdivision in its window.
#include <QComboBox>

#include <gmock/gmock.h>

#include "editor/controls/scaled_slider.h"
#include "tests/editor/tools/study_tool_test.h"

namespace editor {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class SubdivisionWindow : public StudyToolTest {
 protected:
  SubdivisionWindow() : StudyToolTest("subdivision") {}
};

constexpr const char* SmallTree =
    "tool subdivision theta=45 res=64 count=500\nbrdf ward sx=0.2 sy=0.2\npdf adaptive mode=reject nQT=20 "
    "res=64\n";

TEST_F(SubdivisionWindow, SubdividesAsItsSettingsSay) {
  set(SmallTree);
  const int cells = std::stoi(summary());
  EXPECT_GT(cells, 10);
  type("depth", "1");
  ASSERT_TRUE(is_done());
  EXPECT_THAT(summary(), StartsWith("4 cells to depth 1,")) << "quarters of the square";
  test::action(window_, "Undo").trigger();
  ASSERT_TRUE(is_done());
  EXPECT_EQ(std::stoi(summary()), cells);
  type("count", "100");
  ASSERT_TRUE(is_done());
  EXPECT_THAT(summary(), HasSubstr("100 samples by adaptive"));
}

TEST_F(SubdivisionWindow, HasWholeNumbersOfLevels) {
  set(SmallTree);
  auto& slider = test::named<ScaledSlider>(window_, "depth");
  const double before = number("depth");
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_Left);
  ASSERT_TRUE(is_done());
  EXPECT_EQ(number("depth"), before - 1);
  type("depth", "2.5");
  ASSERT_TRUE(is_done());
  EXPECT_THAT(notice(), HasSubstr("2.5 is not whole"));
}

TEST_F(SubdivisionWindow, DescribesTheCellUnderThePointer) {
  set(SmallTree);
  // The disc is the largest part of the figure; its centre is the normal.
  const std::string cell = pointed_at({296, 300});
  for (const char* word : {"depth", "mass"}) EXPECT_THAT(cell, HasSubstr(word));
  EXPECT_NE(pointed_at({140, 320}), cell) << "in the lobe";
  EXPECT_EQ(pointed_at({1030, 10}), "");
}

TEST_F(SubdivisionWindow, ComparesSchemes) {
  set(SmallTree);
  auto& panels = test::named<QComboBox>(window_, "panels");
  panels.setFocus();
  QTest::keyClicks(&panels, "comp");  // by keyboard
  emit panels.activated(panels.currentIndex());
  ASSERT_TRUE(is_done());
  EXPECT_THAT(studies::to_text(window_.state()), HasSubstr("panels=compare"));
  ASSERT_TRUE(window_.study());
  EXPECT_THAT(window_.study()->figure.str(), HasSubstr("cascadeCDF"));
}

TEST_F(SubdivisionWindow, ShowsTheDirectionsOfAFile) {
  set(SmallTree);
  open({QString::fromStdString(folder_.add(
      "a.fit", "ward sx=0.3\nviewer (0.5, 0)\nbegin\n(0, 0, 1) 0.2\n(-0.4, 0, 0.9) 0.5\nend\n"))});
  EXPECT_EQ(notice(), "");
  EXPECT_THAT(window_.study()->figure.str(), HasSubstr("a.fit"));
  open({QString::fromStdString(folder_.add("cut.fit", "ward\nviewer (0.5"))});
  EXPECT_THAT(notice(), HasSubstr("cut.fit:2:"));
}

TEST_F(SubdivisionWindow, IsAnimatedOverTheView) {
  set(SmallTree);
  EXPECT_EQ(message_of([this] { window_.export_animation(path("view.svg"), 3); }), "");
  const std::string first = test::bytes_of(folder_.path("view_000.svg"));
  EXPECT_NE(test::bytes_of(folder_.path("view_002.svg")), first);
  QAction& play = test::action(window_, "Play");
  const double before = number("theta");
  play.trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return number("theta") != before; }, test::Minute));
  play.trigger();
  ASSERT_TRUE(is_done());
}

}  // namespace
}  // namespace editor
