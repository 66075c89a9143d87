#pragma once

#include <QAction>
#include <QObject>
#include <QString>
#include <functional>

#include "editor/document/geometry_edits.h"

namespace convert {
enum class SubdivisionScheme;
}

namespace editor {

class Document;
class JobList;

/// The actions that change vertices and faces. Those about whole meshes are about the meshes of the selected
/// faces, or about all meshes if no face is selected. They are jobs: what was edited before one is done keeps
/// its edit.
class MeshActions : public QObject {
  Q_OBJECT

 public:
  MeshActions(Document& document, JobList& jobs, QWidget& window);

  QAction* delete_faces() const { return delete_faces_; }
  /// Subdivision and smoothing of whole meshes.
  QList<QAction*> of_meshes() const { return of_meshes_; }

 signals:
  /// Something is to be known.
  void told(const QString& message);
  /// Something could not be done, and why.
  void failed(const QString& why);

 private:
  using Edit = std::function<grf::Scene(const SelectedFaces& faces)>;
  struct Edited;

  void subdivide(convert::SubdivisionScheme scheme);
  void smooth();
  void remove();
  void start(const QString& title, const FaceSelection& selection, const Edit& edit);
  void take(const QString& title, const Edited& edited);
  FaceSelection selected_or_all() const;
  QList<QAction*> all() const { return QList{delete_faces_} + of_meshes_; }

  Document& document_;
  JobList& jobs_;
  QAction* delete_faces_;
  QList<QAction*> of_meshes_;
};

}  // namespace editor
