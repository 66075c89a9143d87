// The page Welcome and its lessons, each done step by step with pointer and keyboard.
#include <QCheckBox>
#include <QCommandLinkButton>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QTabBar>
#include <QToolButton>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/brdf/brdf_editor.h"
#include "editor/document/preferences.h"
#include "editor/panels/surface_panel.h"
#include "editor/rendering/forecast_row.h"
#include "editor/rendering/render_panel.h"
#include "editor/window/lesson_guide.h"
#include "editor/window/pages.h"
#include "editor/window/sample_scenes.h"
#include "editor/window/welcome_controller.h"
#include "editor/window/welcome_page.h"
#include "tests/editor/window/accessibility.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

using test::Minute;

TEST(SampleScenes, AreThoseWithOptionsAndAPicture) {
  const test::TemporaryFolder folder;
  const auto touch = [&](const std::string& name) {
    std::filesystem::create_directories(std::filesystem::path(folder.path(name)).parent_path());
    std::ofstream(folder.path(name)) << "x";
  };
  for (const char* name :
       {"b/red_room.grf", "b/red_room.op", "b/red_room.png", "a/baked.igrf", "a/baked.op", "a/baked.png",
        "a/no_options.grf", "a/no_options.png", "a/no_picture.grf", "a/no_picture.op", "a/texture.png",
        "c/red_room.op", "c/red_room.png", "c/lost.op", "c/lost.png", "top.grf", "top.op", "top.png"})
    touch(name);
  std::ofstream(folder.path("c/red_room.grf")) << "texture \"../a/texture.png\"";
  std::ofstream(folder.path("c/lost.grf")) << "include \"made_by_a_script.grf\"";
  const std::vector<SampleScene> found = sample_scenes(QString::fromStdString(folder.path("")));
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].title, "Baked");
  EXPECT_TRUE(found[0].file.endsWith("/a/baked.igrf"));
  EXPECT_TRUE(found[0].picture.endsWith("/a/baked.png"));
  EXPECT_EQ(found[1].title, "Red room (b)");
  EXPECT_EQ(found[2].title, "Red room (c)");
  EXPECT_TRUE(sample_scenes("/no/such/folder").empty());
}

/// The window of a first session, on the page Welcome.
class Welcome : public Authoring {
 protected:
  Welcome() {
    window_.resize(1600, 1000);
    window_.welcome().show_page();
  }

  WelcomePage& page() { return *window_.findChild<WelcomePage*>(); }
  QTabBar& tabs() { return test::named<QTabBar>(window_, "Pages"); }
  LessonGuide& guide() { return *window_.welcome().guide(); }
  QString card() {
    QString text;
    for (const QLabel* label : guide().findChildren<QLabel*>()) text += label->text() + '\n';
    return text;
  }
  void start(const QString& lesson) {
    QTest::mouseClick(&test::named<QCommandLinkButton>(page(), lesson), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor(
        [this] { return window_.welcome().guide() != nullptr && guide().is_running(); }, Minute));
    ASSERT_TRUE(QTest::qWaitFor([this] { return window_.view().is_complete(); }, Minute));
    window_.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  }
  /// Waits until the lesson is at a step, and checks that it marks what is in view.
  void expect_step(int step) {
    ASSERT_TRUE(QTest::qWaitFor([this, step] { return guide().step() == step; }, Minute))
        << card().toStdString();
    const bool is_end = guide().marked().isEmpty();
    EXPECT_TRUE(window_.rect().contains(guide().geometry())) << card().toStdString();
    if (!is_end) {
      EXPECT_TRUE(window_.rect().contains(guide().marked())) << card().toStdString();
    }
  }
  /// Checks that a widget is in the marked part of the window.
  void expect_marked(QWidget& widget) {
    const QRect place(widget.mapTo(&window_, QPoint()), widget.size());
    EXPECT_TRUE(guide().marked().contains(place)) << card().toStdString();
  }
  void expect_menu_marked(const QString& title) {
    for (QAction* entry : window_.menuBar()->actions()) {
      if (entry->text().remove('&') != title) continue;
      EXPECT_TRUE(guide().marked().contains(
          window_.menuBar()->actionGeometry(entry).translated(window_.menuBar()->mapTo(&window_, QPoint()))))
          << card().toStdString();
      return;
    }
    ADD_FAILURE() << "there is no menu " << title.toStdString();
  }
  /// Clicks a face of the model that is seen about the middle of the view.
  void click_model() {
    SceneView& view = window_.view();
    for (int step = 0; step < 64; ++step) {
      const QPoint place = view.rect().center() + QPoint(12 * (step % 8) - 48, 12 * (step / 8) - 48);
      if (!view.face_at(place)) continue;
      return QTest::mouseClick(&view, Qt::LeftButton, {}, place);
    }
    FAIL() << "no face is seen in the middle of the view";
  }
};

