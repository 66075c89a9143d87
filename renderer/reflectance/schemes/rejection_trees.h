#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/schemes/drawn_direction.h"
#include "renderer/reflectance/schemes/rejection_tree.h"

namespace reflectance {

/// A most_tries that no node has to be split for.
constexpr float AnyTries = std::numeric_limits<float>::infinity();

struct RejectionSettings {
  int thetas = 90;         ///< trees over the view's angle to the normal
  int phis = 0;            ///< trees over its azimuth; 0: as many as the BRDF needs
  float most_tries = 2;    ///< that a leaf may need in the mean, over 1
  int resolution = 800;    ///< of the grid over the disc, along an edge
  bool keep_table = true;  ///< else values are computed anew, which takes longer
};

/// Directions in proportion to the mean of f over RGB times the cosine, by rejection: trees over the unit
/// disc for a set of views (sections 5.1 to 5.3 of the thesis), of which the nearest to u is taken. A tree
/// lies relative to its view's azimuth, and is turned to u's, so that a lobe stays at the mirror direction;
/// of an anisotropic BRDF, the nearest azimuth gives the shape.
///
/// What is drawn from is constant in each cell of a grid, so that the density is exact: the cell's value
/// comes from the table, or without one is computed again as it was for the tree.
class RejectionTrees {
 public:
  RejectionTrees(const Brdf& brdf, const RejectionSettings& settings);

  /// Nothing where u is under the horizon, the BRDF black, or RejectionTree::Bound met.
  std::optional<DrawnDirection> draw(const Brdf& brdf, const Vec3f& u, const Uniforms& xi) const;

  /// A direction for each xi, but for those that `draw` would give nothing for; each has the density of
  /// `draw`, and all together are spread more evenly over the tree.
  std::vector<DrawnDirection> draw_many(const Brdf& brdf, const Vec3f& u, std::span<const Uniforms> xi) const;

  float density(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const;

  std::span<const RejectionTree> trees() const { return trees_; }
  std::size_t bytes() const;

 private:
  /// A tree, and the turn about the normal from its frame into u's.
  struct View {
    const RejectionTree* tree;
    Vec3f tree_u;        ///< in the tree's frame: at azimuth 0
    float cosine, sine;  ///< of u's azimuth
    Vec2f tree_azimuth;  ///< cosine and sine of that which the tree was made for
  };

  std::optional<View> view_of(const Vec3f& u) const;
  Vec3f view_direction(int theta) const;
  Vec2f azimuth(int phi) const;
  RejectionTree made_tree(const Brdf& brdf, const Vec3f& tree_u, const Vec2f& tree_azimuth,
                          const DiscGrid& grid, const RejectionSettings& settings) const;
  float value(const Brdf& brdf, const View& view, double x, double y) const;
  std::optional<RejectionTree::Point> draw_point(const Brdf& brdf, const View& view,
                                                 const RejectionTree::Leaf& leaf, const Vec2f& first,
                                                 MoreUniforms& more) const;
  DrawnDirection drawn(const Brdf& brdf, const Vec3f& u, const View& view,
                       const RejectionTree::Point& point) const;

  int thetas_;
  int phis_;
  std::vector<RejectionTree> trees_;  ///< all thetas of the first phi, then of the next; none if black
};

}  // namespace reflectance
