// Tests that every action and control of the editor's windows has texts and can be reached by keyboard.
#include "tests/editor/window/accessibility.h"

#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QTreeWidget>
#include <QWidgetAction>
#include <algorithm>
#include <map>
#include <memory>

#include <gtest/gtest.h>

#include "editor/image/image_browser.h"
#include "editor/options/options_window.h"
#include "editor/panels/face_query_dialog.h"
#include "editor/panels/light_panel.h"
#include "editor/panels/sky_dialog.h"
#include "editor/rendering/effects_page.h"
#include "editor/view/scene_view.h"
#include "editor/window/file_actions.h"
#include "editor/window/render_controller.h"
#include "editor/window/tools.h"
#include "tests/editor/window/window_driver.h"
#include "tests/support/paths.h"

namespace editor {
namespace {

QString plain(QString text) { return text.remove('&').remove("..."); }

/// Actions of Qt itself: toggles of docks and tool bars, and those inside line edits.
bool is_of_qt(const QAction& action) {
  const QObject* owner = action.parent();
  if (const auto* dock = qobject_cast<const QDockWidget*>(owner)) return dock->toggleViewAction() == &action;
  if (const auto* bar = qobject_cast<const QToolBar*>(owner)) return bar->toggleViewAction() == &action;
  return action.objectName().startsWith("_q_") ||
         QString(owner->metaObject()->className()).startsWith("QLineEdit");
}

void expect_words_of_actions(const QWidget& window) {
  std::map<std::pair<const QObject*, QString>, QString> shortcuts;
  for (const QAction* action : window.findChildren<QAction*>()) {
    if (qobject_cast<const QWidgetAction*>(action) != nullptr) continue;  // a widget in a tool bar
    if (action->isSeparator() || action->menu() != nullptr || is_of_qt(*action)) continue;
    const std::string text = action->text().toStdString();
    if (const auto* entry = qobject_cast<const QMenu*>(action->parent());
        entry != nullptr && !action->isEnabled())
      continue;  // the text of an empty menu
    EXPECT_FALSE(text.empty()) << "of " << action->parent()->metaObject()->className();
    EXPECT_NE(plain(action->toolTip()), plain(action->text())) << text;
    bool has_place = !action->shortcut().isEmpty();
    for (const QObject* place : action->associatedObjects())
      has_place = has_place || qobject_cast<const QMenu*>(place) != nullptr;
    EXPECT_TRUE(has_place) << text << " is in no menu and has no shortcut";
    const QObject* context =
        action->shortcutContext() == Qt::WindowShortcut ? &window : action->associatedObjects().value(0);
    for (const QKeySequence& keys : action->shortcuts()) {
      const auto [known, is_new] = shortcuts.try_emplace({context, keys.toString()}, action->text());
      EXPECT_TRUE(is_new) << keys.toString().toStdString() << " is of " << text << " and of "
                          << known->second.toStdString();
    }
  }
}

/// Checks that the mnemonics of menus and labels are unique.
void expect_letters_apart(const QMainWindow& window) {
  std::map<QString, QString> known;
  const auto add = [&known](const QString& text) {
    const QString letter = QKeySequence::mnemonic(text).toString();
    if (letter.isEmpty()) return;
    const auto [other, is_new] = known.try_emplace(letter, text);
    EXPECT_TRUE(is_new) << text.toStdString() << " and " << other->second.toStdString();
  };
  for (const QAction* menu : window.menuBar()->actions()) add(menu->text());
  for (const QLabel* label : window.findChildren<QLabel*>()) {
    if (label->isVisible() && label->buddy() != nullptr) add(label->text());
  }
}

TEST_F(Accessibility, OfTheMainWindow) {
  const test::TemporaryFolder folder;
  const QString file = QString::fromStdString(folder.path("box.grf"));
  QFile::copy(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.grf", file);
  MainWindow window(QString::fromStdString(folder.path("sessions")));
  window.resize(1800, 1150);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  expect_words_of_actions(window);
  const auto check_docks = [&] {
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
      Docks::show(dock);
      check_tabs(window);
    }
  };
  check_docks();
  window.files().open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.files().is_importing(); }, test::Minute));
  check_docks();
  test::action(window, "All").trigger();
  check_docks();
  test::action(window, "None").trigger();
  test::action(window, "Add a light").trigger();
  auto& lights = *window.findChild<LightPanel*>();
  lights.choose(window.document().objects().lights.front().path);
  check_docks();
  expect_letters_apart(window);
  window.image_browser();
  check_controls(window);
  test::action(window, "Effects").trigger();
  auto& effects = window.findChild<EffectsPage*>()->table();
  ASSERT_TRUE(QTest::qWaitFor([&] { return effects.topLevelItemCount() > 0; }, test::Minute));
  check_controls(window);
  expect_words_of_actions(window);
}

