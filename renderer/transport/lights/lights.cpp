#include "renderer/transport/lights/lights.h"

#include <bit>
#include <cmath>
#include <numbers>

#include "renderer/transport/lights/spherical_rectangle.h"
#include "renderer/transport/lights/spherical_triangle.h"
#include "renderer/transport/scene/ray_offset.h"

namespace transport {
namespace {

/// An emitter's geometry relative to a point.
struct RelativeEmitter {
  Vec3d corner;
  Vec3d edge1;
  Vec3d edge2;

  RelativeEmitter(const Emitter& emitter, const Vec3f& from)
      : corner(Vec3d(emitter.corner) - Vec3d(from)), edge1(emitter.edge1), edge2(emitter.edge2) {}

  /// Up to float rounding.
  bool is_rectangle() const {
    const double cosine = edge1.dot(edge2);
    return cosine * cosine <= 1e-12 * edge1.dot(edge1) * edge2.dot(edge2);
  }
};

/// Calls `use` with the emitter's spherical shape.
template <class Use>
auto with_shape(const Emitter& emitter, const RelativeEmitter& view, const Use& use) {
  if (emitter.is_triangle) return use(SphericalTriangle(view.corner, view.edge1, view.edge2));
  if (view.is_rectangle()) return use(SphericalRectangle(view.corner, view.edge1, view.edge2));
  return use(SphericalParallelogram(view.corner, view.edge1, view.edge2));
}

/// Whether an emitter is so far away, and not edge-on, that its points all look the same: uniform area
/// sampling is then as good as uniform solid-angle sampling, and takes a tenth of the time.
bool is_far(const Emitter& emitter, const Vec3f& from) {
  const float part = emitter.is_triangle ? 1.0F / 3 : 0.5F;
  const Vec3f to_middle = emitter.corner - from + (emitter.edge1 + emitter.edge2) * part;
  const float distance2 = to_middle.length2();
  if (!(distance2 > 4 * (emitter.edge1.length2() + emitter.edge2.length2()))) return false;
  constexpr float LeastCosine2 = 0.01F;
  const Vec3f area = emitter.doubled_area_normal();
  const float cosine = area.dot(to_middle);
  return cosine * cosine > LeastCosine2 * area.length2() * distance2;
}

/// The solid-angle pdf of uniform area sampling, towards a point on the emitter.
float pdf_by_area(const Emitter& emitter, const Vec3f& to_light) {
  const float distance2 = to_light.length2();
  const float projected =
      std::abs(emitter.doubled_area_normal().dot(to_light)) * (emitter.is_triangle ? 0.5F : 1.0F);
  return distance2 * std::sqrt(distance2) / projected;
}

/// Samples uniformly by area: multiples of the two edges.
Vec2f sample_area(const Emitter& emitter, const Vec2f& xi) {
  if (!emitter.is_triangle) return xi;
  const float root = std::sqrt(xi.x);
  return {1 - root, root * xi.y};
}

/// Adds random low bits, hashed from xi, to choose among more emitters than a float can distinguish.
double add_random_bits(float choice, const Vec2f& xi) {
  std::uint32_t bits = std::bit_cast<std::uint32_t>(xi.x) * 0x9E3779B1U ^ std::bit_cast<std::uint32_t>(xi.y);
  bits = (bits ^ (bits >> 16)) * 0x7FEB352DU;
  bits = (bits ^ (bits >> 15)) * 0x846CA68BU;
  bits ^= bits >> 16;
  return double(choice) + double(bits) * 0x1p-56;
}

LightSample sample_at(const Emitter& emitter, const Vec2f& place, const Vec3f& direction, float pdf,
                      std::uint32_t index) {
  const Vec3f extent = absolute(emitter.corner) + absolute(emitter.edge1) + absolute(emitter.edge2);
  return {direction,
          emitter.corner + emitter.edge1 * place.x + emitter.edge2 * place.y,
          extent * InterpolationError,
          emitter.doubled_area_normal().normalized(),
          emitter.radiance,
          pdf,
          index,
          place};
}

}  // namespace

Lights::Lights(std::vector<Emitter> emitters) : emitters_(std::move(emitters)), tree_(emitters_) {
  emitters_.shrink_to_fit();
  for (const Emitter& emitter : emitters_) power_ += std::numbers::pi * double(emitter.power());
}

std::optional<LightSample> Lights::sample(const Vec3f& from, const Vec3f& normal, float choice,
                                          const Vec2f& xi) const {
  const auto found = tree_.choose(emitters_, from, normal, add_random_bits(choice, xi));
  if (!found) return std::nullopt;
  const LightTree::Choice& chosen = *found;
  const Emitter& emitter = emitters_[chosen.emitter];
  if (is_far(emitter, from)) {
    const Vec2f place = sample_area(emitter, xi);
    const Vec3f to_light = emitter.corner - from + emitter.edge1 * place.x + emitter.edge2 * place.y;
    const float pdf = chosen.probability * pdf_by_area(emitter, to_light);
    if (!std::isfinite(pdf)) return std::nullopt;
    return sample_at(emitter, place, to_light.normalized(), pdf, chosen.emitter);
  }
  const RelativeEmitter view(emitter, from);
  Vec2d place(0);
  const float solid_angle = with_shape(emitter, view, [&](const auto& shape) {
    if (shape.solid_angle() > 0) place = shape.sample(xi);
    return shape.solid_angle();
  });
  const float pdf = chosen.probability / solid_angle;
  if (!(pdf > 0) || !std::isfinite(pdf)) return std::nullopt;
  const Vec3d to_light = view.corner + view.edge1 * place.x + view.edge2 * place.y;
  return sample_at(emitter, Vec2f(place), Vec3f(to_light.normalized()), pdf, chosen.emitter);
}

float Lights::pdf(const Vec3f& from, const Vec3f& normal, std::size_t emitter, const Vec3f& direction) const {
  const Emitter& seen = emitters_[emitter];
  const float probability = tree_.probability(emitters_, from, normal, static_cast<std::uint32_t>(emitter));
  if (!(probability > 0)) return 0;
  if (is_far(seen, from)) {
    // The distance along the direction to the emitter's plane.
    const Vec3f area = seen.doubled_area_normal();
    const float along = area.dot(seen.corner - from) / area.dot(direction);
    const float pdf = probability * pdf_by_area(seen, direction * along);
    return std::isfinite(pdf) ? pdf : 0;
  }
  const float solid_angle =
      with_shape(seen, RelativeEmitter(seen, from), [](const auto& shape) { return shape.solid_angle(); });
  const float pdf = probability / solid_angle;
  return std::isfinite(pdf) ? pdf : 0;
}

}  // namespace transport
