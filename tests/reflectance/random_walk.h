#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <random>
#include <utility>

#include <ImathVec.h>

namespace test {

/// A walk over the facets of a surface with uniformly distributed heights (Heitz, Hanika, d'Eon and
/// Dachsbacher 2016, "Multiple-scattering microfacet BSDFs with the Smith model"): it reflects a ray until it
/// leaves, and knows nothing of albedos. Directions point the way that the ray travels.
class RandomWalk {
 public:
  RandomWalk(double alpha, std::uint32_t seed) : alpha_(alpha), random_(seed) {}

  /// Returns the factor that is left of the light and the number of bounces; `reflectance` is called with the
  /// cosine at each facet.
  template <class Reflectance>
  std::pair<double, int> run(const Imath::V3d& u, Reflectance reflectance) {
    Imath::V3d ray = -u;
    double height = 1;
    double left = 1;
    for (int bounces = 0; bounces < 1000; ++bounces) {
      const auto next = next_height(ray, height);
      if (!next) return {left, bounces};
      height = *next;
      const Imath::V3d normal = visible_normal(-ray);
      left *= reflectance(-ray.dot(normal));
      ray = (ray - 2 * ray.dot(normal) * normal).normalized();
    }
    return {0, 1000};
  }

 private:
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }

  /// Smith's Lambda, for rays that rise or descend.
  double lambda(const Imath::V3d& w) const {
    const double slope = alpha_ * std::sqrt(std::max(0.0, 1 - w.z * w.z)) / std::abs(w.z);
    return (std::copysign(std::sqrt(1 + slope * slope), w.z) - 1) / 2;
  }

  /// The height from -1 to 1 at which the ray meets a facet; nothing if it leaves.
  std::optional<double> next_height(const Imath::V3d& ray, double height) {
    const double below = (height + 1) / 2;
    const double chance = uniform();
    if (ray.z > 1 - 1e-9) return std::nullopt;
    if (ray.z < -1 + 1e-9) return 2 * chance * below - 1;
    if (std::abs(ray.z) < 1e-7) return height;
    const double power = lambda(ray);
    if (ray.z > 0 && chance > 1 - std::pow(below, power)) return std::nullopt;
    return std::min(1.0, 2 * below / std::pow(1 - chance, 1 / power) - 1);
  }

  /// A facet's normal as seen from a direction, which may be below the surface (Dupuy and Benyoub 2023).
  Imath::V3d visible_normal(const Imath::V3d& from) {
    const Imath::V3d view = Imath::V3d(alpha_ * from.x, alpha_ * from.y, from.z).normalized();
    const double angle = 2 * std::numbers::pi * uniform();
    const double z = (1 - uniform()) * (1 + view.z) - view.z;
    const double radius = std::sqrt(std::max(0.0, 1 - z * z));
    const Imath::V3d cap = Imath::V3d(radius * std::cos(angle), radius * std::sin(angle), z) + view;
    return Imath::V3d(alpha_ * cap.x, alpha_ * cap.y, cap.z).normalized();
  }

  double alpha_;
  std::mt19937 random_;
};

}  // namespace test
