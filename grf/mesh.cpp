#include "grf/mesh.h"

#include <algorithm>
#include <limits>

namespace grf {

void Mesh::add_face(std::span<const std::uint32_t> face_corners, std::uint32_t surface_index) {
  corners.insert(corners.end(), face_corners.begin(), face_corners.end());
  face_offsets.push_back(static_cast<std::uint32_t>(corners.size()));
  surface_of_face.push_back(surface_index);
}

void Mesh::free_spare_memory() {
  const auto free = [](auto& values) {
    if (has_spare_memory(values)) values.shrink_to_fit();
  };
  free(positions);
  free(corners);
  free(face_offsets);
  free(surface_of_face);
  normals.free_spare_memory();
  colours.free_spare_memory();
  uvs.free_spare_memory();
  irradiance.free_spare_memory();
}

bool operator==(const Mesh& a, const Mesh& b) {
  const bool same_shape = a.name == b.name && a.comments == b.comments && a.positions == b.positions &&
                          a.normals == b.normals && a.colours == b.colours && a.uvs == b.uvs &&
                          a.irradiance == b.irradiance && a.corners == b.corners &&
                          a.face_offsets == b.face_offsets && a.surfaces.front() == b.surfaces.front();
  if (!same_shape) return false;
  std::uint32_t known_a = 0;
  std::uint32_t known_b = 0;  // the last pair found equal: faces come in runs
  for (std::size_t i = 0; i < a.face_count(); ++i) {
    const std::uint32_t surface_a = a.surface_of_face[i];
    const std::uint32_t surface_b = b.surface_of_face[i];
    if (surface_a == known_a && surface_b == known_b) continue;
    if (a.surfaces[surface_a] != b.surfaces[surface_b]) return false;
    known_a = surface_a;
    known_b = surface_b;
  }
  return true;
}

std::vector<bool> used_surfaces(const Mesh& mesh) {
  std::vector<bool> used(mesh.surfaces.size());
  for (const std::uint32_t surface : mesh.surface_of_face) used[surface] = true;
  return used;
}

std::uint32_t copy_vertex(const Mesh& from, std::uint32_t vertex, Mesh& to) {
  const auto copy = static_cast<std::uint32_t>(to.positions.size());
  to.positions.push_back(from.positions[vertex]);
  if (from.normals.has(vertex)) to.normals.set(copy, from.normals[vertex]);
  if (from.colours.has(vertex)) to.colours.set(copy, from.colours[vertex]);
  if (from.uvs.has(vertex)) to.uvs.set(copy, from.uvs[vertex]);
  if (from.irradiance.has(vertex)) to.irradiance.set(copy, from.irradiance[vertex]);
  return copy;
}

Mesh part_of(const Mesh& mesh, std::span<const std::uint32_t> faces) {
  constexpr auto Unused = std::numeric_limits<std::uint32_t>::max();
  Mesh part;
  if (!faces.empty()) part.surfaces = {mesh.surface(faces.front())};
  SurfaceIndex surfaces(part);
  std::vector<std::uint32_t> vertex_of(mesh.positions.size(), Unused);
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t face : faces) {
    corners.clear();
    for (const std::uint32_t corner : mesh.face(face)) {
      if (vertex_of[corner] == Unused) vertex_of[corner] = copy_vertex(mesh, corner, part);
      corners.push_back(vertex_of[corner]);
    }
    part.add_face(corners, surfaces.index_of(mesh.surface(face)));
  }
  return part;
}

SurfaceIndex::SurfaceIndex(Mesh& mesh) : mesh_(&mesh) {
  for (std::uint32_t i = 0; i < mesh.surfaces.size(); ++i) {
    by_hash_.emplace(hash_value(mesh.surfaces[i]), i);
  }
}

std::uint32_t SurfaceIndex::index_of(const Surface& surface) {
  const std::size_t hash = hash_value(surface);
  const auto [first, last] = by_hash_.equal_range(hash);
  const auto known = std::find_if(first, last, [&](const auto& entry) {
    return is_written_alike(mesh_->surfaces[entry.second], surface);
  });
  if (known != last) return known->second;
  const auto index = static_cast<std::uint32_t>(mesh_->surfaces.size());
  mesh_->surfaces.push_back(surface);
  by_hash_.emplace(hash, index);
  return index;
}

}  // namespace grf
