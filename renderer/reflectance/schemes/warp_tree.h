#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <Imath/half.h>

#include "renderer/reflectance/geometry.h"

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

/// The four children of a node.
using WarpQuad = std::array<WarpNode, 4>;

/// A function of a point of the unit square. `size` is the side of the square that the point is a corner of:
/// where the function has a pole or drops to 0 at the border, it may be evaluated so much further inside.
using SquareFunction = std::function<float(const Vec2f& point, float size)>;

struct WarpTreeLimits {
  float error = 3e-3F;  ///< the variance of f/g over g's density, f being the function and g the tree
  int most_quads = 4096;
  int least_depth = 3;
  int most_depth = 14;
};

/// A quadtree on the unit square whose leaves are bilinear: a table g of a function f >= 0 that can be
/// sampled exactly. Leaves are split where the error of the integral is largest; `probes` are points where f
/// must not be missed, however narrow it is there. g has a floor, a small share of its mean. The first group
/// is that of the root's children. A function that is 0 everywhere gives an empty tree. Values are in units
/// of `scale`.
struct WarpTree {
  std::vector<WarpQuad> quads;
  float scale = 0;

  static WarpTree build(const SquareFunction& function, std::span<const Vec2f> probes,
                        const WarpTreeLimits& limits);
};

}  // namespace reflectance
