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

class CameraPanel;
class OptionsWindow;
class RenderPanel;
class SceneView;

/// Keeps the rendered scene and the render camera in sync with the document: the camera is locked to the 3D
/// view, or placed in it.
class RenderController : public QObject {
  Q_OBJECT

 public:
  /// All outlive it; the window holds the actions.
  RenderController(Document& document, SceneView& view, RenderPanel& panel, CameraPanel& cameras,
                   QWidget& window);
  ~RenderController() override;

  /// Adds the actions of the render camera.
  void fill(QMenu& menu);
  void fill(QToolBar& bar);

  /// Moves the render camera.
  void move_camera(const transport::View& camera);
  /// The current render camera.
  transport::View camera() const;
  /// Opens all options in a separate window.
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
  QAction* framing_ = nullptr;
};

}  // namespace editor
