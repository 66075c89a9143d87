#include "samples/shapes/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "samples/shapes/scene_text.h"

namespace shape {
namespace {

constexpr double Step = 1e-5;

V3d normal_at(const Surface& surface, double along, double around) {
  const V3d by_along = surface(along + Step, around) - surface(along - Step, around);
  const V3d by_around = surface(along, around + Step) - surface(along, around - Step);
  return by_around.cross(by_along).normalized();
}

}  // namespace

grf::Vec3f rounded(const V3d& v, double steps) {
  const auto round = [&](double x) { return static_cast<float>(std::round(x * steps) / steps + 0.0); };
  return {round(v.x), round(v.y), round(v.z)};
}

Fitting::Fitting(const std::vector<V3d>& positions) {
  Imath::Box3d bounds;
  for (const V3d& position : positions) bounds.extendBy(position);
  const V3d size = bounds.size();
  scale_ = 2 / std::max({size.x, size.y, size.z});
  foot_ = V3d(bounds.center().x, bounds.min.y, bounds.center().z);
}

std::uint32_t Builder::add_vertex(const V3d& position, const V3d& normal) {
  positions_.push_back(position);
  normals_.push_back(normal);
  return static_cast<std::uint32_t>(positions_.size() - 1);
}

void Builder::add_cells(std::uint32_t first, std::uint32_t rings, std::uint32_t segments) {
  const std::uint32_t last = first + 1 + (rings - 1) * segments;
  for (std::uint32_t k = 0; k < segments; ++k) {
    const std::uint32_t beside = (k + 1) % segments;
    triangles_.push_back({first, first + 1 + beside, first + 1 + k});
    for (std::uint32_t i = 0; i + 2 < rings; ++i) {
      const std::uint32_t row = first + 1 + i * segments;
      const std::uint32_t next = row + segments;
      triangles_.push_back({row + k, row + beside, next + beside});
      triangles_.push_back({row + k, next + beside, next + k});
    }
    const std::uint32_t row = last - segments;
    triangles_.push_back({row + k, row + beside, last});
  }
}

void Builder::add(const Surface& surface, double triangles, double length_over_girth) {
  // A ring has two triangles a segment, but for those at the poles.
  const auto segments =
      std::max(6U, static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 2 / length_over_girth))));
  const auto rings = std::max(4U, static_cast<std::uint32_t>(std::lround(triangles / 2 / segments)) + 1);
  // Of the triangles there, whether the surface bulges or is hollow.
  const auto pole_normal = [&](double pole, double beside, double sense) {
    const V3d centre = surface(pole, 0);
    V3d sum(0);
    for (int k = 0; k < 4; ++k) {
      const V3d edge = surface(beside, k * TwoPi / 4) - centre;
      sum += edge.cross(surface(beside, (k + 1) * TwoPi / 4) - centre) * sense;
    }
    return sum.normalized();
  };
  const std::uint32_t first = add_vertex(surface(0, 0), pole_normal(0, 1.0 / rings, -1));
  for (std::uint32_t i = 1; i < rings; ++i) {
    const double along = static_cast<double>(i) / rings;
    for (std::uint32_t k = 0; k < segments; ++k) {
      const double around = TwoPi * k / segments;
      add_vertex(surface(along, around), normal_at(surface, along, around));
    }
  }
  add_vertex(surface(1, 0), pole_normal(1, 1 - 1.0 / rings, 1));
  add_cells(first, rings, segments);
}

grf::Mesh Builder::mesh() const {
  grf::MeshDraft mesh;
  const Fitting fit(positions_);
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    mesh.positions.push_back(rounded(fit(positions_[i]), 1e5));
    mesh.normals.set(i, rounded(normals_[i], 1e4));
  }
  for (const auto& triangle : triangles_) mesh.add_face(triangle, 0);
  return mesh;
}

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

V3d curve_through(const std::vector<V3d>& points, double at) {
  const double place = at * static_cast<double>(points.size() - 1);
  const auto i =
      static_cast<std::ptrdiff_t>(std::clamp(std::floor(place), 0.0, static_cast<double>(points.size() - 2)));
  const double t = place - static_cast<double>(i);
  const auto point = [&](std::ptrdiff_t k) {
    const auto last = static_cast<std::ptrdiff_t>(points.size()) - 1;
    // Straight on before the first and after the last.
    if (k < 0) return points[0] * 2.0 - points[1];
    if (k > last) return points[points.size() - 1] * 2.0 - points[points.size() - 2];
    return points[static_cast<std::size_t>(k)];
  };
  const V3d a = point(i - 1), b = point(i), c = point(i + 1), d = point(i + 2);
  return (b * 2.0 + (c - a) * t + (a * 2.0 - b * 5.0 + c * 4.0 - d) * (t * t) +
          (b * 3.0 - a - c * 3.0 + d) * (t * t * t)) *
         0.5;
}

Surface tube(const DirectionAlong& curve, const std::function<double(double along, double around)>& radius,
             const DirectionAlong& up) {
  return [=](double along, double around) {
    const V3d tangent = (curve(along + Step) - curve(along - Step)).normalized();
    const V3d side = tangent.cross(up(along)).normalized();
    const V3d top = side.cross(tangent);
    return curve(along) + (top * std::cos(around) + side * std::sin(around)) * radius(along, around);
  };
}

}  // namespace shape
