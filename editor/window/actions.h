#pragma once

#include <QKeySequence>
#include <QString>
#include <functional>

class QAction;
class QWidget;

namespace editor {

/// What an action of a menu is called, and how it is reached.
struct ActionText {
  QString text;  ///< with its mnemonic
  QString icon;  ///< name; may be empty
  QKeySequence shortcut;
  QString tip;  ///< what it does, in a sentence without its stop
};

/// An action of a window, whose shortcut works wherever the focus is in it.
QAction* new_action(QWidget& window, const ActionText& text, const std::function<void()>& triggered);

/// One that is on or off.
QAction* new_switch(QWidget& window, const ActionText& text, bool is_on,
                    const std::function<void(bool)>& toggled);

}  // namespace editor
