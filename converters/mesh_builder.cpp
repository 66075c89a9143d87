#include "converters/mesh_builder.h"

#include <bit>
#include <utility>

namespace convert {
namespace {

// -0 is 0 here, since they are equal.
std::uint64_t bits(float number) { return std::bit_cast<std::uint32_t>(number + 0.0F); }

std::uint64_t mixed(std::uint64_t hash, const grf::Vec3f& v) {
  return mixed_hash(mixed_hash(hash, bits(v.x) << 32U | bits(v.y)), bits(v.z));
}

std::uint64_t hash_of(const Corner& corner) {
  std::uint64_t hash = mixed(0, corner.position);
  if (corner.normal) hash = mixed(hash + 1, *corner.normal);
  if (corner.colour) hash = mixed(hash + 2, *corner.colour);
  if (corner.uv) hash = mixed_hash(hash + 3, bits(corner.uv->x) << 32U | bits(corner.uv->y));
  return hash;
}

template <class T>
bool is_same(const grf::OptionalVertexValues<T>& values, std::uint32_t vertex,
             const std::optional<T>& value) {
  return values.has(vertex) == value.has_value() && (!value || values[vertex] == *value);
}

}  // namespace

MeshBuilder::MeshBuilder(std::string name) { mesh_.name = std::move(name); }

std::uint32_t MeshBuilder::surface(const grf::Surface& surface) {
  if (!surfaces_) {
    mesh_.surfaces = {surface};
    surfaces_.emplace(mesh_.surfaces);
  }
  return surfaces_->index_of(surface);
}

void MeshBuilder::add_face(std::span<const Corner> corners, std::uint32_t surface) {
  face_.clear();
  for (const Corner& corner : corners) face_.push_back(vertex(corner));
  mesh_.add_face(face_, surface);
}

void MeshBuilder::add_face(std::span<const std::uint32_t> vertices, std::uint32_t surface) {
  mesh_.add_face(vertices, surface);
}

std::uint32_t MeshBuilder::vertex(const Corner& corner) {
  const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
  const std::uint32_t vertex = vertices_.find_or_add(
      hash_of(corner), next, [&](std::uint32_t known) { return is_equal(known, corner); });
  if (vertex != next) return vertex;
  mesh_.positions.push_back(corner.position);
  if (corner.normal) mesh_.normals.set(next, *corner.normal);
  if (corner.colour) mesh_.colours.set(next, *corner.colour);
  if (corner.uv) mesh_.uvs.set(next, *corner.uv);
  return vertex;
}

bool MeshBuilder::is_equal(std::uint32_t vertex, const Corner& corner) const {
  return mesh_.positions[vertex] == corner.position && is_same(mesh_.normals, vertex, corner.normal) &&
         is_same(mesh_.colours, vertex, corner.colour) && is_same(mesh_.uvs, vertex, corner.uv);
}

grf::Mesh MeshBuilder::take() {
  mesh_.free_spare_memory();
  return std::move(mesh_);
}

}  // namespace convert
