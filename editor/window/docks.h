#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;
class QSettings;
class QWidget;

namespace editor {

/// Title, icon, shortcut, tool tip and default area of a dock.
struct DockText {
  QString name;  ///< key in the settings
  QString title;
  QString icon;
  QKeySequence shortcut;
  QString tip;
};

/// The docks of a window: each has an action that shows and focuses it, or hides it if it has the focus. The
/// layout is restored in the next session.
class Docks {
 public:
  explicit Docks(QMainWindow& window) : window_(window) {}

  QDockWidget* add(const DockText& text, Qt::DockWidgetArea area, QWidget* contents);
  /// Shows a dock, in front of others that are tabbed with it.
  static void show(QDockWidget* dock);
  void fill(QMenu& menu) const;
  QAction* action_of(const QDockWidget* dock) const;

  /// Makes the current layout the one that `reset` restores.
  void keep_as_default();
  void reset();
  void save(QSettings& settings) const;
  void restore(const QSettings& settings);

 private:
  struct Entry {
    QDockWidget* dock;
    QAction* action;
  };

  QMainWindow& window_;
  QList<Entry> entries_;
  QByteArray default_;
};

}  // namespace editor
