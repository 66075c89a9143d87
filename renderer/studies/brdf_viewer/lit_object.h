// The BRDF viewer shows an object with a BRDF under lights and an environment; the CPU evaluates it here.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "renderer/reflectance/lit_surface.h"
#include "renderer/transport/camera.h"
#include "renderer/transport/lights/environment_map.h"
#include "renderer/transport/scene/compiled_scene.h"

namespace studies {

using reflectance::Rgb;
using reflectance::Vec3f;

/// The surroundings of an object, at infinity.
struct Environment {
  enum class Kind { None, Constant, Studio, Map };

  Kind kind = Kind::None;
  Rgb scale = Rgb(1);  ///< factor; of a constant environment the radiance
  float turned = 0;    ///< about the y axis, radians
  std::shared_ptr<const transport::EnvironmentMap> map = {};  ///< of the kind Map: see `set_map`
  /// Directions drawn from the map in proportion to its luminance, in its own frame; null: none are drawn.
  std::shared_ptr<const std::vector<Vec3f>> drawn = {};
  static constexpr int DrawnDirections = 4096;

  void set_map(std::shared_ptr<const transport::EnvironmentMap> of_map);

  /// Returns the radiance from a unit direction in world space.
  Rgb operator()(const Vec3f& direction) const;
  // The environment as a sampler of directions: see LitSurface.
  bool is_drawn() const { return kind == Kind::Map && drawn != nullptr; }
  float pdf(const Vec3f& direction) const;
  Vec3f direction(int index) const;
  /// Returns a direction of the map in world space.
  Vec3f in_world(const Vec3f& of_map) const;
};

/// A part of a BRDF, with the weight of its reflection of the environment.
struct EnvironmentPart {
  reflectance::Brdf brdf;
  reflectance::SpecularTable specular;
  float weight = 1;
  bool is_whole = true;  ///< whether it is all of the BRDF
};

/// A BRDF, and the parts of it that the environment is reflected by.
struct LitBrdf {
  reflectance::Brdf brdf;
  reflectance::SpecularTable specular;
  std::vector<EnvironmentPart> parts;
};

/// Returns the BRDF without its diffuse part, which is what its parameter `kd` adds; nothing if that is all
/// of it.
std::optional<reflectance::Brdf> without_diffuse(const reflectance::Brdf& brdf);

/// Scales the diffuse part of a BRDF's reflection of the environment by `diffuseness`, and the rest by
/// `specularity`. As the reflected light is linear in the BRDF f = d + s, it is the sum of f scaled by
/// `diffuseness` and of s scaled by their difference.
LitBrdf lit_brdf(const reflectance::Brdf& brdf, float diffuseness, float specularity);

struct Lighting {
  std::vector<reflectance::DistantLight> lights;
  Environment environment;
  int samples = 256;  ///< directions of the environment, a multiple of 4
};

/// The shifts of the sampled directions in a pixel, in [0,1), rows from the top. Those of an environment
/// without details are the same everywhere, so that there is no noise.
struct PixelShift {
  float first = 0.5F;
  float second = 0.5F;
  PixelShift() = default;
  PixelShift(int column, int row);
};

/// Returns the light that a surface reflects: that of the lights, and that of the environment, estimated by
/// `count` of its directions from `first` on.
Rgb reflected_radiance(const LitBrdf& brdf, const Lighting& lighting, const Vec3f& normal,
                       const Vec3f& to_eye, const PixelShift& pixel_shift, int first, int count);

/// What a pixel shows.
struct SurfacePixel {
  Vec3f normal = Vec3f(0);  ///< unit, on the eye's side; 0 for the background
  Vec3f to_eye = Vec3f(0);
};

/// Returns the view of an object from an azimuth and an elevation in degrees. At a distance of 1 the whole of
/// it is visible.
transport::View view_of_object(const grf::Box3d& bounds, double azimuth, double elevation, double distance,
                               double aspect);

/// Finds what the pixels of an image show, rows from the top, through points of them that are shifted from
/// their centres by these fractions of a pixel.
std::vector<SurfacePixel> surface_pixels(const transport::CompiledScene& scene, const transport::View& view,
                                         int width, int height, const grf::Vec2f& shift = grf::Vec2f(0));

/// Shades rows of an image, of which the pixels are those from the row `first_row` on, with `a` left of the
/// column `split` and with `b` from it on. Empty if it was stopped.
std::vector<Rgb> shade(const std::vector<SurfacePixel>& pixels, int width, int first_row, const LitBrdf& a,
                       const LitBrdf& b, int split, const Lighting& lighting, int first, int count,
                       const std::function<bool()>& is_stopped);

}  // namespace studies
