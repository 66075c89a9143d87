// The display mode Rendered, through the whole window, by pointer and keyboard.
#include <QImage>
#include <fstream>

#include <gtest/gtest.h>

#include "editor/image/scale_bar.h"
#include "editor/rendering/render_panel.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

/// A red square that emits light and fills the view, with a green one beside it, which the OP file does not
/// show.
const char* const Emitters =
    "begin mesh \"red\" light rgb (1,0,0) begin vertexs (-4,-4,0) (4,-4,0) (4,4,0) (-4,4,0) end vertexs "
    "begin faces (0,1,2,3) end faces end mesh\n"
    "begin mesh \"green\" light rgb (0,1,0) begin vertexs (6,-4,0) (14,-4,0) (14,4,0) (6,4,0) end vertexs "
    "begin faces (0,1,2,3) end faces end mesh\n";

class Rendered : public Authoring {
 protected:
  Rendered() {
    std::ofstream(folder_.path("scene.grf")) << Emitters;
    std::ofstream(folder_.path("scene.op"))
        << "BPT_Scene scene.grf\nBPT_Viewer 0 0 5\nBPT_VLook 0 0 0\nBPT_FieldOfView 30\n"
           "BPT_Image_Resolution 100 80\nBPT_Samples 4\nBPT_Depth 1\n";
    open(path("scene.grf"));
  }

  SceneView& view() { return window_.view(); }
  Preview& preview() { return window_.render_panel().preview(); }
  void enter() { QTest::keyClick(&window_, Qt::Key_9, Qt::AltModifier); }
  void leave() { QTest::keyClick(&window_, Qt::Key_3, Qt::AltModifier); }
  /// A pixel of the view, at a place in fractions of its size.
  QColor pixel(double x, double y) {
    const QImage image = view().grab().toImage();
    return image.pixelColor(static_cast<int>(x * image.width()), static_cast<int>(y * image.height()));
  }
  bool is_at(double x, double y, const QColor& colour) {
    return QTest::qWaitFor([&] { return pixel(x, y) == colour; }, test::Minute);
  }
  bool has_finished() {
    return QTest::qWaitFor([this] { return view().note().contains("100 %") && view().is_full(); },
                           test::Minute);
  }
  void click(double x, double y) {
    QTest::mouseClick(&view(), Qt::LeftButton, {},
                      QPoint(static_cast<int>(x * view().width()), static_cast<int>(y * view().height())));
  }
  void look_at_green() {
    transport::View there = view().camera().view();
    there.eye.x = there.target.x = 10;
    view().move_camera(ViewCamera(there));
  }
};

TEST_F(Rendered, ShowsThePreviewAtTheSizeOfTheView) {
  EXPECT_NE(pixel(0.3, 0.3), QColor(Qt::red));
  enter();
  ASSERT_EQ(view().mode(), DisplayMode::Rendered);
  ASSERT_TRUE(has_finished()) << view().note().toStdString();
  ASSERT_TRUE(is_at(0.3, 0.3, Qt::red));
  EXPECT_TRUE(is_at(0.9, 0.8, Qt::red));
  EXPECT_EQ(preview().image()->width, view().width());
  EXPECT_EQ(preview().image()->height, view().height());
  EXPECT_EQ(window_.document().options().valid_options().size.width, 100) << "the options stay";
  leave();
  EXPECT_FALSE(preview().is_on());
  EXPECT_EQ(view().note(), "");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view().is_complete(); }, test::Minute));
  EXPECT_NE(pixel(0.3, 0.3), QColor(Qt::red));
}

TEST_F(Rendered, FollowsCameraEditsAndSize) {
  enter();
  ASSERT_TRUE(is_at(0.3, 0.3, Qt::red));
  look_at_green();
  EXPECT_TRUE(is_at(0.3, 0.3, Qt::green));
  document().undo_stack().undo();  // if the camera were an undo step, it would go back
  EXPECT_TRUE(is_at(0.3, 0.3, Qt::green));
  window_.resize(window_.width() - 60, window_.height() - 40);
  EXPECT_TRUE(QTest::qWaitFor([&] { return preview().image()->width == view().width(); }, test::Minute));
  // Without the green square, nothing is there.
  click(0.3, 0.3);
  ASSERT_FALSE(view().selection().empty());
  test::action(window_, "Delete faces").trigger();
  EXPECT_TRUE(is_at(0.3, 0.3, Qt::black));
  EXPECT_TRUE(preview().is_on());
}

TEST_F(Rendered, HasTheSelectionOverTheImage) {
  enter();
  ASSERT_TRUE(has_finished());
  ASSERT_TRUE(is_at(0.3, 0.3, Qt::red));
  click(0.3, 0.3);
  ASSERT_FALSE(view().selection().empty());
  ASSERT_TRUE(QTest::qWaitFor([&] { return pixel(0.3, 0.3) != QColor(Qt::red); }, test::Minute))
      << "the accent over selected faces";
  EXPECT_GT(pixel(0.3, 0.3).red(), 100) << "lets the image through";
}

TEST_F(Rendered, IsStoppedAndStartedByThePreviewsKeys) {
  enter();
  ASSERT_TRUE(is_at(0.3, 0.3, Qt::red));
  QTest::keyClick(&window_, Qt::Key_F5, Qt::ShiftModifier);
  EXPECT_FALSE(preview().is_on());
  look_at_green();
  EXPECT_FALSE(preview().is_on()) << "it stays stopped";
  EXPECT_EQ(view().rendered(), nullptr) << "an image from elsewhere is not shown";
  EXPECT_EQ(view().note(), "Rendered: stopped");
  QTest::keyClick(&window_, Qt::Key_F5);
  EXPECT_TRUE(is_at(0.3, 0.3, Qt::green));
}

