#pragma once

#include <QObject>

class QAction;
class QActionGroup;
class QMenu;
class QToolBar;
class QWidget;

namespace editor {

class SceneView;
enum class DisplayMode;

/// Actions for display mode and camera of the 3D view. Its keys are their shortcuts, which work while it has
/// the focus.
class ViewActions : public QObject {
  Q_OBJECT

 public:
  /// The mode Rendered is only for windows with a renderer.
  ViewActions(SceneView& view, QWidget& window, bool has_renderer = false);

  void fill(QMenu& menu);
  void fill(QToolBar& bar);
  /// Sets the display mode of the view, as its action does.
  void set_mode(DisplayMode mode);

 private:
  void make_modes(bool has_renderer);
  void make_overlays();
  void make_places();

  SceneView& view_;
  QWidget& window_;
  QActionGroup* modes_;
  QList<QAction*> overlays_;
  QList<QAction*> places_;
  QAction* frame_all_ = nullptr;
  QAction* frame_selection_ = nullptr;
};

}  // namespace editor
