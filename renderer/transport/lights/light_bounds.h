#pragma once

#include <array>

#include "grf/math.h"
#include "renderer/transport/float8.h"
#include "renderer/transport/lights/emitter.h"

namespace transport {

using grf::Box3f;

/// A cone of directions within an angle of an axis.
struct Cone {
  Vec3f axis = Vec3f(0, 0, 1);  ///< unit
  float cosine = 1;             ///< of the angle
};

/// Returns a small cone that bounds both.
Cone merged(const Cone& a, const Cone& b);

/// Bounds on the position, orientation and power of some emitters, which determine their importance.
struct LightBounds {
  Box3f box;
  Cone normals;     ///< bounds the normals of the emitters' fronts
  float power = 0;  ///< see Emitter
};

LightBounds bounds_of(const Emitter& emitter);

/// The bounds of up to eight clusters of emitters, one array per field: their importance is computed in
/// vector registers.
class LightBounds8 {
 public:
  static constexpr int Size = 8;

  void set(int index, const LightBounds& bounds);

  /// Estimates the light that a diffuse surface at a point receives from each cluster, up to a factor: 0 only
  /// if it gets none, and where there is no cluster. `normal` is the receiver's, unit. (Conty Estevez and
  /// Kulla 2018, "Importance sampling of many lights with adaptive tree splitting", section 5.3.) Distances
  /// are clamped to half of the radius of the box's sphere and not, as in the paper, to the radius: under a
  /// ceiling of 1000 lamps that leaves a tenth of the variance.
  Float8 importance(const Vec3f& from, const Vec3f& normal) const;

 private:
  using Lanes = std::array<float, Size>;
  struct Vectors {
    alignas(32) Lanes x{};
    alignas(32) Lanes y{};
    alignas(32) Lanes z{};

    void set(int index, const Vec3f& value);
  };

  Vectors centre_;              ///< of the box
  Vectors half_size_;           ///< of the box
  Vectors axis_;                ///< of the cone of normals
  alignas(32) Lanes cosine_{};  ///< of the cone's angle
  alignas(32) Lanes power_{};   ///< 0 where there is no cluster
};

/// Whether the emitter faces the point and some of it is above the horizon.
bool can_illuminate(const Emitter& emitter, const Vec3f& from, const Vec3f& normal);

}  // namespace transport
