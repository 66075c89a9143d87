#include "editor/window/docks.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>
#include <algorithm>

#include "editor/appearance/icons.h"
#include "editor/controls/actions.h"

namespace editor {
namespace {

bool has_focus(const QDockWidget* dock) {
  const QWidget* focused = QApplication::focusWidget();
  return focused != nullptr && dock->isAncestorOf(focused);
}

/// The first widget of a dock in the tab order.
QWidget* first_field(QDockWidget* dock) {
  for (QWidget* each = dock->widget(); each != nullptr && dock->isAncestorOf(each);
       each = each->nextInFocusChain()) {
    if (each->isVisible() && each->isEnabled() && (each->focusPolicy() & Qt::TabFocus) != 0) return each;
  }
  return nullptr;
}

void toggle(QDockWidget* dock) {
  if (dock->isVisible() && has_focus(dock)) return dock->hide();
  Docks::show(dock);
  if (QWidget* field = first_field(dock)) field->setFocus(Qt::ShortcutFocusReason);
}

}  // namespace

QDockWidget* Docks::add(const DockText& text, Qt::DockWidgetArea area, QWidget* contents) {
  auto* dock = new QDockWidget(text.title, &window_);
  dock->setObjectName(text.name);
  dock->setAccessibleName(text.title);
  dock->setToolTip(text.tip);
  dock->setWidget(contents);
  window_.addDockWidget(area, dock);
  QAction* action =
      new_action(window_, {text.title, text.icon, text.shortcut, text.tip}, [dock] { toggle(dock); });
  entries_.append({dock, action});
  return dock;
}

void Docks::show(QDockWidget* dock) {
  dock->show();
  dock->raise();
}

void Docks::fill(QMenu& menu) const {
  for (const Entry& entry : entries_) menu.addAction(entry.action);
}

QAction* Docks::action_of(const QDockWidget* dock) const {
  const auto entry = std::ranges::find_if(entries_, [dock](const Entry& each) { return each.dock == dock; });
  return entry->action;
}

void Docks::keep_as_default() { default_ = window_.saveState(); }

void Docks::reset() { window_.restoreState(default_); }

void Docks::save(QSettings& settings) const {
  settings.setValue("window/geometry", window_.saveGeometry());
  settings.setValue("window/docks", window_.saveState());
}

void Docks::restore(const QSettings& settings) {
  window_.restoreGeometry(settings.value("window/geometry").toByteArray());
  window_.restoreState(settings.value("window/docks").toByteArray());
}

}  // namespace editor
