#pragma once

#include "grf/math.h"
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
  Vec3f centre;      ///< of the bounding sphere
  float radius = 0;  ///< of the bounding sphere
  Cone normals;      ///< bounds the normals of the emitters' fronts
  float power = 0;   ///< see Emitter
};

LightBounds bounds_of(const Emitter& emitter);

/// An estimate of the light that a diffuse surface at a point receives, up to a factor: 0 only if it gets
/// none. `normal` is the receiver's, unit. (Conty Estevez and Kulla 2018, "Importance sampling of many lights
/// with adaptive tree splitting", section 5.3.) Distances are clamped to half of the sphere's radius and not,
/// as in the paper, to the radius: under a ceiling of 1000 lamps that leaves a tenth of the variance.
float importance(const LightBounds& bounds, const Vec3f& from, const Vec3f& normal);

/// Returns this estimate for a single emitter: 0 from behind it, and if it lies below the receiver's horizon.
float importance(const Emitter& emitter, const Vec3f& from, const Vec3f& normal);

/// Whether the emitter faces the point and some of it is above the horizon.
bool can_illuminate(const Emitter& emitter, const Vec3f& from, const Vec3f& normal);

}  // namespace transport
