#include "editor/document/object_placement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <variant>

#include "editor/document/scene_places.h"
#include "grf/vertex_tree.h"

namespace editor {
namespace {

using grf::Matrix44d;
using grf::Vec3d;
using Kind = grf::TransformStep::Kind;

const TransformSteps& steps_at(const grf::Scene& scene, grf::ScenePathView transform) {
  return std::get<grf::Transform>(block_at(scene, transform)->content).steps;
}

/// The row of a matrix for a vector.
Vec3d axis_of(const Matrix44d& matrix, int row) { return {matrix[row][0], matrix[row][1], matrix[row][2]}; }

/// The uniform scale of a matrix whose axes are orthogonal and equally long; 0 for another matrix.
double uniform_scale_of(const Matrix44d& matrix) {
  const double length = axis_of(matrix, 0).length();
  for (int row = 0; row < 3; ++row) {
    const Vec3d axis = axis_of(matrix, row);
    if (std::abs(axis.length() - length) > 1e-9 * length) return 0;
    if (std::abs(axis.dot(axis_of(matrix, (row + 1) % 3))) > 1e-9 * length * length) return 0;
  }
  return length;
}

/// Appends an action in world space to the steps of a transform in a parent.
void append(TransformSteps& steps, const TransformAction& action, const Matrix44d& to_world) {
  const Matrix44d to_parent = to_world.inverse();
  const auto direction = [&to_parent](const Vec3d& vector) {
    Vec3d result;
    to_parent.multDirMatrix(vector, result);
    return result;
  };
  if (action.kind == Kind::Translation) return translate(steps, direction(action.value));
  const double size = uniform_scale_of(to_world);
  if (size == 0) return transform(steps, to_world * action.matrix() * to_parent);
  const Vec3d pivot = action.pivot * to_parent;
  if (action.kind == Kind::Rotation) {
    const double sense = to_world.determinant() < 0 ? -1 : 1;
    return rotate(steps, direction(action.value), sense * action.degrees, pivot);
  }
  Matrix44d axes;
  for (int row = 0; row < 3; ++row) {
    const Vec3d axis = direction(axis_of(action.axes, row)) * size;
    for (int column = 0; column < 3; ++column) axes[row][column] = axis[column];
  }
  scale(steps, action.value, axes, pivot);
}

/// Replaces the steps of the object at one of the paths, which are updated for blocks that come or go.
class StepsEdit {
 public:
  StepsEdit(grf::Scene& scene, std::vector<grf::ScenePath>& paths) : scene_(scene), paths_(paths) {}

  template <class Change>
  void apply(const grf::ScenePath& path, const Change& change) {
    const grf::ScenePath transform = own_transform(scene_, path);
    const grf::ScenePath& place = transform.empty() ? path : transform;
    grf::Block& block = *grf::find(scene_, place).block;
    TransformSteps steps = block_steps(block);
    change(steps, to_world_at(scene_, place));
    const int levels = set_block_steps(block, std::move(steps));
    for (grf::ScenePath& each : paths_) follow_levels(each, place, levels);
  }

