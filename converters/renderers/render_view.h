// The camera, film and surroundings of an exported scene, from the options of a render.
#pragma once

#include <optional>

#include "grf/diagnostics.h"
#include "grf/math.h"
#include "renderer/image/image.h"
#include "renderer/options/render_options.h"

namespace convert {

/// The light around a scene: an image in latitude-longitude format. Without rotation its centre is at -z, and
/// +x is right of that.
struct Surroundings {
  image::Image image;  ///< radiance, finite and 0 or more
  float rotation = 0;  ///< about the y axis, degrees, counter-clockwise seen from above
  float scale = 1;     ///< factor of the radiance
};

/// A view of a scene with all that a renderer needs besides surfaces. The axes are unit vectors in world
/// space, orthogonal to each other; right = forward x up.
struct RenderView {
  grf::Vec3d eye = grf::Vec3d(0);
  grf::Vec3d forward = grf::Vec3d(0, 0, -1);
  grf::Vec3d up = grf::Vec3d(0, 1, 0);
  double field_of_view = 45;  ///< vertical, degrees
  double lens_radius = 0;     ///< 0: a pinhole
  double focus_distance = 1;  ///< to the plane of focus, along `forward`
  int width = 0;
  int height = 0;
  int samples = 1;                           ///< per pixel
  int depth = 1;                             ///< the most bounces of a path
  grf::Colour background = grf::Colour(0);   ///< radiance where there are no surroundings
  std::optional<Surroundings> surroundings;  ///< take the place of the background
  bool has_backplate = false;                ///< an image behind the scene, which lights nothing
};

/// Returns the transform from a camera that looks along -z, with y up, to the world.
grf::Matrix44d camera_to_world(const RenderView& view);

/// Returns a distance beyond which nothing of the bounds is.
double reach_from(const grf::Vec3d& eye, const grf::Box3d& bounds);

/// Returns the view that the options ask for, or if there are none the default one that frames the bounds.
/// Nothing after an error.
std::optional<RenderView> render_view(const std::optional<options::RenderOptions>& render_options,
                                      const grf::Box3d& bounds, grf::Diagnostics& diagnostics);

}  // namespace convert
