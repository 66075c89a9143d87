// What every action and every control of the editor's windows has: words, and a way to them without a mouse.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAccessible>
#include <QComboBox>
#include <QDockWidget>
#include <QMenu>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QTabWidget>
#include <QToolBar>
#include <QWidgetAction>
#include <map>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "editor/image/image_pane.h"
#include "editor/options/options_window.h"
#include "editor/panels/light_panel.h"
#include "editor/rendering/render_panel.h"
#include "editor/window/file_actions.h"
#include "editor/window/render_link.h"
#include "editor/window/tools.h"
#include "tests/editor/window/window_driver.h"

namespace editor {
namespace {

std::string described(const QWidget& widget) {
  QString text = widget.metaObject()->className();
  for (const QWidget* each = &widget; each != nullptr; each = each->parentWidget()) {
    if (!each->accessibleName().isEmpty()) text += " in " + each->accessibleName();
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) text += " '" + button->text() + "'";
  return text.toStdString();
}

QString plain(QString text) { return text.remove('&').remove("..."); }

/// Qt's own: the switches of docks and tool bars, and what line edits have inside.
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
      continue;  // what an empty menu says
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

/// Its own, or that of what it is a part of, which Qt shows in its place.
bool has_tool_tip(const QWidget& widget) {
  for (const QWidget* each = &widget; each != nullptr && !each->isWindow(); each = each->parentWidget()) {
    if (qobject_cast<const QDockWidget*>(each) != nullptr) return false;
    if (!each->toolTip().isEmpty()) return true;
  }
  return false;
}

/// Pictures that fill a page: a tool tip would cover what one looks at, and the status line says it.
bool is_picture(const QWidget& widget) {
  return qobject_cast<const SceneView*>(&widget) != nullptr ||
         qobject_cast<const ImagePane*>(&widget) != nullptr;
}

/// Whether a widget is one that people use, and no part of another.
bool is_control(const QWidget& widget) {
  if (!widget.isVisible() || widget.focusPolicy() == Qt::NoFocus || widget.focusProxy() != nullptr)
    return false;
  if (widget.objectName().startsWith("qt_") || qobject_cast<const QScrollBar*>(&widget) != nullptr)
    return false;
  const QWidget* owner = widget.parentWidget();
  return qobject_cast<const QComboBox*>(owner) == nullptr &&
         qobject_cast<const QAbstractSpinBox*>(owner) == nullptr && !widget.isWindow();
}

class Accessibility : public testing::Test {
 protected:
  Accessibility() { QSettings().clear(); }

  /// The controls that are seen now have names and tool tips, and Tab leads away from each of them.
  void check_controls(QWidget& window) {
    QTest::qWait(1);
    std::size_t controls = 0;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
      if (!is_control(*widget) || widget->window() != &window) continue;
      ++controls;
      if (!seen_.insert(described(*widget)).second) continue;
      const auto* interface = QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
      EXPECT_TRUE(interface != nullptr && !interface->text(QAccessible::Name).isEmpty())
          << "no name: " << described(*widget);
      EXPECT_TRUE(has_tool_tip(*widget) || is_picture(*widget)) << "no tool tip: " << described(*widget);
      if (qobject_cast<const QAbstractButton*>(widget) != nullptr) {
        EXPECT_NE(widget->focusPolicy() & Qt::TabFocus, 0) << "not by Tab: " << described(*widget);
      }
    }
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    if (window.focusWidget() == nullptr) window.setFocus();
    for (std::size_t i = 0; controls > 1 && i < controls + 20 && QApplication::focusWidget() != nullptr;
         ++i) {
      QWidget* before = QApplication::focusWidget();
      QTest::keyClick(before, Qt::Key_Tab);
      ASSERT_NE(QApplication::focusWidget(), before) << "Tab does not leave " << described(*before);
    }
  }

  /// With each tab of what is seen.
  void check_tabs(QWidget& window) {
    check_controls(window);
    for (QTabWidget* tabs : window.findChildren<QTabWidget*>()) {
      if (!tabs->isVisible()) continue;
      for (int tab = 0; tab < tabs->count(); ++tab) {
        tabs->setCurrentIndex(tab);
        check_controls(window);
      }
      if (tabs->isVisible()) tabs->setCurrentIndex(0);
    }
  }

  std::set<std::string> seen_;
};

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
  check_docks();
  test::action(window, "All").trigger();
  check_docks();
  test::action(window, "None").trigger();
  test::action(window, "Add a light").trigger();
  auto& lights = *window.findChild<LightPanel*>();
  lights.choose(window.document().objects().lights.front().path);
  check_docks();
  window.image_browser();
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

}  // namespace
}  // namespace editor
