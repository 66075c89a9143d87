#include "editor/view/geometry_store.h"

#include <QtConcurrent>
#include <algorithm>
#include <unordered_map>
#include <utility>

#include "editor/view/proxy_mesh.h"

namespace editor {
namespace {

/// Meshes with no more corners than this in total are prepared at once; the others in threads.
constexpr std::size_t SmallMeshes = 40'000;
/// Corners that a thread prepares before partial results are shown.
constexpr std::size_t CornersPerTask = 400'000;
/// Smaller meshes get no proxy.
constexpr std::size_t LeastProxiedTriangles = 1'000;

bool is_of_same_shape(const grf::Mesh& a, const grf::Mesh& b) {
  return a.geometry.shares(b.geometry) && a.irradiance.shares(b.irradiance);
}

}  // namespace

void GeometryStore::set_objects(const SceneObjects& objects) {
  std::unordered_multimap<const grf::Geometry*, Entry> before;
  for (Entry& entry : entries_) before.emplace(&*entry.mesh->geometry, std::move(entry));
  entries_.assign(objects.meshes.size(), {});
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& entry = entries_[i];
    entry.mesh = objects.meshes[i].mesh;
    const std::size_t triangles = entry.mesh->geometry->triangle_count();
    if (objects.triangles > 2 * ProxyTriangles && triangles > LeastProxiedTriangles) {
      const double fraction = static_cast<double>(ProxyTriangles) / static_cast<double>(objects.triangles);
      entry.proxy_triangles =
          std::max<std::size_t>(100, static_cast<std::size_t>(static_cast<double>(triangles) * fraction));
    }
    const auto [begin, end] = before.equal_range(&*entry.mesh->geometry);
    const auto same = std::find_if(
        begin, end, [&entry](const auto& each) { return is_of_same_shape(*each.second.mesh, *entry.mesh); });
    if (same != end) reuse(same->second, entry);
  }
  make_missing();
}

void GeometryStore::make_missing() {
  std::size_t corners_at_once = 0;
  std::vector<grf::Shared<grf::Mesh>> later;
  std::size_t corners_later = 0;
  for (Entry& entry : entries_) {
    if (entry.is_in_work) continue;
    const std::size_t corners = entry.mesh->geometry->corners.size();
    if (entry.shape.geometry == nullptr && corners_at_once + corners > SmallMeshes) {
      entry.is_in_work = true;
      later.push_back(entry.mesh);
      corners_later += corners;
      if (corners_later > CornersPerTask) {
        make_geometries(std::exchange(later, {}));
        corners_later = 0;
      }
      continue;
    }
    if (entry.shape.geometry == nullptr) {
      corners_at_once += corners;
      entry.shape.geometry = std::make_shared<const MeshGeometry>(*entry.mesh);
    }
    if (entry.proxy_triangles > 0 && !entry.has_proxy) start_proxy(entry);
  }
  if (!later.empty()) make_geometries(std::move(later));
}

void GeometryStore::reuse(const Entry& old, Entry& entry) {
  entry.shape.geometry = old.shape.geometry;
  entry.is_in_work = old.is_in_work && entry.shape.geometry == nullptr;
  if (entry.proxy_triangles == 0) return;
  entry.shape.proxy = old.shape.proxy;
  // An existing proxy of about the wanted size is kept.
  const double ratio = static_cast<double>(old.proxy_triangles) / static_cast<double>(entry.proxy_triangles);
  const bool is_alike = ratio > 0.5 && ratio < 2;
  entry.has_proxy = old.has_proxy && is_alike;
  entry.is_in_work = old.is_in_work && (is_alike || entry.shape.geometry == nullptr);
}

void GeometryStore::make_geometries(std::vector<grf::Shared<grf::Mesh>> meshes) {
  QtConcurrent::run([meshes = std::move(meshes)] {
    std::vector<MadeGeometry> made;
    for (const auto& mesh : meshes) made.emplace_back(mesh, std::make_shared<const MeshGeometry>(*mesh));
    return made;
  }).then(this, [this](const std::vector<MadeGeometry>& made) {
    for (const MadeGeometry& each : made) take_geometry(each);
    emit changed();
  });
}

void GeometryStore::take_geometry(const MadeGeometry& made) {
  for (Entry& entry : entries_) {
    if (entry.shape.geometry != nullptr || !is_of_same_shape(*entry.mesh, *made.first)) continue;
    entry.shape.geometry = made.second;
    entry.is_in_work = false;
    if (entry.proxy_triangles > 0) start_proxy(entry);
  }
}

void GeometryStore::start_proxy(Entry& entry) {
  entry.is_in_work = true;
  const std::size_t triangles = entry.proxy_triangles;
  if (entry.shape.proxy == nullptr) {
    entry.shape.proxy =
        std::make_shared<const TriangleArrays>(subsampled(entry.shape.geometry->arrays(), triangles));
  }
  QtConcurrent::run([geometry = entry.shape.geometry, triangles] {
    return std::make_shared<const TriangleArrays>(make_proxy_mesh(geometry->arrays(), triangles));
  }).then(this, [this, geometry = entry.shape.geometry](const std::shared_ptr<const TriangleArrays>& proxy) {
    for (Entry& other : entries_) {
      if (other.shape.geometry != geometry || other.proxy_triangles == 0) continue;
      other.shape.proxy = proxy;
      other.has_proxy = true;
      other.is_in_work = false;
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
  return std::ranges::all_of(entries_, [](const Entry& entry) { return entry.shape.geometry != nullptr; });
}

bool GeometryStore::is_complete() const {
  return has_all_meshes() && std::ranges::all_of(entries_, [](const Entry& entry) {
           return entry.proxy_triangles == 0 || entry.has_proxy;
         });
}

}  // namespace editor
