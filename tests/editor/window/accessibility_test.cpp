// Tests that every action and control of the editor's windows has texts and can be reached by keyboard.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAccessible>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QTabWidget>
#include <QToolBar>
#include <QTreeWidget>
#include <QWidgetAction>
#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "editor/brdf/brdf_editor.h"
#include "editor/controls/notice_bar.h"
#include "editor/image/image_browser.h"
#include "editor/image/image_pane.h"
#include "editor/options/options_window.h"
#include "editor/panels/light_panel.h"
#include "editor/panels/message_panel.h"
#include "editor/rendering/render_panel.h"
#include "editor/view/scene_view.h"
#include "editor/window/file_actions.h"
#include "editor/window/render_controller.h"
#include "editor/window/source_view.h"
#include "editor/window/tools.h"
#include "grf/read.h"
#include "tests/editor/window/window_driver.h"
#include "tests/support/paths.h"

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

/// Its own tool tip, or that of its parent, which Qt shows instead.
bool has_tool_tip(const QWidget& widget) {
  for (const QWidget* each = &widget; each != nullptr && !each->isWindow(); each = each->parentWidget()) {
    if (qobject_cast<const QDockWidget*>(each) != nullptr) return false;
    if (!each->toolTip().isEmpty()) return true;
  }
  return false;
}

/// Pictures that fill a page, whose tool tip would cover them; the status line has their text.
bool is_picture(const QWidget& widget) {
  return qobject_cast<const SceneView*>(&widget) != nullptr ||
         qobject_cast<const ImagePane*>(&widget) != nullptr;
}

/// Whether a widget is used directly, and is not a part of another control.
bool is_control(const QWidget& widget) {
  if (!widget.isVisible() || widget.focusPolicy() == Qt::NoFocus || widget.focusProxy() != nullptr)
    return false;
  if (widget.objectName().startsWith("qt_") || qobject_cast<const QScrollBar*>(&widget) != nullptr)
    return false;
  const QWidget* owner = widget.parentWidget();
  return qobject_cast<const QComboBox*>(owner) == nullptr &&
         qobject_cast<const QAbstractSpinBox*>(owner) == nullptr && !widget.isWindow();
}

/// Whether Tab has to reach it. In a group of exclusive buttons Tab reaches the checked one, and arrows the
/// others: Qt changes their focus policy once one has the focus.
bool is_led_to(const QWidget& widget) {
  return is_control(widget) && widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus) != 0;
}

/// The dock that contains a control, or another part of the window.
const QWidget* part_of(const QWidget& widget) {
  const QWidget* each = &widget;
  while (qobject_cast<const QDockWidget*>(each) == nullptr && !each->parentWidget()->isWindow())
    each = each->parentWidget();
  return each;
}

/// Right of another one or under it in reading order, or at the top of the next column.
bool is_read_after(const QWidget& next, const QWidget& before) {
  const auto place = [](const QWidget& widget) {
    return QRect(widget.mapTo(widget.window(), QPoint()), widget.size());
  };
  return place(next).top() >= place(before).center().y() || place(next).left() >= place(before).center().x();
}

/// Whether the window's last control precedes this one, so that the tab order starts again.
bool begins_anew(const QWidget& next, const QWidget& before) {
  const QWidget* each = &before;
  while (each != &next && !each->isWindow()) each = each->nextInFocusChain();
  return each != &next;
}

/// The full cycle of Tab, or of Shift+Tab, in reading order within each dock.
std::vector<QWidget*> tab_around(QWidget& start, Qt::KeyboardModifiers modifiers = {}) {
  std::vector<QWidget*> way;
  const auto most = start.window()->findChildren<QWidget*>().size();
  start.setFocus(Qt::OtherFocusReason);
  for (QWidget* each = &start; way.empty() || each != &start; each = QApplication::focusWidget()) {
    if (!way.empty() && modifiers == Qt::NoModifier && part_of(*each) == part_of(*way.back())) {
      EXPECT_TRUE(is_read_after(*each, *way.back()) || begins_anew(*each, *way.back()))
          << "Tab leads back, from " << described(*way.back()) << " to " << described(*each);
    }
    way.push_back(each);
    QTest::keyClick(each, Qt::Key_Tab, modifiers);
    if (QApplication::focusWidget() == each || std::ssize(way) > most) {
      ADD_FAILURE() << "Tab does not lead from " << described(*each) << " on to " << described(start);
      break;
    }
  }
  return way;
}

