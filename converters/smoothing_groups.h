#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "grf/math.h"

namespace convert {

/// Computes vertex normals from smoothing groups. At a vertex, all faces of a group share one normal
/// (computed as in `mesh_operations/vertex_normals.h`); faces of other groups there have another one.
class SmoothingGroups {
 public:
  /// Adds a face of a group, with the indices of its corners' positions.
  void add_face(std::uint32_t group, std::span<const std::uint32_t> vertices,
                std::span<const grf::Vec3f> positions);

  /// Returns the unit normal, or nothing if the faces are degenerate or back to back.
  std::optional<grf::Vec3f> normal(std::uint32_t group, std::uint32_t vertex) const;

 private:
  std::unordered_map<std::uint64_t, grf::Vec3d> sums_;  // by group and vertex
  std::vector<grf::Vec3d> of_face_;
};

}  // namespace convert
