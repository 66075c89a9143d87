#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "renderer/plot/svg.h"
#include "renderer/reflectance/schemes/azimuth_rotation.h"
#include "renderer/reflectance/schemes/rejection_tree.h"
#include "renderer/reflectance/schemes/rejection_trees.h"
#include "renderer/studies/angles.h"

namespace studies {

struct SubdivisionLimits {
  double most_tries = 2;  ///< n_max: mean number of tries that a leaf may need
  int most_depth = reflectance::RejectionTree::AnyDepth;
  int resolution = 200;  ///< of the grid over the disc, along an edge
};

/// The adaptive quadtree of a BRDF on the unit disc, for one view: the renderer's tree of `adaptive
/// mode=reject`, made for exactly this view. It is aligned with the view's azimuth; directions and points of
/// the disc are in the local frame of the surface.
class Subdivision {
 public:
  /// A leaf with a part inside the disc.
  struct Cell {
    reflectance::CellRange range;
    int depth = 0;          ///< that of the root is 0
    double mass = 0;        ///< fraction of the tree's integral: the probability that a sample is here
    double maximum = 0;     ///< the bound of rejection, in 1/sr
    double acceptance = 0;  ///< mean probability that a try in the cell is accepted
  };

  /// A node on the way from the root to a leaf.
  struct Step {
    reflectance::CellRange range;
    double probability = 1;  ///< of choosing it among its three siblings and itself; 1 for the root
  };

  Subdivision(const reflectance::Brdf& brdf, const Angles& view, const SubdivisionLimits& limits);

  const std::vector<Cell>& cells() const { return cells_; }
  const reflectance::DiscGrid& grid() const { return grid_; }
  /// Returns the integral of f over the disc: the albedo, without a delta part.
  double integral() const { return double(tree_.nodes().front().integral) * tree_.largest(); }
  int deepest() const;
  /// Returns the mean number of tries per sample.
  double mean_tries() const;

  /// Returns the index of the cell of a point of the unit disc, such as (v.x, v.y); nothing outside.
  std::optional<std::size_t> cell_at(double x, double y) const;

  /// Returns the nodes from the root to the leaf of a point of the unit disc.
  std::vector<Step> path_to(double x, double y) const;

  /// Returns the corners of a node's square in the surface's frame, in a circle.
  std::array<plot::Point, 4> corners(const reflectance::CellRange& range) const;

  /// Integrates a solid-angle pdf over each cell of the grid, in row order, on several threads. Values are
  /// omitted once it is stopped.
  std::vector<double> integrals(const std::function<double(const reflectance::Vec3f&)>& pdf,
                                const std::function<bool()>& is_stopped) const;

  /// Sums values of the grid's cells over each of the tree's cells.
  std::vector<double> sums_over_cells(const std::vector<double>& values) const;

  /// Returns the index of the grid's cell of a point of the unit disc.
  std::size_t grid_index(double x, double y) const;

 private:
  plot::Point to_tree(double x, double y) const;

  /// Visits the nodes from the root to the leaf of a point in the tree's frame: visit(node, range, parent).
  template <class Visit>
  void descend(const plot::Point& point, Visit visit) const;

  reflectance::DiscGrid grid_;
  reflectance::AzimuthRotation rotation_;
  reflectance::RejectionTree tree_;
  std::vector<Cell> cells_;
  std::vector<std::optional<std::size_t>> cell_of_node_;
};

}  // namespace studies
