// The product of a BRDF, the cosine and an environment map is sampled at one point of a surface.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "renderer/reflectance/reflector.h"
#include "renderer/reflectance/resampling.h"
#include "renderer/studies/environment/file.h"

namespace studies {

/// A surface under an environment map, seen from one direction.
struct LitSurface {
  std::shared_ptr<const FilteredMap> environment;
  std::shared_ptr<const reflectance::Reflector> reflector;
  reflectance::Frame frame;  ///< from the local frame of the BRDF to the map's
  reflectance::Vec3f u;      ///< towards the eye, local

  const transport::EnvironmentMap& map() const { return environment->map; }
};

/// The quantities of one direction. Densities are per solid angle.
struct DirectionValues {
  reflectance::Rgb radiance;
  reflectance::Rgb f_cos;  ///< 1/sr, without the delta part; 0 at or below the horizon
  double brdf = 0;         ///< density in proportion to f cos
  double map = 0;          ///< of the environment map's sampling
  double warps = 0;        ///< of the environment map's sampling for this normal
  double product = 0;      ///< in proportion to f cos L
  double scheme = 0;       ///< of the sampling scheme, and so of candidates
};

/// The reflected light of a surface by quadrature over the sphere, and densities in proportion to it. The
/// delta part of the BRDF is left out. f cos L is integrated by the midpoint rule on a latitude-longitude
/// grid with the map's means over its cells. Cells where f cos varies, and those around the mirror direction,
/// are subdivided. Densities are in proportion to the mean over RGB, as the resampling is.
class SurfaceQuadrature {
 public:
  static constexpr SphereGrid Grid = {512, 256};

  /// Stopped early, the results do not matter.
  explicit SurfaceQuadrature(const LitSurface& surface, const std::function<bool()>& is_stopped = {});

  const reflectance::Rgb& reflected() const { return reflected_; }  ///< integral of f cos L
  const reflectance::Rgb& albedo() const { return albedo_; }        ///< integral of f cos

  /// Returns the values of a direction in the map's frame.
  DirectionValues at(const reflectance::Vec3f& direction) const;

  /// Returns the values at the centres of the grid's cells, with the mean radiance over each, and densities
  /// of the map and the product accordingly.
  const std::vector<DirectionValues>& cells() const { return cells_; }

  /// Returns the fraction of the reflected light from directions where the candidates' density is less than
  /// that of the product over `factor`.
  double missed_light(double factor) const;

  /// Returns the expected fraction of effective candidates, 1 / integral of product^2 / scheme: 1 if they are
  /// in proportion to the product, 0 if the scheme misses some of it. Variation within cells is left out.
  double expected_efficiency() const;

 private:
  struct Cell;
  /// Integrals of f cos and f cos L.
  struct Sums {
    Imath::V3d albedo = Imath::V3d(0);
    Imath::V3d reflected = Imath::V3d(0);

    void add(const reflectance::Rgb& f_cos, const reflectance::Rgb& radiance, double solid_angle);
    void add(const Sums& other);
  };
  Sums sample_row(int y);
  Sums integral_of_row(int y) const;
  void subdivide(const Cell& cell, Sums& sums) const;
  template <class Row>
  static Sums sum_of_rows(const Row& row, const std::function<bool()>& is_stopped);
  bool varies(int x, int y) const;
  bool is_near_mirror(const reflectance::Vec3f& centre, double size) const;
  reflectance::Rgb f_cos(const reflectance::Vec3f& direction) const;
  reflectance::Rgb fine_radiance(double x, double y) const;
  double importance(const reflectance::Rgb& difference, const reflectance::Rgb& radiance,
                    double solid_angle) const;

  const LitSurface& surface_;
  reflectance::Vec3f mirror_;  ///< direction in the map's frame
  std::vector<DirectionValues> cells_;
  // Estimates of the integrals before subdivision, means over RGB.
  double albedo_scale_ = 0;
  double reflected_scale_ = 0;
  reflectance::Rgb albedo_;
  reflectance::Rgb reflected_;
};

/// A candidate of a resampling.
struct Candidate {
  reflectance::Vec3f v;       ///< local direction
  reflectance::Rgb estimate;  ///< f cos L / p; 0 for a sample that was rejected
  float pdf = 0;              ///< of the scheme; 0 for a delta direction
  bool is_specular = false;
  int copies = 0;  ///< how often it was chosen

  double weight() const { return static_cast<double>(reflectance::mean(estimate)); }
};

/// A resampling, as the path tracer does it at a hit.
struct ResampledLight {
  std::vector<Candidate> candidates;
  reflectance::Rgb estimate = reflectance::Rgb(0);  ///< of the unoccluded reflected radiance

  /// Returns (sum w)^2 / sum w^2: of how many equally good candidates this is worth; 0 if all weigh nothing.
  double effective_candidates() const;
  double largest_weight() const;  ///< over the mean; 0 if all weigh nothing
  std::size_t rejected() const;   ///< candidates of weight 0
};

ResampledLight resample(const LitSurface& surface, const reflectance::Resampling& counts, std::uint32_t seed);

/// Which local directions an experiment takes for unoccluded.
using Visibility = std::function<bool(const reflectance::Vec3f& v)>;

/// The spread of estimates over repetitions of a resampling.
struct Deviation {
  reflectance::Resampling counts;
  double relative = 0;  ///< standard deviation over mean, of the mean over RGB; 0 if there is no light
};

/// Numbers of candidates and samples to measure. Each number of candidates is repeated so often that there
/// are `least_total` candidates, and at least `least_repetitions` times.
struct DeviationPlan {
  std::vector<int> candidates;
  std::vector<int> chosen;  ///< in ascending order
  int least_repetitions = 64;
  int least_total = 16384;
};

/// Measures the deviation for each number of candidates with each number of samples that is not larger. All
/// numbers of samples are chosen from the same candidates.
std::vector<Deviation> measure_deviations(const LitSurface& surface, const Visibility& is_visible,
                                          const DeviationPlan& plan, std::uint32_t seed,
                                          const std::function<bool()>& is_stopped = {});

}  // namespace studies
