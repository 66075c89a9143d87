#include "converters/mesh_builder.h"

#include <bit>
#include <utility>

namespace convert {

MeshBuilder::MeshBuilder(std::string name) { mesh_.name = std::move(name); }

std::uint32_t MeshBuilder::surface(const grf::Surface& surface) {
  if (!surfaces_) {
    mesh_.surfaces = {surface};
    surfaces_.emplace(mesh_);
  }
  return surfaces_->index_of(surface);
}

void MeshBuilder::add_face(std::span<const Corner> corners, std::uint32_t surface) {
  face_.clear();
  for (const Corner& corner : corners) face_.push_back(vertex(corner));
  mesh_.add_face(face_, surface);
}

std::uint32_t MeshBuilder::vertex(const Corner& corner) {
  const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
  const auto [known, is_new] = vertices_.emplace(key_of(corner), next);
  if (is_new) {
    mesh_.positions.push_back(corner.position);
    if (corner.normal) mesh_.normals.set(next, *corner.normal);
    if (corner.colour) mesh_.colours.set(next, *corner.colour);
    if (corner.uv) mesh_.uvs.set(next, *corner.uv);
  }
  return known->second;
}

MeshBuilder::Key MeshBuilder::key_of(const Corner& corner) {
  Key key = {};
  std::size_t i = 0;
  const auto put = [&](const auto& v) {
    for (unsigned k = 0; k < v.dimensions(); ++k) {
      key[i++] = std::bit_cast<std::uint32_t>(v[static_cast<int>(k)]);
    }
  };
  put(corner.position);
  put(corner.normal.value_or(grf::Vec3f(0)));
  put(corner.colour.value_or(grf::Colour(0)));
  put(corner.uv.value_or(grf::Vec2f(0)));
  key[i] = (corner.normal ? 1U : 0U) | (corner.colour ? 2U : 0U) | (corner.uv ? 4U : 0U);
  return key;
}

// FNV-1a on words, with a last mix since the bits of round numbers differ in their upper half alone.
std::size_t MeshBuilder::KeyHash::operator()(const Key& key) const {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const std::uint32_t word : key) hash = (hash ^ word) * 0x100000001b3ULL;
  return hash ^ (hash >> 32U);
}

}  // namespace convert
