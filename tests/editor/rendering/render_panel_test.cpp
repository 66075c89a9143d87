#include "editor/rendering/render_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QToolButton>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/controls/number_box.h"
#include "editor/document/document.h"
#include "editor/document/op_document.h"
#include "editor/image/scale_bar.h"
#include "editor/jobs/job_list.h"
#include "editor/rendering/error_curve.h"
#include "editor/rendering/fitted_image.h"
#include "editor/rendering/render_history.h"
#include "renderer/options/op_file.h"
#include "tests/editor/answer.h"
#include "tests/editor/rendering/rendering_helpers.h"

namespace {

using editor::NumberBox;
using editor::RenderPanel;
using testing::HasSubstr;

class RenderPanelTest : public testing::Test {
 protected:
  RenderPanelTest() {
    panel_.resize(1600, 260);
    panel_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&panel_));
    panel_.activateWindow();  // there is no window manager that would
    EXPECT_TRUE(QTest::qWaitForWindowActive(&panel_));
  }

  template <class Control>
  Control* control(const char* name) {
    for (Control* one : panel_.findChildren<Control*>()) {
      if (one->accessibleName() == name) return one;
    }
    throw std::runtime_error(name);
  }
  QLineEdit& text_of(const char* name) { return *control<NumberBox>(name)->findChild<QLineEdit*>(); }
  void type(const char* name, const QString& text) {
    text_of(name).setText(text);
    control<NumberBox>(name)->commit();
  }
  QString path(const char* name) const { return QString::fromStdString(folder_.path(name)); }
  void open_scene(const grf::Scene& scene, const QString& scene_path) {
    document_.take(scene, scene_path, {});
  }
  const options::RenderOptions& options() const { return options_.valid_options(); }
  /// A scene whose OP file sets few samples and a small image.
  void open(int samples) {
    folder_.add("scene.op",
                "# keep me\nBPT_Scene scene.grf\nBPT_Image_Resolution 96 72\nBPT_Viewer 0 2 6\n"
                "BPT_VLook 0 0.5 0\nBPT_Samples " +
                    std::to_string(samples) + "\n");
    open_scene(test::scene_of_text(test::Corner), path("scene.grf"));
  }
  bool has_image() {
    return QTest::qWaitFor([this] { return panel_.findChild<editor::FittedImage*>()->image() != nullptr; },
                           test::Minute);
  }
  bool render_ends() {
    return QTest::qWaitFor([this] { return !panel_.final_render().is_running(); }, test::Minute);
  }
  std::string status() { return control<QLabel>("State of the render")->text().toStdString(); }

  test::TemporaryFolder folder_;
  editor::Document document_;
  editor::OpDocument& options_ = document_.options();
  editor::JobList jobs_;
  RenderPanel panel_{document_, jobs_};
};

TEST_F(RenderPanelTest, TakesCameraAndOptionsFromTheFileBesideTheScene) {
  open(24);
  EXPECT_EQ(options().eye, grf::Vec3f(0, 2, 6));
  EXPECT_EQ(control<NumberBox>("Samples")->value(), 24);
  EXPECT_EQ(control<NumberBox>("Width")->value(), 96);
}

TEST_F(RenderPanelTest, PreviewsByF5AndFollowsEdits) {
  open(100'000);
  QTest::keyClick(&panel_, Qt::Key_F5);
  ASSERT_TRUE(has_image());
  QSignalSpy images(&panel_.preview(), &editor::Preview::image_changed);
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel_.preview().image()->width == 96; }, test::Minute));
  test::expect_lit_corner(*panel_.preview().image());
  test::expect_lit_corner(*panel_.findChild<editor::FittedImage*>()->image());
  options::RenderOptions elsewhere = options();
  elsewhere.eye = grf::Vec3f(1, 2, 5);
  options_.follow(elsewhere);
  ASSERT_TRUE(QTest::qWaitFor([&] { return images.size() >= 2; }, test::Minute));
  EXPECT_EQ(options().eye, grf::Vec3f(1, 2, 5));
  QTest::keyClick(&panel_, Qt::Key_F5);
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel_.preview().is_paused(); }, test::Minute));
  EXPECT_EQ(panel_.preview_action()->text(), "Resume");
  QTest::keyClick(&panel_, Qt::Key_F5, Qt::ShiftModifier);
  EXPECT_FALSE(panel_.preview().is_on());
  EXPECT_FALSE(panel_.stop_action()->isEnabled());
  EXPECT_THAT(panel_.stop_action()->toolTip().toStdString(), HasSubstr("No render is running"));
}

