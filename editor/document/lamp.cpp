#include "editor/document/lamp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "editor/document/light_edits.h"
#include "editor/document/scene_places.h"

namespace editor {
namespace {

using grf::Vec3d;
using grf::Vec3f;
using Kind = grf::TransformStep::Kind;

constexpr double Degree = std::numbers::pi / 180;
constexpr double LampPrecision = std::numeric_limits<float>::epsilon();
/// Of edges and radii that pass for orthogonal and equal.
constexpr double ShapeTolerance = 1e-5;
constexpr std::size_t FewestCorners = 12;

/// The sides of a rectangle, which with its direction are a right-handed frame.
struct Sides {
  Vec3d right;
  Vec3d down;
};

Sides sides_without_roll(double yaw, double elevation) {
  const double a = yaw * Degree, e = elevation * Degree;
  return {{std::cos(a), 0, -std::sin(a)},
          {-std::sin(a) * std::sin(e), -std::cos(e), -std::cos(a) * std::sin(e)}};
}

Sides sides_of(const Lamp& lamp) {
  const Sides level = sides_without_roll(lamp.yaw, lamp.elevation);
  const double r = lamp.roll * Degree;
  return {level.right * std::cos(r) + level.down * std::sin(r),
          level.down * std::cos(r) - level.right * std::sin(r)};
}

/// Rounds what an angle lost as `float`.
double rounded_degrees(double radians) { return shortest_near(radians / Degree, 2e-5); }

/// Straight up and down the yaw is that of the side, if the lamp has one.
void set_direction(Lamp& lamp, const Vec3d& direction, const Vec3d* side = nullptr) {
  const double horizontal = std::hypot(direction.x, direction.z);
  lamp.elevation = rounded_degrees(std::atan2(direction.y, horizontal));
  if (std::abs(lamp.elevation) < 90) {
    lamp.yaw = rounded_degrees(std::atan2(-direction.x, -direction.z));
  } else if (side != nullptr) {
    lamp.yaw = rounded_degrees(std::atan2(-side->z, side->x));
  }
}

/// Whether an object's transform mirrors: its light then emits to the other side of edge 1 x edge 2.
double handedness(const grf::Matrix44d& to_world) { return to_world.determinant() < 0 ? -1 : 1; }

Vec3d transformed(const Vec3d& vector, const grf::Matrix44d& matrix) {
  Vec3d result;
  matrix.multDirMatrix(vector, result);
  return result;
}

// Rectangles

std::optional<Lamp> rectangle_of(const LightObject& light) {
  const Vec3d edge1 = transformed(Vec3d(light.light.edge1), light.to_world);
  const Vec3d edge2 = transformed(Vec3d(light.light.edge2), light.to_world);
  Lamp lamp;
  lamp.width = edge1.length();
  lamp.height = edge2.length();
  if (!(lamp.width > 0) || !(lamp.height > 0)) return std::nullopt;
  const Vec3d right = edge1 / lamp.width;
  const Vec3d down = edge2 / lamp.height * handedness(light.to_world);
  if (!(std::abs(right.dot(down)) < ShapeTolerance)) return std::nullopt;
  lamp.centre = Vec3d(light.light.corner) * light.to_world + (edge1 + edge2) / 2;
  set_direction(lamp, right.cross(down), &right);
  const Sides level = sides_without_roll(lamp.yaw, lamp.elevation);
  lamp.roll = rounded_degrees(std::atan2(right.dot(level.down), right.dot(level.right)));
  for (double* size : {&lamp.width, &lamp.height}) *size = shortest_near(*size, 2 * LampPrecision * *size);
  lamp.radiance = light.light.radiance.value_or(grf::Colour(1));
  return lamp;
}

/// A vector near this one with short decimals; components that hardly differ stay as they were.
Vec3f rounded(const Vec3d& vector, const Vec3f& before, double size) {
  Vec3f result = before;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(vector[axis] - static_cast<double>(before[axis])) <= 1e-9 * size) continue;
    result[axis] = static_cast<float>(shortest_near(vector[axis], LampPrecision * size));
  }
  return result;
}

