#include "editor/view/geometry_store.h"

#include <QtConcurrent>
#include <algorithm>
#include <unordered_map>
#include <utility>

#include "editor/view/stand_in.h"

namespace editor {
namespace {

/// Meshes of fewer corners are prepared at once.
constexpr std::size_t SmallMesh = 40'000;
/// Nothing is gained by standing in for fewer triangles.
constexpr std::size_t LeastStoodInFor = 1'000;

}  // namespace

/// Finds the entries of before by the geometry that they are made from.
class GeometryStore::KnownEntries {
 public:
  explicit KnownEntries(const std::vector<Entry>& entries) : entries_(entries) {}

  /// The entry that has the same geometry and irradiance, or null. Most often it has the same number.
  const Entry* find(std::size_t number, const Entry& entry) {
    if (number < entries_.size() && is_of_same_shape(entries_[number], entry)) return &entries_[number];
    if (by_geometry_.empty()) {
      for (const Entry& each : entries_) by_geometry_.emplace(&*each.mesh->geometry, &each);
    }
    const auto [begin, end] = by_geometry_.equal_range(&*entry.mesh->geometry);
    const auto found = std::find_if(
        begin, end, [&entry](const auto& each) { return is_of_same_shape(*each.second, entry); });
    return found == end ? nullptr : found->second;
  }

 private:
  static bool is_of_same_shape(const Entry& a, const Entry& b) {
    return a.mesh->geometry.shares(b.mesh->geometry) && a.mesh->irradiance.shares(b.mesh->irradiance);
  }

  const std::vector<Entry>& entries_;
  std::unordered_multimap<const grf::Geometry*, const Entry*> by_geometry_;
};

void GeometryStore::set_objects(const SceneObjects& objects) {
  std::vector<Entry> old = std::exchange(entries_, {});
  KnownEntries known(old);
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
    if (const Entry* same = known.find(i, entry)) reuse(*same, entry);
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

void GeometryStore::reuse(const Entry& old, Entry& entry) {
  entry.shape.geometry = old.shape.geometry;
  if (entry.quick_triangles == 0) return;
  entry.shape.quick = old.shape.quick;
  // A stand-in of about the wanted size does.
  const double ratio = static_cast<double>(old.quick_triangles) / static_cast<double>(entry.quick_triangles);
  entry.has_stand_in = old.has_stand_in && ratio > 0.5 && ratio < 2;
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
