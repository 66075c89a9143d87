#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/schemes/rejection_tree.h"
#include "renderer/reflectance/schemes/sampled_direction.h"

namespace reflectance {

/// A most_tries for which no node has to be split.
constexpr float AnyTries = std::numeric_limits<float>::infinity();

/// Evaluates f, the mean over RGB, for each cell of a grid over the disc, at the centre of its part inside; 0
/// outside. The grid's x axis is the plane of incidence: `plane_u` is the view in it, with y = 0 and x >= 0,
/// and `azimuth` the cosine and sine of the view's azimuth. A rejection tree is made from these values.
std::vector<float> disc_values(const Brdf& brdf, const Vec3f& plane_u, const Vec2f& azimuth,
                               const DiscGrid& grid);

struct RejectionSettings {
  int thetas = 90;         ///< number of trees over the view's angle to the normal
  int phis = 0;            ///< number of trees over its azimuth; 0: as many as the BRDF needs
  float most_tries = 2;    ///< mean number of tries that a leaf may need, over 1
  int resolution = 800;    ///< of the grid over the disc, along an edge
  bool keep_table = true;  ///< else values are recomputed, which takes longer
};

/// Samples directions in proportion to the RGB mean of f cos by rejection: trees over the unit disc for a set
/// of views (sections 5.1 to 5.3 of the thesis), of which the nearest to u is used. A tree is relative to its
/// view's azimuth and is rotated to u's, so that a lobe stays at the mirror direction; for an anisotropic
/// BRDF, the nearest azimuth gives the shape.
///
/// The sampled function is constant in each cell of a grid, so the pdf is exact: the cell's value comes from
/// the table, or without one is recomputed as it was for the tree.
class RejectionTrees {
 public:
  RejectionTrees(const Brdf& brdf, const RejectionSettings& settings);

  /// Samples a direction; nothing if u is below the horizon, the BRDF black, or RejectionTree::Bound reached.
  std::optional<SampledDirection> draw(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const;

  /// Samples a direction per xi, without those for which `draw` returns nothing; each has the pdf of `draw`,
  /// and together they are stratified over the tree.
  std::vector<SampledDirection> draw_many(const Brdf& brdf, const Vec3f& u,
                                          std::span<const Uniforms> xi) const;

  float pdf(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const;

  std::span<const RejectionTree> trees() const { return trees_; }
  std::size_t bytes() const;

 private:
  /// A tree, and the rotation about the normal from its frame into u's.
  struct View {
    const RejectionTree* tree;
    Vec3f tree_u;        ///< in the tree's frame: at azimuth 0
    float cosine, sine;  ///< of u's azimuth
    Vec2f tree_azimuth;  ///< cosine and sine of the azimuth that the tree was made for
  };

  std::optional<View> view_of(const Vec3f& u) const;
  Vec3f view_direction(int theta) const;
  Vec2f azimuth(int phi) const;
  float value(const Brdf& brdf, const View& view, double x, double y) const;
  std::optional<RejectionTree::Point> draw_point(const Brdf& brdf, const View& view,
                                                 const RejectionTree::Leaf& leaf, const Vec2f& first,
                                                 SplitMix& more) const;
  SampledDirection drawn(const Brdf& brdf, const Vec3f& u, const View& view,
                         const RejectionTree::Point& point) const;

  int thetas_;
  int phis_;
  std::vector<RejectionTree> trees_;  ///< all thetas of the first phi, then of the next; none if black
};

}  // namespace reflectance
