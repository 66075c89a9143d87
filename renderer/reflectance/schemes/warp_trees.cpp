#include "renderer/reflectance/schemes/warp_trees.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "renderer/reflectance/even_points.h"

namespace reflectance {
namespace {

/// The trees' views are evenly spaced in this, sin(theta/2), which is nearly so in theta and costs no arc.
/// The last is not at the horizon itself, where f is 0.
float view_coordinate(const Vec3f& u) {
  constexpr float Last = 0.7068F;  // 89.95 degrees
  return std::min(std::sqrt((u.x * u.x + u.y * u.y) / (2 + 2 * u.z)) / Last, 1.0F);
}
Vec3f view(float coordinate, float phi) {
  constexpr float Last = 0.7068F;
  const float half_sine = coordinate * Last;
  return from_angles(1 - 2 * half_sine * half_sine, 2 * half_sine * std::sqrt(1 - half_sine * half_sine),
                     phi);
}

/// The direction that a point of the square [-1,1]^2 stands for.
Vec3f to_hemisphere(float a, float b) {
  const bool wide = std::abs(a) > std::abs(b);
  const float radius = wide ? a : b;
  const float angle = radius != 0 ? Pi / 4 * ((wide ? b : a) / radius) : 0.0F;
  const float sine = std::sin(angle);
  const float cosine = std::cos(angle);
  // 1 - radius^2 is cos(theta) in Lambert's projection, radius sqrt(2 - radius^2) the sine.
  const float length = radius * std::sqrt(2 - radius * radius);
  const float z = (1 - radius) * (1 + radius);
  return wide ? Vec3f(length * cosine, length * sine, z) : Vec3f(length * sine, length * cosine, z);
}

/// The point of the square that stands for a direction.
Vec2f to_square(const Vec3f& v) {
  const float x = std::abs(v.x);
  const float y = std::abs(v.y);
  const float larger = std::max(x, y);
  if (!(larger > 0)) return {0, 0};
  // 1 - z by way of the sine, which has its digits near the normal.
  const float radius = std::sqrt((v.x * v.x + v.y * v.y) / (1 + v.z));
  const float other = radius * (4 / Pi) * std::atan(std::min(x, y) / larger);
  const float a = std::copysign(x >= y ? radius : other, v.x);
  const float b = std::copysign(x >= y ? other : radius, v.y);
  return {a, b};
}

/// The point of the trees' unit square, and back. Of an isotropic BRDF the half with y > 0 is stored.
Vec2f to_tree(const Vec3f& v, bool is_half) {
  const Vec2f square = to_square(v);
  return {(square.x + 1) / 2, is_half ? std::abs(square.y) : (square.y + 1) / 2};
}
Vec3f from_tree(const Vec2f& point, bool is_half) {
  return to_hemisphere(2 * point.x - 1, is_half ? point.y : 2 * point.y - 1);
}

Vec3f turned(const Vec3f& v, float cosine, float sine) {
  return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
}

/// f cos over the tree's square, for one view.
class Target {
 public:
  Target(const Brdf& brdf, bool is_half, const Vec3f& u, float phi)
      : brdf_(brdf), is_half_(is_half), phi_(phi), u_(u) {}

  float at(const Vec2f& point, float size) const {
    // At the horizon f cos is 0, or drops to it within no distance at all.
    const float margin = size / 16;
    const float low = is_half_ ? 0 : margin;
    const Vec3f v =
        from_tree({std::clamp(point.x, margin, 1 - margin), std::clamp(point.y, low, 1 - margin)}, is_half_);
    if (!is_half_) return value(v);
    // Measured data need not be the same on both sides.
    return (value(v) + value({v.x, -v.y, v.z})) / 2;
  }

  /// Points where the BRDF's own sampler finds light.
  std::vector<Vec2f> probes() const {
    constexpr std::uint32_t Count = 128;
    std::vector<Vec2f> points;
    for (std::uint32_t i = 0; i < Count; ++i) {
      const auto drawn =
          std::visit([&](const auto& model) { return model.sample(u_, even_point(i)); }, brdf_);
      if (drawn && drawn->direction.z > 0) points.push_back(to_tree(turned_back(drawn->direction), is_half_));
    }
    return points;
  }

