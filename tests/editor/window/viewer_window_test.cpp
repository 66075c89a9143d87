#include "editor/window/viewer_window.h"

#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>
#include <QUrl>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/controls/notice_bar.h"
#include "editor/window/source_view.h"
#include "tests/editor/pointer.h"
#include "tests/editor/view/shown_view.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using testing::HasSubstr;

class ViewerWindowTest : public testing::Test {
 protected:
  ViewerWindowTest() { QSettings().clear(); }

  void SetUp() override {
    window_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
  }

  QString file(const std::string& name, const std::string& bytes = test::cube_text()) {
    return QString::fromStdString(folder_.add(name, bytes));
  }
  /// Whether the window shows a file and emits `opened` after an action.
  bool shows(const std::function<void()>& action) { return comes(&ViewerWindow::opened, action); }
  bool fails(const std::function<void()>& action) { return comes(&ViewerWindow::failed, action); }
  bool opens(const QString& path) {
    return shows([&] { window_.open(path); });
  }
  template <class Signal>
  bool comes(Signal signal, const std::function<void()>& action) {
    QSignalSpy spy(&window_, signal);
    action();
    return !spy.empty() || spy.wait(20000);
  }

  void move(const QPoint& to, Qt::MouseButton button) { test::move_pointer(window_.view(), to, button); }
  const SceneObjects& objects() { return window_.view().objects(); }
  std::string notice() { return window_.notice().text().toStdString(); }
  std::string status() const {
    QString all;
    for (const QLabel* label : window_.statusBar()->findChildren<QLabel*>()) {
      if (label->isVisible()) all += label->text() + '\n';
    }
    return all.toStdString();
  }
  /// The window with the source text; null if there is none.
  static const SourceView* shown_source() {
    for (const QWidget* widget : QApplication::topLevelWidgets()) {
      const auto* source = qobject_cast<const SourceView*>(widget);
      if (source != nullptr && source->isVisible()) return source;
    }
    return nullptr;
  }
  QList<QAction*> file_actions() const { return window_.menuBar()->actions().first()->menu()->actions(); }

  test::TemporaryFolder folder_;
  ViewerWindow window_;
};

TEST_F(ViewerWindowTest, SaysWhatToDoWhileThereIsNoScene) {
  EXPECT_FALSE(window_.view().isVisible());
  EXPECT_FALSE(file_actions()[1]->isEnabled());
  EXPECT_THAT(file_actions()[1]->toolTip().toStdString(), HasSubstr("open a file first"));
  window_.open({});
  window_.reload();
  EXPECT_EQ(window_.path(), QString());
}

TEST_F(ViewerWindowTest, ShowsAScene) {
  ASSERT_TRUE(opens(file("cube.grf")));
  EXPECT_EQ(objects().meshes.size(), 1U);
  EXPECT_EQ(window_.windowTitle(), "cube.grf - GRF viewer");
  EXPECT_THAT(status(), HasSubstr("6 faces, 12 triangles"));
  EXPECT_FALSE(window_.notice().isVisible());
  ASSERT_TRUE(test::wait_for([&] { return window_.view().is_complete(); }));
  // The scene is framed: visible in the middle, and not at the edge.
  SceneView& view = window_.view();
  QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.rect().center());
  EXPECT_EQ(view.selection().count(), 1U);
  EXPECT_THAT(status(), HasSubstr("1 selected"));
  QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, QPoint(4, 4));
  EXPECT_EQ(view.selection().count(), 0U);
  EXPECT_THAT(status(), testing::Not(HasSubstr("selected")));
}

TEST_F(ViewerWindowTest, SaysWhatIsUnderThePointer) {
  ASSERT_TRUE(opens(file("cube.grf")));
  ASSERT_TRUE(test::wait_for([&] { return window_.view().is_complete(); }));
  move(window_.view().rect().center(), Qt::NoButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return status().find("cube") != std::string::npos; }));
}

TEST_F(ViewerWindowTest, CountsWarnings) {
  ASSERT_TRUE(opens(file("cube.grf",
                         "begin mesh begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs\n"
                         "begin faces (0,1,2) end mesh\n")));
  EXPECT_THAT(status(), HasSubstr("1 warning\n"));
}

TEST_F(ViewerWindowTest, ReadsAFileAgainWhenItChanges) {
  const QString path = file("cube.grf");
  ASSERT_TRUE(opens(path));
  ViewCamera camera = window_.view().camera();
  camera.orbit(1, 0);
  window_.view().set_camera(camera);
  ASSERT_TRUE(shows([&] { file("cube.grf", test::cube_text() + test::cube_text()); })) << "written to";
  EXPECT_EQ(objects().meshes.size(), 2U);
  EXPECT_EQ(window_.view().camera(), camera) << "from where one looked at it";
  ASSERT_TRUE(shows([&] {
    file("new.grf", test::cube_text() + test::cube_text() + test::cube_text());
    std::filesystem::rename(folder_.path("new.grf"), folder_.path("cube.grf"));
  })) << "replaced";
  EXPECT_EQ(objects().meshes.size(), 3U);
  ASSERT_TRUE(shows([&] { file("cube.grf"); })) << "and watched on";
  EXPECT_EQ(objects().meshes.size(), 1U);
}

TEST_F(ViewerWindowTest, WatchesIncludedFilesAndNoOthers) {
  file("part.grf");
  ASSERT_TRUE(opens(file("scene.grf", "include \"part.grf\"\n")));
  EXPECT_EQ(objects().meshes.size(), 1U);
  ASSERT_TRUE(shows([&] { file("part.grf", test::cube_text() + test::cube_text()); }));
  EXPECT_EQ(objects().meshes.size(), 2U);
  QSignalSpy opened(&window_, &ViewerWindow::opened);
  file("other.grf");
  EXPECT_FALSE(opened.wait(500));
}

