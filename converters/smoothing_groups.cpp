#include "converters/smoothing_groups.h"

#include <cstddef>

#include "converters/mesh_operations/vertex_normals.h"

namespace convert {
namespace {

std::uint64_t key_of(std::uint32_t group, std::uint32_t vertex) {
  return static_cast<std::uint64_t>(group) << 32U | vertex;
}

}  // namespace

void SmoothingGroups::add_face(std::uint32_t group, std::span<const std::uint32_t> vertices,
                               std::span<const grf::Vec3f> positions) {
  weighted_normals(vertices, positions, of_face_);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    sums_.try_emplace(key_of(group, vertices[k]), 0.0).first->second += of_face_[k];
  }
}

std::optional<grf::Vec3f> SmoothingGroups::normal(std::uint32_t group, std::uint32_t vertex) const {
  const auto sum = sums_.find(key_of(group, vertex));
  return sum == sums_.end() ? std::nullopt : unit_normal(sum->second);
}

}  // namespace convert
