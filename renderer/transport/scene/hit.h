// A hit has the geometry and attributes of a triangle where a ray meets it.
#pragma once

#include "renderer/transport/scene/geometry.h"
#include "renderer/transport/scene/ray_caster.h"
#include "renderer/transport/scene/surface_point.h"

namespace transport {

/// A triangle of a placed mesh, at the hit point, in the coordinates of the compiled scene.
class HitTriangle {
 public:
  HitTriangle(const Geometry& geometry, const TriangleHit& hit, const Ray& ray);

  const Triangle& triangle() const { return triangle_; }
  const Instance& instance() const { return instance_; }

  /// Position, error, normals, cone and identity.
  SurfacePoint point() const;
  Rgb vertex_colour() const;
  std::optional<Rgb> irradiance() const;
  Vec2f uv() const;
  /// The length in uv coordinates of one unit of length on the triangle: the geometric mean over directions.
  float uv_scale() const;
  Vec3f tangent(const Vec3f& axis, const Vec3f& normal) const;
  /// The offset from the triangle to the curved surface that the vertex normals suggest, on the side that the
  /// ray came from; 0 where that surface is not above the triangle.
  Vec3f terminator_offset() const;

 private:
  void keep_off_edges();
  Vec3f position() const;
  /// The bound of a position's error, per axis.
  Vec3f error_in_scene(const Vec3f& position) const;
  Vec3f geometric_normal() const;
  Vec3f shading_normal(const Vec3f& geometric_normal) const;
  template <class Value>
  Value interpolate(const Value& a, const Value& b, const Value& c) const {
    return a * (1 - u_ - v_) + b * u_ + c * v_;
  }
  template <class Value>
  Value interpolate(const std::vector<Value>& values) const {
    return interpolate(values[corners_[0]], values[corners_[1]], values[corners_[2]]);
  }
  bool is_placed_by_map() const { return id_.instance != 0; }
  Vec3f normal_in_scene(const Vec3f& normal) const {
    return is_placed_by_map() ? normal * instance_.normal_map : normal;
  }
  Vec3f vector_in_scene(const Vec3f& vector) const {
    return is_placed_by_map() ? instance_.to_scene.vector(vector) : vector;
  }

  const Instance& instance_;
  const TriangleMesh& mesh_;
  const Triangle& triangle_;
  const std::array<std::uint32_t, 3>& corners_;
  const Ray& ray_;
  TriangleId id_;
  float distance_;
  float u_, v_;  ///< barycentric weights of the second and third corner
  // In the mesh's coordinates.
  Vec3f a_, b_, c_;
  Vec3f doubled_area_;  ///< normal whose length is twice the area
  Vec3f error_;         ///< of an interpolated position
};

}  // namespace transport
