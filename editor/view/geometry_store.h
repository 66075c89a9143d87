#pragma once

#include <QObject>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "editor/document/scene_objects.h"
#include "editor/view/mesh_geometry.h"

namespace editor {

/// The drawable geometry of a mesh.
struct MeshShape {
  std::shared_ptr<const MeshGeometry> geometry;  ///< null until it is built
  /// The proxy that is drawn while the camera moves; null if that is the mesh itself.
  std::shared_ptr<const TriangleArrays> proxy;

  bool operator==(const MeshShape&) const = default;
};

/// Builds drawable geometry in threads, and caches it while only surfaces change. A few small meshes are
/// built at once, so that edits do not flicker.
class GeometryStore : public QObject {
  Q_OBJECT

 public:
  /// A scene with more triangles than this uses proxies.
  static constexpr std::size_t ProxyTriangles = 50'000;

  explicit GeometryStore(QObject* parent = nullptr) : QObject(parent) {}

  /// Starts to build missing geometry, and drops unused geometry.
  void set_objects(const SceneObjects& objects);

  /// The geometry of the meshes, in their order.
  std::vector<MeshShape> shapes() const;
  /// Whether all meshes are built; proxies may still follow.
  bool has_all_meshes() const;
  /// Whether everything is built.
  bool is_complete() const;

 signals:
  /// Emitted when something was built.
  void changed();

 private:
  struct Entry {
    grf::Shared<grf::Mesh> mesh;
    MeshShape shape;
    std::size_t proxy_triangles = 0;  ///< size of the wanted proxy; 0: none
    bool has_proxy = false;
    bool is_in_work = false;  ///< whether its geometry or its proxy is being built
  };
  /// A mesh and its geometry.
  using MadeGeometry = std::pair<grf::Shared<grf::Mesh>, std::shared_ptr<const MeshGeometry>>;

  static void reuse(const Entry& old, Entry& entry);
  void make_missing();
  void make_geometries(std::vector<grf::Shared<grf::Mesh>> meshes);
  void take_geometry(const MadeGeometry& made);
  void start_proxy(Entry& entry);

  std::vector<Entry> entries_;
};

}  // namespace editor
