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

/// The value at a point of the unit square.
inline float value_at(const BilinearPatch& patch, const Vec2f& point) {
  const float low = patch[0] + point.x * (patch[1] - patch[0]);
  const float high = patch[2] + point.x * (patch[3] - patch[2]);
  return low + point.y * (high - low);
}

/// The point x of [0,1] up to which the linear density from a to b has the share xi.
inline float linear_warp(float a, float b, float xi) {
  // (b-a)/2 x^2 + a x = xi (a+b)/2, with the root written so that a = b is no special case.
  const float sum = a + b;
  if (!(sum > 0)) return xi;
  const float root = std::sqrt(a * a + xi * (b - a) * sum);
  return std::min(xi * sum / (a + root), 1.0F);
}

/// The point that a uniform pair becomes where the patch is a density, up to a factor. Inverts first the
/// marginal along x and then the conditional along y, which are linear densities both.
inline Vec2f warped(const BilinearPatch& patch, const Vec2f& xi) {
  const float x = linear_warp(patch[0] + patch[2], patch[1] + patch[3], xi.x);
  const float low = patch[0] + x * (patch[1] - patch[0]);
  const float high = patch[2] + x * (patch[3] - patch[2]);
  return {x, linear_warp(low, high, xi.y)};
}

/// Four nodes of a quadtree side by side: the children of one, in the order of a patch's corners, or those of
/// the tree's top that are one above the other. A node is a leaf, or has a group of four below it.
class WarpQuad {
 public:
  void set_leaf(std::size_t node, const BilinearPatch& patch);
  void set_inner(std::size_t node, float mean, std::uint32_t children);

  /// Of the four nodes.
  const std::array<float, 4>& means() const { return means_; }

  bool is_leaf(std::size_t node) const { return words_[node] < InnerMark; }
  /// The number of the group of four below an inner node.
  std::uint32_t children(std::size_t node) const { return words_[node] - InnerMark; }

  /// Of a leaf. Corners are kept as the roots of their parts in the mean, with eight bits, so that the mean
  /// is exact, and none is off by over a fiftieth that is over a twentieth of the largest.
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

/// The two topmost levels of all four columns, which every tree has, as one: sixteen strips from bottom to
/// top, four in each column, of four cells each.
struct WarpTop {
  static constexpr int Side = 4;  ///< of a column, in cells

  alignas(16) std::array<float, 4> column_means = {};
  alignas(16) std::array<std::array<float, 4>, 4> strip_means = {};
  std::array<std::array<WarpQuad, 4>, 4> strips = {};
};

/// A function of a point of four columns. `size` is the side of the square that the point is a corner of:
/// where the function drops to 0 at a border, or has a pole there, it may be evaluated a part of that further
/// inside.
using ColumnFunction = std::function<float(const ColumnPoint& point, float size)>;

struct WarpTreeLimits {
  float error = 7e-3F;  ///< the variance of f/g over g's density, f being the function and g the tree
  int most_quads = 1024;
  int most_depth = 14;
};

/// A table g of a function f >= 0 that can be sampled exactly: a quadtree with bilinear leaves in each of
/// four columns. Leaves are split where the error of the integral is largest. g has a floor, a small share of
/// its mean. A function that is 0 everywhere gives a black tree.
struct WarpTree {
  WarpTop top;
  std::vector<WarpQuad> quads;

  bool is_black() const { return !(mean(top.column_means) > 0); }

  /// `widths` say how much room each column stands for; `probes` are points where f must not be missed,
  /// however narrow it is there.
  static WarpTree build(const ColumnFunction& function, const std::array<float, 4>& widths,
                        std::span<const ColumnPoint> probes, const WarpTreeLimits& limits);
};

}  // namespace reflectance
