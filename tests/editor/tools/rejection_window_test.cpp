// Tests of the study of rejection sampling in its window.
#include <QComboBox>

#include <gmock/gmock.h>

#include "tests/editor/tools/study_tool_test.h"

namespace editor {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class RejectionWindow : public StudyToolTest {
 protected:
  RejectionWindow() : StudyToolTest("rejection") {}
};

TEST_F(RejectionWindow, SamplesTheDistributionThatIsChosen) {
  ASSERT_TRUE(is_done());
  EXPECT_THAT(summary(), StartsWith("ward")) << "f cos of the BRDF at first";
  auto& distribution = test::named<QComboBox>(window_, "Distribution");
  distribution.setFocus();
  QTest::keyClicks(&distribution, "bet");  // by keyboard
  emit distribution.activated(distribution.currentIndex());
  ASSERT_TRUE(is_done());
  EXPECT_THAT(summary(), StartsWith("Beta: alpha = 2, beta = 5: 2000 samples"));
  type("alpha", "3");
  ASSERT_TRUE(is_done());
  EXPECT_THAT(summary(), StartsWith("Beta: alpha = 3, beta = 5: 2000 samples"));
  type("alpha", "0.5");
  ASSERT_TRUE(is_done());
  EXPECT_THAT(notice(), HasSubstr("'alpha' is below 1, so that no bound is above it"));
}

TEST_F(RejectionWindow, TurnsTheViewOfTheBrdf) {
  set("tool rejection\ndistribution brdf theta=30\nbrdf ward\n");
  test::drag(window_.figure(), {200, 300}, {220, 300});
  ASSERT_TRUE(is_done());
  EXPECT_GT(number("theta"), 35) << "to the right";
  EXPECT_NEAR(number("phi"), 0, 1e-6);
}

TEST_F(RejectionWindow, ExportsItsSamples) {
  set("tool rejection samples=50\ndistribution brdf theta=30\nbrdf ward\n");
  EXPECT_EQ(message_of([this] { window_.export_data(path("a.csv")); }), "");
  EXPECT_THAT(test::bytes_of(folder_.path("a.csv")), StartsWith("x,y,z,f\n"));
  EXPECT_EQ(message_of([this] { window_.export_data(path("a.fit")); }), "");
  EXPECT_THAT(test::bytes_of(folder_.path("a.fit")), StartsWith("ward"));
  set("tool rejection samples=50\ndistribution normal\nbrdf ward\n");
  EXPECT_THAT(message_of([this] { window_.export_data(path("b.fit")); }).toStdString(), HasSubstr(".csv"));
}

}  // namespace
}  // namespace editor
