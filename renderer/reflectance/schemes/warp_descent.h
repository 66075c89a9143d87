// A sample descends through the quadtrees of WarpTrees. It takes most of a sample's time: each level is a
// chain of dependent operations, whose length counts. All four children are handled at once.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "renderer/reflectance/schemes/lanes.h"
#include "renderer/reflectance/schemes/warp_tree.h"

namespace reflectance {

/// A sample on its way down: the pair of uniform numbers, which each choice rescales, and the square of a
/// column that it is in.
class WarpDescent {
 public:
  explicit WarpDescent(const Vec2f& xi) : x_(_mm_set1_ps(xi.x)), y_(_mm_set1_ps(xi.y)) {}

  /// Returns the rescaled numbers.
  Vec2f rest() const { return {_mm_cvtss_f32(x_), _mm_cvtss_f32(y_)}; }

  /// Maps a point of the current square, from 0 to 1, to the column.
  Vec2f to_column(const Vec2f& local) const {
    const Lanes high = lanes_of<2, 2, 2, 2>(corner_);
    const float side = _mm_cvtss_f32(side_);
    return {_mm_cvtss_f32(corner_) + side * local.x, _mm_cvtss_f32(high) + side * local.y};
  }

  /// Chooses one of four columns side by side, then of four strips within it, then of the strip's four cells
  /// one above the other, each in proportion to its mass.
  std::size_t choose_column(Lanes masses) { return choose_of_four(masses, x_); }
  void choose_cell(Lanes strips, auto cells_of_strip) {
    const std::size_t strip = choose_of_four(strips, x_);
    const std::size_t cell = choose_of_four(cells_of_strip(strip), y_);
    side_ = _mm_set1_ps(1.0F / WarpTop::Side);
    const auto x = static_cast<float>(static_cast<int>(strip));
    const auto y = static_cast<float>(static_cast<int>(cell));
    corner_ = side_ * _mm_setr_ps(x, x, y, y);
    cell_ = {strip, cell};
  }
  struct TopCell {
    std::size_t strip, cell;
  };
  const TopCell& cell() const { return cell_; }

  /// Chooses a child by the numbers, left or right first.
  std::size_t choose(Lanes means) {
    const Lanes columns = means + lanes_of<2, 3, 0, 1>(means);
    const Lanes left = lanes_of<0, 0, 0, 0>(columns);
    const Lanes x = x_ * (columns + lanes_of<1, 0, 3, 2>(columns));
    const Lanes is_right = _mm_cmpge_ps(x, left);
    const Lanes chosen = _mm_blendv_ps(lanes_of<0, 0, 2, 2>(means), lanes_of<1, 1, 3, 3>(means), is_right);
    const Lanes bottom = lanes_of<0, 0, 0, 0>(chosen);
    const Lanes both = chosen + lanes_of<2, 2, 0, 0>(chosen);
    const Lanes y = y_ * both;
    const Lanes is_top = _mm_cmpge_ps(y, bottom);
    x_ = uniform((x - _mm_and_ps(is_right, left)) / both);
    y_ = uniform((y - _mm_and_ps(is_top, bottom)) /
                 _mm_blendv_ps(bottom, lanes_of<2, 2, 2, 2>(chosen), is_top));
    side_ = side_ * _mm_set1_ps(0.5F);
    corner_ = corner_ + _mm_and_ps(side_, _mm_blend_ps(is_right, is_top, 0b1100));
    return bits(is_right, 1) | bits(is_top, 2);
  }

 private:
  /// Chooses one of four and rescales the number.
  static std::size_t choose_of_four(Lanes masses, Lanes& number) {
    const Lanes pairs = masses + shifted<4>(masses);
    const Lanes ends = pairs + shifted<8>(pairs);
    const Lanes x = number * lanes_of<3, 3, 3, 3>(ends);
    const std::size_t is_beyond = bits(_mm_cmpge_ps(x, ends), 7);
    const int chosen = std::popcount(is_beyond);
    const __m128i lane = _mm_set1_epi32(chosen);
    number = uniform((x - _mm_permutevar_ps(shifted<4>(ends), lane)) / _mm_permutevar_ps(masses, lane));
    return static_cast<std::size_t>(chosen);
  }
  /// Shifts lanes up by some bytes, filling with zeros.
  template <int Bytes>
  static Lanes shifted(Lanes lanes) {
    return _mm_castsi128_ps(_mm_slli_si128(_mm_castps_si128(lanes), Bytes));
  }
  static Lanes uniform(Lanes x) {
    return _mm_min_ps(_mm_max_ps(x, _mm_setzero_ps()), _mm_set1_ps(0x1.fffffep-1F));
  }
  static std::size_t bits(Lanes mask, unsigned number) {
    return static_cast<unsigned>(_mm_movemask_ps(mask)) & number;
  }

  Lanes x_, y_;
  Lanes corner_ = _mm_setzero_ps();  ///< x in the first two lanes, y in the last two
  Lanes side_ = _mm_set1_ps(1);
  TopCell cell_ = {};
};

/// The position of a sample in one tree: at an inner node, within a leaf, or within a part of a leaf that
/// another tree divides further.
class WarpCursor {
 public:
  WarpCursor() = default;
  WarpCursor(const WarpQuad& top, const WarpQuad* quads, float weight, std::size_t cell)
      : quads_(quads), quad_(&top), weight_(_mm_set1_ps(weight)) {
    enter(cell);
  }