TEST_F(RenderPanelTest, ShowsTheErrorOfThePreviewsPixels) {
  open(4);
  panel_.preview_action()->trigger();
  ASSERT_TRUE(QTest::qWaitFor([this] { return status().starts_with("Preview done"); }, test::Minute));
  auto& image = *panel_.findChild<editor::FittedImage*>();
  auto& scale = *control<editor::ScaleBar>("Scale of the error in the Render dock");
  // A place of the image in fractions of its size; it is centred in the widget.
  const auto pixel = [&image](double x, double y) {
    const QSize drawn = QSize(96, 72).scaled(image.size(), Qt::KeepAspectRatio);
    return image.grab().toImage().pixelColor(
        (image.width() - drawn.width()) / 2 + static_cast<int>(x * drawn.width()),
        (image.height() - drawn.height()) / 2 + static_cast<int>(y * drawn.height()));
  };
  EXPECT_FALSE(scale.isVisible());
  EXPECT_EQ(pixel(0.02, 0.02), QColor(Qt::black)) << "nothing is there";
  control<QCheckBox>("Error of pixels")->click();
  EXPECT_TRUE(panel_.error_action()->isChecked());
  ASSERT_TRUE(QTest::qWaitFor([&scale] { return scale.isVisible(); }, test::Minute));
  // Where nothing is there is no error, the darkest blue of YlGnBu (Harrower and Brewer 2003).
  EXPECT_TRUE(QTest::qWaitFor([&] { return pixel(0.02, 0.02) == QColor(8, 29, 88); }, test::Minute));
  EXPECT_GT(pixel(0.5, 0.7).lightness(), 100) << "four samples of the lamp";
  panel_.error_action()->trigger();
  EXPECT_FALSE(control<QCheckBox>("Error of pixels")->isChecked());
  EXPECT_FALSE(scale.isVisible());
}

// Few samples of a lamp are seen as noise; the eye sees none in an image that hardly differs from the truth.
TEST_F(RenderPanelTest, SaysWhatTheEyeSeesOfTheNoise) {
  const auto visible = [this] { return control<QLabel>("Visible noise")->text().toStdString(); };
  open(2);
  EXPECT_EQ(visible(), "");
  panel_.preview_action()->trigger();
  ASSERT_TRUE(QTest::qWaitFor([this] { return status().starts_with("Preview done"); }, test::Minute));
  EXPECT_THAT(visible(), testing::MatchesRegex("The eye sees noise: ΔE [0-9.]+, until about [0-9]+ samples"));
  options::RenderOptions many = options();
  many.samples = 4096;
  options_.follow(many);
  EXPECT_EQ(visible(), "") << "it is not known yet";
  ASSERT_TRUE(QTest::qWaitFor([this] { return status().starts_with("Preview done"); }, test::Minute));
  EXPECT_THAT(visible(), testing::StartsWith("The eye sees no noise: ΔE 0."));
  panel_.render_action()->trigger();
  ASSERT_TRUE(QTest::qWaitFor([this] { return status().starts_with("Done"); }, test::Minute));
  EXPECT_THAT(visible(), testing::StartsWith("The eye sees no noise: ΔE 0."));
}

TEST_F(RenderPanelTest, ListsThePreviewAmongTheJobsWhileItRenders) {
  open(100'000);
  panel_.preview_action()->trigger();
  ASSERT_EQ(jobs_.jobs().size(), 1U);
  editor::Job& job = *jobs_.jobs().front();
  EXPECT_EQ(job.title(), "Preview");
  EXPECT_EQ(job.state(), editor::Job::State::Running);
  ASSERT_TRUE(QTest::qWaitFor([&job] { return job.done() > 0; }, test::Minute)) << "progress";
  options::RenderOptions elsewhere = options();
  elsewhere.eye = grf::Vec3f(1, 2, 5);
  options_.follow(elsewhere);
  EXPECT_THAT(jobs_.jobs(), testing::ElementsAre(&job)) << "the same job follows the edit";
  panel_.preview_action()->trigger();
  ASSERT_TRUE(QTest::qWaitFor([this] { return panel_.preview().is_paused(); }, test::Minute));
  EXPECT_TRUE(jobs_.jobs().empty()) << "a paused preview";
  panel_.preview_action()->trigger();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !jobs_.jobs().empty(); }, test::Minute)) << "resumed";
  EXPECT_EQ(jobs_.jobs().front()->cancel_tip(), "Stop the preview");
  jobs_.jobs().front()->cancel();
  EXPECT_FALSE(panel_.preview().is_on());
  EXPECT_TRUE(jobs_.jobs().empty());
}