 private:
  float value(const Vec3f& relative) const {
    const float value =
        mean(evaluate(brdf_, u_, turned(relative, std::cos(phi_), std::sin(phi_)))) * relative.z;
    return std::isfinite(value) ? std::max(value, 0.0F) : 0.0F;
  }
  Vec3f turned_back(const Vec3f& v) const { return turned(v, std::cos(phi_), -std::sin(phi_)); }

  const Brdf& brdf_;
  bool is_half_;
  float phi_;
  Vec3f u_;
};

/// Where a sample is in one tree: at an inner node, or within a leaf, or within a part of a leaf that another
/// tree divides further.
class Cursor {
 public:
  Cursor() = default;
  Cursor(const WarpQuad* quads, float weight) : quads_(quads), quad_(quads), weight_(weight) {}

  bool is_patch() const { return quad_ == nullptr; }
  const BilinearPatch& patch() const { return patch_; }
  float weight() const { return weight_; }

  void add_child_means(BilinearPatch& sums) const {
    if (!is_patch()) {
      for (std::size_t k = 0; k < 4; ++k) sums[k] += weight_ * (*quad_)[k].mean();
      return;
    }
    // The mean of a bilinear function is its value in the middle.
    const auto& [p, q, r, s] = patch_;
    const float sixteenth = weight_ / 16;
    sums[0] += sixteenth * (9 * p + 3 * q + 3 * r + s);
    sums[1] += sixteenth * (3 * p + 9 * q + r + 3 * s);
    sums[2] += sixteenth * (3 * p + q + 9 * r + 3 * s);
    sums[3] += sixteenth * (p + 3 * q + 3 * r + 9 * s);
  }

  void enter(std::size_t child) {
    if (!is_patch()) {
      const WarpNode& node = (*quad_)[child];
      quad_ = node.is_leaf() ? nullptr : quads_ + node.children();
      if (node.is_leaf()) patch_ = node.patch();
      return;
    }
    const Vec2f low(child % 2 == 0 ? 0.0F : 0.5F, child < 2 ? 0.0F : 0.5F);
    const Vec2f high = low + Vec2f(0.5F);
    patch_ = {value_at(patch_, low), value_at(patch_, {high.x, low.y}), value_at(patch_, {low.x, high.y}),
              value_at(patch_, high)};
  }

 private:
  const WarpQuad* quads_ = nullptr;
  const WarpQuad* quad_ = nullptr;
  float weight_ = 0;
  BilinearPatch patch_ = {};
};

/// A sample on its way down: the pair of numbers, of which each level uses up a part, and the square that it
/// is in.
struct Descent {
  Vec2f rest;
  Vec2f corner = Vec2f(0);
  float side = 1;

  /// The child that the numbers choose, column first. Without branches, which no processor could predict.
  std::size_t choose(const BilinearPatch& means) {
    const float left = means[0] + means[2];
    const float both = left + means[1] + means[3];
    const float x = rest.x * both;
    const std::size_t right = x >= left ? 1 : 0;
    const float column = right != 0 ? both - left : left;
    rest.x = uniform((x - (right != 0 ? left : 0)) / column);
    const float bottom = means[right];
    const float y = rest.y * column;
    const std::size_t top = y >= bottom ? 1 : 0;
    rest.y = uniform((y - (top != 0 ? bottom : 0)) / (top != 0 ? column - bottom : bottom));
    side /= 2;
    corner += side * Vec2f(static_cast<float>(right), static_cast<float>(top));
    return right + 2 * top;
  }

