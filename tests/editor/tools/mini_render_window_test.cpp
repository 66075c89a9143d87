// Tests of Mini bpt in its window.
#include <QComboBox>

#include <gmock/gmock.h>

#include "renderer/image/image.h"
#include "tests/editor/tools/study_tool_test.h"

namespace editor {
namespace {

using testing::HasSubstr;

class MiniRenderWindow : public StudyToolTest {
 protected:
  MiniRenderWindow() : StudyToolTest("minibpt") {}

  bool has_picture() {
    return QTest::qWaitFor([this] { return window_.study() && !window_.figure().image().isNull(); },
                           test::Minute);
  }
};

constexpr const char* Small =
    "tool minibpt samples=4 width=64\nbrdf diffuse kd=0.5\nbrdf diffuse kd=0.2\npdf auto\npdf diffuse\n";

TEST_F(MiniRenderWindow, ShowsAPictureThatIsRefinedUntilItIsStopped) {
  type("samples", "60000");
  ASSERT_TRUE(has_picture());
  EXPECT_TRUE(window_.is_busy()) << "60,000 samples take longer";
  test::action(window_, "Stop").trigger();
  EXPECT_TRUE(QTest::qWaitFor([this] { return !window_.is_busy(); }, 2000));
  EXPECT_FALSE(window_.figure().image().isNull()) << "it is kept";
  EXPECT_EQ(notice(), "");
}

TEST_F(MiniRenderWindow, FollowsItsSettings) {
  set(Small);
  EXPECT_THAT(summary(), HasSubstr("4 samples per pixel"));
  const QImage sphere = window_.figure().image();
  auto& shape = test::named<QComboBox>(window_, "shape");
  shape.setFocus();
  QTest::keyClicks(&shape, "kno");  // by keyboard
  emit shape.activated(shape.currentIndex());
  ASSERT_TRUE(is_done());
  EXPECT_THAT(studies::to_text(window_.state()), HasSubstr("shape=knot"));
  EXPECT_NE(window_.figure().image(), sphere);
  type("samples", "16");
  ASSERT_TRUE(is_done());
  EXPECT_THAT(summary(), HasSubstr("16 samples per pixel"));
}

// Dragging turns the eye about the look-at point, at the same distance.
TEST_F(MiniRenderWindow, IsTurnedByThePointer) {
  set(Small);
  const auto distance = [this] {
    return std::hypot(number("viewer_x") - number("vlook_x"), number("viewer_y") - number("vlook_y"),
                      number("viewer_z") - number("vlook_z"));
  };
  const double before = distance();
  const double x = number("viewer_x");
  test::drag(window_.figure(), {300, 300}, {200, 280});
  ASSERT_TRUE(is_done());
  EXPECT_NEAR(distance(), before, 1e-3);
  EXPECT_GT(std::abs(number("viewer_x") - x), 0.5);
}

TEST_F(MiniRenderWindow, ComparesTwoBrdfs) {
  set("tool minibpt samples=4 width=64 compare=brdfs\nbrdf diffuse kd=0.5\nbrdf diffuse kd=0.2\npdf "
      "auto\npdf auto\n");
  EXPECT_THAT(summary(), HasSubstr("A: 4 samples per pixel"));
  EXPECT_THAT(summary(), HasSubstr("B: "));
}

TEST_F(MiniRenderWindow, ExportsItsImage) {
  set(Small);
  EXPECT_EQ(message_of([&] { window_.export_data(path("a.exr")); }), "");
  grf::Diagnostics diagnostics;
  const auto image = image::read_image(folder_.path("a.exr"), diagnostics);
  ASSERT_TRUE(image) << diagnostics.to_text();
  EXPECT_EQ(image->width, 64);
  EXPECT_THAT(message_of([&] { window_.export_data(path("a.gif")); }).toStdString(),
              HasSubstr("can be written as"));
}

TEST_F(MiniRenderWindow, OpensASceneWithItsOptions) {
  folder_.add("a.op",
              "BPT_Scene a.grf\nBPT_Viewer 10 20 300\nBPT_VLook 10 20 0\nBPT_Image_Resolution 48 32\n");
  set(Small);
  open({QString::fromStdString(folder_.add(
      "a.grf",
      "begin mesh brdf diffuse begin vertexs (0,0,0) (20,0,0) (10,40,0) end begin faces (0,1,2) end end\n"
      "light begin (0,90,90) (20,0,0) (0,-20,20) end\n"))});
  EXPECT_EQ(notice(), "");
  EXPECT_EQ(number("viewer_z"), 300) << "beyond the slider's first range";
  EXPECT_EQ(number("vlook_x"), 10);
  EXPECT_EQ(number("width"), 48);
  ASSERT_TRUE(window_.study());
}

// A model of another format is read in a process of its own, and its BRDF is that of the form.
TEST_F(MiniRenderWindow, OpensAModelOfAnyFormat) {
  set(Small);
  const QImage sphere = window_.figure().image();
  open({QString::fromStdString(folder_.add("box.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"))});
  EXPECT_EQ(notice(), "");
  EXPECT_THAT(studies::to_text(window_.state()), HasSubstr("shape=model"));
  ASSERT_TRUE(window_.study());
  EXPECT_THAT(window_.study()->figure.str(), HasSubstr("box.off on a floor"));
  EXPECT_NE(window_.figure().image(), sphere);
  open({QString::fromStdString(folder_.add("cut.off", "OFF\n3 1 0\n0 0"))});
  EXPECT_THAT(notice(), HasSubstr("cut.off"));
  EXPECT_FALSE(window_.study());
  test::action(window_, "Undo").trigger();
  ASSERT_TRUE(is_done());
  EXPECT_EQ(notice(), "");
  EXPECT_TRUE(window_.study());
}

TEST_F(MiniRenderWindow, SaysWhatIsWrongAndGoesOn) {
  set(Small);
  open({QString::fromStdString(folder_.add("zeros.hdr", std::string(500'000, '\0')))});
  EXPECT_THAT(notice(), HasSubstr("zeros.hdr"));
  test::action(window_, "Undo").trigger();
  ASSERT_TRUE(is_done());
  EXPECT_EQ(notice(), "");
  EXPECT_TRUE(window_.study());
}

}  // namespace
}  // namespace editor