TEST_F(RenderPanelTest, AsksBeforeItReplacesAnImageThatItHasNotMade) {
  open(4);
  folder_.add("scene.exr", "of somebody else");
  test::answer(QMessageBox::Cancel);
  panel_.render_action()->trigger();
  EXPECT_FALSE(panel_.final_render().is_running());
  EXPECT_EQ(QFileInfo(path("scene.exr")).size(), 16);
  test::answer(QMessageBox::Save);
  panel_.render_action()->trigger();
  ASSERT_TRUE(panel_.final_render().is_running());
  ASSERT_TRUE(render_ends());
  EXPECT_GT(QFileInfo(path("scene.exr")).size(), 1000);
  panel_.render_action()->trigger();  // without a question
  ASSERT_TRUE(panel_.final_render().is_running());
  ASSERT_TRUE(render_ends());
}

TEST_F(RenderPanelTest, NeverReplacesTheEnvironmentMap) {
  const std::string map = std::string("PF\n1 1\n-1.0\n") + std::string(12, '\1');
  folder_.add("sky.pfm", map);
  folder_.add("scene.op",
              "BPT_Scene scene.grf\nBPT_Samples 4\nBPT_EM_Background sky.pfm\nBPT_Output_Image sky.pfm\n");
  open_scene(test::scene_of_text(test::Corner), path("scene.grf"));
  ASSERT_EQ(options().environment.empty(), false);
  QSignalSpy failed(&panel_.final_render(), &editor::FinalRender::failed);
  test::answer(QMessageBox::Save);
  panel_.render_action()->trigger();
  ASSERT_EQ(failed.size(), 1);
  EXPECT_THAT(failed[0][0].toString().toStdString(), HasSubstr("environment map"));
  EXPECT_EQ(QFileInfo(path("sky.pfm")).size(), static_cast<qint64>(map.size()));
}

TEST_F(RenderPanelTest, RendersByF6AndKeepsAHistory) {
  open(8);
  QSignalSpy opened(&panel_, &RenderPanel::image_opened);
  QTest::keyClick(&panel_, Qt::Key_F6);
  EXPECT_THAT(panel_.render_action()->toolTip().toStdString(), HasSubstr("Queue a render"));
  ASSERT_TRUE(render_ends());
  EXPECT_THAT(status(), HasSubstr("Done · 8 samples"));
  EXPECT_TRUE(QFileInfo::exists(path("scene.exr")));
  EXPECT_EQ(test::bytes_of(folder_.path("scene.op")).substr(0, 9), "# keep me") << "authors' files stay";
  auto* history = panel_.findChild<editor::RenderHistory*>();
  ASSERT_EQ(history->count(), 1);
  QTest::mouseClick(history->viewport(), Qt::LeftButton, {},
                    history->visualItemRect(history->item(0)).center());
  ASSERT_GE(opened.size(), 1);
  EXPECT_TRUE(QFileInfo::exists(opened[0][0].toString()));
  auto* image = panel_.findChild<editor::FittedImage*>();
  QTest::mouseClick(image, Qt::LeftButton);
  EXPECT_EQ(opened.back()[0].toString(), path("scene.exr"));
  image->setFocus();
  QTest::keyClick(image, Qt::Key_Return);
  EXPECT_EQ(opened.back()[0].toString(), path("scene.exr"));
}

