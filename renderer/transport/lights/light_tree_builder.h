#pragma once

#include <array>
#include <span>
#include <vector>

#include "renderer/transport/lights/light_tree.h"

namespace transport {

/// Builds a light tree top-down: emitters are split where the surface area orientation heuristic is least
/// (Conty Estevez and Kulla 2018, section 5.2), over a few buckets along each axis. The levels of this binary
/// tree are then joined into nodes of eight children (Wald, Benthin and Boulos 2008, "Getting rid of
/// packets").
class LightTreeBuilder {
 public:
  LightTreeBuilder(std::span<const Emitter> emitters, LightTree& tree);

  void build();

 private:
  struct Item {
    Box3f box;
    Vec3f normal;
    float power = 0;
    std::uint32_t emitter = 0;
  };
  using Items = std::span<Item>;

  /// The bounds of some items.
  struct Extent {
    Box3f box;
    Cone normals;
    double power = 0;
    std::size_t count = 0;

    void extend_by(const Extent& other);
    double cost() const;
  };

  static constexpr int MostBuckets = 12;
  using Buckets = std::array<std::array<Extent, MostBuckets>, 3>;

  struct Cut {
    int axis = -1;  ///< -1: none
    int bucket = 0;
    double cost = 0;
  };

  /// Maps an item to its bucket along each axis.
  struct Grid {
    Vec3f lower;
    Vec3f scale;
    int count = 0;

    Grid(Items items, int bucket_count);
    int bucket(const Item& item, int axis) const;
  };

  static Item item_of(const Emitter& emitter, std::uint32_t index);
  static Buckets fill(Items items, const Grid& grid);
  static Cut best_cut(const Buckets& buckets, const Grid& grid);
  static std::size_t partition(Items items);

  /// A node of the binary tree: a cluster of emitters.
  struct Cluster {
    LightBounds bounds;
    std::uint32_t count = 0;  ///< of emitters
    /// The emitter if it is alone, else the second of its halves, the first of which follows the cluster.
    std::uint32_t emitter_or_second = 0;
  };

  Extent build(Items items, std::uint32_t cluster);
  std::vector<std::uint32_t> children_of(std::uint32_t cluster) const;
  void join(std::uint32_t cluster, LightTree::Place parent);

  LightTree& tree_;
  std::vector<Cluster> clusters_;  ///< the root first
  std::vector<Item> items_;
};

}  // namespace transport
