#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <Imath/half.h>

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

/// The point that a uniform pair becomes where the patch is a density, up to a factor. Inverts first the
/// marginal along x and then the conditional along y, which are linear densities both.
Vec2f warped(const BilinearPatch& patch, const Vec2f& xi);

/// One node of a quadtree in eight bytes: a leaf's corner values as halves, or the mean over the node and
/// where its four children are.
class WarpNode {
 public:
  static WarpNode leaf(const BilinearPatch& patch);
  static WarpNode inner(float mean, std::uint16_t children);

  bool is_leaf() const { return words_[3] != InnerMark; }
  BilinearPatch patch() const { return {at(0), at(1), at(2), at(3)}; }
  float mean() const {
    return is_leaf() ? reflectance::mean(patch())
                     : std::bit_cast<float>(std::uint32_t(words_[1]) << 16U | words_[0]);
  }
  /// The number of the group of four that the children are, in the order of a patch's corners.
  std::uint16_t children() const { return words_[2]; }

 private:
  static constexpr std::uint16_t InnerMark = 0xffff;  // as a half not a number, so no leaf has it

  float at(std::size_t corner) const { return Imath::half(Imath::half::FromBits, words_[corner]); }

  std::array<std::uint16_t, 4> words_ = {};
};

/// Four nodes side by side: the children of one, in the order of a patch's corners.
using WarpQuad = std::array<WarpNode, 4>;

/// A function of a point of four columns. `size` is the side of the square that the point is a corner of:
/// where the function drops to 0 at a border, or has a pole there, it may be evaluated a part of that further
/// inside.
using ColumnFunction = std::function<float(const ColumnPoint& point, float size)>;

struct WarpTreeLimits {
  float error = 7e-3F;  ///< the variance of f/g over g's density, f being the function and g the tree
  int most_quads = 1024;
  int least_depth = 2;
  int most_depth = 14;
};

/// A table g of a function f >= 0 that can be sampled exactly: a quadtree with bilinear leaves in each of
/// four columns. Leaves are split where the error of the integral is largest. g has a floor, a small share of
/// its mean. The first group is that of the columns. A function that is 0 everywhere gives an empty tree.
struct WarpTree {
  std::vector<WarpQuad> quads;
  float scale = 0;  ///< what the quads' values are in units of

  /// `widths` say how much room each column stands for; `probes` are points where f must not be missed,
  /// however narrow it is there.
  static WarpTree build(const ColumnFunction& function, const std::array<float, 4>& widths,
                        std::span<const ColumnPoint> probes, const WarpTreeLimits& limits);
};

}  // namespace reflectance
