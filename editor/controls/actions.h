#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>
#include <functional>

class QAction;
class QWidget;

namespace editor {

/// Title, icon, shortcut and tool tip of an action.
struct ActionText {
  QString text;  ///< with its mnemonic
  QString icon;  ///< name; may be empty
  QKeySequence shortcut;
  QString tip;  ///< imperative sentence without a full stop
};

/// Creates an action of a window, whose shortcut works wherever the focus is in the window.
QAction* new_action(QWidget& window, const ActionText& text, const std::function<void()>& triggered);

/// Sets the shortcuts of an action; its tool tip has the first one.
void set_shortcuts(QAction& action, const QList<QKeySequence>& shortcuts);

/// Creates a checkable action.
QAction* new_switch(QWidget& window, const ActionText& text, bool is_on,
                    const std::function<void(bool)>& toggled);

}  // namespace editor