grf::AreaLight with_rectangle(const LightObject& object, const Lamp& before, const Lamp& lamp) {
  grf::AreaLight light = object.light;
  if (lamp.radiance != before.radiance) light.radiance = lamp.radiance;
  const grf::Matrix44d to_local = object.to_world.inverse();
  Vec3d edge1(light.edge1), edge2(light.edge2);
  if (lamp.yaw != before.yaw || lamp.elevation != before.elevation || lamp.roll != before.roll) {
    const Sides sides = sides_of(lamp);
    edge1 = transformed(sides.right * lamp.width, to_local);
    edge2 = transformed(sides.down * (lamp.height * handedness(object.to_world)), to_local);
  } else {
    if (lamp.width != before.width) edge1 *= lamp.width / before.width;
    if (lamp.height != before.height) edge2 *= lamp.height / before.height;
  }
  light.edge1 = rounded(edge1, object.light.edge1, edge1.length());
  light.edge2 = rounded(edge2, object.light.edge2, edge2.length());
  const Vec3d middle_before = (Vec3d(object.light.edge1) + Vec3d(object.light.edge2)) / 2;
  const Vec3d middle = (Vec3d(light.edge1) + Vec3d(light.edge2)) / 2;
  const Vec3d corner = Vec3d(object.light.corner) + transformed(lamp.centre - before.centre, to_local) +
                       middle_before - middle;
  light.corner = rounded(corner, object.light.corner, std::max(corner.length(), middle.length()));
  return light;
}

// Discs and spheres

/// Sums of many vertices, and vertices on a circle, are not as authored by a few rounding errors.
Vec3d rounded_centre(const std::vector<Vec3f>& positions) {
  Vec3d centre(0);
  for (const Vec3f& position : positions) centre += Vec3d(position) / static_cast<double>(positions.size());
  const double size = std::max(centre.length(), (Vec3d(positions.front()) - centre).length());
  for (int axis = 0; axis < 3; ++axis) centre[axis] = shortest_near(centre[axis], LampPrecision * size);
  return centre;
}

std::optional<Lamp> round_lamp_of(const MeshObject& mesh, const grf::Matrix44d& to_world) {
  const grf::Geometry& geometry = *mesh.mesh->geometry;
  if (geometry.positions.size() < FewestCorners || mesh.mesh->face_count() == 0) return std::nullopt;
  const Vec3d centre = rounded_centre(geometry.positions);
  const double radius = (Vec3d(geometry.positions.front()) - centre).length();
  const double scale = transformed(Vec3d(1, 0, 0), to_world).length();
  Lamp lamp;
  lamp.centre = centre * to_world;
  lamp.radius = shortest_near(radius, 2 * LampPrecision * radius) * scale;
  if (!(lamp.radius > 0)) return std::nullopt;
  lamp.radius = shortest_near(lamp.radius, 2 * LampPrecision * lamp.radius);
  const Vec3d area = grf::doubled_area_vector(geometry, 0, to_world) * handedness(to_world);
  const Vec3d normal = area.normalized();
  bool is_flat = true;
  for (const Vec3f& position : geometry.positions) {
    const Vec3d arm = Vec3d(position) * to_world - lamp.centre;
    if (std::abs(arm.length() - lamp.radius) > ShapeTolerance * lamp.radius) return std::nullopt;
    is_flat = is_flat && std::abs(arm.dot(normal)) < ShapeTolerance * lamp.radius;
  }
  lamp.shape = is_flat ? LampShape::Disc : LampShape::Sphere;
  if (is_flat) set_direction(lamp, normal);
  lamp.radiance = mesh.flat_surfaces.empty() ? grf::Colour(1) : mesh.flat_surfaces.front().colour;
  return lamp;
}

Vec3f on_circle(int i, int count) {
  const double angle = 2 * std::numbers::pi * i / count;
  return {static_cast<float>(std::cos(angle)), 0, static_cast<float>(std::sin(angle))};
}

/// A regular polygon about the origin that faces down.
void add_disc(grf::MeshDraft& mesh) {
  constexpr int Corners = 48;
  std::vector<std::uint32_t> face;
  for (int i = 0; i < Corners; ++i) {
    face.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(on_circle(i, Corners));
  }
  mesh.add_face(face, 0);
}

