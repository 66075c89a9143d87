#include "converters/smooth_normals.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace convert {
namespace {

std::uint64_t key_of(std::uint32_t group, std::uint32_t vertex) {
  return static_cast<std::uint64_t>(group) << 32U | vertex;
}

/// Of a polygon, by Newell's method, about its first corner so that little is lost far from the origin.
grf::Vec3d area_vector(std::span<const std::uint32_t> vertices, std::span<const grf::Vec3f> positions) {
  const grf::Vec3d origin(positions[vertices[0]]);
  grf::Vec3d sum(0);
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i) {
    sum +=
        (grf::Vec3d(positions[vertices[i]]) - origin).cross(grf::Vec3d(positions[vertices[i + 1]]) - origin);
  }
  return sum;
}

/// Between two edges, counted inside the face, and so over pi where a corner points inwards.
double angle_between(const grf::Vec3d& next, const grf::Vec3d& previous, const grf::Vec3d& normal) {
  const double angle = std::atan2(next.cross(previous).dot(normal), next.dot(previous));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

}  // namespace

void SmoothNormals::add_face(std::uint32_t group, std::span<const std::uint32_t> vertices,
                             std::span<const grf::Vec3f> positions) {
  const grf::Vec3d area = area_vector(vertices, positions);
  const double length = area.length();
  if (!(length > 0)) return;
  const grf::Vec3d normal = area / length;
  const std::size_t count = vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const grf::Vec3d here(positions[vertices[i]]);
    const grf::Vec3d next(positions[vertices[(i + 1) % count]]);
    const grf::Vec3d previous(positions[vertices[(i + count - 1) % count]]);
    const auto sum = sums_.try_emplace(key_of(group, vertices[i]), 0.0).first;
    sum->second += normal * angle_between(next - here, previous - here, normal);
  }
}

std::optional<grf::Vec3f> SmoothNormals::normal(std::uint32_t group, std::uint32_t vertex) const {
  const auto sum = sums_.find(key_of(group, vertex));
  if (sum == sums_.end()) return std::nullopt;
  constexpr double Cancelled = 1e-9;  // what rounding leaves of faces that are back to back
  if (!(sum->second.length() > Cancelled)) return std::nullopt;
  return grf::Vec3f(sum->second.normalized());
}

}  // namespace convert