TEST_F(Welcome, ListsRecentFilesAndOpensOne) {
  std::ofstream(folder_.path("mine.grf"))
      << "begin mesh \"a\" begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs "
         "begin faces (0,1,2) end faces end mesh\n";
  add_recent_file(path("gone.grf"));
  add_recent_file(path("mine.grf"));
  window_.welcome().show_page();
  ASSERT_TRUE(QTest::qWaitFor([this] {
    return !page().findChildren<QCommandLinkButton*>().empty() &&
           page().findChildren<QCommandLinkButton*>().front()->isVisible();
  }));
  EXPECT_FALSE(test::named<QCommandLinkButton>(page(), "gone.grf").isEnabled());
  QSignalSpy replaced(&document(), &Document::scene_replaced);
  QTest::mouseClick(&test::named<QCommandLinkButton>(page(), "mine.grf"), Qt::LeftButton);
  ASSERT_TRUE(!replaced.empty() || replaced.wait(Minute));
  EXPECT_EQ(document().path(), path("mine.grf"));
  EXPECT_FALSE(page().isVisible()) << "the scene is shown instead";
  EXPECT_TRUE(window_.view().isVisible());
}

TEST_F(Welcome, OpensASampleByItsPicture) {
  auto& sample = test::named<QToolButton>(page(), "Cornell box (cornell_box)");
  EXPECT_FALSE(sample.icon().isNull());
  QSignalSpy replaced(&document(), &Document::scene_replaced);
  sample.setFocus();
  QTest::keyClick(&sample, Qt::Key_Space);
  ASSERT_TRUE(!replaced.empty() || replaced.wait(Minute));
  EXPECT_TRUE(document().path().endsWith("cornell_box.grf"));
  test::action(window_, "Welcome").trigger();
  EXPECT_TRUE(page().isVisible()) << "Help > Welcome shows it again";
}

TEST_F(Welcome, IsLeftOutAtTheStartOnRequest) {
  EXPECT_TRUE(Preferences::load().shows_welcome);
  auto* box = page().findChild<QCheckBox*>();
  EXPECT_TRUE(box->isChecked());
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Space);
  EXPECT_FALSE(Preferences::load().shows_welcome);
}

class WelcomeAccess : public Accessibility {};

TEST_F(WelcomeAccess, NamesEachControl) {
  const test::TemporaryFolder folder;
  MainWindow window(QString::fromStdString(folder.path("sessions")));
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  window.welcome().show_page();
  check_controls(window);
  window.welcome().start_lesson(2);
  check_controls(window);
}

