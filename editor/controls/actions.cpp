#include "editor/controls/actions.h"

#include <QAction>
#include <QWidget>

#include "editor/appearance/icons.h"

namespace editor {
namespace {

QAction* make(QWidget& window, const ActionText& text) {
  auto* action = new QAction(text.text, &window);
  if (!text.icon.isEmpty()) action->setIcon(icon(text.icon));
  action->setStatusTip(text.tip);
  set_shortcuts(*action, {text.shortcut});
  window.addAction(action);
  return action;
}

}  // namespace

void set_shortcuts(QAction& action, const QList<QKeySequence>& shortcuts) {
  QList<QKeySequence> given = shortcuts;
  given.removeAll(QKeySequence());
  action.setShortcuts(given);
  const QString keys = action.shortcut().toString(QKeySequence::NativeText);
  const QString tip = action.statusTip();
  action.setToolTip(keys.isEmpty() ? tip : QString("%1 (%2)").arg(tip, keys));
}

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
