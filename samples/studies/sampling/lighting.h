// The light that the study's errors are of, in the local frame of a surface.
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
/// beyond), a patch as large as these that is anywhere over the hemisphere, and an environment map. Discs and
/// patch have radiance 1.
enum Light : std::size_t { Highlight, Beside, Anywhere, Environment };
constexpr std::size_t LightCount = 4;
constexpr std::array<std::string_view, LightCount> LightNames = {"highlight", "beside", "anywhere",
                                                                 "environment"};

/// Those that tell the most of a scheme first: a light in one place may be where a poor one happens to draw.
constexpr std::array<Light, LightCount> LightsByWeight = {Anywhere, Environment, Highlight, Beside};

/// The places of `Anywhere`: squares of the map of view_square.h, of equal solid angle.
constexpr std::size_t PlacesAlongEdge = 16;
constexpr std::size_t PlaceCount = PlacesAlongEdge * PlacesAlongEdge;

/// The views, as angles to the normal in degrees. Their azimuth matters to anisotropic BRDFs alone.
constexpr std::array<float, 3> ViewDegrees = {20, 45, 70};

/// A direction at an angle to the normal, in degrees, at the views' azimuth or (below 0) opposite it.
Vec3f in_plane_of_views(float degrees);

/// A sky that is brighter at the horizon, brown ground in squares, and a sun behind haze, 6 degrees in
/// radius, that gives about a third of the light. The surface leans 30 degrees from the horizontal, and the
/// sun stands 4 degrees from the mirror direction of the middle view.
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

/// The lights for a BRDF that is seen from one direction, with what it reflects of them.
class Setting {
 public:
  Setting(const reflectance::Brdf& brdf, const Vec3f& u, double degrees, const Surroundings& surroundings);

  const Vec3f& view() const { return view_; }

  /// Estimates of what is reflected, as means over RGB; of `Anywhere`, in all of its places.
  class Estimate {
   public:
    explicit Estimate(const Setting& setting) : setting_(&setting) {}
    void add(const reflectance::DirectionSample& sample, double share);

    /// The squares of the relative errors. They are relative to what is reflected, but no less than a
    /// thousandth of what a white matte surface reflects; of `Anywhere`, the square is summed over the places
    /// and relative to the like sum of what is reflected, as of a picture in which the light is seen in all
    /// of them.
    std::array<double, LightCount> squared_errors() const;

   private:
    const Setting* setting_;
    std::array<double, LightCount> sums_ = {};
    std::array<double, PlaceCount> places_ = {};
  };

  /// The relative error of one independent sample with density f cos / albedo.
  double perfect_error(Light light) const { return perfect_[light]; }

 private:
  /// Of f cos: without light, with it, and with its square; and of the cosine with it.
  struct Sums {
    double albedo = 0, once = 0, squared = 0, matte = 0;
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
  std::array<double, PlaceCount> places_ = {};  ///< what is reflected of `Anywhere`
};

}  // namespace study
