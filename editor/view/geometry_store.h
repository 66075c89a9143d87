#pragma once

#include <QObject>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "editor/document/scene_objects.h"
#include "editor/view/mesh_geometry.h"

namespace editor {

/// What a mesh is drawn from.
struct MeshShape {
  std::shared_ptr<const MeshGeometry> geometry;  ///< null until it is made
  /// What is drawn instead while the camera moves; null if that is the mesh itself.
  std::shared_ptr<const TriangleArrays> quick;

  bool operator==(const MeshShape&) const = default;
};

/// What meshes are drawn from, made in other threads, and kept while only surfaces change. A few small meshes
/// are there at once, so that none of their edits flickers.
class GeometryStore : public QObject {
  Q_OBJECT

 public:
  /// A scene of more triangles than this has stand-ins.
  static constexpr std::size_t QuickTriangles = 50'000;

  explicit GeometryStore(QObject* parent = nullptr) : QObject(parent) {}

  /// Starts to make what is missing, and forgets what these have not.
  void set_objects(const SceneObjects& objects);

  /// Of the meshes in their order.
  std::vector<MeshShape> shapes() const;
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
    MeshShape shape;
    std::size_t quick_triangles = 0;  ///< wanted; 0: no stand-in
    bool has_stand_in = false;
    bool is_in_work = false;  ///< its geometry, or its stand-in, is being made
  };
  /// A mesh, and what was made of it.
  using MadeGeometry = std::pair<grf::Shared<grf::Mesh>, std::shared_ptr<const MeshGeometry>>;

  static void reuse(const Entry& old, Entry& entry);
  void make_missing();
  void make_geometries(std::vector<grf::Shared<grf::Mesh>> meshes);
  void take_geometry(const MadeGeometry& made);
  void make_stand_in(Entry& entry);

  std::vector<Entry> entries_;
};

}  // namespace editor
