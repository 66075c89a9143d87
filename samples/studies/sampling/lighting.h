// Test lights of the study, in the local frame of a surface.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "renderer/reflectance/brdf.h"
#include "renderer/transport/lights/environment_map.h"

namespace study {

using reflectance::Rgb;
using reflectance::Vec3f;

/// A disc of 5 degrees in radius at the mirror direction, one 30 degrees from it towards the normal (and
/// beyond), a patch of the same size anywhere on the hemisphere, and an environment map. Discs and patch have
/// radiance 1.
enum Light : std::size_t { Highlight, Beside, Anywhere, Environment };
constexpr std::size_t LightCount = 4;
constexpr std::array<std::string_view, LightCount> LightNames = {"highlight", "beside", "anywhere",
                                                                 "environment"};

/// The lights, most informative first: a light at one position may favour a poor scheme by chance.
constexpr std::array<Light, LightCount> LightsByWeight = {Anywhere, Environment, Highlight, Beside};

/// The positions of `Anywhere` form a grid of squares of equal solid angle; see view_square.h.
constexpr std::size_t PlacesAlongEdge = 16;
constexpr std::size_t PlaceCount = PlacesAlongEdge * PlacesAlongEdge;

/// The views, as angles to the normal in degrees. Their azimuth matters only to anisotropic BRDFs.
constexpr std::array<float, 3> ViewDegrees = {20, 45, 70};

/// Returns the direction at an angle to the normal, in degrees, at the views' azimuth, or opposite below 0.
Vec3f in_plane_of_views(float degrees);

/// An environment: a sky brighter at the horizon, brown ground in squares, and a hazy sun, 6 degrees in
/// radius, with about a third of the light. The surface is tilted by 30 degrees, and the sun is 4 degrees
/// from the mirror direction of the middle view.
class Surroundings {
 public:
  Surroundings();

  const transport::EnvironmentMap& map() const { return map_; }
  const reflectance::Frame& frame() const { return frame_; }
  Rgb radiance(const Vec3f& local) const { return map_.radiance(frame_.to_world(local)); }

 private:
  reflectance::Frame frame_;
  transport::EnvironmentMap map_;
};

/// The lights for a BRDF and a view, with the reflected radiance.
class Setting {
 public:
  Setting(const reflectance::Brdf& brdf, const Vec3f& u, double degrees, const Surroundings& surroundings);

  const Vec3f& view() const { return view_; }

  /// An estimate of reflected radiance, as RGB means; for `Anywhere`, at all positions.
  class Estimate {
   public:
    explicit Estimate(const Setting& setting) : setting_(&setting) {}
    void add(const reflectance::DirectionSample& sample, double share);

    /// Returns the squared relative errors. They are relative to the reflected radiance, but at least to a
    /// thousandth of that of a white diffuse surface. For `Anywhere`, squares are summed over the positions
    /// and relative to the sum of squared radiances, as in a picture that shows the light at all of them.
    std::array<double, LightCount> squared_errors() const;

   private:
    const Setting* setting_;
    std::array<double, LightCount> sums_ = {};
    std::array<double, PlaceCount> places_ = {};
  };

  /// Returns the relative error of one independent sample with pdf f cos / albedo.
  double perfect_error(Light light) const { return perfect_[light]; }

 private:
  /// Sums of f cos: without light, with it, and with its square; and of the cosine with it.
  struct Sums {
    double albedo = 0, once = 0, squared = 0, diffuse = 0;
  };
  Sums over_disc(const reflectance::Brdf& brdf, const Vec3f& axis) const;
  Sums over_map(const reflectance::Brdf& brdf) const;
  void measure_places(const reflectance::Brdf& brdf, double albedo);
  void keep(Light light, const Sums& sums, double albedo);

  Vec3f view_;
  std::array<Vec3f, 2> axes_;
  const Surroundings* surroundings_;
  std::array<double, LightCount> reflected_ = {};  ///< integrals of f cos L by quadrature
  std::array<double, LightCount> scale_ = {}, perfect_ = {};
  std::array<double, PlaceCount> places_ = {};  ///< reflected radiance per position of `Anywhere`
};

}  // namespace study
