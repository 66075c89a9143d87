#pragma once

#include <optional>

#include "editor/document/object_placement.h"

namespace editor {

/// Returns the scene with the object at a path translated in world space, if there is one.
inline std::optional<grf::Scene> moved_object(const grf::Scene& scene, const grf::ScenePath& path,
                                              const grf::Vec3d& offset, grf::Diagnostics& diagnostics) {
  TransformAction action;
  action.value = offset;
  auto moved = transform_objects(scene, {path}, action, diagnostics);
  if (!moved) return std::nullopt;
  return std::move(moved->scene);
}

}  // namespace editor
