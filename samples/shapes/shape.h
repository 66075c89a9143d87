// What the generators of shapes share.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <ImathBox.h>
#include <ImathVec.h>

#include "grf/scene.h"

namespace shape {

using Imath::V3d;

/// Rounded as exporters do, far above what libraries of functions differ by.
grf::Vec3f rounded(const V3d& v, double steps);

/// Turns positions about the origin into ones that stand on y = 0, with a longest side of 2.
class Fitting {
 public:
  explicit Fitting(const std::vector<V3d>& positions);
  V3d operator()(const V3d& position) const { return (position - foot_) * scale_; }

 private:
  double scale_;
  V3d foot_;
};

/// A point of a closed surface like a sphere's: `along` 0..1 from pole to pole, `around` 0..2 pi. Seen from
/// outside with `along` upwards, `around` grows to the right.
using Surface = std::function<V3d(double along, double around)>;

/// Closed surfaces, each of its own vertices with smooth normals.
class Builder {
 public:
  /// About so many triangles, in cells that are about square; `length_over_girth` is that of the surface.
  void add(const Surface& surface, double triangles, double length_over_girth);
  /// Fitted and rounded.
  grf::Mesh mesh() const;

 private:
  std::uint32_t add_vertex(const V3d& position, const V3d& normal);
  void add_cells(std::uint32_t first, std::uint32_t rings, std::uint32_t segments);

  std::vector<V3d> positions_, normals_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

/// From 0 at `from` to 1 at `to`, smoothly.
double smooth_step(double from, double to, double x);

/// A smooth curve through points, evenly in `at` from 0 at the first to 1 at the last (Catmull and Rom 1974).
V3d curve_through(const std::vector<V3d>& points, double at);

/// A direction for each place along a curve.
using DirectionAlong = std::function<V3d(double along)>;

/// A body, a limb and so on: a tube about a curve, as wide as `radius`; at `around` = 0 it has the side of
/// `up`, which must nowhere be the curve's own direction. The radius must end in 0 on both sides, or nearly
/// so.
Surface tube(const DirectionAlong& curve, const std::function<double(double along, double around)>& radius,
             const DirectionAlong& up);

/// A trefoil whose tube has spiralling ridges and bumps: folds, shadows on itself, detail of all sizes.
grf::Mesh knot(int triangles);
/// A sphere of circles of latitude.
grf::Mesh sphere(int triangles);
/// A twisted serpent with legs, wings, horns, spikes and scales; 20,000 triangles show its shape, 200,000 its
/// scales.
grf::Mesh dragon(int triangles);
/// A jug with a lip and a handle, open and with a wall of some thickness.
grf::Mesh jug(int triangles);

}  // namespace shape
