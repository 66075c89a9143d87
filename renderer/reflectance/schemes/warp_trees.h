#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/schemes/drawn_direction.h"
#include "renderer/reflectance/schemes/warp_descent.h"

namespace reflectance {

struct WarpTreesSettings {
  int theta_count = 90;  ///< view angles from the normal to the horizon that have a tree
  int phi_count = 0;     ///< and view azimuths, of anisotropic BRDFs alone; 0: up to 16, as the BRDF needs
  WarpTreeLimits limits = {};
};

/// The adaptive method of the thesis (chapter 5) with its two faults mended: one uniform pair gives one
/// direction, by inversion and not by rejection, continuously but for the lines where a tree splits; and the
/// horizon has as much room as the rest. For that the quadtrees are not on the disc of projected directions,
/// where f grows without bound at the rim, but on the square of view_square.h, and hold f cos.
///
/// There is a tree for each of some views. Between them, tables are blended linearly: a sample walks down all
/// trees around its view at once, so that what it draws from is exactly the blend. These are two of an
/// isotropic BRDF, of which one half space is stored and the other mirrors it, and of others three: views are
/// corners of triangles over angle and azimuth. All trees together take at most 16 MB.
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
  /// A view's azimuth among those of the trees.
  struct Azimuth {
    std::size_t low = 0;
    std::size_t high = 0;
    float high_share = 0;
    float side = 1;  ///< -1: the trees are of the view's image
  };
  struct Blend {
    ViewColumns columns;
    std::array<WarpPart, 3> parts = {};
    std::array<float, 4> masses = {};  ///< of the columns
    float side = 1;                    ///< -1: the trees are the mirror image at the plane of the view

    float mass() const { return masses[0] + masses[1] + masses[2] + masses[3]; }
  };

  static Symmetry symmetry_of(const Brdf& brdf);
  int phi_count_for(const Brdf& brdf) const;
  WarpTree make_tree(const Brdf& brdf, std::size_t index) const;
  float radius_step() const;
  float azimuth(std::size_t index) const;
  Azimuth azimuth_of(const Vec3f& u) const;
  Blend blend_for(const Vec3f& u) const;
  WarpPart part(std::size_t theta, std::size_t phi, float weight) const;

  WarpTreesSettings settings_;
  bool is_isotropic_;
  Symmetry symmetry_;
  std::vector<WarpTop> tops_;  ///< of the trees, theta in the outer order, phi in the inner
  std::vector<std::uint32_t> first_quads_;
  std::vector<WarpQuad> quads_;
};

}  // namespace reflectance