TEST_F(Rendered, IsLimitedToARegionThatIsDragged) {
  enter();
  ASSERT_TRUE(is_at(0.3, 0.3, Qt::red));
  QTest::keyClick(&window_, Qt::Key_W, Qt::ControlModifier | Qt::AltModifier);
  const QSize size = view().size();
  test::drag(view(), {size.width() / 2, size.height() / 2}, {size.width() * 9 / 10, size.height() * 9 / 10});
  EXPECT_TRUE(QTest::qWaitFor([&] { return pixel(0.3, 0.3) != QColor(Qt::red); }, test::Minute));
  EXPECT_TRUE(is_at(0.7, 0.7, Qt::red));
  EXPECT_NE(pixel(0.95, 0.7), QColor(Qt::red));
  const auto rendered = [&](double x, double y) {
    const image::Image& image = *preview().image();
    return image.at(static_cast<int>(x * image.width), static_cast<int>(y * image.height));
  };
  // What is outside is not rendered.
  EXPECT_TRUE(QTest::qWaitFor([&] { return rendered(0.3, 0.3) == grf::Colour(0); }, test::Minute));
  EXPECT_GT(rendered(0.7, 0.7).x, 0.5F);
  EXPECT_TRUE(view().selection().empty()) << "the drag selects nothing";
  EXPECT_TRUE(test::action(window_, "Preview region").isChecked());
  QTest::keyClick(&window_, Qt::Key_W, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_TRUE(is_at(0.3, 0.3, Qt::red));
  EXPECT_TRUE(QTest::qWaitFor([&] { return rendered(0.3, 0.3).x > 0.5F; }, test::Minute));
  // By keyboard: the middle.
  QTest::keyClick(&window_, Qt::Key_W, Qt::ControlModifier | Qt::AltModifier);
  QTest::keyClick(&view(), Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor([&] { return pixel(0.2, 0.4) != QColor(Qt::red); }, test::Minute));
  EXPECT_TRUE(is_at(0.3, 0.4, Qt::red));
}

TEST_F(Rendered, IsDenoisedAndMarkedOnRequest) {
  enter();
  ASSERT_TRUE(has_finished());
  EXPECT_FALSE(view().note().contains("denoised"));
  QTest::keyClick(&window_, Qt::Key_N, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_TRUE(view().note().contains("denoised"));
  ASSERT_TRUE(has_finished());
  EXPECT_TRUE(is_at(0.3, 0.3, Qt::red)) << "what has no noise stays as it is";
  leave();
  EXPECT_EQ(view().note(), "");
}

/// A square that emits light, at the left, is seen without noise; the one at the right is lit by two lamps.
const char* const LitBesideEmitter =
    "begin mesh light rgb (1,0,0) begin vertexs (-9,-9,0) (0,-9,0) (0,9,0) (-9,9,0) end vertexs "
    "begin faces (0,1,2,3) end faces end mesh\n"
    "begin mesh brdf diffuse kd=0.8 begin vertexs (0,-9,0) (9,-9,0) (9,9,0) (0,9,0) end vertexs "
    "begin faces (0,1,2,3) end faces end mesh\n"
    "light begin rgb (30,30,30) (3,2,9) (0,1,0) (1,0,0) end light begin rgb (50,50,50) (1,-4,8) (0,1,0) "
    "(1,0,0) "
    "end\n";

TEST_F(Rendered, ShowsTheErrorOfPixelsInFalseColours) {
  std::ofstream(folder_.path("noisy.grf")) << LitBesideEmitter;
  std::ofstream(folder_.path("noisy.op")) << "BPT_Scene noisy.grf\nBPT_Viewer 0 0 5\nBPT_VLook 0 0 0\n"
                                             "BPT_FieldOfView 30\nBPT_Samples 2\nBPT_Depth 1\n";
  open(path("noisy.grf"));
  enter();
  ASSERT_TRUE(has_finished());
  ASSERT_TRUE(is_at(0.2, 0.6, Qt::red));
  auto* scale = view().findChild<ScaleBar*>();
  ASSERT_NE(scale, nullptr);
  EXPECT_FALSE(scale->isVisible());
  QTest::keyClick(&window_, Qt::Key_X, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_TRUE(scale->isVisible());
  EXPECT_GE(scale->x(), view().width() * 3 / 4);
  EXPECT_TRUE(view().note().contains("error of pixels")) << view().note().toStdString();
  // The darkest blue of YlGnBu (Harrower and Brewer 2003).
  EXPECT_TRUE(is_at(0.2, 0.6, QColor(8, 29, 88))) << pixel(0.2, 0.6).name().toStdString();
  // Two samples of lamps that are not equally bright have a relative error of 3 % to 100 %.
  const QColor noisy = pixel(0.6, 0.6);
  EXPECT_GT(noisy.lightness(), 100) << noisy.name().toStdString();
  // An edit starts anew: no error is known at first.
  QTest::keyClick(&window_, Qt::Key_X, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_FALSE(scale->isVisible());
  EXPECT_TRUE(is_at(0.2, 0.6, Qt::red));
  leave();
}

TEST_F(Rendered, NeedsPerspective) {
  enter();
  ASSERT_TRUE(is_at(0.3, 0.3, Qt::red));
  QTest::keyClick(&view(), Qt::Key_5);
  EXPECT_FALSE(preview().is_on());
  EXPECT_EQ(view().rendered(), nullptr);
  QTest::keyClick(&view(), Qt::Key_5);
  EXPECT_TRUE(is_at(0.3, 0.3, Qt::red));
}

}  // namespace
}  // namespace editor