 private:
  static float uniform(float x) { return std::clamp(x, 0.0F, 0x1.fffffep-1F); }
};

/// Walks down several trees at once to where all are within a leaf, and gives the blend of the leaves. A
/// number that the compiler knows, because this is where the time of a sample goes.
template <std::size_t Count, class Parts>
BilinearPatch walk_down(const Parts& parts, Descent& descent) {
  std::array<Cursor, Count> cursors;
  for (std::size_t i = 0; i < Count; ++i) cursors[i] = {parts[i].quads, parts[i].weight};
  const auto is_inside = [](const Cursor& cursor) { return cursor.is_patch(); };
  while (!std::all_of(cursors.begin(), cursors.end(), is_inside)) {
    BilinearPatch means = {};
    for (const Cursor& cursor : cursors) cursor.add_child_means(means);
    const std::size_t child = descent.choose(means);
    for (Cursor& cursor : cursors) cursor.enter(child);
  }
  BilinearPatch patch = {};
  for (const Cursor& cursor : cursors) {
    for (std::size_t k = 0; k < 4; ++k) patch[k] += cursor.weight() * cursor.patch()[k];
  }
  return patch;
}

}  // namespace

WarpTrees::WarpTrees(const Brdf& brdf, const WarpTreesSettings& settings)
    : settings_(settings), is_isotropic_(!is_anisotropic(brdf)) {
  if (is_isotropic_) settings_.phi_count = 1;
  if (!is_isotropic_) symmetry_ = symmetry_of(brdf);
  const auto columns = static_cast<std::size_t>(settings_.phi_count);
  const std::size_t count = static_cast<std::size_t>(settings_.theta_count) * columns;
  std::vector<WarpTree> trees(count);
  tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
    const auto row = static_cast<float>(i / columns);
    const float phi = azimuth(i % columns);
    const float place =
        settings_.theta_count == 1 ? 0.5F : row / static_cast<float>(settings_.theta_count - 1);
    const Target target(brdf, is_isotropic_, view(place, phi), phi);
    const SquareFunction function = [&](const Vec2f& point, float size) { return target.at(point, size); };
    trees[i] = WarpTree::build(function, target.probes(), settings_.limits);
  });
  for (const WarpTree& tree : trees) append(tree);
  quads_.shrink_to_fit();
}

// By trial: a BRDF need not know.
WarpTrees::Symmetry WarpTrees::symmetry_of(const Brdf& brdf) {
  constexpr std::uint32_t Trials = 256;
  Symmetry symmetry{true, true};
  for (std::uint32_t i = 0; i < Trials; ++i) {
    const Vec3f u = cosine_direction(even_point(i).direction);
    const Vec3f v = cosine_direction(even_point(Trials + i).direction);
    const float value = mean(evaluate(brdf, u, v));
    const auto changes = [&](const Vec3f& factors) {
      return std::abs(mean(evaluate(brdf, u * factors, v * factors)) - value) > 1e-3F * value;
    };
    if (changes({-1, -1, 1})) symmetry.half_turn = false;
    if (changes({1, -1, 1})) symmetry.mirror = false;
  }
  return symmetry;
}

float WarpTrees::azimuth(std::size_t column) const {
  if (settings_.phi_count == 1) return 0;
  const float period = symmetry_.half_turn ? Pi : 2 * Pi;
  const auto place = static_cast<float>(column);
  const auto count = static_cast<float>(settings_.phi_count);
  return symmetry_.mirror ? period / 2 * place / (count - 1) : period * place / count;
}

WarpTrees::Column WarpTrees::column_of(const Vec3f& u) const {
  if (settings_.phi_count == 1) return {};
  const float period = symmetry_.half_turn ? Pi : 2 * Pi;
  float turns = std::atan2(u.y, u.x) / period;
  turns -= std::floor(turns);
  Column column;
  column.is_mirrored = symmetry_.mirror && turns > 0.5F;
  if (column.is_mirrored) turns = 1 - turns;
  const auto count = static_cast<std::size_t>(settings_.phi_count);
  const float place =
      symmetry_.mirror ? 2 * turns * static_cast<float>(count - 1) : turns * static_cast<float>(count);
  column.low = std::min(static_cast<std::size_t>(place), count - 1);
  column.high = symmetry_.mirror ? std::min(column.low + 1, count - 1) : (column.low + 1) % count;
  column.high_share = std::min(place - static_cast<float>(column.low), 1.0F);
  return column;
}

