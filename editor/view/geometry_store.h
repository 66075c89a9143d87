#pragma once

#include <QObject>
#include <cstddef>
#include <memory>
#include <vector>

#include "editor/document/scene_objects.h"
#include "editor/view/mesh_geometry.h"

namespace editor {

/// What meshes are drawn from, made in other threads, and kept while only surfaces change. Small meshes are
/// there at once, so that none of their edits flickers.
class GeometryStore : public QObject {
  Q_OBJECT

 public:
  /// A scene of more triangles than this has stand-ins.
  static constexpr std::size_t QuickTriangles = 50'000;

  explicit GeometryStore(QObject* parent = nullptr) : QObject(parent) {}

  /// Starts to make what is missing, and forgets what these have not.
  void set_objects(const SceneObjects& objects);

  /// Of a mesh by its index; null until it is made.
  const std::shared_ptr<const MeshGeometry>& geometry(std::size_t mesh) const {
    return entries_[mesh].geometry;
  }
  /// What is drawn instead while the camera moves; null if that is the mesh itself.
  const std::shared_ptr<const TriangleArrays>& quick(std::size_t mesh) const { return entries_[mesh].quick; }
  /// Whether all meshes are made; stand-ins may still come.
  bool has_all_meshes() const;
  /// Whether nothing more will come.
  bool is_complete() const;

 signals:
  /// Something was made.
  void changed();

 private:
  struct Entry {
    grf::Shared<grf::Mesh> mesh;
    std::shared_ptr<const MeshGeometry> geometry;
    std::shared_ptr<const TriangleArrays> quick;
    std::size_t quick_triangles = 0;  ///< wanted; 0: no stand-in
    bool has_stand_in = false;
  };

  void reuse(std::vector<Entry>& old, Entry& entry) const;
  void make_geometry(Entry& entry);
  void take_geometry(const grf::Shared<grf::Mesh>& mesh, std::shared_ptr<const MeshGeometry> geometry);
  void make_stand_in(Entry& entry);

  std::vector<Entry> entries_;
};

}  // namespace editor