 private:
  grf::Scene& scene_;
  std::vector<grf::ScenePath>& paths_;
};

/// Changes the steps of each block, and returns the scene with the paths of the objects in it.
template <class Change>
TransformedObjects with_steps(const grf::Scene& scene, const std::vector<grf::ScenePath>& paths,
                              const std::vector<grf::ScenePath>& blocks, const Change& change) {
  TransformedObjects result{scene, paths};
  // The blocks' own paths change as those of the objects do.
  std::vector<grf::ScenePath> all = paths;
  all.insert(all.end(), blocks.begin(), blocks.end());
  StepsEdit edit(result.scene, all);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    edit.apply(grf::ScenePath(all[paths.size() + i]),
               [&](TransformSteps& steps, const Matrix44d& to_world) { change(i, steps, to_world); });
  }
  std::copy_n(all.begin(), paths.size(), result.paths.begin());
  return result;
}

bool report_invalid(const grf::Scene& scene, const std::vector<grf::ScenePath>& paths,
                    grf::Diagnostics& diagnostics) {
  const bool is_missing = std::ranges::any_of(
      paths, [&](const grf::ScenePath& path) { return block_at(scene, path) == nullptr; });
  if (is_missing) diagnostics.error({}, "only objects of the scene can be transformed, not definitions");
  return is_missing;
}

bool has_zero(const Vec3d& factors) { return factors.x * factors.y * factors.z == 0; }

bool report_zero(grf::Diagnostics& diagnostics) {
  diagnostics.error({}, "a scale factor must not be 0");
  return true;
}

Vec3d rounded(const Vec3d& point, double size) {
  return {shortest_near(point.x, 5e-6 * size), shortest_near(point.y, 5e-6 * size),
          shortest_near(point.z, 5e-6 * size)};
}

/// The bounds of what is inside an object, in coordinates of which `to_world` is the matrix.
grf::Box3d bounds_in(const SceneObjects& objects, grf::ScenePathView path, const Matrix44d& to_world) {
  const Matrix44d to_local = to_world.inverse();
  grf::Box3d box;
  for (const MeshInstance& instance : *objects.instances) {
    if (!is_inside(instance.path, path)) continue;
    const grf::Mesh& mesh = *objects.meshes[instance.mesh].mesh;
    box.extendBy(mesh.geometry.vertices().bounds_under(instance.to_world * to_local));
  }
  for (const LightObject& light : objects.lights) {
    if (!is_inside(light.path, path)) continue;
    for (const Vec3d& corner : corners_of(light)) box.extendBy(corner * to_local);
  }
  for (const ObserverObject& observer : objects.observers) {
    if (is_inside(observer.path, path)) box.extendBy(observer.position * to_local);
  }
  return box;
}

/// Translates each object along an axis by a distance of its own.
std::optional<TransformedObjects> translate_each(const grf::Scene& scene,
                                                 const std::vector<grf::ScenePath>& paths, int axis,
                                                 const std::map<grf::ScenePath, double>& distances,
                                                 grf::Diagnostics& diagnostics) {
  if (report_invalid(scene, paths, diagnostics)) return std::nullopt;
  std::vector<grf::ScenePath> blocks;
  std::vector<double> of_blocks;
  for (const auto& [block, distance] : distances) {
    blocks.push_back(block);
    of_blocks.push_back(distance);
  }
  return with_steps(scene, paths, blocks,
                    [&](std::size_t i, TransformSteps& steps, const Matrix44d& to_world) {
                      TransformAction action;
                      action.value[axis] = of_blocks[i];
                      append(steps, action, to_world);
                    });
}

double aligned_place(const grf::Box3d& box, int axis, Alignment alignment) {
  if (alignment == Alignment::Minimum) return box.min[axis];
  if (alignment == Alignment::Maximum) return box.max[axis];
  return box.center()[axis];
}

/// The centre of an object: that of its bounds in its own coordinates, so that turning it keeps the centre.
Vec3d centre_of(const grf::Scene& scene, const SceneObjects& objects, const grf::ScenePath& path) {
  const Matrix44d to_world = object_to_world(scene, path);
  const grf::Box3d box = bounds_in(objects, path, to_world);
  if (box.isEmpty()) return to_world.translation();
  return rounded(box.center(), box.size().length()) * to_world;
}

}  // namespace

TransformSteps block_steps(const grf::Block& block) {
  const auto* transform = std::get_if<grf::Transform>(&block.content);
  return transform == nullptr ? TransformSteps() : transform->steps;
}

