#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/schemes/sampled_direction.h"
#include "renderer/reflectance/schemes/warp_descent.h"

namespace reflectance {

struct WarpTreesSettings {
  int theta_count = 90;  ///< number of view angles with a tree, from the normal to the horizon
  int phi_count = 0;  ///< number of view azimuths, only for anisotropic BRDFs; 0: up to 16, as the BRDF needs
  WarpTreeLimits limits = {};
};

/// The adaptive method of the thesis (chapter 5) without its two faults: one uniform pair gives one
/// direction, by inversion instead of rejection, continuously except at tree splits; and the horizon is
/// resolved as well as the rest. Hence the quadtrees are not on the disc of projected directions, where f
/// grows without bound at the rim, but on the square of view_square.h, and store f cos.
///
/// There is a tree per tabulated view. Between views, tables are blended linearly: a sample descends all
/// trees around its view at once, so that it samples exactly the blend. An isotropic BRDF blends two trees,
/// with one half space stored and the other mirrored; others blend three, at the corners of triangles over
/// angle and azimuth. All trees together take at most 16 MB.
class WarpTrees {
 public:
  WarpTrees(const Brdf& brdf, const WarpTreesSettings& settings);

  /// Samples a direction; nothing for a view from which the BRDF is black.
  std::optional<SampledDirection> sample(const Vec3f& u, const Vec2f& xi) const;

  /// Returns the pdf of `sample`.
  float pdf(const Vec3f& u, const Vec3f& v) const;

  std::size_t bytes() const;

 private:
  /// The symmetries of an anisotropic BRDF. Fibres and scratches along an axis have both.
  struct Symmetry {
    bool half_turn = false;  ///< under rotating view and light about the normal
    bool mirror = false;     ///< under reflecting view and light at the plane of x and z
  };
  /// The interpolation of a view's azimuth between the trees.
  struct Azimuth {
    std::size_t low = 0;
    std::size_t high = 0;
    float high_fraction = 0;
    float side = 1;  ///< -1: the trees are of the mirrored view
  };
  struct Blend {
    ViewColumns columns;
    std::array<WeightedTree, 3> parts = {};
    std::array<float, 4> masses = {};  ///< of the columns
    float side = 1;                    ///< -1: the trees are mirrored at the plane of the view

    float mass() const { return masses[0] + masses[1] + masses[2] + masses[3]; }
  };

  static Symmetry symmetry_of(const Brdf& brdf);
  int phi_count_for(const Brdf& brdf) const;
  WarpTree make_tree(const Brdf& brdf, std::size_t index) const;
  float radius_step() const;
  float azimuth(std::size_t index) const;
  Azimuth azimuth_of(const Vec3f& u) const;
  Blend blend_for(const Vec3f& u) const;
  WeightedTree part(std::size_t theta, std::size_t phi, float weight) const;

  WarpTreesSettings settings_;
  bool is_isotropic_;
  Symmetry symmetry_;
  std::vector<WarpTop> tops_;  ///< all phis of the first theta, then of the next
  std::vector<std::uint32_t> first_quads_;
  std::vector<WarpQuad> quads_;
};

}  // namespace reflectance
