// Which surfaces of a scene paths can meet.
#pragma once

#include <optional>
#include <vector>

#include "renderer/transport/camera.h"
#include "renderer/transport/plan/effect.h"
#include "renderer/transport/plan/outline.h"

namespace transport {

/// What bounds the paths of a render.
struct PathLimits {
  View view;  ///< in the world
  int width = 0;
  int height = 0;
  int depth = 0;
  EffectSet effects = EffectSet::all();  ///< those that are not switched off
};

/// What paths can meet. It may say more than is so, as nothing is taken to hide anything, but never less:
/// what it leaves out is outside the pyramid of view, and for paths that were scattered it is behind the
/// plane of all that they come from, or has its other side to them, or is the inside of a convex solid. Faces
/// of which one is in front of the other by no more than rounding, less than the distance from surfaces at
/// which rays start, do not see each other.
struct Reach {
  Reach(const Outline& outline, const PathLimits& limits);

  /// Of each surface of the outline.
  std::vector<bool> is_seen;      ///< by the eye
  std::vector<bool> is_met;       ///< by any ray
  std::vector<bool> is_lit_from;  ///< by any ray, some face of it on its front
  std::vector<bool> reflects;     ///< met, and a path is scattered there
  std::vector<bool> is_smooth;    ///< met, at a face with interpolated normals
  /// The most scattering events that a path has.
  int depth = 0;
  /// The surfaces that reflect were not told apart: the scene has too many parts.
  bool is_guessed = false;

 private:
  void assume_all(const Outline& outline, int most_events);
};

}  // namespace transport