int set_block_steps(grf::Block& block, TransformSteps steps) {
  auto* transform = std::get_if<grf::Transform>(&block.content);
  if (transform == nullptr && steps.empty()) return 0;
  if (transform == nullptr) {
    grf::Transform around;
    around.steps = std::move(steps);
    grf::Block wrapping;
    wrapping.location = block.location;
    around.body.blocks.push_back(std::move(block));
    wrapping.content = std::move(around);
    block = std::move(wrapping);
    return 1;
  }
  const bool is_needed = !steps.empty() || transform->body.blocks.size() != 1 || !block.comments.empty() ||
                         !transform->body.end_comments.empty();
  // GRF has no transform without a step.
  if (steps.empty()) steps.push_back({Kind::Translation, grf::Vec3f(0)});
  transform->steps = std::move(steps);
  if (is_needed) return 0;
  grf::Block child = std::move(transform->body.blocks.front());
  block = std::move(child);
  return -1;
}

void follow_levels(grf::ScenePath& path, grf::ScenePathView block, int levels) {
  const auto below = path.begin() + static_cast<std::ptrdiff_t>(std::min(block.size(), path.size()));
  if (!is_inside(path, block)) return;
  if (levels > 0) path.insert(below, 0);
  if (levels < 0 && below != path.end()) path.erase(below);
}

Matrix44d TransformAction::matrix() const {
  Matrix44d back;
  Matrix44d forth;
  Matrix44d action;
  if (kind == Kind::Translation) return action.setTranslation(value);
  back.setTranslation(-pivot);
  forth.setTranslation(pivot);
  if (kind == Kind::Rotation) {
    action.setAxisAngle(value.normalized(), degrees * std::numbers::pi / 180);
  } else {
    action.setScale(value);
    action = axes.transposed() * action * axes;
  }
  return back * action * forth;
}

std::optional<TransformedObjects> transform_objects(const grf::Scene& scene,
                                                    const std::vector<grf::ScenePath>& paths,
                                                    const TransformAction& action,
                                                    grf::Diagnostics& diagnostics) {
  if (report_invalid(scene, paths, diagnostics)) return std::nullopt;
  if (action.kind == Kind::Scale && has_zero(action.value) && report_zero(diagnostics)) return std::nullopt;
  return with_steps(scene, paths, moved_blocks(scene, paths),
                    [&](std::size_t, TransformSteps& steps, const Matrix44d& to_world) {
                      append(steps, action, to_world);
                    });
}

grf::ScenePath own_transform(const grf::Scene& scene, grf::ScenePathView path) {
  const auto* block = block_at(scene, path);
  if (block != nullptr && std::holds_alternative<grf::Transform>(block->content))
    return {path.begin(), path.end()};
  if (path.size() < 2) return {};
  const grf::ScenePathView around = path.first(path.size() - 1);
  const auto* parent = block_at(scene, around);
  const auto* outer = parent != nullptr ? std::get_if<grf::Transform>(&parent->content) : nullptr;
  if (outer == nullptr || outer->body.blocks.size() != 1) return {};
  return {around.begin(), around.end()};
}

std::vector<grf::ScenePath> moved_blocks(const grf::Scene& scene, const std::vector<grf::ScenePath>& paths) {
  std::vector<grf::ScenePath> moved;
  for (const grf::ScenePath& path : paths) {
    const grf::ScenePath block = moved_block(scene, path);
    const grf::ScenePath transform = own_transform(scene, block);
    moved.push_back(transform.empty() ? block : transform);
  }
  std::ranges::sort(moved);
  std::vector<grf::ScenePath> outermost;
  for (grf::ScenePath& path : moved) {
    if (outermost.empty() || !is_inside(path, outermost.back())) outermost.push_back(std::move(path));
  }
  return outermost;
}