/// Checks that Tab reaches everything visible, dock after dock, and Shift+Tab the reverse.
void expect_tab_leads_to_all(QWidget& start) {
  QTest::qWait(1);
  const std::vector<QWidget*> way = tab_around(start);
  const std::set<const QWidget*> reached(way.begin(), way.end());
  for (const QWidget* widget : start.window()->findChildren<QWidget*>()) {
    if (!is_led_to(*widget) || widget->window() != start.window()) continue;
    EXPECT_TRUE(reached.contains(widget)) << "Tab does not lead to " << described(*widget);
  }
  std::set<const QWidget*> left;
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (part_of(*way[i]) == part_of(*way[i - 1])) continue;
    left.insert(part_of(*way[i - 1]));
    const bool is_of_the_first = part_of(*way[i]) == part_of(start);  // which started in its middle
    EXPECT_TRUE(is_of_the_first || !left.contains(part_of(*way[i])))
        << described(*way[i]) << " comes apart from what is beside it";
  }
  std::vector<QWidget*> back = tab_around(start, Qt::ShiftModifier);
  std::reverse(back.begin() + 1, back.end());
  EXPECT_TRUE(back == way) << "Shift and Tab do not lead the same way";
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

class Accessibility : public testing::Test {
 protected:
  Accessibility() { QSettings().clear(); }

  /// Checks that visible controls have names and tool tips, and are reached by Tab.
  void check_controls(QWidget& window) {
    QTest::qWait(1);
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
      if (!is_control(*widget) || widget->window() != &window) continue;
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
    const auto all = window.findChildren<QWidget*>();
    const auto is_seen = [](const QWidget* each) { return is_led_to(*each); };
    if (std::count_if(all.begin(), all.end(), is_seen) > 1) {
      expect_tab_leads_to_all(**std::find_if(all.begin(), all.end(), is_seen));
    }
  }

  /// Checks each tab of the window.
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

TEST_F(Accessibility, OfTheToolsWithFiles) {
  const std::map<QString, QString> files = {
      {"grfviewer", "cornell_box.grf"}, {"op", "cornell_box.op"}, {"image", "cornell_box.png"}};
  for (const Tool& tool : tools()) {
    SCOPED_TRACE(tool.name.toStdString());
    const std::unique_ptr<QWidget> window(
        tool.open({GRANADA_SOURCE_DIR "/samples/cornell_box/" + files.at(tool.name)}));
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
  search->setText("zyzzyva");
  for (const QTreeWidgetItem* row : dialog->findChild<QTreeWidget*>()->findItems("", Qt::MatchContains)) {
    EXPECT_TRUE(row->isHidden());
  }
}

/// Faces whose rows in the docks differ as much as possible.
const std::string ManyRows = R"(def gold = brdf ward sx=0.2
def dull = brdf diffuse kd=0.3
def red = rgb (1, 0, 0)
begin
begin mesh
  begin vertexs
    (0, 0, 0) (2, 0, 0) (2, 1, 0) (0, 1, 0)
  end vertexs
  begin faces
    brdf phong n=20 ks=(0.1, 0.2, 0.3)
    pdf adaptive mode=reject
    rgb red
    (0, 1, 2)
    brdf combine 0.4 gold, 0.6 dull
    light rgb (1, 2, 3)
    (0, 2, 3)
    brdf ashikhmin ex=20
    light none
    (0, 1, 3)
    brdf diffuse
    (1, 2, 3)
  end faces
end mesh
end
)";

/// Tests of the tab order in the whole window.
class TabOrder : public Accessibility {
 protected:
  TabOrder() : window_(QString::fromStdString(folder_.path("sessions"))) {
    window_.resize(1900, 1150);
    window_.show();
    window_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
  }

