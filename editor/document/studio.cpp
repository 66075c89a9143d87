#include "editor/document/studio.h"

#include <algorithm>
#include <utility>

#include "editor/document/light_edits.h"
#include "editor/document/primitive_shapes.h"

namespace editor {
namespace {

/// A square area light that faces a point.
grf::AreaLight light_facing(const grf::Vec3d& target, const grf::Vec3d& position, double side,
                            float radiance) {
  const grf::Vec3d forward = (target - position).normalized();
  const grf::Vec3d right = forward.cross(grf::Vec3d(0, 1, 0)).normalized() * side;
  const grf::Vec3d down = forward.cross(right);  // right x down points forward
  grf::AreaLight light;
  light.corner = grf::Vec3f(position - (right + down) / 2);
  light.edge1 = grf::Vec3f(right);
  light.edge2 = grf::Vec3f(down);
  light.radiance = grf::Colour(radiance);
  return light;
}

}  // namespace

grf::Scene add_studio(const grf::Scene& scene, const SceneObjects& objects) {
  grf::Box3d bounds = objects.mesh_bounds;
  if (bounds.isEmpty()) bounds = {grf::Vec3d(-0.5, 0, -0.5), grf::Vec3d(0.5, 1, 0.5)};
  const grf::Vec3d centre = bounds.center();
  const double radius = std::max(bounds.size().length() / 2, 1e-6);

  constexpr double FloorSide = 80;  // its edge is near the horizon, in the dark
  constexpr double Gap = 1e-4;      // the undersides of objects are not in the plane of the floor
  grf::Mesh floor = mesh_of(shape_of_size(PrimitiveShape::Kind::Plane, FloorSide * radius));
  floor.name = "floor";
  grf::BrdfModel grey;
  grey.keyword = "diffuse";
  grey.arguments = {grf::Argument{"kd", grf::Value(0.5F), {}}};
  floor.surfaces.front().brdf = grey;
  const grf::Vec3d below(centre.x, bounds.min.y - Gap * radius, centre.z);
  grf::Scene studio = add_mesh(scene, objects, std::move(floor), below).scene;

  constexpr float SoftBoxRadiance = 3.5F;
  constexpr float RimRadiance = 4.5F;
  const grf::Vec3d soft_box = centre + grf::Vec3d(-1.8, 3.2, 2.9) * radius;
  const grf::Vec3d rim = centre + grf::Vec3d(1.5, 4, -3.5) * radius;
  studio = add_light(studio, light_facing(centre, soft_box, 5 * radius, SoftBoxRadiance));
  return add_light(studio, light_facing(centre, rim, 1.5 * radius, RimRadiance));
}

}  // namespace editor
