#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/schemes/warp_tree.h"

namespace reflectance {

/// A direction and its density per solid angle.
struct DrawnDirection {
  Vec3f direction;
  float density = 0;
};

struct WarpTreesSettings {
  int theta_count = 90;  ///< view angles from the normal to the horizon that have a tree
  int phi_count = 16;    ///< and view azimuths, for anisotropic BRDFs alone
  WarpTreeLimits limits = {};
};

/// The adaptive method of the thesis (chapter 5) with its two faults mended: one uniform pair gives one
/// direction, by inversion and not by rejection, continuously but for the lines where a tree splits; and the
/// horizon has as much room as the rest. For that the quadtrees are not on the disc of projected directions,
/// where f grows without bound at the rim, but on the square of view_square.h, and hold f cos.
///
/// There is a tree for each of some views. Between them, tables are blended linearly: a sample walks down all
/// trees around its view at once, so that what it draws from is exactly the blend. Of an isotropic BRDF one
/// half space is stored, the other mirrors it.
class WarpTrees {
 public:
  WarpTrees(const Brdf& brdf, const WarpTreesSettings& settings);

  /// Nothing for a view from which the BRDF is black.
  std::optional<DrawnDirection> sample(const Vec3f& u, const Vec2f& xi) const;

  /// Of `sample`.
  float density(const Vec3f& u, const Vec3f& v) const;

  std::size_t bytes() const;

 private:
  /// What an anisotropic BRDF does not change with. Both hold of fibres and scratches along an axis.
  struct Symmetry {
    bool half_turn = false;  ///< of view and light about the normal
    bool mirror = false;     ///< of view and light, at the plane of x and z
  };
  struct Tree {
    std::size_t first_quad = 0;
    float scale = 0;  ///< 0: black
  };
  /// A view's azimuth among those of the trees.
  struct Azimuth {
    std::size_t low = 0;
    std::size_t high = 0;
    float high_share = 0;
    bool is_mirrored = false;
  };
  /// One of the trees around a view, and its part in the blend.
  struct Part {
    const WarpQuad* quads = nullptr;
    float weight = 0;
  };
  struct Blend {
    ViewColumns columns;
    std::array<Part, 4> parts = {};
    std::size_t count = 0;
    std::array<float, 4> masses = {};  ///< of the columns
    bool is_mirrored = false;          ///< at the plane of the view

    float mass() const { return masses[0] + masses[1] + masses[2] + masses[3]; }
  };

  static Symmetry symmetry_of(const Brdf& brdf);
  WarpTree make_tree(const Brdf& brdf, std::size_t index) const;
  float radius_step() const;
  float azimuth(std::size_t index) const;
  Azimuth azimuth_of(const Vec3f& u) const;
  Blend blend_for(const Vec3f& u) const;
  void add(Blend& blend, std::size_t theta, std::size_t phi, float weight) const;

  WarpTreesSettings settings_;
  bool is_isotropic_;
  Symmetry symmetry_;
  std::vector<Tree> trees_;  ///< theta in the outer order, phi in the inner
  std::vector<WarpQuad> quads_;
};

}  // namespace reflectance
