#pragma once

#include <QFuture>
#include <QObject>
#include <functional>

#include "editor/document/face_selection.h"

class QAction;
class QMenu;
class QToolBar;
class QWidget;

namespace editor {

class Document;
class FaceQueryDialog;
class RegionInput;
class SceneView;

/// Actions that select faces, and the tools that select regions of the 3D view.
class SelectionActions : public QObject {
  Q_OBJECT

 public:
  SelectionActions(Document& document, SceneView& view, QWidget& window);

  void fill(QMenu& menu);
  void fill(QToolBar& bar);

 private:
  using Change = std::function<FaceSelection(const FaceSelection&)>;

  QAction* add(const QString& text, const QKeySequence& keys, const QString& tip, const Change& change);
  void make_likenesses();
  void make_angles();
  void make_gestures(SceneView& view);
  void make_tools(SceneView& view);
  void open_query();
  void find_edges();

  Document& document_;
  QWidget& window_;
  QFuture<void> finding_;             ///< the edges of meshes
  FaceQueryDialog* query_ = nullptr;  ///< created on first use
  QAction* open_query_ = nullptr;
  QList<QAction*> whole_;  ///< all, none, invert
  QList<QAction*> neighbours_;
  QList<QAction*> similar_;
  QList<QAction*> angles_;
  QList<QAction*> gestures_;  ///< lasso, tools, selecting through
};

}  // namespace editor
