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

/// What a dock is, and where it stands at first.
struct DockText {
  QString name;  ///< by which settings know it
  QString title;
  QString icon;
  QKeySequence shortcut;
  QString tip;
};

/// The docks of a window: each has an action that shows it and gives it the focus, or hides it if it has
/// that. Where they stand is remembered from session to session.
class Docks {
 public:
  explicit Docks(QMainWindow& window) : window_(window) {}

  QDockWidget* add(const DockText& text, Qt::DockWidgetArea area, QWidget* contents);
  /// Shows a dock, over others at its place.
  static void show(QDockWidget* dock);
  void fill(QMenu& menu) const;
  QAction* action_of(const QDockWidget* dock) const;

  /// Takes the places that docks have now as those of `reset`.
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
