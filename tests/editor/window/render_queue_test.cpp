// Renders several cameras and an animation through the whole window, by keyboard.
#include <QComboBox>
#include <QDialog>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <fstream>

#include <gtest/gtest.h>

#include "editor/controls/number_box.h"
#include "editor/image/image_browser.h"
#include "editor/rendering/render_panel.h"
#include "renderer/image/image.h"
#include "tests/editor/pointer.h"
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
    const auto image = image::read_image(folder_.path(name), diagnostics);
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

/// The area light emits red before a background of 0.25 grey; the corners of the image show the background,
/// and a lens blurs neither.
class EffectQueue : public RenderQueue {
 protected:
  EffectQueue() {
    std::ofstream(folder_.path("scene.op"))
        << "BPT_Scene scene.grf\nBPT_Viewer 0 0 5\nBPT_VLook 0 0 0\nBPT_FieldOfView 120\n"
           "BPT_Image_Resolution 32 24\nBPT_Samples 2\nBPT_Depth 0\nBPT_LensRadius 0.01\n"
           "BPT_Background 0.25 0.25 0.25\n";
    open(path("scene.grf"));
  }
  transport::Rgb corner_of(const std::string& name) {
    grf::Diagnostics diagnostics;
    return image::read_image(folder_.path(name), diagnostics)->at(0, 0);
  }
};

TEST_F(EffectQueue, RendersEachEffectThatThePlanFinds) {
  QTimer timer;
  QStringList effects;
  timer.callOnTimeout([&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr || !effects.isEmpty()) return;
    auto& list = test::named<QListWidget>(*dialog, "Effects to render");
    for (int row = 0; row < list.count(); ++row) effects << list.item(row)->text();
    QTest::keyClick(dialog, Qt::Key_Return);
  });
  timer.start(20);
  QTest::keyClick(&window_, Qt::Key_F6, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(QTest::qWaitFor([this] { return window_.jobs().jobs().size() == 3; }, test::Minute));
  EXPECT_EQ(effects, QStringList({"area_lights", "background", "depth_of_field"}));
  EXPECT_EQ(window_.jobs().jobs()[0]->title(), "Render scene_effect_area_lights.exr");
  ASSERT_TRUE(are_jobs_done());
  const transport::Rgb red(1, 0, 0), black(0), grey(0.25F);
  EXPECT_EQ(middle_of("scene_effect_area_lights.exr"), red);
  EXPECT_EQ(corner_of("scene_effect_area_lights.exr"), black) << "without the background";
  EXPECT_EQ(middle_of("scene_effect_background.exr"), black) << "the light emits nothing";
  EXPECT_EQ(corner_of("scene_effect_background.exr"), grey);
  EXPECT_EQ(middle_of("scene_effect_depth_of_field.exr"), red) << "in the light of all sources";
  EXPECT_EQ(corner_of("scene_effect_depth_of_field.exr"), grey);
  EXPECT_FALSE(exists("scene.exr"));
  EXPECT_EQ(document().options().valid_options().only, options::RenderOptions().only) << "the options stay";
  ImageBrowser& images = window_.image_browser();
  EXPECT_TRUE(QTest::qWaitFor([&] { return images.names().size() == 3; }))
      << "on the page of images: " << images.names().join(", ").toStdString();
  EXPECT_TRUE(images.names().contains("scene_effect_depth_of_field.exr"));
}

TEST_F(RenderQueue, ShowsTheLayersOfAFinishedRender) {
  options::RenderOptions now = document().options().valid_options();
  now.layers = {"albedo", "depth", "samples"};
  document().options().set_options("Layers", now);
  QTest::keyClick(&window_, Qt::Key_7, Qt::ControlModifier);
  QTest::keyClick(&window_, Qt::Key_F6);
  ASSERT_TRUE(are_jobs_done());
  ImageBrowser& images = window_.image_browser();
  auto& layers = test::named<QComboBox>(images, "Layer");
  ASSERT_TRUE(QTest::qWaitFor([&] { return layers.count() == 4; }, test::Minute));
  images.pane().setFocus();
  QTest::keyClick(&images.pane(), Qt::Key_L, Qt::ShiftModifier);
  EXPECT_EQ(layers.currentText(), "samples");
  QTest::keyClick(&images.pane(), Qt::Key_L, Qt::ShiftModifier);
  EXPECT_EQ(layers.currentText(), "depth");
  test::move_pointer(images.pane(), images.pane().place_of({16, 12}));
  const auto& values = test::named<QLabel>(images, "Values of the pixel");
  EXPECT_TRUE(QTest::qWaitFor([&] { return values.text() == "x 16  y 12   depth 5"; }))
      << "the eye is 5 in front of the square: " << values.text().toStdString();
}

TEST_F(RenderQueue, ComparesTheImageWithTheOneThatItReplaced) {
  const QAction& action = *window_.render_panel().compare_action();
  QTest::keyClick(&window_, Qt::Key_F6);
  ASSERT_TRUE(are_jobs_done());
  EXPECT_FALSE(action.isEnabled()) << "there was no image before";
  options::RenderOptions now = document().options().valid_options();
  now.camera = "at/green";
  document().options().set_options("Camera", now);
  QTest::keyClick(&window_, Qt::Key_F6);
  ASSERT_TRUE(are_jobs_done());
  EXPECT_TRUE(action.isEnabled());
  QTest::keyClick(&window_, Qt::Key_C, Qt::ControlModifier | Qt::AltModifier);
  ImageBrowser& images = window_.image_browser();
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return images.pane().arrangement() == Arrangement::Wipe; }, test::Minute));
  EXPECT_EQ(images.names(), QStringList({"scene.exr, before", "scene.exr"}));
  const QImage view = images.pane().grab().toImage();
  const auto at = [&](int x) { return view.pixel(images.pane().place_of({x, 20}).toPoint()); };
  EXPECT_EQ(at(2), qRgb(0, 255, 0)) << "A is the last one";
  EXPECT_EQ(at(29), qRgb(255, 0, 0)) << "B the one before";
  const auto& statistics = test::named<QLabel>(images, "Image statistics");
  EXPECT_TRUE(QTest::qWaitFor([&] { return statistics.text().contains("RMSE 0.8165"); }))  // sqrt(2 / 3)
      << statistics.text().toStdString();
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
