#include "renderer/transport/scene/hit.h"

#include <algorithm>
#include <cmath>

namespace transport {
namespace {

float largest_component(const Vec3f& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

float sum_of_components(const Vec3f& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// (b - a) x (c - a). In float, rounding can turn the normal of a sliver anywhere, so slivers use double, in
/// which differences are accurate enough.
Vec3f doubled_area_normal(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  const Vec3f ab = b - a;
  const Vec3f ac = c - a;
  const Vec3f normal = ab.cross(ac);
  constexpr float SliverSine2 = 1e-6F;
  if (normal.length2() > SliverSine2 * ab.length2() * ac.length2()) return normal;
  const grf::Vec3d origin(a);
  return Vec3f((grf::Vec3d(b) - origin).cross(grf::Vec3d(c) - origin));
}

}  // namespace

HitTriangle::HitTriangle(const Geometry& geometry, const TriangleHit& hit, const Ray& ray)
    : instance_(geometry.instances[hit.id.instance]),
      mesh_(geometry.meshes[instance_.mesh]),
      triangle_(mesh_.triangles[hit.id.triangle]),
      corners_(triangle_.corners),
      ray_(ray),
      id_(hit.id),
      distance_(hit.distance),
      u_(hit.u),
      v_(hit.v),
      a_(mesh_.positions[corners_[0]]),
      b_(mesh_.positions[corners_[1]]),
      c_(mesh_.positions[corners_[2]]),
      doubled_area_(doubled_area_normal(a_, b_, c_)),
      // Of one interpolation; and the error of Embree's next test against this triangle grows with the whole
      // triangle, so all of its corners count in full.
      error_((absolute(a_) + absolute(b_) + absolute(c_)) * InterpolationError) {
  keep_off_edges();
}

// A point that rounding moves over the edge of its triangle would be outside a closed room. So it keeps some
// error bounds away from the edges, as far as the triangle is large enough.
void HitTriangle::keep_off_edges() {
  // In the scene's coordinates, since an instance's transform rounds, too. The point's own error counts along
  // all axes, as does that of the test against the triangle across the edge.
  const Vec3f ab = vector_in_scene(b_ - a_);
  const Vec3f ac = vector_in_scene(c_ - a_);
  const float area = largest_component(is_placed_by_map() ? ab.cross(ac) : doubled_area_);
  const float margin = 6 * largest_component(error_in_scene(position()));
  // As a barycentric weight: the distance to an edge over the triangle's height on it, which is the doubled
  // area over the edge.
  const auto least = [&](const Vec3f& edge) {
    return area > 0 ? std::min(margin * sum_of_components(edge) / area, 0.125F) : 0.125F;
  };
  const float least_u = least(ac);
  const float least_v = least(ab);
  const float least_w = least(ac - ab);
  float w = 1 - u_ - v_;
  if (u_ >= least_u && v_ >= least_v && w >= least_w) return;
  u_ = std::max(u_, least_u);
  v_ = std::max(v_, least_v);
  w = std::max(w, least_w);
  const float sum = u_ + v_ + w;
  u_ /= sum;
  v_ /= sum;
}

Vec3f HitTriangle::position() const {
  const Vec3f position = interpolate(a_, b_, c_);
  return is_placed_by_map() ? instance_.to_scene.point(position) : position;
}

Vec3f HitTriangle::error_in_scene(const Vec3f& position) const {
  if (!is_placed_by_map()) return error_;
  const auto& m = instance_.to_scene.linear;
  const float rounding = instance_.error_factor * (largest_component(position) + instance_.error_extent);
  Vec3f error;
  for (int i = 0; i < 3; ++i) {
    error[i] =
        std::abs(m[0][i]) * error_.x + std::abs(m[1][i]) * error_.y + std::abs(m[2][i]) * error_.z + rounding;
  }
  return error;
}

Vec3f HitTriangle::geometric_normal() const {
  const Vec3f normal = normal_in_scene(doubled_area_).normalized();
  return normal.length2() > 0.5F ? normal : -ray_.direction.normalized();
}

Vec3f HitTriangle::shading_normal(const Vec3f& geometric_normal) const {
  if (triangle_.is_flat) return geometric_normal;
  const Vec3f normal = normal_in_scene(interpolate(mesh_.normals));
  return normal.length2() > 0 ? normal.normalized() : geometric_normal;
}

// The position is interpolated, not computed along the ray, where the error grows with the distance.
SurfacePoint HitTriangle::point() const {
  SurfacePoint point;
  point.position = position();
  point.error = error_in_scene(point.position);
  point.geometric_normal = geometric_normal();
  point.shading_normal = shading_normal(point.geometric_normal);
  point.id = id_;
  point.cone = ray_.cone.at(distance_);
  return point;
}

Rgb HitTriangle::vertex_colour() const { return mesh_.colours.empty() ? Rgb(1) : interpolate(mesh_.colours); }

std::optional<Rgb> HitTriangle::irradiance() const {
  if (mesh_.irradiance.empty()) return std::nullopt;
  const Rgb irradiance = interpolate(mesh_.irradiance);
  if (std::isnan(irradiance.x)) return std::nullopt;
  return irradiance;
}

Vec2f HitTriangle::uv() const { return mesh_.uvs.empty() ? Vec2f(0) : interpolate(mesh_.uvs); }

float HitTriangle::uv_scale() const {
  if (mesh_.uvs.empty()) return 0;
  const Vec2f& a = mesh_.uvs[corners_[0]];
  const float uv_area = std::abs((mesh_.uvs[corners_[1]] - a).cross(mesh_.uvs[corners_[2]] - a));
  const float area = vector_in_scene(b_ - a_).cross(vector_in_scene(c_ - a_)).length();
  return area > 0 ? std::sqrt(uv_area / area) : 0;
}

Vec3f HitTriangle::tangent(const Vec3f& axis, const Vec3f& normal) const {
  if (!mesh_.uvs.empty()) {
    const Vec2f& a = mesh_.uvs[corners_[0]];
    const Vec2f ab = mesh_.uvs[corners_[1]] - a;
    const Vec2f ac = mesh_.uvs[corners_[2]] - a;
    const float area = ab.cross(ac);
    // Only the direction matters, so the sign of the area suffices.
    const Vec3f along_u = ((b_ - a_) * ac.y - (c_ - a_) * ab.y) * std::copysign(1.0F, area);
    if (area != 0 && along_u.length2() > 0) return vector_in_scene(along_u);
  }
  if (!is_placed_by_map()) return axis.cross(normal);
  // In object space, to which the object's y axis belongs.
  const Vec3f object_normal = normal * instance_.to_scene.linear.transposed();
  return vector_in_scene(Vec3f(0, 1, 0).cross(object_normal));
}

Vec3f HitTriangle::terminator_offset() const {
  const Vec3f place = interpolate(a_, b_, c_);
  const float side = ray_.direction.dot(normal_in_scene(doubled_area_)) <= 0 ? 1.0F : -1.0F;
  const auto above = [&](const Vec3f& corner, std::uint32_t index) {
    Vec3f normal = normal_in_scene(mesh_.normals[index]);
    if (is_placed_by_map()) normal.normalize();
    return normal * std::max(0.0F, vector_in_scene(corner - place).dot(normal) * side);
  };
  return interpolate(above(a_, corners_[0]), above(b_, corners_[1]), above(c_, corners_[2])) * side;
}

}  // namespace transport
