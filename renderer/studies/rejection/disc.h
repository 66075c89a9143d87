// f cos is sampled by rejection as f over the unit disc of projected directions, where area is projected
// solid angle.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "renderer/plot/svg.h"
#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/schemes/azimuth_rotation.h"
#include "renderer/reflectance/schemes/rejection_tree.h"
#include "renderer/studies/angles.h"
#include "renderer/studies/rejection/run.h"

namespace studies {

/// The function that is sampled: f, the mean over RGB without the delta part, for a view. Points (x, y) of
/// the disc are relative to the plane of incidence: the view is at y = 0, x >= 0.
class DiscFunction {
 public:
  /// The BRDF outlives the function.
  DiscFunction(const reflectance::Brdf& brdf, const Angles& view);

  /// Returns f in 1/sr; 0 outside the disc.
  double operator()(double x, double y) const;
  /// Returns the direction over a point, in the frame of the BRDF.
  reflectance::Vec3f direction(const plot::Point& point) const;

  const reflectance::Brdf& brdf() const { return brdf_; }
  /// Returns the view in the frame of the BRDF, and in the plane of incidence.
  const reflectance::Vec3f& u() const { return u_; }
  const reflectance::Vec3f& plane_u() const { return plane_u_; }
  const grf::Vec2f& azimuth() const { return azimuth_; }

 private:
  const reflectance::Brdf& brdf_;
  grf::Vec2f azimuth_;
  reflectance::AzimuthRotation rotation_;
  reflectance::Vec3f u_;
  reflectance::Vec3f plane_u_;
};

/// A local maximum on the disc.
struct Peak {
  plot::Point at;
  double value = 0;
};

/// Directions are taken up to this angle from the normal: f of some models is infinite at the horizon, so
/// that no bound would be above it. Beyond are 3e-6 of the disc.
constexpr double LimitDegrees = 89.9;

/// Finds local maxima, the largest first; none if f is 0. It starts from a grid over the angles, the mirror
/// direction and samples of the BRDF's own sampler, and climbs from the best of them.
std::vector<Peak> find_peaks(const DiscFunction& function);

/// Integrals over cells of the disc, for tests of samples: columns of x, with rows that divide the chord.
struct DiscCells {
  static constexpr int Columns = 48;
  static constexpr int Rows = 3;

  std::vector<double> masses;  ///< row by row in a column
  double total = 0;

  static std::size_t cell_of(const plot::Point& point);
};

/// Integrates adaptively, with small cells around the peaks.
DiscCells integrate(const std::function<double(double x, double y)>& function, std::span<const Peak> peaks);

/// The region that places of tries are uniform in.
enum class Region { Disc, Square };
double area_of(Region region);

/// Samples under one bound, up to the limiting angle.
Run<plot::Point> sample_disc(const DiscFunction& function, double bound, Region region,
                             const RunLimits& limits, std::uint32_t seed);

/// The quadtree of the renderer over the same function, tabulated on a grid as for rendering.
class DiscTree {
 public:
  DiscTree(const DiscFunction& function, int cells, double most_tries);

  /// Returns the grid's maximum, in 1/sr.
  double grid_maximum() const { return largest_; }
  /// Returns the number of leaves that have samples.
  std::size_t leaves() const { return leaves_; }
  /// Returns the expected fraction of tries that are accepted.
  double acceptance() const { return acceptance_; }
  /// Returns the bound of the leaf at a point, in 1/sr.
  double bound_at(const plot::Point& point) const;
  /// Calls visit(box) for each leaf.
  void visit_leaves(const std::function<void(const reflectance::Box& box)>& visit) const;
  /// Samples with the tree. Records the tries inside the disc, without heights.
  Run<plot::Point> sample(const RunLimits& limits, std::uint32_t seed) const;

 private:
  using Leaf = reflectance::RejectionTree::Leaf;
  void visit(const std::function<void(const Leaf& leaf)>& visit) const;

  int cells_;
  reflectance::RejectionTree tree_;
  double largest_ = 0;
  double acceptance_ = 0;
  std::size_t leaves_ = 0;
};

}  // namespace studies