void add_sphere(grf::MeshDraft& mesh) {
  constexpr std::uint32_t Rings = 11, Corners = 24;
  for (std::uint32_t ring = 1; ring <= Rings; ++ring) {
    const double polar = std::numbers::pi * ring / (Rings + 1);
    for (std::uint32_t i = 0; i < Corners; ++i) {
      const Vec3d level = Vec3d(on_circle(static_cast<int>(i), Corners)) * std::sin(polar);
      mesh.positions.emplace_back(Vec3d(level.x, std::cos(polar), level.z));
    }
  }
  const auto top = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.emplace_back(0.0F, 1.0F, 0.0F);
  mesh.positions.emplace_back(0.0F, -1.0F, 0.0F);
  for (std::uint32_t i = 0; i < Corners; ++i) {
    const std::uint32_t next = (i + 1) % Corners, last = (Rings - 1) * Corners;
    mesh.add_face(std::vector{top, next, i}, 0);
    for (std::uint32_t row = 0; row < last; row += Corners) {
      mesh.add_face(std::vector{row + i, row + next, row + Corners + next, row + Corners + i}, 0);
    }
    mesh.add_face(std::vector{top + 1, last + i, last + next}, 0);
  }
}

/// Applies an action to the object at a path, which may get another one.
bool act(TransformedObjects& edited, const TransformAction& action, grf::Diagnostics& diagnostics) {
  auto next = transform_objects(edited.scene, edited.paths, action, diagnostics);
  if (next) edited = std::move(*next);
  return next.has_value();
}

TransformAction turn_between(const Lamp& before, const Lamp& lamp) {
  const Vec3d from = direction_of(before), to = direction_of(lamp);
  Vec3d axis = from.cross(to);
  if (axis.length() < 1e-9) axis = std::abs(from.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 0, 1);
  TransformAction action;
  action.kind = Kind::Rotation;
  action.value = axis;
  action.degrees = std::atan2(from.cross(to).length(), from.dot(to)) / Degree;
  action.pivot = before.centre;
  return action;
}

bool move_lamp(TransformedObjects& edited, const Lamp& before, const Lamp& lamp,
               grf::Diagnostics& diagnostics) {
  if (lamp.radius != before.radius) {
    TransformAction action;
    action.kind = Kind::Scale;
    action.value = Vec3d(lamp.radius / before.radius);
    action.pivot = before.centre;
    if (!act(edited, action, diagnostics)) return false;
  }
  const bool is_turned = lamp.yaw != before.yaw || lamp.elevation != before.elevation;
  if (lamp.shape == LampShape::Disc && is_turned && !act(edited, turn_between(before, lamp), diagnostics))
    return false;
  if (lamp.centre == before.centre) return true;
  TransformAction action;
  action.value = lamp.centre - before.centre;
  return act(edited, action, diagnostics);
}

const LightObject* light_at(const SceneObjects& objects, grf::ScenePathView path) {
  const auto found = std::ranges::find_if(
      objects.lights, [&](const LightObject& light) { return std::ranges::equal(light.path, path); });
  return found == objects.lights.end() ? nullptr : &*found;
}

}  // namespace

Vec3d direction_of(const Lamp& lamp) {
  const Sides level = sides_without_roll(lamp.yaw, lamp.elevation);
  return level.right.cross(level.down);
}

void aim(Lamp& lamp, const Vec3d& point) {
  const Vec3d way = point - lamp.centre;
  if (!(way.length() > 0)) return;
  const double horizontal = std::hypot(way.x, way.z);
  lamp.elevation = std::atan2(way.y, horizontal) / Degree;
  // A centre is as precise as `float`: straight down it must not choose the yaw.
  if (horizontal > 1e-6 * way.length()) lamp.yaw = std::atan2(-way.x, -way.z) / Degree;
  lamp.roll = 90 * std::round(lamp.roll / 90);
}

void light_highlight(Lamp& lamp, const Vec3d& point, const Vec3d& normal, const Vec3d& view_direction,
                     double distance) {
  const Vec3d unit = normal.normalized(), view = view_direction.normalized();
  lamp.centre = point + (view - unit * (2 * view.dot(unit))) * distance;
  aim(lamp, point);
}

