#include "renderer/plan/reachability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace plan {
namespace {

using grf::Vec3d;
using grf::Vec3f;
using transport::Camera;
using transport::Effect;
using transport::InvalidIndex;

/// The sides of the parts: the front, then the back of each.
using States = std::vector<bool>;

class VisibilityBounds {
 public:
  VisibilityBounds(const CoarseScene& coarse_scene, const PathLimits& limits)
      : coarse_scene_(coarse_scene), limits_(limits) {}

  States seen_by_eye() const;
  /// Returns the sides that rays from these sides can hit.
  States met_from(const States& sources) const;
  /// Returns those of the sides at which a path is scattered, at the first bounce or later.
  States scattering(const States& states, bool is_first) const;

 private:
  std::span<const Vec3d> points_of(const CoarsePart& part) const {
    return std::span(coarse_scene_.points).subspan(part.first_point, part.points);
  }
  bool rises_over(const CoarsePart& part, const CoarsePart& plane, bool front) const;
  bool is_met(const CoarsePart& part, bool front, const CoarsePart& from, bool from_front) const;
  bool is_outside(std::span<const Vec3d> points, double least, const CoarseSolid& solid) const;
  bool leaves_anywhere(const CoarsePart& part) const;
  bool reflects_later(const CoarseSurface& surface) const;

  const CoarseScene& coarse_scene_;
  const PathLimits& limits_;
};

/// Returns the planes through the eye and the image's sides, and the plane across the view, with normals that
/// point inside.
std::array<Vec3d, 5> sides_of_view(const Camera& camera, int width, int height) {
  const auto right = static_cast<float>(width);
  const auto bottom = static_cast<float>(height);
  const std::array corners = {Vec3d(camera.ray(0, 0).direction), Vec3d(camera.ray(right, 0).direction),
                              Vec3d(camera.ray(right, bottom).direction),
                              Vec3d(camera.ray(0, bottom).direction)};
  const Vec3d middle = corners[0] + corners[1] + corners[2] + corners[3];
  std::array<Vec3d, 5> sides;
  sides[4] = middle.normalized();
  for (std::size_t i = 0; i < 4; ++i) {
    sides[i] = corners[i].cross(corners[(i + 1) % 4]).normalized();
    if (sides[i].dot(middle) < 0) sides[i] = -sides[i];
  }
  return sides;
}

States VisibilityBounds::seen_by_eye() const {
  const transport::View view = relative_to(coarse_scene_.origin, limits_.view);
  const Vec3d eye = Vec3d(Vec3f(view.eye));
  // The directions of the image's corners have float precision.
  constexpr double Margin = 1e-5;
  const auto sides =
      sides_of_view(Camera(view, limits_.width, limits_.height), limits_.width, limits_.height);
  const Vec3d& forward = sides.back();
  const double focus_distance = focus_distance_of(view);
  States seen(2 * coarse_scene_.parts.size());
  for (std::size_t i = 0; i < coarse_scene_.parts.size(); ++i) {
    const CoarsePart& part = coarse_scene_.parts[i];
    const auto points = points_of(part);
    const bool is_out_of_view = std::any_of(sides.begin(), sides.end(), [&](const Vec3d& side) {
      return std::all_of(points.begin(), points.end(), [&](const Vec3d& point) {
        const Vec3d way = point - eye;
        // Rays from the lens' rim are off the ray from its centre by its radius, less towards the plane of
        // focus.
        const double blur = view.lens_radius * std::abs(1 - forward.dot(way) / focus_distance);
        return side.dot(way) < -Margin * (way.length() + part.extent) - blur;
      });
    });
    if (is_out_of_view) continue;
    const double height = part.is_plane() ? part.normal.dot(eye) - part.height : 0;
    const double margin = Margin * (part.extent + eye.length()) + view.lens_radius;
    seen[2 * i] = height >= -margin;
    // Rays from outside a solid end on its faces' fronts.
    const bool is_hidden = part.solid != InvalidIndex &&
                           is_outside(std::span(&eye, 1), margin, coarse_scene_.solids[part.solid]);
    seen[2 * i + 1] = height <= margin && !is_hidden;
  }
  return seen;
}

/// Whether part of a part is on this side of another one's plane.
bool VisibilityBounds::rises_over(const CoarsePart& part, const CoarsePart& plane, bool front) const {
  if (!plane.is_plane()) return true;
  const double least = CoarseRounding * std::max(part.extent, plane.extent);
  const auto points = points_of(part);
  return std::any_of(points.begin(), points.end(), [&](const Vec3d& point) {
    const double height = plane.normal.dot(point) - plane.height;
    return (front ? height : -height) > least;
  });
}

/// Whether all points are in front of some face of the solid by more than `least`.
bool VisibilityBounds::is_outside(std::span<const Vec3d> points, double least,
                                  const CoarseSolid& solid) const {
  const std::span faces = std::span(coarse_scene_.parts).subspan(solid.first_part, solid.parts);
  return std::any_of(faces.begin(), faces.end(), [&](const CoarsePart& face) {
    return std::all_of(points.begin(), points.end(),
                       [&](const Vec3d& point) { return face.normal.dot(point) - face.height > least; });
  });
}

/// Where the terminator is offset, rays start above the triangle and may leave below its plane.
bool VisibilityBounds::leaves_anywhere(const CoarsePart& part) const {
  return part.is_smooth && limits_.effects.has(Effect::InterpolatedNormals);
}

bool VisibilityBounds::is_met(const CoarsePart& part, bool front, const CoarsePart& from,
                              bool from_front) const {
  if (leaves_anywhere(from)) return true;
  if (!rises_over(part, from, from_front) || !rises_over(from, part, front)) return false;
  if (front || part.solid == InvalidIndex || (from.solid == part.solid && !from_front)) return true;
  // Its back can only be hit from inside.
  const double least = -CoarseRounding * std::max(part.extent, from.extent);
  return !is_outside(points_of(from), least, coarse_scene_.solids[part.solid]);
}

States VisibilityBounds::met_from(const States& sources) const {
  States met(sources.size());
  for (std::size_t to = 0; to < met.size(); ++to) {
    const CoarsePart& part = coarse_scene_.parts[to / 2];
    for (std::size_t from = 0; from < sources.size() && !met[to]; ++from) {
      met[to] = sources[from] && is_met(part, to % 2 == 0, coarse_scene_.parts[from / 2], from % 2 == 0);
    }
  }
  return met;
}

/// Seen by specular reflection, all that reflects counts as seen by the eye.
bool VisibilityBounds::reflects_later(const CoarseSurface& surface) const {
  const transport::EffectSet& effects = limits_.effects;
  if (surface.is_specular && effects.has(Effect::MirrorReflection)) return true;
  const bool has_mirrors = effects.has(Effect::MirrorReflection) &&
                           std::any_of(coarse_scene_.surfaces.begin(), coarse_scene_.surfaces.end(),
                                       [](const CoarseSurface& other) { return other.is_specular; });
  return has_mirrors || effects.has(surface.is_only_diffuse() ? Effect::DiffuseInterreflection
                                                              : Effect::GlossyInterreflection);
}

States VisibilityBounds::scattering(const States& states, bool is_first) const {
  States result(states.size());
  std::vector<bool> of_surface;
  for (const CoarseSurface& surface : coarse_scene_.surfaces) {
    const bool is_left = surface.is_diffuse || surface.is_glossy ||
                         (surface.is_specular && limits_.effects.has(Effect::MirrorReflection));
    of_surface.push_back(is_left && (is_first || reflects_later(surface)));
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    result[i] = states[i] && of_surface[coarse_scene_.parts[i / 2].surface];
  }
  return result;
}

bool any(const States& states) { return std::find(states.begin(), states.end(), true) != states.end(); }

}  // namespace

