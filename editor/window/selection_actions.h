#pragma once

#include <QObject>
#include <functional>

#include "editor/document/face_selection.h"

class QAction;
class QMenu;
class QToolBar;
class QWidget;

namespace editor {

class Document;
class SceneView;

/// Actions that select faces, and the modes of a drag in the 3D view.
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

  Document& document_;
  QWidget& window_;
  QList<QAction*> whole_;  ///< all, none, invert
  QList<QAction*> neighbours_;
  QList<QAction*> similar_;
  QList<QAction*> angles_;
  QList<QAction*> gestures_;
};

}  // namespace editor
