#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "renderer/reflectance/schemes/lanes.h"
#include "renderer/reflectance/schemes/view_square.h"

namespace reflectance {

/// The values of a bilinear function at the corners of a square: (0,0), (1,0), (0,1), (1,1).
using BilinearPatch = std::array<float, 4>;

inline float mean(const BilinearPatch& patch) { return (patch[0] + patch[1] + patch[2] + patch[3]) / 4; }

/// Interpolates the value at a point of the unit square.
inline float value_at(const BilinearPatch& patch, const Vec2f& point) {
  const float low = patch[0] + point.x * (patch[1] - patch[0]);
  const float high = patch[2] + point.x * (patch[3] - patch[2]);
  return low + point.y * (high - low);
}

/// Inverts the cdf of the linear pdf from a to b on [0,1] at xi.
inline float linear_warp(float a, float b, float xi) {
  // (b-a)/2 x^2 + a x = xi (a+b)/2, with the root written so that a = b is no special case.
  const float sum = a + b;
  if (!(sum > 0)) return xi;
  const float root = std::sqrt(a * a + xi * (b - a) * sum);
  return std::min(xi * sum / (a + root), 1.0F);
}

/// Warps a uniform pair by a patch as an unnormalised pdf. Inverts first the marginal along x and then the
/// conditional along y, both linear pdfs.
inline Vec2f warped(const BilinearPatch& patch, const Vec2f& xi) {
  const float x = linear_warp(patch[0] + patch[2], patch[1] + patch[3], xi.x);
  const float low = patch[0] + x * (patch[1] - patch[0]);
  const float high = patch[2] + x * (patch[3] - patch[2]);
  return {x, linear_warp(low, high, xi.y)};
}

/// Four sibling nodes of a quadtree: the children of one in the order of a patch's corners, or those of the
/// tree's top that are one above the other. A node is a leaf, or has a group of four below it.
class WarpQuad {
 public:
  void set_leaf(std::size_t node, const BilinearPatch& patch);
  void set_inner(std::size_t node, float mean, std::uint32_t children);

  /// Returns the means of the four nodes.
  const std::array<float, 4>& means() const { return means_; }

  bool is_leaf(std::size_t node) const { return words_[node] < InnerMark; }
  /// Returns the index of the group of four below an inner node.
  std::uint32_t children(std::size_t node) const { return words_[node] - InnerMark; }

  /// Decodes a leaf's patch. Corners are kept as square roots of their fractions of the mean, in eight bits,
  /// so that the mean is exact, and corners over a twentieth of the largest are within 2 %.
  BilinearPatch patch(std::size_t node) const {
    const Lanes root = _mm_cvtepi32_ps(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(static_cast<int>(words_[node]))));
    const Lanes square = root * root;
    const Lanes pairs = square + lanes_of<1, 0, 3, 2>(square);
    BilinearPatch patch;
    _mm_storeu_ps(patch.data(),
                  square * (_mm_set1_ps(4 * means_[node]) / (pairs + lanes_of<2, 3, 0, 1>(pairs))));
    return patch;
  }

 private:
  static constexpr std::uint32_t LargestRoot = 0xfe;  // so that no leaf has the mark
  static constexpr std::uint32_t InnerMark = 0xff000000;

  std::array<float, 4> means_ = {};
  std::array<std::uint32_t, 4> words_ = {};
};

/// The two topmost levels of all four columns, which every tree has: sixteen strips from bottom to top, four
/// per column, of four cells each.
struct WarpTop {
  static constexpr int Side = 4;  ///< of a column, in cells

  alignas(16) std::array<float, 4> column_means = {};
  alignas(16) std::array<std::array<float, 4>, 4> strip_means = {};
  std::array<std::array<WarpQuad, 4>, 4> strips = {};
};

/// A function of a point in four columns. `size` is the side of the square that has the point as a corner: if
/// the function drops to 0 at a border, or has a pole there, it may be evaluated a fraction of that further
/// inside.
using ColumnFunction = std::function<float(const ColumnPoint& point, float size)>;

struct WarpTreeLimits {
  float error = 7e-3F;  ///< the variance of f/g over g's pdf, f being the function and g the tree
  int most_quads = 1024;
  int most_depth = 14;
};

/// An approximation g of a function f >= 0 that can be sampled exactly: a quadtree with bilinear leaves in
/// each of four columns. The leaf with the largest error of the integral is split first. g has a floor, a
/// small fraction of its mean. A function that is 0 everywhere gives a black tree.
struct WarpTree {
  WarpTop top;
  std::vector<WarpQuad> quads;

  bool is_black() const { return !(mean(top.column_means) > 0); }

  /// Builds the tree. `widths` are the widths of the columns in the square; `probes` are points where f must
  /// not be missed, however narrow it is there.
  static WarpTree build(const ColumnFunction& function, const std::array<float, 4>& widths,
                        std::span<const ColumnPoint> probes, const WarpTreeLimits& limits);
};

}  // namespace reflectance