std::optional<TransformedObjects> align_objects(const grf::Scene& scene, const SceneObjects& objects,
                                                const std::vector<grf::ScenePath>& paths, int axis,
                                                Alignment alignment, grf::Diagnostics& diagnostics) {
  if (paths.empty()) return std::nullopt;
  const grf::ScenePath active = moved_blocks(scene, {paths.back()}).front();
  const grf::Box3d target = object_bounds(objects, active);
  std::map<grf::ScenePath, double> distances;
  for (const grf::ScenePath& block : moved_blocks(scene, paths)) {
    const grf::Box3d box = object_bounds(objects, block);
    if (box.isEmpty() || target.isEmpty()) continue;
    const double way = aligned_place(target, axis, alignment) - aligned_place(box, axis, alignment);
    distances[block] = shortest_near(way, 1e-6 * target.size().length());
  }
  return translate_each(scene, paths, axis, distances, diagnostics);
}

std::optional<TransformedObjects> distribute_objects(const grf::Scene& scene, const SceneObjects& objects,
                                                     const std::vector<grf::ScenePath>& paths, int axis,
                                                     grf::Diagnostics& diagnostics) {
  std::vector<std::pair<double, grf::ScenePath>> centres;
  for (const grf::ScenePath& block : moved_blocks(scene, paths)) {
    const grf::Box3d box = object_bounds(objects, block);
    if (!box.isEmpty()) centres.emplace_back(box.center()[axis], block);
  }
  std::ranges::sort(centres);
  std::map<grf::ScenePath, double> distances;
  for (std::size_t i = 1; i + 1 < centres.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(centres.size() - 1);
    const double length = centres.back().first - centres.front().first;
    const double way = centres.front().first + part * length - centres[i].first;
    distances[centres[i].second] = shortest_near(way, 1e-6 * length);
  }
  return translate_each(scene, paths, axis, distances, diagnostics);
}

std::optional<TransformedObjects> drop_to_floor(const grf::Scene& scene, const SceneObjects& objects,
                                                const std::vector<grf::ScenePath>& paths,
                                                grf::Diagnostics& diagnostics) {
  std::map<grf::ScenePath, double> distances;
  for (const grf::ScenePath& block : moved_blocks(scene, paths)) {
    const grf::Box3d box = object_bounds(objects, block);
    if (!box.isEmpty()) distances[block] = -box.min.y;
  }
  return translate_each(scene, paths, 1, distances, diagnostics);
}

std::optional<TransformedObjects> place_on_surface(const grf::Scene& scene, const SceneObjects& objects,
                                                   const std::vector<grf::ScenePath>& paths,
                                                   const Vec3d& point, const std::optional<Vec3d>& normal,
                                                   grf::Diagnostics& diagnostics) {
  grf::Box3d box;
  for (const grf::ScenePath& block : moved_blocks(scene, paths)) box.extendBy(object_bounds(objects, block));
  if (box.isEmpty()) {
    diagnostics.error({}, "the selected objects have no size, so that they cannot stand on a surface");
    return std::nullopt;
  }
  const double size = box.size().length();
  const Vec3d base = rounded({box.center().x, box.min.y, box.center().z}, size);
  TransformedObjects placed{scene, paths};
  const Vec3d axis = normal ? Vec3d(0, 1, 0).cross(*normal) : Vec3d(0);
  const double degrees = normal ? std::atan2(axis.length(), normal->y) * 180 / std::numbers::pi : 0;
  if (degrees > 1e-4) {
    TransformAction turn;
    turn.kind = Kind::Rotation;
    // Upside down, any horizontal axis will do.
    turn.value = axis.length() > 1e-6 ? axis.normalized() : Vec3d(0, 0, 1);
    turn.degrees = degrees;
    turn.pivot = base;
    auto turned = transform_objects(placed.scene, placed.paths, turn, diagnostics);
    if (!turned) return std::nullopt;
    placed = std::move(*turned);
  }
  TransformAction move;
  move.value = rounded(point, size) - base;
  return transform_objects(placed.scene, placed.paths, move, diagnostics);
}

std::optional<TransformedObjects> reset_transforms(const grf::Scene& scene,
                                                   const std::vector<grf::ScenePath>& paths,
                                                   grf::Diagnostics& diagnostics) {
  if (report_invalid(scene, paths, diagnostics)) return std::nullopt;
  return with_steps(scene, paths, moved_blocks(scene, paths),
                    [](std::size_t, TransformSteps& steps, const Matrix44d&) { steps.clear(); });
}