void Reachability::assume_all(const CoarseScene& coarse_scene, int most_bounces) {
  is_guessed = true;
  depth = most_bounces;
  const std::size_t count = coarse_scene.surfaces.size();
  for (std::vector<bool>* list : {&is_seen, &is_met, &is_front_met, &is_smooth}) list->assign(count, true);
  for (std::size_t i = 0; i < count; ++i)
    reflects[i] = most_bounces > 0 && coarse_scene.surfaces[i].reflects();
}

Reachability::Reachability(const CoarseScene& coarse_scene, const PathLimits& limits) {
  for (std::vector<bool>* list : {&is_seen, &is_met, &is_front_met, &reflects, &is_smooth}) {
    list->resize(coarse_scene.surfaces.size());
  }
  if (coarse_scene.parts.empty()) {
    assume_all(coarse_scene, limits.depth);
    return;
  }
  const auto mark = [&](const States& states, std::vector<bool>& list) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (states[i]) list[coarse_scene.parts[i / 2].surface] = true;
    }
  };
  const auto mark_met = [&](const States& states) {
    mark(states, is_met);
    for (std::size_t i = 0; i < states.size(); ++i) {
      const CoarsePart& part = coarse_scene.parts[i / 2];
      if (states[i] && i % 2 == 0) is_front_met[part.surface] = true;
      if (states[i] && part.is_smooth) is_smooth[part.surface] = true;
    }
  };
  const VisibilityBounds visibility(coarse_scene, limits);
  States met = visibility.seen_by_eye();
  mark(met, is_seen);
  mark_met(met);
  // Surfaces that face each other alternate, so the last but one counts too. If paths keep finding new
  // surfaces for long, all are assumed to be hit.
  constexpr int MostLooks = 32;
  States sources, before;
  while (depth < limits.depth) {
    States next = visibility.scattering(met, depth == 0);
    if (!any(next)) return;
    mark(next, reflects);
    if (next == sources || next == before) {
      depth = limits.depth;
      return;
    }
    if (++depth > MostLooks) {
      assume_all(coarse_scene, limits.depth);
      return;
    }
    before = std::exchange(sources, std::move(next));
    met = visibility.met_from(sources);
    mark_met(met);
  }
}

}  // namespace plan