TEST_F(RenderPanelTest, QueuesRendersOfTheSceneAsItIsWhenTheyAreAskedFor) {
  open(1'000'000);
  const auto render_as = [this](int samples, const char* output) {
    options::RenderOptions now = options();
    now.samples = samples;
    now.output = folder_.path(output);
    options_.follow(now);
    QTest::keyClick(&panel_, Qt::Key_F6);
  };
  render_as(1'000'000, "first.exr");
  auto* curve = panel_.findChild<editor::ErrorCurve*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return curve->size() >= 2; }, test::Minute));
  render_as(2, "second.exr");
  render_as(4, "removed.exr");
  render_as(3, "third.exr");
  std::vector<std::string> titles;
  for (const editor::Job* job : jobs_.jobs()) titles.push_back(job->title().toStdString());
  EXPECT_THAT(titles, testing::ElementsAre("Render first.exr", "Render second.exr", "Render removed.exr",
                                           "Render third.exr"));
  EXPECT_GT(jobs_.jobs()[0]->done(), 0);
  EXPECT_EQ(jobs_.jobs()[1]->state(), editor::Job::State::Waiting);
  jobs_.jobs()[2]->cancel();
  options::RenderOptions later = options();
  later.samples = 1'000'000;
  options_.follow(later);
  document_.replace("Empty it", {});
  jobs_.jobs()[0]->cancel();
  ASSERT_TRUE(QTest::qWaitFor([this] { return jobs_.jobs().empty(); }, test::Minute));
  auto* history = panel_.findChild<editor::RenderHistory*>();
  ASSERT_EQ(history->count(), 3);
  EXPECT_THAT(status(), HasSubstr("Done · 3 samples"));
  for (const char* made : {"first.exr", "second.exr", "third.exr"}) {
    EXPECT_TRUE(QFileInfo::exists(path(made))) << made;
  }
  EXPECT_FALSE(QFileInfo::exists(path("removed.exr")));
  test::expect_lit_corner(*panel_.findChild<editor::FittedImage*>()->image());
}

TEST_F(RenderPanelTest, ReplacesNoImageThatCameWhileTheRenderWaited) {
  open(1'000'000);
  QTest::keyClick(&panel_, Qt::Key_F6);
  options::RenderOptions now = options();
  now.output = folder_.path("second.exr");
  options_.follow(now);
  QTest::keyClick(&panel_, Qt::Key_F6);
  folder_.add("second.exr", "of somebody else");
  std::string why;
  QObject::connect(&panel_.final_render(), &editor::FinalRender::failed,
                   [&why](const QString& problem) { why += problem.toStdString(); });
  jobs_.jobs()[0]->cancel();
  ASSERT_TRUE(QTest::qWaitFor([this] { return jobs_.jobs().empty(); }, test::Minute));
  EXPECT_THAT(why, HasSubstr("second.exr exists"));
  EXPECT_EQ(QFileInfo(path("second.exr")).size(), 16);
}

TEST_F(RenderPanelTest, MarksARenderThatWasStopped) {
  open(1'000'000);
  QTest::keyClick(&panel_, Qt::Key_F6);
  auto* curve = panel_.findChild<editor::ErrorCurve*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return curve->size() >= 2; }, test::Minute));
  EXPECT_THAT(status(), HasSubstr("left"));
  panel_.stop_action()->trigger();
  ASSERT_TRUE(render_ends());
  EXPECT_THAT(status(), HasSubstr("Stopped, image kept"));
  auto* history = panel_.findChild<editor::RenderHistory*>();
  ASSERT_EQ(history->count(), 1);
  EXPECT_THAT(history->item(0)->text().toStdString(), HasSubstr("stopped"));
}

TEST_F(RenderPanelTest, WritesTheOpFileWhereThereIsNoneOrWhereItIsTold) {
  open_scene(test::scene_of_text(test::Corner), path("new.grf"));
  QSignalSpy differs(&panel_, &RenderPanel::op_file_differs);
  type("Width", "40");
  type("Height", "30");
  type("Samples", "2");
  panel_.render_action()->trigger();
  ASSERT_TRUE(render_ends());
  EXPECT_TRUE(differs.empty());
  grf::Diagnostics diagnostics;
  auto read = options::read_op_file(folder_.path("new.op"), diagnostics);
  ASSERT_TRUE(read) << diagnostics.to_text();
  EXPECT_EQ(read->samples, 2);
  type("Samples", "3");
  panel_.render_action()->trigger();
  ASSERT_TRUE(render_ends());
  ASSERT_EQ(differs.size(), 1);
  EXPECT_EQ(options::read_op_file(folder_.path("new.op"), diagnostics)->samples, 2);
  EXPECT_TRUE(options_.save_beside(path("new.grf"), diagnostics));
  EXPECT_EQ(options::read_op_file(folder_.path("new.op"), diagnostics)->samples, 3);
}

