// Reachability analysis finds the surfaces of a scene that paths can hit.
#pragma once

#include <optional>
#include <vector>

#include "renderer/plan/coarse_scene.h"
#include "renderer/transport/camera.h"
#include "renderer/transport/effect.h"

namespace plan {

/// The limits of a render's paths.
struct PathLimits {
  transport::View view;  ///< in world space
  int width = 0;
  int height = 0;
  int depth = 0;
  transport::EffectSet effects = transport::EffectSet::all();  ///< those that are not switched off
};

/// The surfaces that paths can hit, a conservative estimate: occlusion is ignored, and a surface is excluded
/// only if it is outside the view pyramid, widened by the blur of a lens; for scattered paths, if it is
/// behind the planes of all surfaces that they leave, faces away from them, or is inside a convex solid.
/// Faces do not see each other if one is in front of the other by no more than rounding, less than the
/// distance from surfaces at which rays start.
struct Reachability {
  Reachability(const CoarseScene& coarse_scene, const PathLimits& limits);

  /// One element per surface of the coarse scene.
  std::vector<bool> is_seen;       ///< by the eye
  std::vector<bool> is_met;        ///< by any ray
  std::vector<bool> is_front_met;  ///< by any ray, on the front of some of its faces
  std::vector<bool> reflects;      ///< met, and paths are scattered there
  std::vector<bool> is_smooth;     ///< met, at a face with interpolated normals
  /// The maximum number of bounces of a path.
  int depth = 0;
  /// Whether reflecting surfaces could not be distinguished, because the scene has too many parts.
  bool is_guessed = false;

 private:
  void assume_all(const CoarseScene& coarse_scene, int most_bounces);
};

}  // namespace plan
