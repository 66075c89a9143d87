#pragma once

#include "grf/math.h"
#include "renderer/transport/lights/emitter.h"

namespace transport {

using grf::Box3f;

/// Directions within an angle of an axis.
struct Cone {
  Vec3f axis = Vec3f(0, 0, 1);  ///< unit
  float cosine = 1;             ///< of the angle
};

/// A small cone about both.
Cone merged(const Cone& a, const Cone& b);

/// Where some emitters are, to where they shine, and how much: what decides how much light they can give.
struct LightBounds {
  Vec3f centre;      ///< of a sphere about them
  float radius = 0;  ///< of the sphere
  Cone normals;      ///< of the emitters' fronts
  float power = 0;   ///< see Emitter
};

LightBounds bounds_of(const Emitter& emitter);

/// How much light a diffuse surface at a point may get, up to a factor: 0 only if it gets none. `normal` is
/// the receiver's, unit. (Conty Estevez and Kulla 2018, "Importance sampling of many lights with adaptive
/// tree splitting", section 5.3.) Distances count down to half of the sphere's radius and not, as in the
/// paper, to all of it: under a ceiling of 1000 lamps that leaves a tenth of the variance.
float importance(const LightBounds& bounds, const Vec3f& from, const Vec3f& normal);

/// The same of one emitter, which is 0 from behind and if it lies under the receiver's horizon.
float importance(const Emitter& emitter, const Vec3f& from, const Vec3f& normal);

/// True if the emitter shows its front and some of it is over the horizon.
bool may_light(const Emitter& emitter, const Vec3f& from, const Vec3f& normal);

}  // namespace transport
