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

/// Actions that edit vertices and faces, as jobs. Those for whole meshes apply to the meshes with selected
/// faces, or to all meshes if no face is selected. Meshes that are edited meanwhile keep that edit.
class MeshActions : public QObject {
  Q_OBJECT

 public:
  MeshActions(Document& document, JobList& jobs, QWidget& window);

  QAction* delete_faces() const { return delete_faces_; }
  /// Subdivision and smoothing of whole meshes.
  QList<QAction*> of_meshes() const { return of_meshes_; }
  /// Projections and transforms of the texture coordinates of the selected faces.
  QList<QAction*> of_texture_coordinates() const { return of_texture_coordinates_; }

  using Edit = std::function<grf::Scene(const SelectedFaces& faces)>;
  /// Edits faces as one undo step, in a large scene as a job.
  void start(const QString& title, const FaceSelection& selection, const Edit& edit);

 signals:
  /// Emitted with a message for the status line.
  void status_message(const QString& message);
  /// Emitted with the reason why something could not be done.
  void failed(const QString& why);

 private:
  struct Edited;

  void make_projections(QWidget& window);
  void make_uv_transforms(QWidget& window);
  void add_uv_edit(QWidget& window, const QString& text, const QString& tip, const Edit& edit);
  void subdivide(convert::SubdivisionScheme scheme);
  void smooth();
  void select_inward();
  void remove();
  void take(const QString& title, const Edited& edited);
  FaceSelection selected_or_all() const;
  QList<QAction*> all() const { return QList{delete_faces_} + of_meshes_ + of_texture_coordinates_; }

  Document& document_;
  JobList& jobs_;
  QAction* delete_faces_;
  QList<QAction*> of_meshes_;
  QList<QAction*> of_texture_coordinates_;
};

}  // namespace editor
