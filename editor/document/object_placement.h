// Moves, rotates and scales objects of a scene in world space.
#pragma once

#include <optional>
#include <vector>

#include "editor/document/scene_objects.h"
#include "editor/document/transform_steps.h"
#include "grf/diagnostics.h"
#include "grf/math.h"
#include "grf/scene.h"
#include "grf/scene_path.h"

namespace editor {

/// A translation, rotation or scale in world space.
struct TransformAction {
  grf::TransformStep::Kind kind = grf::TransformStep::Kind::Translation;
  grf::Vec3d value = grf::Vec3d(0);  ///< offset, axis of rotation, or factor along each row of `axes`
  double degrees = 0;                ///< counter-clockwise about the axis
  grf::Vec3d pivot = grf::Vec3d(0);  ///< stays where it is; ignored by translations
  grf::Matrix44d axes;               ///< orthonormal axes of the factors

  grf::Matrix44d matrix() const;
};

/// A scene with transformed objects, and the paths of these objects in it.
struct TransformedObjects {
  grf::Scene scene;
  std::vector<grf::ScenePath> paths;
};

/// Transforms blocks of a scene. Each gets one transform of its own, unless it is one, or is the only child
/// of one; a transform without effect is removed again. An object of an included file moves with its include,
/// an object that is inside another one of the list with that. Returns nothing, with the reason in the
/// diagnostics, for a path without a block and for a scale by 0.
std::optional<TransformedObjects> transform_objects(const grf::Scene& scene,
                                                    const std::vector<grf::ScenePath>& paths,
                                                    const TransformAction& action,
                                                    grf::Diagnostics& diagnostics);

/// The transform of an object relative to its parent; the identity if it has none.
ObjectTransform object_transform_at(const grf::Scene& scene, grf::ScenePathView path);
/// Sets the transform of the last of the objects relative to its parent.
std::optional<TransformedObjects> set_object_transform(const grf::Scene& scene,
                                                       const std::vector<grf::ScenePath>& paths,
                                                       const ObjectTransform& transform,
                                                       grf::Diagnostics& diagnostics);

/// The blocks that move with these objects, sorted: none is inside another one.
std::vector<grf::ScenePath> moved_blocks(const grf::Scene& scene, const std::vector<grf::ScenePath>& paths);

enum class Alignment { Minimum, Centre, Maximum };
/// Translates objects along an axis, 0 to 2, so that their bounds agree with those of the last one.
std::optional<TransformedObjects> align_objects(const grf::Scene& scene, const SceneObjects& objects,
                                                const std::vector<grf::ScenePath>& paths, int axis,
                                                Alignment alignment, grf::Diagnostics& diagnostics);
/// Translates objects along an axis so that the centres of their bounds are equally far apart, between the
/// first and the last one along it.
std::optional<TransformedObjects> distribute_objects(const grf::Scene& scene, const SceneObjects& objects,
                                                     const std::vector<grf::ScenePath>& paths, int axis,
                                                     grf::Diagnostics& diagnostics);
/// Translates each object vertically so that its lowest point is at y = 0.
std::optional<TransformedObjects> drop_to_floor(const grf::Scene& scene, const SceneObjects& objects,
                                                const std::vector<grf::ScenePath>& paths,
                                                grf::Diagnostics& diagnostics);
/// Translates objects together so that the middle of the lowest side of their bounds is at a point; with a
/// unit normal they are rotated first, so that what was upward (+y) is along it.
std::optional<TransformedObjects> place_on_surface(const grf::Scene& scene, const SceneObjects& objects,
                                                   const std::vector<grf::ScenePath>& paths,
                                                   const grf::Vec3d& point,
                                                   const std::optional<grf::Vec3d>& normal,
                                                   grf::Diagnostics& diagnostics);
/// Removes the transforms of objects.
std::optional<TransformedObjects> reset_transforms(const grf::Scene& scene,
                                                   const std::vector<grf::ScenePath>& paths,
                                                   grf::Diagnostics& diagnostics);

/// The steps of a block that is a transform; empty for another one.
TransformSteps block_steps(const grf::Block& block);
/// Gives a block other steps: a transform is added around it where it is none, or removed where it has no
/// effect. Returns by how many levels its contents are deeper.
int set_block_steps(grf::Block& block, TransformSteps steps);
/// Updates a path after the contents of a block became deeper by so many levels.
void follow_levels(grf::ScenePath& path, grf::ScenePathView block, int levels);

/// Translates a block in world space, also one of an included file.
void translate_block(grf::Scene& scene, const grf::ScenePath& path, const grf::Vec3d& offset);

/// The path of the block that moves when the object at a path is moved: its include, if it is in one.
grf::ScenePath moved_block(const grf::Scene& scene, grf::ScenePathView path);
/// The matrix from the coordinates inside an object's own transform to world space.
grf::Matrix44d object_to_world(const grf::Scene& scene, grf::ScenePathView path);
/// The orthonormal axes of an object in world space.
grf::Matrix44d object_axes(const grf::Scene& scene, grf::ScenePathView path);
/// The bounds of an object and its children in world space, lights included; empty if nothing is there.
grf::Box3d object_bounds(const SceneObjects& objects, grf::ScenePathView path);

/// The path of the transform that moves only the block at a path: that block, or its parent. Empty for none.
grf::ScenePath own_transform(const grf::Scene& scene, grf::ScenePathView path);

/// The point about which objects are rotated and scaled.
enum class PivotPoint {
  Centre,  ///< the mean of the centres of the objects' bounds, each in its own coordinates
  Origin,  ///< the mean of the objects' origins
  Active,  ///< the origin of the last object
  World    ///< the origin of world space
};
/// Returns the pivot in world space, rounded to five digits of the objects' size.
grf::Vec3d pivot_of(const grf::Scene& scene, const SceneObjects& objects,
                    const std::vector<grf::ScenePath>& paths, PivotPoint point);

}  // namespace editor
