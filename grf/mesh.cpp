#include "grf/mesh.h"

#include <limits>
#include <utility>

namespace grf {

MeshDraft::MeshDraft(const Mesh& mesh)
    : Geometry(*mesh.geometry),
      name(mesh.name),
      comments(mesh.comments),
      irradiance(*mesh.irradiance),
      surfaces(mesh.surfaces),
      surface_of_face(*mesh.surface_of_face) {}

void MeshDraft::add_face(std::span<const std::uint32_t> face_corners, std::uint32_t surface_index) {
  Geometry::add_face(face_corners);
  surface_of_face.push_back(surface_index);
}

std::uint32_t MeshDraft::copy_vertex(const Mesh& from, std::uint32_t vertex) {
  const auto copy = static_cast<std::uint32_t>(positions.size());
  const Geometry& geometry = *from.geometry;
  positions.push_back(geometry.positions[vertex]);
  if (geometry.normals.has(vertex)) normals.set(copy, geometry.normals[vertex]);
  if (geometry.colours.has(vertex)) colours.set(copy, geometry.colours[vertex]);
  if (geometry.uvs.has(vertex)) uvs.set(copy, geometry.uvs[vertex]);
  if (from.irradiance->has(vertex)) irradiance.set(copy, (*from.irradiance)[vertex]);
  return copy;
}

void MeshDraft::free_spare_memory() {
  Geometry::free_spare_memory();
  irradiance.free_spare_memory();
  if (has_spare_memory(surface_of_face)) surface_of_face.shrink_to_fit();
}

Mesh::Mesh(MeshDraft&& draft)
    : name(std::move(draft.name)),
      comments(std::move(draft.comments)),
      geometry(static_cast<Geometry&&>(draft)),
      surfaces(std::move(draft.surfaces)),
      surface_of_face(std::move(draft.surface_of_face)) {
  if (!draft.irradiance.empty()) irradiance = std::move(draft.irradiance);  // few have any, and share none
}

bool operator==(const Mesh& a, const Mesh& b) {
  const bool is_alike = a.name == b.name && a.comments == b.comments && a.geometry == b.geometry &&
                        a.irradiance == b.irradiance && a.surfaces.front() == b.surfaces.front();
  if (!is_alike) return false;
  if (a.surface_of_face.shares(b.surface_of_face) && a.surfaces == b.surfaces) return true;
  std::uint32_t known_a = 0;
  std::uint32_t known_b = 0;  // with known_a the last pair found equal: faces come in runs
  for (std::size_t i = 0; i < a.face_count(); ++i) {
    const std::uint32_t surface_a = (*a.surface_of_face)[i];
    const std::uint32_t surface_b = (*b.surface_of_face)[i];
    if (surface_a == known_a && surface_b == known_b) continue;
    if (a.surfaces[surface_a] != b.surfaces[surface_b]) return false;
    known_a = surface_a;
    known_b = surface_b;
  }
  return true;
}

std::vector<bool> used_surfaces(const Mesh& mesh) {
  std::vector<bool> used(mesh.surfaces.size());
  for (const std::uint32_t surface : *mesh.surface_of_face) used[surface] = true;
  return used;
}

Mesh submesh(const Mesh& mesh, std::span<const std::uint32_t> faces) {
  constexpr auto Unused = std::numeric_limits<std::uint32_t>::max();
  MeshDraft part;
  if (!faces.empty()) part.surfaces = {mesh.surface(faces.front())};
  SurfaceIndex surfaces(part.surfaces);
  std::vector<std::uint32_t> vertex_of(mesh.geometry->positions.size(), Unused);
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t face : faces) {
    corners.clear();
    for (const std::uint32_t corner : mesh.face(face)) {
      if (vertex_of[corner] == Unused) vertex_of[corner] = part.copy_vertex(mesh, corner);
      corners.push_back(vertex_of[corner]);
    }
    part.add_face(corners, surfaces.index_of(mesh.surface(face)));
  }
  return part;
}

std::uint32_t SurfaceIndex::index_of(const Surface& surface) {
  const auto count = static_cast<std::uint32_t>(surfaces_->size());
  if (by_key_.empty()) {
    for (std::uint32_t i = 0; i < count; ++i) by_key_.emplace(written_key((*surfaces_)[i]), i);
  }
  const auto [known, is_new] = by_key_.emplace(written_key(surface), count);
  if (is_new) surfaces_->push_back(surface);
  return known->second;
}

}  // namespace grf