TEST_F(ViewerWindowTest, KeepsTheSceneWhenItsFileIsBroken) {
  const QString path = file("cube.grf");
  ASSERT_TRUE(opens(path));
  ASSERT_TRUE(fails([&] { file("cube.grf", "begin mesh\n  brdf 7\n"); }));
  EXPECT_TRUE(window_.notice().isVisible());
  EXPECT_THAT(notice(), HasSubstr("cube.grf:2:8: error:"));
  EXPECT_THAT(notice(), HasSubstr("previous version is still shown"));
  EXPECT_EQ(objects().meshes.size(), 1U);
  EXPECT_TRUE(window_.view().isVisible());

  auto* show_line = window_.notice().findChildren<QPushButton*>().first();
  QTest::mouseClick(show_line, Qt::LeftButton);
  const SourceView* source = shown_source();
  ASSERT_NE(source, nullptr);
  EXPECT_EQ(source->path(), path);

  ASSERT_TRUE(shows([&] { file("cube.grf"); })) << "once it is mended";
  EXPECT_FALSE(window_.notice().isVisible());
  window_.close();
  EXPECT_EQ(shown_source(), nullptr);
}

TEST_F(ViewerWindowTest, KeepsTheSceneWhenAnotherCannotBeOpened) {
  ASSERT_TRUE(opens(file("cube.grf")));
  ASSERT_TRUE(fails([&] { window_.open(QString::fromStdString(folder_.path("later.grf"))); }));
  EXPECT_THAT(notice(), HasSubstr("later.grf"));
  EXPECT_THAT(notice(), HasSubstr("cube.grf is still shown"));
  EXPECT_EQ(window_.windowTitle(), "cube.grf - GRF viewer");
  ASSERT_TRUE(shows([&] { file("later.grf", test::cube_text() + test::cube_text()); }));
  EXPECT_EQ(window_.windowTitle(), "later.grf - GRF viewer");
}

TEST_F(ViewerWindowTest, ShowsModelsOfOtherFormats) {
  ASSERT_TRUE(opens("/usr/share/glmark2/models/bunny.obj"));
  EXPECT_GT(objects().faces, 1000U);
  EXPECT_EQ(window_.windowTitle(), "bunny.obj - GRF viewer");
  ASSERT_TRUE(fails([&] { window_.open(file("broken.obj", "f 1 2 3\n")); }));
  EXPECT_THAT(notice(), HasSubstr("broken.obj"));
  EXPECT_GT(objects().faces, 1000U);
  ASSERT_TRUE(shows([&] { file("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); }));
  EXPECT_EQ(objects().faces, 1U);
}

TEST_F(ViewerWindowTest, TheFileAskedForLastCounts) {
  const QString first = file("first.grf");
  const QString second = file("second.grf", test::cube_text() + test::cube_text());
  QSignalSpy opened(&window_, &ViewerWindow::opened);
  window_.open("/usr/share/glmark2/models/bunny.obj");
  window_.open(first);
  window_.open(second);
  ASSERT_TRUE(opened.wait(20000));
  EXPECT_EQ(opened.size(), 1);
  EXPECT_EQ(objects().meshes.size(), 2U);
}

TEST_F(ViewerWindowTest, TakesFilesThatAreDropped) {
  const auto drop = [this](const QList<QUrl>& urls) {
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.setAccepted(false);
    QApplication::sendEvent(&window_, &enter);
    if (!enter.isAccepted()) return false;
    QDropEvent event(QPointF(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window_, &event);
    return true;
  };
  EXPECT_FALSE(drop({QUrl("https://example.org/cube.grf")}));
  ASSERT_TRUE(shows([&] { EXPECT_TRUE(drop({QUrl::fromLocalFile(file("cube.grf"))})); }));
}

TEST_F(ViewerWindowTest, ReloadsAndClosesByTheMenu) {
  ASSERT_TRUE(opens(file("cube.grf")));
  EXPECT_TRUE(shows([&] { file_actions()[1]->trigger(); }));
  for (const QAction* action : file_actions()) {
    if (action->isSeparator()) continue;
    EXPECT_FALSE(action->shortcut().isEmpty());
    EXPECT_NE(action->toolTip(), action->text());
  }
  file_actions().last()->trigger();
  EXPECT_FALSE(window_.isVisible());
  EXPECT_TRUE(QSettings().contains("viewer/geometry"));
}

TEST_F(ViewerWindowTest, MovesNothing) {
  ASSERT_TRUE(opens(file("cube.grf", test::cube_text() + "light begin (-1,3,-1) (2,0,0) (0,0,2) end\n")));
  SceneView& view = window_.view();
  ASSERT_TRUE(test::wait_for([&] { return view.is_complete(); }));
  ASSERT_EQ(view.handles().size(), 1U);
  const SceneHandle before = view.handles().front();
  const double aspect = double(view.width()) / view.height();
  const grf::Vec2d place = *view.camera().place_of(before.grip, aspect);
  const QPoint pixel(int((0.5 + 0.5 * place.x) * view.width()), int((0.5 - 0.5 * place.y) * view.height()));
  QSignalSpy moved(&view, &SceneView::object_moved);
  QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, pixel);
  for (const int way : {10, 30}) move(pixel + QPoint(way, way), Qt::LeftButton);
  QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, pixel + QPoint(30, 30));
  ASSERT_EQ(moved.size(), 1);
  EXPECT_EQ(view.handles().front().position, before.position);
  EXPECT_THAT(window_.statusBar()->currentMessage().toStdString(), HasSubstr("open the scene in the editor"));
}

}  // namespace
}  // namespace editor
