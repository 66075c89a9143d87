// Tests of the EM viewer in its window.
#include <QComboBox>
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "tests/editor/tools/study_tool_test.h"

namespace editor {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class EnvironmentWindow : public StudyToolTest {
 protected:
  EnvironmentWindow() : StudyToolTest("emviewer") {}
};

constexpr const char* SmallEnvironment =
    "tool emviewer N=64 M=8 deviations=false\nbrdf diffuse kd=0.5\npdf diffuse\n";

TEST_F(EnvironmentWindow, FollowsItsSliders) {
  set(SmallEnvironment);
  EXPECT_THAT(summary(), HasSubstr("of 64 candidates are effective"));
  const QImage before = window_.figure().image();
  type("N", "128");
  ASSERT_TRUE(is_done());
  EXPECT_THAT(summary(), HasSubstr("of 128 candidates are effective"));
  auto& show = test::named<QComboBox>(window_, "show");
  show.setFocus();
  QTest::keyClicks(&show, "prod");  // by keyboard
  emit show.activated(show.currentIndex());
  ASSERT_TRUE(is_done());
  EXPECT_NE(window_.figure().image(), before);
  EXPECT_THAT(studies::to_text(window_.state()), HasSubstr("show=product"));
}

// The centre of the unrolled map looks down -z, at the horizon: below, a diffuse surface reflects nothing.
TEST_F(EnvironmentWindow, DescribesTheDirectionUnderThePointer) {
  set(SmallEnvironment);
  const std::string above = pointed_at({675, 200});
  EXPECT_THAT(above, HasSubstr("f cos"));
  EXPECT_NE(pointed_at({675, 300}), above);
  EXPECT_EQ(pointed_at({1030, 20}), "");
}

TEST_F(EnvironmentWindow, IsTurnedByThePointer) {
  set(SmallEnvironment);
  const double before = number("azimuth");
  test::drag(window_.figure(), {150, 300}, {200, 300});
  ASSERT_TRUE(is_done());
  EXPECT_NEAR(std::abs(number("azimuth") - before), 30, 0.1);
}

TEST_F(EnvironmentWindow, SaysWhatIsWrongAndGoesOn) {
  set(SmallEnvironment);
  type("M", "100");
  ASSERT_TRUE(is_done());
  EXPECT_THAT(notice(), HasSubstr("M"));
  EXPECT_FALSE(window_.study());
  test::action(window_, "Undo").trigger();
  ASSERT_TRUE(is_done());
  EXPECT_EQ(notice(), "");
  open({QString::fromStdString(folder_.add("zeros.hdr", std::string(500'000, '\0')))});
  EXPECT_THAT(notice(), HasSubstr("zeros.hdr"));
  test::action(window_, "Undo").trigger();
  ASSERT_TRUE(is_done());
  EXPECT_TRUE(window_.study());
}

TEST_F(EnvironmentWindow, ExportsItsCandidates) {
  set(SmallEnvironment);
  EXPECT_EQ(message_of([this] { window_.export_data(path("a.csv")); }), "");
  const std::string csv = test::bytes_of(folder_.path("a.csv"));
  EXPECT_THAT(csv, StartsWith("candidate,x,y,z,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 65);
}

}  // namespace
}  // namespace editor
