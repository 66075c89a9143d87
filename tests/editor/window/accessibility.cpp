#include "tests/editor/window/accessibility.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QScrollBar>
#include <QSettings>
#include <QTabWidget>
#include <QTest>
#include <algorithm>
#include <vector>

#include "editor/image/image_pane.h"
#include "editor/view/scene_view.h"

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

}  // namespace

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

Accessibility::Accessibility() { QSettings().clear(); }

void Accessibility::check_controls(QWidget& window) {
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

void Accessibility::check_tabs(QWidget& window) {
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

}  // namespace editor