  bool is_patch() const { return quad_ == nullptr; }

  /// Returns the patch times the weight of the tree.
  Lanes patch() const { return weight_ * patch_; }
  Lanes child_means() const {
    return weight_ * (is_patch() ? means_of_quarters() : _mm_loadu_ps(quad_->means().data()));
  }

  void enter(std::size_t child) {
    if (is_patch()) {
      patch_ = quarter(child);
    } else if (quad_->is_leaf(child)) {
      patch_ = _mm_loadu_ps(quad_->patch(child).data());
      quad_ = nullptr;
    } else {
      quad_ = quads_ + quad_->children(child);
    }
  }

 private:
  // The mean of a bilinear function is its value in the middle.
  Lanes means_of_quarters() const {
    const Lanes three = _mm_set1_ps(3);
    const Lanes along_x = three * patch_ + lanes_of<1, 0, 3, 2>(patch_);
    return (three * along_x + lanes_of<2, 3, 0, 1>(along_x)) * _mm_set1_ps(1.0F / 16);
  }

  // Each corner of a quarter is half way between a corner of the whole and the corner that both share.
  Lanes quarter(std::size_t child) const {
    const int x = static_cast<int>(child % 2);
    const int y = static_cast<int>(child / 2) * 2;
    const Lanes half = _mm_set1_ps(0.5F);
    const Lanes along_x = half * (patch_ + _mm_permutevar_ps(patch_, _mm_setr_epi32(x, x, x + 2, x + 2)));
    return half * (along_x + _mm_permutevar_ps(along_x, _mm_setr_epi32(y, y + 1, y, y + 1)));
  }

  const WarpQuad* quads_ = nullptr;
  const WarpQuad* quad_ = nullptr;
  Lanes weight_ = _mm_setzero_ps();
  Lanes patch_ = _mm_setzero_ps();
};

/// One of the trees around a view, with its blend weight.
struct WeightedTree {
  const WarpTop* top = nullptr;
  const WarpQuad* quads = nullptr;
  float weight = 0;
};

/// Descends several trees at once, from the top of a column to a sample within a leaf of each, and returns
/// the blend of the leaves.
template <std::size_t Count>
BilinearPatch walk_down(const std::array<WeightedTree, Count>& parts, std::size_t column,
                        WarpDescent& descent) {
  const auto blend = [&](auto means_of) {
    Lanes sum = _mm_setzero_ps();
    for (const WeightedTree& part : parts) {
      sum = sum + _mm_set1_ps(part.weight) * _mm_loadu_ps(means_of(*part.top).data());
    }
    return sum;
  };
  const auto strips = [&](const WarpTop& top) { return top.strip_means[column]; };
  descent.choose_cell(blend(strips), [&](std::size_t strip) {
    return blend([&](const WarpTop& top) { return top.strips[column][strip].means(); });
  });
  std::array<WarpCursor, Count> cursors;
  for (std::size_t i = 0; i < Count; ++i) {
    const WeightedTree& part = parts[i];
    cursors[i] = {part.top->strips[column][descent.cell().strip], part.quads, part.weight,
                  descent.cell().cell};
  }
  const auto is_inside = [](const WarpCursor& cursor) { return cursor.is_patch(); };
  while (!std::all_of(cursors.begin(), cursors.end(), is_inside)) {
    Lanes means = _mm_setzero_ps();
    for (const WarpCursor& cursor : cursors) means = means + cursor.child_means();
    const std::size_t child = descent.choose(means);
    for (WarpCursor& cursor : cursors) cursor.enter(child);
  }
  Lanes sum = _mm_setzero_ps();
  for (const WarpCursor& cursor : cursors) sum = sum + cursor.patch();
  BilinearPatch patch;
  _mm_storeu_ps(patch.data(), sum);
  return patch;
}

/// Returns the tree's value at a point.
inline float value_at(const WarpTop& top, const WarpQuad* quads, const ColumnPoint& point) {
  constexpr int Last = WarpTop::Side - 1;
  Vec2f local = point.local * float(WarpTop::Side);
  const int strip = std::min(static_cast<int>(local.x), Last);
  const int cell = std::min(static_cast<int>(local.y), Last);
  local -= Vec2f(static_cast<float>(strip), static_cast<float>(cell));
  const WarpQuad* quad = &top.strips[point.column][static_cast<std::size_t>(strip)];
  auto node = static_cast<std::size_t>(cell);
  while (!quad->is_leaf(node)) {
    quad = quads + quad->children(node);
    local *= 2;
    const int right = std::min(static_cast<int>(local.x), 1);
    const int upper = std::min(static_cast<int>(local.y), 1);
    local -= Vec2f(static_cast<float>(right), static_cast<float>(upper));
    node = static_cast<std::size_t>(right) + 2 * static_cast<std::size_t>(upper);
  }
  return value_at(quad->patch(node), local);
}

}  // namespace reflectance