TEST_F(RenderPanelTest, ControlsAreThoseOfTheTable) {
  type("Target error", "2.5");
  control<QComboBox>("Sampling scheme")->setCurrentText("Hemisphere");
  type("Depth", "7");
  EXPECT_EQ(options_.undo_stack().count(), 3);
  EXPECT_EQ(options().target_error, 0.025F);
  EXPECT_EQ(options().scheme, "Hemisphere");
  EXPECT_EQ(options().depth, 7);
  options::RenderOptions render_options;
  render_options.scheme = "Reject";
  options_.follow(render_options);
  EXPECT_EQ(control<QComboBox>("Sampling scheme")->currentText(), "Reject");
  EXPECT_EQ(options_.undo_stack().count(), 3) << "not by hand";
}

TEST_F(RenderPanelTest, TakesArithmeticAndNothingForWhatIsNotGiven) {
  type("Width", "1920 / 7 px");
  EXPECT_EQ(options().size.width, 274);
  EXPECT_EQ(text_of("Width").text(), "274 px");
  EXPECT_EQ(text_of("Samples").placeholderText(), "auto");
  for (const char* nothing : {"", "0"}) {
    type("Samples", "2^6");
    EXPECT_EQ(options().samples, 64);
    type("Samples", nothing);
    EXPECT_EQ(options().samples, std::nullopt);
    EXPECT_EQ(text_of("Samples").text(), "");
    type("Target error", "0.3 %");
    EXPECT_EQ(options().target_error, 0.003F);
    type("Depth", "3");
    EXPECT_EQ(options().target_error, 0.003F) << "of another control";
    EXPECT_EQ(text_of("Target error").text(), "0.3 %");
    type("Target error", nothing);
    EXPECT_EQ(options().target_error, std::nullopt);
    type("Time limit", "1.5*60 s");
    EXPECT_EQ(options().max_seconds, 90.0F);
    type("Time limit", nothing);
    EXPECT_EQ(options().max_seconds, std::nullopt);
  }
  type("Height", "20000");
  EXPECT_EQ(options().size.height, options::RenderOptions().size.height);
  EXPECT_THAT(control<NumberBox>("Height")->toolTip().toStdString(),
              HasSubstr("<p>Range: 1 px to 16384 px.</p>"));
  EXPECT_THAT(control<NumberBox>("Height")->accessibleDescription().toStdString(),
              HasSubstr("Range: 1 px to 16384 px.\nWidth and height in pixels."));
}

// The buttons of tool bars take no focus.
TEST_F(RenderPanelTest, RendersWithWhatIsBeingTyped) {
  open(4);
  text_of("Samples").setText("2");
  panel_.render_action()->trigger();
  ASSERT_TRUE(render_ends());
  EXPECT_THAT(status(), HasSubstr("Done · 2 samples"));
}

TEST_F(RenderPanelTest, AllHaveNamesAndHelp) {
  for (const QWidget* widget : panel_.findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().startsWith("qt_")) continue;
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->metaObject()->className();
    EXPECT_FALSE(widget->toolTip().isEmpty()) << widget->metaObject()->className();
  }
}

TEST_F(RenderPanelTest, SaysWhyASceneCannotBeRendered) {
  grf::Scene scene = test::scene_of_text(test::Corner);
  test::first_mesh(scene).edit().surfaces[0].texture = grf::Texture{"lost.png", {}};
  open_scene(scene, path("scene.grf"));
  panel_.preview_action()->trigger();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !panel_.preview().is_on(); }, test::Minute));
  EXPECT_THAT(control<QPlainTextEdit>("Log")->toPlainText().toStdString(), HasSubstr("lost.png"));
  EXPECT_THAT(status(), HasSubstr("Preview failed"));
  panel_.render_action()->trigger();
  ASSERT_TRUE(render_ends());
  EXPECT_THAT(status(), HasSubstr("Render failed"));
}

}  // namespace
