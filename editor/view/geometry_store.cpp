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

}  // namespace

void GeometryStore::set_objects(const SceneObjects& objects) {
  std::vector<Entry> old = std::exchange(entries_, {});
  entries_.resize(objects.meshes.size());
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& entry = entries_[i];
    entry.mesh = objects.meshes[i].mesh;
    const std::size_t triangles = entry.mesh->geometry->triangle_count();
    if (objects.triangles > 2 * QuickTriangles && triangles > LeastStoodInFor) {
      const double share = static_cast<double>(QuickTriangles) / static_cast<double>(objects.triangles);
      entry.quick_triangles =
          std::max<std::size_t>(100, static_cast<std::size_t>(static_cast<double>(triangles) * share));
    }
    reuse(old, entry);
  }
  // Makers look entries up, so that all of them are there first.
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].shape.geometry == nullptr) {
      make_geometry(entries_[i]);
    } else if (entries_[i].quick_triangles > 0 && !entries_[i].has_stand_in) {
      make_stand_in(entries_[i]);
    }
  }
}

void GeometryStore::reuse(std::vector<Entry>& old, Entry& entry) const {
  const auto shared =
      std::find_if(old.begin(), old.end(), [&](const Entry& other) { return other.mesh.shares(entry.mesh); });
  const auto found =
      shared != old.end() ? shared : std::find_if(old.begin(), old.end(), [&](const Entry& other) {
        return other.shape.geometry != nullptr && other.mesh->geometry.shares(entry.mesh->geometry) &&
               other.mesh->irradiance.shares(entry.mesh->irradiance);
      });
  if (found == old.end()) return;
  entry.shape.geometry = found->shape.geometry;
  if (entry.quick_triangles == 0) return;
  entry.shape.quick = found->shape.quick;
  // A stand-in of about the wanted size does.
  const double ratio =
      static_cast<double>(found->quick_triangles) / static_cast<double>(entry.quick_triangles);
  entry.has_stand_in = found->has_stand_in && ratio > 0.5 && ratio < 2;
}

void GeometryStore::make_geometry(Entry& entry) {
  if (entry.mesh->geometry->corners.size() < SmallMesh) {
    entry.shape.geometry = std::make_shared<const MeshGeometry>(*entry.mesh);
    if (entry.quick_triangles > 0) make_stand_in(entry);
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
  for (Entry& entry : entries_) {
    if (entry.shape.geometry != nullptr || !entry.mesh.shares(mesh)) continue;
    entry.shape.geometry = geometry;
    if (entry.quick_triangles > 0) make_stand_in(entry);
  }
  emit changed();
}

void GeometryStore::make_stand_in(Entry& entry) {
  const std::size_t triangles = entry.quick_triangles;
  if (entry.shape.quick == nullptr) {
    entry.shape.quick =
        std::make_shared<const TriangleArrays>(thinned(entry.shape.geometry->arrays(), triangles));
  }
  QtConcurrent::run([geometry = entry.shape.geometry, triangles] {
    return std::make_shared<const TriangleArrays>(stand_in(geometry->arrays(), triangles));
  }).then(this, [this, geometry = entry.shape.geometry](const std::shared_ptr<const TriangleArrays>& quick) {
    for (Entry& other : entries_) {
      if (other.shape.geometry != geometry || other.quick_triangles == 0) continue;
      other.shape.quick = quick;
      other.has_stand_in = true;
    }
    emit changed();
  });
}

std::vector<MeshShape> GeometryStore::shapes() const {
  std::vector<MeshShape> shapes;
  for (const Entry& entry : entries_) shapes.push_back(entry.shape);
  return shapes;
}

bool GeometryStore::has_all_meshes() const {
  return std::all_of(entries_.begin(), entries_.end(),
                     [](const Entry& entry) { return entry.shape.geometry != nullptr; });
}

bool GeometryStore::is_complete() const {
  return has_all_meshes() && std::all_of(entries_.begin(), entries_.end(), [](const Entry& entry) {
           return entry.quick_triangles == 0 || entry.has_stand_in;
         });
}

}  // namespace editor
