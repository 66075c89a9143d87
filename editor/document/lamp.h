// A lamp is what an author thinks of: a shape with a centre, a direction, a size and a radiance in world
// space.
#pragma once

#include <optional>

#include "editor/document/object_placement.h"
#include "editor/document/scene_objects.h"
#include "grf/diagnostics.h"
#include "grf/math.h"
#include "grf/scene.h"
#include "grf/scene_path.h"

namespace editor {

enum class LampShape { Rectangle, Disc, Sphere };

/// A lamp in world space. The rectangle is an area light, disc and sphere are mesh lights.
///
/// Yaw turns the direction of the emission about +y, counter-clockwise seen from above, from -z on; elevation
/// is its angle above the horizon, -90..90, and -90 is straight down. Without roll the side of the width is
/// horizontal; roll turns it about the direction, clockwise seen by the lamp. All are in degrees.
struct Lamp {
  LampShape shape = LampShape::Rectangle;
  grf::Vec3d centre = grf::Vec3d(0);
  double yaw = 0;
  double elevation = -90;
  double roll = 0;    ///< of a rectangle
  double width = 1;   ///< of a rectangle: the length of edge 1
  double height = 1;  ///< of a rectangle: the length of edge 2
  double radius = 1;  ///< of disc and sphere
  grf::Colour radiance = grf::Colour(1);

  bool operator==(const Lamp&) const = default;
};

/// The unit vector of the emission.
grf::Vec3d direction_of(const Lamp& lamp);
/// Turns a lamp toward a point, about its centre. A horizontal side stays horizontal.
void aim(Lamp& lamp, const grf::Vec3d& point);
/// Places a lamp such that a mirror at a point shows its centre, at a distance from the point, to an eye that
/// looks in that direction, and aims at the point.
void light_highlight(Lamp& lamp, const grf::Vec3d& point, const grf::Vec3d& normal,
                     const grf::Vec3d& view_direction, double distance);

/// A lamp above the centre of the bounds, facing down, in proportion to them.
Lamp lamp_over(LampShape shape, const grf::Box3d& bounds);

/// The lamp at a path. Nothing for other objects, for an area light whose edges are not orthogonal in world
/// space, and for a mesh light that is neither a regular disc nor a sphere in world space, of 12 corners or
/// more, or is in an included file.
std::optional<Lamp> lamp_at(const grf::Scene& scene, const SceneObjects& objects, grf::ScenePathView path);
/// Adds a lamp to the scene. Disc and sphere are meshes of unit radius under a transform.
grf::Scene add_lamp(const grf::Scene& scene, const Lamp& lamp);
/// Changes the lamp at a path, where `lamp_at` finds one, to another one of the same shape. Only numbers that
/// have to change do, and new ones are rounded to few decimals within the precision of `float`. Nothing, with
/// the reason in the diagnostics, if there is no lamp.
std::optional<TransformedObjects> change_lamp(const grf::Scene& scene, const SceneObjects& objects,
                                              grf::ScenePathView path, const Lamp& lamp,
                                              grf::Diagnostics& diagnostics);

}  // namespace editor