  void open() {
    QSignalSpy replaced(&window_.document(), &Document::scene_replaced);
    window_.files().open(QString::fromStdString(folder_.add("rows.grf", ManyRows)));
    if (replaced.empty() && !replaced.wait(60'000)) throw std::runtime_error("the scene cannot be read");
  }

  void select_face(std::uint32_t face) {
    FaceSelection selection(window_.document().objects());
    selection.set({0, face});
    window_.document().select(std::move(selection));
  }

  QDockWidget& dock(const QString& name) { return *window_.findChild<QDockWidget*>(name); }

  void expect_all_views_of_brdfs() {
    using View = BrdfEditor::View;
    for (const View view : {View::Lobe, View::Plots, View::Library, View::Sphere}) {
      SCOPED_TRACE(static_cast<int>(view));
      window_.brdf_editor().set_view(view);
      check_controls(window_);
    }
  }

  test::TemporaryFolder folder_;
  MainWindow window_;
};

TEST_F(TabOrder, LeadsToAllOfAFreshWindow) {
  expect_tab_leads_to_all(window_.view());
  for (const char* name : {"render", "messages"}) {
    SCOPED_TRACE(name);
    Docks::show(&dock(name));
    expect_tab_leads_to_all(window_.view());
  }
}

TEST_F(TabOrder, LeadsToAllOfWhatFacesHave) {
  open();
  expect_tab_leads_to_all(window_.view());
  test::action(window_, "All").trigger();
  expect_tab_leads_to_all(window_.view());
  for (std::uint32_t face = 0; face < 4; ++face) {  // each with its own form, which is created and removed
    SCOPED_TRACE(face);
    select_face(face);
    check_controls(window_);
  }
  grf::Diagnostics diagnostics;
  window_.brdf_editor().set_models({*grf::read_brdf("measured \"a.binary\"", "test", diagnostics)});
  check_controls(window_);
  test::action(window_, "Add a light").trigger();
  window_.findChild<LightPanel*>()->choose(window_.document().objects().lights.back().path);
  expect_tab_leads_to_all(window_.view());
}

TEST_F(TabOrder, LeadsToAllOfTheBrdfEditorInEachOfItsShapes) {
  open();
  select_face(0);
  expect_all_views_of_brdfs();
  ASSERT_FALSE(window_.brdf_editor().is_unfolded());
  window_.resizeDocks({&dock("brdf")}, {1000}, Qt::Horizontal);
  ASSERT_TRUE(QTest::qWaitFor([this] { return window_.brdf_editor().is_unfolded(); }));
  expect_all_views_of_brdfs();
  select_face(1);
  expect_tab_leads_to_all(window_.view());
  window_.resizeDocks({&dock("brdf")}, {360}, Qt::Horizontal);
  ASSERT_TRUE(QTest::qWaitFor([this] { return !window_.brdf_editor().is_unfolded(); }));
  expect_all_views_of_brdfs();
}

TEST_F(TabOrder, LeadsToAllOfNoticesAndPages) {
  open();
  window_.notice().show_notice(NoticeBar::Kind::Information, "Something", {{"Mend it", "Mends it", {}}});
  expect_tab_leads_to_all(window_.view());
  expect_tab_leads_to_all(window_.image_browser().pane());
  const std::string path = folder_.path("rows.grf");
  emit window_.message_panel().place_requested(grf::whole_file(path));
  QPlainTextEdit& text = *window_.findChild<SourceView*>()->text();
  ASSERT_TRUE(QTest::qWaitFor([&text] { return text.isVisible(); }));
  expect_tab_leads_to_all(text);
}

TEST_F(TabOrder, BeginsWhereAltAndALetterLead) {
  open();
  select_face(0);
  for (const auto& [letter, name] : {std::pair(Qt::Key_B, "BRDF"), std::pair(Qt::Key_O, "Colour, red"),
                                     std::pair(Qt::Key_A, "Irradiance, red")}) {
    window_.show_scene();
    QTest::keyClick(&window_.view(), letter, Qt::AltModifier);
    ASSERT_NE(QApplication::focusWidget(), nullptr);
    EXPECT_EQ(QApplication::focusWidget()->accessibleName(), name);
  }
}

TEST_F(TabOrder, StaysWhereDocksAreMoved) {
  open();
  select_face(0);
  for (const char* name : {"scene", "brdf"}) {
    SCOPED_TRACE(name);
    dock(name).setFloating(true);
    window_.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
    expect_tab_leads_to_all(window_.view());
    dock(name).setFloating(false);
    expect_tab_leads_to_all(window_.view());
  }
  window_.tabifyDockWidget(&dock("scene"), &dock("surface"));
  expect_tab_leads_to_all(window_.view());
  test::action(window_, "Reset layout").trigger();
  expect_tab_leads_to_all(window_.view());
}

}  // namespace
}  // namespace editor
