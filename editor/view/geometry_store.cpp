#include "editor/view/geometry_store.h"

#include <QtConcurrent>
#include <algorithm>
#include <utility>

#include "editor/view/stand_in.h"

namespace editor {
namespace {

/// Meshes of fewer corners are prepared at once.
constexpr std::size_t SmallMesh = 40'000;
/// Nothing is gained by standing in for fewer triangles.
constexpr std::size_t LeastStoodInFor = 1'000;

std::size_t triangles_of(const grf::Mesh& mesh) { return mesh.corners.size() - 2 * mesh.face_count(); }

}  // namespace

void GeometryStore::set_objects(const SceneObjects& objects) {
  const std::vector<Entry> old_entries = std::exchange(entries_, {});
  const std::vector<MeshShape> old_shapes = std::exchange(shapes_, {});
  entries_.resize(objects.meshes.size());
  shapes_.resize(objects.meshes.size());
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& entry = entries_[i];
    entry.mesh = objects.meshes[i].mesh;
    const std::size_t triangles = triangles_of(*entry.mesh);
    if (objects.triangles > 2 * QuickTriangles && triangles > LeastStoodInFor) {
      const double share = static_cast<double>(QuickTriangles) / static_cast<double>(objects.triangles);
      entry.quick_triangles =
          std::max<std::size_t>(100, static_cast<std::size_t>(static_cast<double>(triangles) * share));
    }
    reuse(old_entries, old_shapes, i);
  }
  // Makers look entries up, so that all of them are there first.
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (shapes_[i].geometry == nullptr) {
      make_geometry(i);
    } else if (entries_[i].quick_triangles > 0 && !entries_[i].has_stand_in) {
      make_stand_in(i);
    }
  }
}

void GeometryStore::reuse(const std::vector<Entry>& old_entries, const std::vector<MeshShape>& old_shapes,
                          std::size_t mesh) {
  Entry& entry = entries_[mesh];
  auto found = std::find_if(old_entries.begin(), old_entries.end(),
                            [&](const Entry& other) { return other.mesh.shares(entry.mesh); });
  if (found == old_entries.end()) {
    found = std::find_if(old_entries.begin(), old_entries.end(), [&](const Entry& other) {
      const auto& geometry = old_shapes[static_cast<std::size_t>(&other - old_entries.data())].geometry;
      return geometry != nullptr && has_same_geometry(*other.mesh, *entry.mesh);
    });
  }
  if (found == old_entries.end()) return;
  const MeshShape& shape = old_shapes[static_cast<std::size_t>(found - old_entries.begin())];
  shapes_[mesh].geometry = shape.geometry;
  if (entry.quick_triangles == 0) return;
  shapes_[mesh].quick = shape.quick;
  // A stand-in of about the wanted size does.
  const double ratio =
      static_cast<double>(found->quick_triangles) / static_cast<double>(entry.quick_triangles);
  entry.has_stand_in = found->has_stand_in && ratio > 0.5 && ratio < 2;
}

void GeometryStore::make_geometry(std::size_t mesh) {
  const Entry& entry = entries_[mesh];
  if (entry.mesh->corners.size() < SmallMesh) {
    shapes_[mesh].geometry = std::make_shared<const MeshGeometry>(*entry.mesh);
    if (entry.quick_triangles > 0) make_stand_in(mesh);
    return;
  }
  QtConcurrent::run([mesh = entry.mesh] {
    return std::make_shared<const MeshGeometry>(*mesh);
  }).then(this, [this, mesh = entry.mesh](const std::shared_ptr<const MeshGeometry>& geometry) {
    take_geometry(mesh, geometry);
  });
}

void GeometryStore::take_geometry(const grf::Shared<grf::Mesh>& mesh,
                                  const std::shared_ptr<const MeshGeometry>& geometry) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (shapes_[i].geometry != nullptr || !entries_[i].mesh.shares(mesh)) continue;
    shapes_[i].geometry = geometry;
    if (entries_[i].quick_triangles > 0) make_stand_in(i);
  }
  emit changed();
}

void GeometryStore::make_stand_in(std::size_t mesh) {
  const std::size_t triangles = entries_[mesh].quick_triangles;
  MeshShape& shape = shapes_[mesh];
  if (shape.quick == nullptr) {
    shape.quick = std::make_shared<const TriangleArrays>(thinned(shape.geometry->arrays(), triangles));
  }
  QtConcurrent::run([geometry = shape.geometry, triangles] {
    return std::make_shared<const TriangleArrays>(stand_in(geometry->arrays(), triangles));
  }).then(this, [this, geometry = shape.geometry](const std::shared_ptr<const TriangleArrays>& quick) {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (shapes_[i].geometry != geometry || entries_[i].quick_triangles == 0) continue;
      shapes_[i].quick = quick;
      entries_[i].has_stand_in = true;
    }
    emit changed();
  });
}

bool GeometryStore::has_all_meshes() const {
  return std::all_of(shapes_.begin(), shapes_.end(),
                     [](const MeshShape& shape) { return shape.geometry != nullptr; });
}

bool GeometryStore::is_complete() const {
  return has_all_meshes() && std::all_of(entries_.begin(), entries_.end(), [](const Entry& entry) {
           return entry.quick_triangles == 0 || entry.has_stand_in;
         });
}

}  // namespace editor