Lamp lamp_over(LampShape shape, const grf::Box3d& bounds) {
  constexpr double Part = 0.25;
  constexpr float Radiance = 10;
  const bool is_empty = bounds.isEmpty();
  const double exact_size = is_empty ? 1 : std::max(Part * bounds.size().length(), 1e-3);
  const double size = shortest_near(exact_size, exact_size / 50);
  const Vec3d middle = is_empty ? Vec3d(0) : bounds.center();
  Lamp lamp;
  lamp.shape = shape;
  lamp.radius = size / 2;
  lamp.width = lamp.height = size;
  const double lowest = shape == LampShape::Sphere ? lamp.radius : 0;
  lamp.centre = Vec3d(middle.x, is_empty ? 1 : bounds.max.y + size / 4 + lowest, middle.z);
  for (int axis = 0; axis < 3; ++axis) lamp.centre[axis] = shortest_near(lamp.centre[axis], size / 50);
  lamp.radiance = grf::Colour(Radiance);
  return lamp;
}

std::optional<Lamp> lamp_at(const grf::Scene& scene, const SceneObjects& objects, grf::ScenePathView path) {
  if (const LightObject* light = light_at(objects, path)) return rectangle_of(*light);
  const auto mesh = objects.mesh_at(path);
  if (!mesh || !objects.meshes[*mesh].is_light || is_in_include(scene, path)) return std::nullopt;
  const auto instance = std::ranges::find(*objects.instances, *mesh, &MeshInstance::mesh);
  if (instance == objects.instances->end()) return std::nullopt;
  return round_lamp_of(objects.meshes[*mesh], instance->to_world);
}

grf::Scene add_lamp(const grf::Scene& scene, const Lamp& lamp) {
  if (lamp.shape == LampShape::Rectangle) {
    const Sides sides = sides_of(lamp);
    grf::AreaLight light;
    light.edge1 = rounded(sides.right * lamp.width, Vec3f(0), lamp.width);
    light.edge2 = rounded(sides.down * lamp.height, Vec3f(0), lamp.height);
    light.corner = Vec3f(lamp.centre - (Vec3d(light.edge1) + Vec3d(light.edge2)) / 2);
    light.radiance = lamp.radiance;
    return add_light(scene, light);
  }
  grf::MeshDraft draft;
  lamp.shape == LampShape::Disc ? add_disc(draft) : add_sphere(draft);
  draft.surfaces.front().colour = lamp.radiance;
  grf::Transform transform;
  ObjectTransform scaled;
  scaled.scale = Vec3d(lamp.radius);
  transform.steps = steps_of(scaled);
  const TransformAction turn = turn_between(Lamp(), lamp);
  if (lamp.shape == LampShape::Disc && turn.degrees > 0)
    rotate(transform.steps, turn.value, turn.degrees, turn.pivot);
  translate(transform.steps, lamp.centre);
  transform.body.blocks.emplace_back().content = grf::MeshLight{grf::Mesh(std::move(draft))};
  grf::Scene changed = scene;
  outermost_blocks(changed).blocks.emplace_back().content = std::move(transform);
  return changed;
}

std::optional<TransformedObjects> change_lamp(const grf::Scene& scene, const SceneObjects& objects,
                                              grf::ScenePathView path, const Lamp& lamp,
                                              grf::Diagnostics& diagnostics) {
  const std::optional<Lamp> before = lamp_at(scene, objects, path);
  if (!before || before->shape != lamp.shape) {
    diagnostics.error({}, "there is no such lamp at that place");
    return std::nullopt;
  }
  TransformedObjects edited{scene, {grf::ScenePath(path.begin(), path.end())}};
  if (lamp.shape == LampShape::Rectangle) {
    auto changed =
        change_light(scene, path, with_rectangle(*light_at(objects, path), *before, lamp), diagnostics);
    if (!changed) return std::nullopt;
    edited.scene = std::move(*changed);
    return edited;
  }
  if (lamp.radiance != before->radiance) {
    auto* light = content_at<grf::MeshLight>(edited.scene, path);
    if (light == nullptr) return std::nullopt;
    for (grf::Surface& surface : light->mesh.edit().surfaces) surface.colour = lamp.radiance;
  }
  if (!move_lamp(edited, *before, lamp, diagnostics)) return std::nullopt;
  return edited;
}

}  // namespace editor
