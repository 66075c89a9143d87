#pragma once

#include <QObject>
#include <QPointer>

#include "editor/document/document.h"
#include "renderer/transport/camera.h"

class QAction;
class QMenu;
class QToolBar;
class QWidget;

namespace editor {

class OptionsWindow;
class RenderPanel;
class SceneView;

/// Keeps what is rendered the same as what is edited: the scene, and the camera of renders, which is that of
/// the 3D view or placed in it.
class RenderLink : public QObject {
  Q_OBJECT

 public:
  /// All outlive it; the window holds the actions.
  RenderLink(Document& document, SceneView& view, RenderPanel& panel, QWidget& window);
  ~RenderLink() override;

  /// The actions of the render's camera.
  void fill(QMenu& menu);
  void fill(QToolBar& bar);

  /// Places the camera of renders.
  void move_camera(const transport::View& camera);
  /// The camera that renders have now.
  transport::View camera() const;
  /// All options in a window of their own.
  void show_options();
  /// Null if it is not open.
  OptionsWindow* options_window() const;

 private:
  void make_actions(QWidget& window);
  void take_scene();
  void show_camera();
  void follow_view();

  Document& document_;
  SceneView& view_;
  RenderPanel& panel_;
  QPointer<OptionsWindow> options_window_;
  QAction* follow_ = nullptr;
  QAction* from_view_ = nullptr;
  QAction* look_through_ = nullptr;
};

}  // namespace editor