TEST_F(Welcome, TeachesToLookAround) {
  start("Look around");
  expect_step(0);
  expect_marked(window_.view());
  EXPECT_FALSE(document().objects().meshes.empty()) << "a sample was opened";
  window_.view().setFocus();
  QTest::keyClick(&window_.view(), Qt::Key_Left);
  expect_step(1);
  QTest::keyClick(&window_.view(), Qt::Key_Plus);
  expect_step(2);
  QTest::keyClick(&window_.view(), Qt::Key_Home);
  ASSERT_TRUE(QTest::qWaitFor([this] { return window_.view().is_complete(); }, Minute));
  click_model();
  expect_step(3);
  expect_marked(window_.surface_panel());
  for (QPushButton* button : guide().findChildren<QPushButton*>())
    if (button->text().remove('&') == "Next") QTest::mouseClick(button, Qt::LeftButton);
  expect_step(4);
  window_.view().setFocus();
  QTest::keyClick(&window_.view(), Qt::Key_F);
  expect_step(5);
  EXPECT_TRUE(card().startsWith("Look around: done")) << card().toStdString();
  EXPECT_TRUE(guide().marked().isEmpty());
}

TEST_F(Welcome, TeachesToChangeAMaterial) {
  start("Change a material");
  click_model();
  expect_step(1);
  expect_menu_marked("Select");
  QTest::keyClick(&window_, Qt::Key_M, Qt::ControlModifier);
  expect_step(2);
  expect_marked(window_.brdf_editor());
  QTest::mouseClick(&test::named<QWidget>(window_, "Library"), Qt::LeftButton);
  auto& tiles = test::named<QListWidget>(window_, "BRDFs of the library");
  const QPoint tile = tiles.visualItemRect(tiles.item(1)).center();
  QTest::mouseClick(tiles.viewport(), Qt::LeftButton, {}, tile);
  QTest::mouseDClick(tiles.viewport(), Qt::LeftButton, {}, tile);
  expect_step(3);
  auto* slider = window_.brdf_editor().form().findChild<QSlider*>();
  ASSERT_NE(slider, nullptr);
  slider->setFocus();
  QTest::keyClick(slider, slider->value() > slider->minimum() ? Qt::Key_PageDown : Qt::Key_PageUp);
  expect_step(4);
  expect_menu_marked("Edit");
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  expect_step(5);
}

TEST_F(Welcome, TeachesToLightAScene) {
  start("Light a scene");
  expect_menu_marked("Scene");
  test::action(window_, "Add a sphere").trigger();
  expect_step(1);
  test::action(window_, "Add a studio").trigger();
  expect_step(2);
  expect_marked(window_.render_panel());
  QTest::keyClick(&window_, Qt::Key_F5);
  expect_step(3);
  EXPECT_TRUE(window_.render_panel().preview().is_on());
  // As the form of the selected light does.
  QTest::keyClick(&window_, Qt::Key_A, Qt::ControlModifier | Qt::AltModifier);
  expect_step(4);
}

TEST_F(Welcome, TeachesToRenderToAnError) {
  start("Render as accurately as you need");
  expect_menu_marked("File");
  EXPECT_EQ(guide().step(), 0);
  {
    const test::FileTyping typing(path("mine.grf"));
    QTest::keyClick(&window_, Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
  }
  expect_step(1);
  expect_marked(window_.render_panel());
  auto& forecasts = *window_.findChild<ForecastRow*>();
  EXPECT_TRUE(forecasts.isVisible());
  QTest::mouseClick(&test::named<QToolButton>(forecasts, "Render until an error of 5 %"), Qt::LeftButton);
  expect_step(2);
  EXPECT_EQ(document().options().valid_options().target_error, 0.05F);
}

TEST_F(Welcome, EndsALessonOnRequest) {
  start("Light a scene");
  for (QPushButton* button : guide().findChildren<QPushButton*>())
    if (button->text().remove('&') == "Close lesson") QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_FALSE(guide().is_running());
  EXPECT_TRUE(guide().marked().isEmpty());
  test::action(window_, "Add a sphere").trigger();
  QTest::qWait(400);
  EXPECT_FALSE(guide().is_running()) << "an edit starts nothing";
}

}  // namespace
}  // namespace editor
