// Users can change the shortcuts of menu entries.
#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>
#include <vector>

class QAction;
class QMainWindow;

namespace editor {

/// Holds the shortcuts of all entries of a window's menus: the default ones, and those that the user chose,
/// which are kept in the settings.
class ShortcutKeys {
 public:
  struct Entry {
    QAction* action;
    QString name;  ///< menu and text, unique in the window
    QList<QKeySequence> defaults;
  };

  /// Finds the entries of the menus, which must be complete, and restores the user's shortcuts.
  explicit ShortcutKeys(const QMainWindow& window);

  const std::vector<Entry>& entries() const { return entries_; }
  /// Returns another action of the window, or of a control in it, that has the shortcut; null if it is free.
  const QAction* other_with(const QKeySequence& keys, const Entry& entry) const;
  /// Sets and stores the shortcuts of an entry; none is allowed.
  void set(const Entry& entry, const QList<QKeySequence>& keys);
  /// Restores and stores the default of each entry.
  void reset();

 private:
  const QMainWindow& window_;
  std::vector<Entry> entries_;
};

}  // namespace editor
