// The tool `emviewer` shows this figure.
#pragma once

#include "renderer/studies/environment/sampling.h"
#include "renderer/studies/environment/settings.h"
#include "renderer/studies/environment/view.h"
#include "renderer/studies/study.h"

namespace studies {

/// What the tool has found out.
struct EnvironmentResult {
  EnvironmentSettings settings;
  grf::BrdfModel model;
  LitSurface surface;
  SurfaceQuadrature quadrature;
  ResampledLight light;
  reflectance::Rgb albedo;     ///< by quadrature, with the delta part
  reflectance::Rgb reflected;  ///< the same of the reflected radiance
  std::vector<Deviation> deviations;

  EnvironmentResult(const EnvironmentSettings& asked_for, const grf::BrdfModel& brdf, LitSurface lit,
                    const std::function<bool()>& is_stopped);
  EnvironmentResult(const EnvironmentResult&) = delete;
  EnvironmentResult& operator=(const EnvironmentResult&) = delete;

  reflectance::Vec3f to_map(const reflectance::Vec3f& local) const { return surface.frame.to_world(local); }
  /// Returns (estimate - quadrature) / quadrature, of the means over RGB; 0 without light.
  double relative_error() const;
};

plot::Svg environment_figure(const EnvironmentResult& result, plot::Paper paper);

/// Returns the direction in the map's frame at a point of the figure, or nothing.
std::optional<reflectance::Vec3f> direction_in_figure(const EnvironmentSettings& settings,
                                                      const plot::Point& point);

}  // namespace studies
