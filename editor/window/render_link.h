#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

#include "editor/document/document.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/camera.h"

class QAction;
class QMenu;
class QToolBar;
class QWidget;

namespace editor {

class OptionsWindow;
class RenderPanel;
class SceneView;

/// Keeps what is rendered the same as what is edited: the scene, its camera, and the options of its OP file,
/// of which each change is a step of undo like those of the scene.
class RenderLink : public QObject {
  Q_OBJECT

 public:
  /// All outlive it; the window holds the actions.
  RenderLink(Document& document, SceneView& view, RenderPanel& panel, QWidget& window);
  ~RenderLink() override;

  /// The actions of the render's camera.
  void fill(QMenu& menu);
  void fill(QToolBar& bar);

  /// Places the camera of renders; while it is dragged the steps are one.
  void move_camera(const transport::View& camera, bool is_done);
  /// The camera that renders have now.
  transport::View camera() const;
  /// All options in a window of their own.
  void show_options();
  /// Null if it is not open.
  OptionsWindow* options_window() const;

 signals:
  void told(const QString& message);
  /// A scene was opened in which nothing emits light: it has a grey sky until something does.
  void lit_by_a_plain_sky();

 private:
  class OptionsCommand;

  void make_actions(QWidget& window);
  void take_scene();
  void give_plain_sky();
  void take_plain_sky();
  void change(const options::RenderOptions& now, const QString& text, const QString& key);
  void apply(const options::RenderOptions& render_options);
  void show_camera();
  void follow_view();
  void save_options();

  Document& document_;
  SceneView& view_;
  RenderPanel& panel_;
  options::RenderOptions options_;  ///< as they were after the last change
  bool are_options_saved_ = true;
  bool has_plain_sky_ = false;
  bool is_taking_ = false;  ///< the options of another scene
  QPointer<OptionsWindow> options_window_;
  QAction* follow_ = nullptr;
  QAction* from_view_ = nullptr;
  QAction* look_through_ = nullptr;
};

}  // namespace editor