void WarpTrees::append(const WarpTree& tree) {
  Tree entry{quads_.size(), tree.scale, 0};
  if (tree.scale > 0) {
    for (const WarpNode& child : tree.quads.front()) entry.mean += child.mean() / 4;
  }
  trees_.push_back(entry);
  quads_.insert(quads_.end(), tree.quads.begin(), tree.quads.end());
}

std::size_t WarpTrees::bytes() const {
  return sizeof *this + trees_.capacity() * sizeof(Tree) + quads_.capacity() * sizeof(WarpQuad);
}

void WarpTrees::add(Blend& blend, std::size_t theta, std::size_t phi, float weight) const {
  const Tree& tree = trees_[theta * static_cast<std::size_t>(settings_.phi_count) + phi];
  const float scaled = weight * tree.scale;
  if (!(scaled > 0)) return;
  blend.parts[blend.count++] = {quads_.data() + tree.first_quad, scaled};
  blend.mean += scaled * tree.mean;
}

WarpTrees::Blend WarpTrees::blend_for(const Vec3f& u) const {
  Blend blend;
  const float last_row = static_cast<float>(settings_.theta_count - 1);
  const float row = view_coordinate(u) * last_row;
  const auto low_row = static_cast<std::size_t>(row);
  const float high_share = row - static_cast<float>(low_row);
  const Column column = column_of(u);
  blend.is_mirrored = column.is_mirrored;
  for (const std::size_t i : {std::size_t(0), std::size_t(1)}) {
    const float row_share = i == 0 ? 1 - high_share : high_share;
    if (!(row_share > 0)) continue;
    add(blend, low_row + i, column.low, row_share * (1 - column.high_share));
    if (column.high_share > 0) add(blend, low_row + i, column.high, row_share * column.high_share);
  }
  return blend;
}

std::optional<DrawnDirection> WarpTrees::sample(const Vec3f& u, const Vec2f& xi) const {
  const Blend blend = blend_for(u);
  if (!(blend.mean > 0)) return std::nullopt;
  Descent descent{xi};
  bool is_left = false;
  if (is_isotropic_) {
    is_left = xi.y < 0.5F;
    descent.rest.y = std::min(is_left ? 1 - 2 * xi.y : 2 * xi.y - 1, 0x1.fffffep-1F);
  }
  const BilinearPatch patch =
      is_isotropic_ ? walk_down<2>(blend.parts, descent) : walk_down<4>(blend.parts, descent);
  const Vec2f local = warped(patch, descent.rest);
  const float density = value_at(patch, local) / (blend.mean * 2 * Pi);
  Vec3f v = from_tree(descent.corner + descent.side * local, is_isotropic_);
  if (is_left != blend.is_mirrored) v.y = -v.y;
  if (!(v.z > 0) || !(density > 0)) return std::nullopt;
  const float sine = std::sqrt(u.x * u.x + u.y * u.y);
  return DrawnDirection{sine > 0 ? turned(v, u.x / sine, u.y / sine) : v, density};
}

float WarpTrees::density(const Vec3f& u, const Vec3f& v) const {
  if (!(v.z > 0)) return 0;
  const Blend blend = blend_for(u);
  if (!(blend.mean > 0)) return 0;
  const float sine = std::sqrt(u.x * u.x + u.y * u.y);
  const Vec3f relative = sine > 0 ? turned(v, u.x / sine, -u.y / sine) : v;
  const Vec2f point =
      to_tree(blend.is_mirrored ? Vec3f(relative.x, -relative.y, relative.z) : relative, is_isotropic_);
  float sum = 0;
  for (const Part& part : blend.all()) {
    Vec2f local = point;
    const WarpQuad* quad = part.quads;
    for (;;) {
      local *= 2;
      const bool right = local.x >= 1;
      const bool top = local.y >= 1;
      local -= Vec2f(right ? 1 : 0, top ? 1 : 0);
      const WarpNode& node = (*quad)[(right ? 1U : 0U) + (top ? 2U : 0U)];
      if (node.is_leaf()) {
        sum += part.weight * value_at(node.patch(), local);
        break;
      }
      quad = part.quads + node.children();
    }
  }
  return sum / (blend.mean * 2 * Pi);
}

}  // namespace reflectance