void translate_block(grf::Scene& scene, const grf::ScenePath& path, const grf::Vec3d& offset) {
  TransformAction action;
  action.value = offset;
  std::vector<grf::ScenePath> none;
  StepsEdit(scene, none).apply(path, [&](TransformSteps& steps, const Matrix44d& to_world) {
    append(steps, action, to_world);
  });
}

ObjectTransform object_transform_at(const grf::Scene& scene, grf::ScenePathView path) {
  const grf::ScenePath transform = own_transform(scene, moved_block(scene, path));
  return transform.empty() ? ObjectTransform() : object_transform_of(steps_at(scene, transform));
}

std::optional<TransformedObjects> set_object_transform(const grf::Scene& scene,
                                                       const std::vector<grf::ScenePath>& paths,
                                                       const ObjectTransform& transform,
                                                       grf::Diagnostics& diagnostics) {
  if (report_invalid(scene, {paths.back()}, diagnostics)) return std::nullopt;
  if (has_zero(transform.scale) && report_zero(diagnostics)) return std::nullopt;
  const ObjectTransform now = object_transform_at(scene, paths.back());
  return with_steps(scene, paths, {moved_block(scene, paths.back())},
                    [&](std::size_t, TransformSteps& steps, const Matrix44d&) {
                      if (now.rotation == transform.rotation && now.scale == transform.scale) {
                        translate(steps, transform.position - now.position);
                      } else {
                        steps = steps_of(transform);
                      }
                    });
}

grf::ScenePath moved_block(const grf::Scene& scene, grf::ScenePathView path) {
  for (std::size_t depth = 1; depth < path.size(); ++depth) {
    const grf::Block* block = block_at(scene, path.first(depth));
    if (block != nullptr && std::holds_alternative<grf::Include>(block->content))
      return {path.begin(), path.begin() + static_cast<std::ptrdiff_t>(depth)};
  }
  return {path.begin(), path.end()};
}

Matrix44d object_to_world(const grf::Scene& scene, grf::ScenePathView path) {
  const grf::ScenePath block = moved_block(scene, path);
  const grf::ScenePath transform = own_transform(scene, block);
  if (transform.empty()) return to_world_at(scene, block);
  return grf::matrix_of(steps_at(scene, transform)) * to_world_at(scene, transform);
}

Matrix44d object_axes(const grf::Scene& scene, grf::ScenePathView path) {
  const Matrix44d to_world = object_to_world(scene, path);
  const Vec3d x = axis_of(to_world, 0).normalized();
  const Vec3d along_y = axis_of(to_world, 1);
  const Vec3d y = (along_y - x * x.dot(along_y)).normalized();
  const Vec3d z = x.cross(y);
  return {x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, 0, 0, 0, 1};
}

grf::Box3d object_bounds(const SceneObjects& objects, grf::ScenePathView path) {
  return bounds_in(objects, path, Matrix44d());
}

Vec3d pivot_of(const grf::Scene& scene, const SceneObjects& objects, const std::vector<grf::ScenePath>& paths,
               PivotPoint point) {
  if (point == PivotPoint::World || paths.empty()) return Vec3d(0);
  if (point == PivotPoint::Active) return object_to_world(scene, paths.back()).translation();
  Vec3d sum(0);
  grf::Box3d reach(Vec3d(0));
  for (const grf::ScenePath& path : paths) {
    const grf::ScenePath block = moved_block(scene, path);
    sum += point == PivotPoint::Centre ? centre_of(scene, objects, block)
                                       : object_to_world(scene, block).translation();
    reach.extendBy(object_bounds(objects, block));
  }
  return rounded(sum / static_cast<double>(paths.size()), 0.1 * reach.size().length());
}

}  // namespace editor