TEST_F(Accessibility, OfTheOptionsWindow) {
  OptionsWindow window;
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  expect_words_of_actions(window);
  check_tabs(window);
}

TEST_F(Accessibility, OfTheTools) {
  for (const Tool& tool : tools()) {
    SCOPED_TRACE(tool.name.toStdString());
    const std::unique_ptr<QWidget> window(tool.open({}));
    window->show();
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
    expect_words_of_actions(*window);
    check_tabs(*window);
  }
}

/// A sample file for each tool; for study tools the state of a study.
std::map<QString, QString> sample_files() {
  const QString box = GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box";
  std::map<QString, QString> files = {
      {"grfviewer", box + ".grf"}, {"op", box + ".op"}, {"image", box + ".png"}};
  for (const QFileInfo& study :
       QDir(GRANADA_SOURCE_DIR "/samples/studies/tools").entryInfoList({"*.study"}, QDir::Files)) {
    const std::string text = test::bytes_of(study.filePath().toStdString());
    const std::size_t name = text.find("tool ") + 5;
    files[QString::fromStdString(text.substr(name, text.find_first_of(" \n", name) - name))] =
        study.filePath();
  }
  return files;
}

TEST_F(Accessibility, OfTheToolsWithFiles) {
  const std::map<QString, QString> files = sample_files();
  for (const Tool& tool : tools()) {
    SCOPED_TRACE(tool.name.toStdString());
    const std::unique_ptr<QWidget> window(tool.open({files.at(tool.name)}));
    window->show();
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
    const auto* view = window->findChild<SceneView*>();
    const auto* images = window->findChild<ImageBrowser*>();
    ASSERT_TRUE(QTest::qWaitFor([&] {
      return (view == nullptr || view->isVisible()) && (images == nullptr || !images->names().empty());
    }));
    expect_words_of_actions(*window);
    check_tabs(*window);
  }
}

TEST_F(Accessibility, OfTheListOfShortcuts) {
  const test::TemporaryFolder folder;
  MainWindow window(QString::fromStdString(folder.path("sessions")));
  window.show();
  test::action(window, "Keyboard shortcuts").trigger();
  auto* list = window.findChild<QDialog*>("shortcuts");
  ASSERT_NE(list, nullptr);
  check_controls(*list);
  for (const char* keys : {"Ctrl+O", "F2", "Ctrl+Del"}) {  // of a menu, and of the scene's list
    EXPECT_FALSE(
        list->findChild<QTreeWidget*>()->findItems(keys, Qt::MatchExactly | Qt::MatchRecursive, 0).isEmpty())
        << keys;
  }
}

TEST_F(Accessibility, OfTheSkyDialog) {
  SkyDialog dialog;
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  check_controls(dialog);
}

TEST_F(Accessibility, OfTheDialogThatSelectsFaces) {
  const test::TemporaryFolder folder;
  MainWindow window(QString::fromStdString(folder.path("sessions")));
  window.show();
  test::action(window, "Select faces by...").trigger();
  auto* dialog = window.findChild<FaceQueryDialog*>();
  ASSERT_NE(dialog, nullptr);
  check_controls(*dialog);
}

TEST_F(Accessibility, OfActionsBySynonyms) {
  const test::TemporaryFolder folder;
  MainWindow window(QString::fromStdString(folder.path("sessions")));
  test::action(window, "Keyboard shortcuts").trigger();
  auto* dialog = window.findChild<QDialog*>("shortcuts");
  ASSERT_NE(dialog, nullptr);
  auto* search = dialog->findChild<QLineEdit*>();
  for (const auto& [query, name] :
       {std::pair("merge", "Append..."), std::pair("glossy", "BRDF"), std::pair("tumble", "Orbit")}) {
    search->setText(query);
    const auto rows =
        dialog->findChild<QTreeWidget*>()->findItems(name, Qt::MatchExactly | Qt::MatchRecursive, 1);
    ASSERT_FALSE(rows.isEmpty()) << name;
    EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [](const auto* row) { return !row->isHidden(); }))
        << query;
  }
  // Return runs the first action that the search left.
  search->setText("Tile edges of nothing");
  QTest::keyClick(search, Qt::Key_Return);
  search->setText("orthographic");
  const ViewCamera camera = window.view().camera();
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_NE(window.view().camera().is_orthographic(), camera.is_orthographic());
  EXPECT_FALSE(dialog->isVisible());
  search->setText("zyzzyva");
  for (const QTreeWidgetItem* row : dialog->findChild<QTreeWidget*>()->findItems("", Qt::MatchContains)) {
    EXPECT_TRUE(row->isHidden());
  }
}

}  // namespace
}  // namespace editor
