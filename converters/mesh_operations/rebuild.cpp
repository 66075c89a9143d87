#include "converters/mesh_operations/rebuild.h"

#include <array>
#include <bit>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "grf/topology.h"

namespace convert {
namespace {

/// The key of a vertex: its position, the bits of normal, colour and texture coordinates, and presence flags.
using Key = std::array<std::uint32_t, 10>;

// The hash is FNV-1a on words, with a final mix since round numbers differ only in their upper bits.
struct KeyHash {
  std::size_t operator()(const Key& key) const {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const std::uint32_t word : key) hash = (hash ^ word) * 0x100000001b3ULL;
    return hash ^ (hash >> 32U);
  }
};

Key key_of(const grf::Mesh& mesh, std::uint32_t vertex, std::uint32_t place) {
  Key key = {place};
  std::size_t i = 1;
  const auto put = [&](const auto& values, unsigned flag) {
    if (!values.has(vertex)) return;
    key.back() |= flag;
    const auto& value = values[vertex];
    for (unsigned k = 0; k < value.dimensions(); ++k) {
      key[i++] = std::bit_cast<std::uint32_t>(value[static_cast<int>(k)]);
    }
  };
  put(mesh.geometry->normals, 1);
  put(mesh.geometry->colours, 2);
  put(mesh.geometry->uvs, 4);
  return key;
}

bool have_same_irradiance(const grf::Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  if (mesh.irradiance->has(a) != mesh.irradiance->has(b)) return false;
  return !mesh.irradiance->has(a) || (*mesh.irradiance)[a] == (*mesh.irradiance)[b];
}

}  // namespace

std::vector<std::uint32_t> first_equal_vertex(const grf::Mesh& mesh) {
  const std::vector<std::uint32_t> places = grf::first_at_position(*mesh.geometry);
  std::unordered_map<Key, std::uint32_t, KeyHash> known;
  known.reserve(mesh.geometry->positions.size());
  std::vector<std::uint32_t> first;
  first.reserve(mesh.geometry->positions.size());
  for (std::uint32_t i = 0; i < mesh.geometry->positions.size(); ++i) {
    const std::uint32_t candidate = known.emplace(key_of(mesh, i, places[i]), i).first->second;
    first.push_back(have_same_irradiance(mesh, candidate, i) ? candidate : i);
  }
  return first;
}

Rebuild::Rebuild(const grf::Mesh& source) : source_(source), mesh_(without_geometry(source)) {
  mesh_.corners.reserve(source.geometry->corners.size());
  mesh_.face_offsets.reserve(source.geometry->face_offsets.size());
  mesh_.surface_of_face.reserve(source.face_count());
}

void Rebuild::add_face(std::span<const std::uint32_t> corners, std::uint32_t surface) {
  mesh_.add_face(corners, surface);
}

grf::Mesh Rebuild::take() {
  std::vector<bool> is_used(source_.geometry->positions.size());
  for (const std::uint32_t corner : mesh_.corners) is_used[corner] = true;
  std::vector<std::uint32_t> copies(source_.geometry->positions.size());
  for (std::uint32_t i = 0; i < is_used.size(); ++i) {
    if (is_used[i]) copies[i] = mesh_.copy_vertex(source_, i);
  }
  for (std::uint32_t& corner : mesh_.corners) corner = copies[corner];
  mesh_.free_spare_memory();
  return std::move(mesh_);
}

grf::MeshDraft without_geometry(const grf::Mesh& mesh) {
  grf::MeshDraft empty;
  empty.name = mesh.name;
  empty.comments = mesh.comments;
  empty.surfaces = mesh.surfaces;
  return empty;
}

}  // namespace convert
