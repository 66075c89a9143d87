#include "editor/controls/actions.h"

#include <QAction>
#include <QWidget>

#include "editor/appearance/icons.h"

namespace editor {
namespace {

QAction* make(QWidget& window, const ActionText& text) {
  auto* action = new QAction(text.text, &window);
  if (!text.icon.isEmpty()) action->setIcon(icon(text.icon));
  action->setShortcut(text.shortcut);
  const QString keys = text.shortcut.toString(QKeySequence::NativeText);
  action->setToolTip(keys.isEmpty() ? text.tip : QString("%1 (%2)").arg(text.tip, keys));
  action->setStatusTip(text.tip);
  window.addAction(action);
  return action;
}

}  // namespace

QAction* new_action(QWidget& window, const ActionText& text, const std::function<void()>& triggered) {
  QAction* action = make(window, text);
  QObject::connect(action, &QAction::triggered, action, triggered);
  return action;
}

QAction* new_switch(QWidget& window, const ActionText& text, bool is_on,
                    const std::function<void(bool)>& toggled) {
  QAction* action = make(window, text);
  action->setCheckable(true);
  action->setChecked(is_on);
  QObject::connect(action, &QAction::toggled, action, toggled);
  return action;
}

}  // namespace editor
