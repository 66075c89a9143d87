#include "converters/vrml/polygons.h"

#include <algorithm>
#include <array>
#include <utility>

#include "converters/mesh_builder.h"

namespace convert::vrml {
namespace {

template <class T>
void reverse_behind_first(std::vector<T>& values, std::size_t begin, std::size_t end) {
  if (values.empty()) return;
  std::reverse(values.begin() + static_cast<std::ptrdiff_t>(begin) + 1,
               values.begin() + static_cast<std::ptrdiff_t>(end));
}

Corner corner_of(const Polygons& polygons, std::size_t i) {
  Corner corner;
  // Normalises -0 to 0, so that equal corners share a vertex.
  corner.position = polygons.positions[polygons.corners[i]] + grf::Vec3f(0);
  if (!polygons.normals.empty() && polygons.normals[i] != grf::Vec3f(0)) {
    corner.normal = polygons.normals[i] + grf::Vec3f(0);
  }
  if (!polygons.colours.empty()) corner.colour = polygons.colours[i];
  if (!polygons.uvs.empty()) corner.uv = polygons.uvs[i] + grf::Vec2f(0);
  return corner;
}

grf::Surface surface_of(const Polygons& polygons, std::size_t face, std::span<const grf::Surface> surfaces) {
  grf::Surface surface = surfaces[polygons.face_materials.empty() ? 0 : polygons.face_materials[face]];
  if (!polygons.face_colours.empty()) surface.colour = polygons.face_colours[face];
  return surface;
}

}  // namespace

void Polygons::add_face(std::span<const std::uint32_t> indices) {
  corners.insert(corners.end(), indices.begin(), indices.end());
  face_ends.push_back(corners.size());
}

void Polygons::reverse_faces() {
  for (std::size_t i = 0; i < face_count(); ++i) {
    const std::size_t begin = face_begin(i);
    reverse_behind_first(corners, begin, face_ends[i]);
    reverse_behind_first(normals, begin, face_ends[i]);
    reverse_behind_first(colours, begin, face_ends[i]);
    reverse_behind_first(uvs, begin, face_ends[i]);
  }
}

void add_default_uvs(Polygons& polygons) {
  grf::Box3d box;
  for (const std::uint32_t corner : polygons.corners) box.extendBy(grf::Vec3d(polygons.positions[corner]));
  if (box.isEmpty()) return;
  const grf::Vec3d size = box.size();
  std::array<int, 3> axes = {0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&size](int a, int b) { return size[a] > size[b]; });
  const double longest = size[axes[0]] > 0 ? size[axes[0]] : 1;
  for (const std::uint32_t corner : polygons.corners) {
    const grf::Vec3d place = (grf::Vec3d(polygons.positions[corner]) - box.min) / longest;
    polygons.uvs.emplace_back(grf::Vec2d(place[axes[0]], place[axes[1]]));
  }
}

grf::Mesh make_mesh(std::string name, const Polygons& polygons, std::span<const grf::Surface> surfaces) {
  MeshBuilder builder(std::move(name));
  const bool one_surface = polygons.face_materials.empty() && polygons.face_colours.empty();
  std::uint32_t surface = one_surface ? builder.surface(surfaces[0]) : 0;
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < polygons.face_count(); ++i) {
    corners.clear();
    for (std::size_t k = polygons.face_begin(i); k < polygons.face_ends[i]; ++k) {
      corners.push_back(corner_of(polygons, k));
    }
    if (!one_surface) surface = builder.surface(surface_of(polygons, i, surfaces));
    builder.add_face(corners, surface);
  }
  return builder.take();
}

}  // namespace convert::vrml
