// Renders several cameras and an animation through the whole window, by keyboard.
#include <QDialog>
#include <QFileInfo>
#include <QListWidget>
#include <fstream>

#include <gtest/gtest.h>

#include "editor/controls/number_box.h"
#include "editor/rendering/render_panel.h"
#include "renderer/transport/image/image.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

/// Two squares that emit, a camera before each, and a third one that looks at the background.
class RenderQueue : public Authoring {
 protected:
  RenderQueue() {
    std::ofstream(folder_.path("scene.grf"))
        << "begin mesh \"red\" light rgb (1,0,0) begin vertexs (-4,-4,0) (4,-4,0) (4,4,0) (-4,4,0) end "
           "vertexs begin faces (0,1,2,3) end faces end mesh\n"
           "begin mesh \"green\" light rgb (0,1,0) begin vertexs (6,-4,0) (14,-4,0) (14,4,0) (6,4,0) end "
           "vertexs begin faces (0,1,2,3) end faces end mesh\n";
    std::ofstream(folder_.path("scene.op"))
        << "BPT_Scene scene.grf\nBPT_Viewer 0 0 5\nBPT_VLook 0 0 0\nBPT_FieldOfView 30\n"
           "BPT_Image_Resolution 32 24\nBPT_Samples 2\nBPT_Depth 1\n"
           "BPT_Cameras \"at/green\" 10 0 5  10 0 0  0 1 0  30 0 0\n"
           "BPT_Cameras away 0 0 5  0 0 9  0 1 0  30 0 0\n";
    open(path("scene.grf"));
  }

  /// Does something in the next dialog.
  template <class Act>
  void in_dialog(const Act& act) {
    QTimer::singleShot(100, &window_, [act] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      act(*dialog);
    });
  }
  transport::Rgb middle_of(const std::string& name) {
    grf::Diagnostics diagnostics;
    const auto image = transport::read_image(folder_.path(name), diagnostics);
    if (!image) throw std::runtime_error(diagnostics.to_text());
    return image->at(16, 12);
  }
  bool exists(const std::string& name) { return QFileInfo::exists(path(name)); }
};

TEST_F(RenderQueue, RendersTheCheckedCameras) {
  in_dialog([](QDialog& dialog) {
    auto& list = test::named<QListWidget>(dialog, "Cameras to render");
    ASSERT_EQ(list.count(), 3);
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_End);
    QTest::keyClick(&list, Qt::Key_Space);
    EXPECT_EQ(list.item(2)->checkState(), Qt::Unchecked);
    QTest::keyClick(&dialog, Qt::Key_Return);
  });
  QTest::keyClick(&window_, Qt::Key_F6, Qt::ControlModifier);
  ASSERT_EQ(window_.jobs().jobs().size(), 2U);
  EXPECT_EQ(window_.jobs().jobs()[0]->title(), "Render scene.exr");
  EXPECT_EQ(window_.jobs().jobs()[1]->title(), "Render scene_at_green.exr");
  ASSERT_TRUE(are_jobs_done());
  EXPECT_EQ(middle_of("scene.exr"), transport::Rgb(1, 0, 0));
  EXPECT_EQ(middle_of("scene_at_green.exr"), transport::Rgb(0, 1, 0));
  EXPECT_FALSE(exists("scene_away.exr"));
  EXPECT_EQ(document().options().valid_options().camera, "") << "the options stay";
}

TEST_F(RenderQueue, RendersNothingAfterEscape) {
  in_dialog([](QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); });
  QTest::keyClick(&window_, Qt::Key_F6, Qt::ControlModifier);
  EXPECT_TRUE(window_.jobs().jobs().empty());
  EXPECT_FALSE(exists("scene.exr"));
}

// From the red square's front, half a turn leads behind it, where it does not emit.
TEST_F(RenderQueue, RendersAnAnimationAsOneJob) {
  in_dialog([](QDialog& dialog) {
    auto& frames = test::named<NumberBox>(dialog, "Frames");
    frames.setFocus();
    QTest::keyClick(&frames, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&frames, "2");
    QTest::keyClick(&frames, Qt::Key_Tab);
    dialog.accept();
  });
  QTest::keyClick(&window_, Qt::Key_F6, Qt::ShiftModifier);
  ASSERT_EQ(window_.jobs().jobs().size(), 1U);
  EXPECT_EQ(window_.jobs().jobs()[0]->title(), "Render scene_0001.exr and 1 more");
  double most = 0;
  QObject::connect(
      window_.jobs().jobs()[0], &Job::changed, &window_, [&most, job = window_.jobs().jobs()[0]] {
        EXPECT_GE(job->done(), most - 1e-9) << "the progress does not begin anew with each frame";
        most = std::max(most, job->done());
      });
  ASSERT_TRUE(are_jobs_done());
  EXPECT_EQ(middle_of("scene_0001.exr"), transport::Rgb(1, 0, 0));
  EXPECT_EQ(middle_of("scene_0002.exr"), transport::Rgb(0));
  EXPECT_FALSE(exists("scene.exr"));
  EXPECT_FALSE(exists("scene_0003.exr"));
  EXPECT_EQ(document().options().valid_options().frames, 1) << "the options stay";
}

}  // namespace
}  // namespace editor
