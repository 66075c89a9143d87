#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>

#include "grf/math.h"

namespace convert {

/// Normals for formats that say by smoothing groups which faces go smoothly into each other. At a vertex, all
/// faces of a group share one normal: the mean of their own, weighted by their angles there (Thuermer and
/// Wuethrich 1998), so that it does not depend on how a polygon is cut. Faces of other groups at the same
/// vertex have another one.
class SmoothNormals {
 public:
  /// A face of a group: indices of its corners' positions.
  void add_face(std::uint32_t group, std::span<const std::uint32_t> vertices,
                std::span<const grf::Vec3f> positions);

  /// Of unit length. Nothing where faces have no area, or are back to back.
  std::optional<grf::Vec3f> normal(std::uint32_t group, std::uint32_t vertex) const;

 private:
  std::unordered_map<std::uint64_t, grf::Vec3d> sums_;  // by group and vertex
};

}  // namespace convert
