#pragma once

#include <QAction>
#include <QObject>
#include <QString>

namespace convert {
enum class SubdivisionScheme;
}

namespace editor {

class Document;
class FaceSelection;

/// The actions that change vertices and faces. Those about whole meshes are about the meshes of the selected
/// faces, or about all meshes if no face is selected.
class MeshActions : public QObject {
  Q_OBJECT

 public:
  MeshActions(Document& document, QWidget& window);

  QAction* delete_faces() const { return delete_faces_; }
  /// Subdivision and smoothing of whole meshes.
  QList<QAction*> of_meshes() const { return of_meshes_; }

 signals:
  /// Something is to be known.
  void told(const QString& message);
  /// Something could not be done, and why.
  void failed(const QString& why);

 private:
  void subdivide(convert::SubdivisionScheme scheme);
  void smooth();
  FaceSelection selected_or_all() const;

  Document& document_;
  QAction* delete_faces_;
  QList<QAction*> of_meshes_;
};

}  // namespace editor
