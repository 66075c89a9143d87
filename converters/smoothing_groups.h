#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "grf/math.h"

namespace convert {

/// Normals for formats that say by smoothing groups which faces go smoothly into each other. At a vertex, all
/// faces of a group share one normal, of which `mesh_operations/vertex_normals.h` says how it is made. Faces
/// of other groups at the same vertex have another one.
class SmoothingGroups {
 public:
  /// A face of a group: indices of its corners' positions.
  void add_face(std::uint32_t group, std::span<const std::uint32_t> vertices,
                std::span<const grf::Vec3f> positions);

  /// Of unit length. Nothing where faces have no area, or are back to back.
  std::optional<grf::Vec3f> normal(std::uint32_t group, std::uint32_t vertex) const;

 private:
  std::unordered_map<std::uint64_t, grf::Vec3d> sums_;  // by group and vertex
  std::vector<grf::Vec3d> of_face_;
};

}  // namespace convert
