#include "renderer/reflectance/schemes/warp_trees.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "renderer/reflectance/even_points.h"
#include "renderer/reflectance/schemes/turn.h"
#include "renderer/reflectance/schemes/warp_descent.h"

namespace reflectance {
namespace {

/// In the square's radius, in which the views of trees are evenly spaced: that is nearly even in theta, too,
/// and costs no arc. The last view is not at the horizon itself, where f is 0.
constexpr float LastRadius = 0.9996F;  // 89.95 degrees

/// The image of a direction on the other side of the view's plane.
Vec3f mirrored_if(bool is_mirrored, const Vec3f& v) { return is_mirrored ? Vec3f(v.x, -v.y, v.z) : v; }

/// f cos in the columns, for one view.
class Target {
 public:
  Target(const Brdf& brdf, bool is_half, float radius, float phi)
      : brdf_(brdf),
        is_half_(is_half),
        columns_(radius, is_half),
        turn_(std::cos(phi), std::sin(phi)),
        u_(direction_at(radius, phi)) {}

  float at(const ColumnPoint& point, float size) const {
    // At the horizon f cos is 0, or drops to it within no distance at all.
    const float margin = size / 16;
    const float left = point.column == 0 ? margin : 0;
    const float right = point.column == 3 ? margin : 0;
    const float bottom = is_half_ ? 0 : margin;
    const Vec2f inside(std::clamp(point.local.x, left, 1 - right),
                       std::clamp(point.local.y, bottom, 1 - margin));
    const Vec3f v = columns_.direction({point.column, inside});
    if (!is_half_) return value(v);
    // Measured data need not be the same on both sides.
    return (value(v) + value({v.x, -v.y, v.z})) / 2;
  }

  /// Points where the BRDF's own sampler finds light.
  std::vector<ColumnPoint> probes() const {
    constexpr std::uint32_t Count = 128;
    std::vector<ColumnPoint> points;
    for (std::uint32_t i = 0; i < Count; ++i) {
      const auto drawn =
          std::visit([&](const auto& model) { return model.sample(u_, even_point(i)); }, brdf_);
      if (!drawn || !(drawn->direction.z > 0)) continue;
      points.push_back(columns_.point(turn_.to_plane(drawn->direction)));
    }
    return points;
  }

 private:
  float value(const Vec3f& relative) const {
    const Vec3f v = turn_.from_plane(relative);
    const float value = mean(evaluate(brdf_, u_, v)) * v.z;
    return std::isfinite(value) ? std::max(value, 0.0F) : 0.0F;
  }

  const Brdf& brdf_;
  bool is_half_;
  ViewColumns columns_;
  Turn turn_;
  Vec3f u_;
};

}  // namespace

WarpTrees::WarpTrees(const Brdf& brdf, const WarpTreesSettings& settings)
    : settings_(settings), is_isotropic_(!is_anisotropic(brdf)) {
  if (is_isotropic_) settings_.phi_count = 1;
  if (!is_isotropic_) symmetry_ = symmetry_of(brdf);
  std::vector<WarpTree> trees(static_cast<std::size_t>(settings_.theta_count * settings_.phi_count));
  tbb::parallel_for(std::size_t(0), trees.size(), [&](std::size_t i) { trees[i] = make_tree(brdf, i); });
  for (const WarpTree& tree : trees) {
    trees_.push_back({quads_.size(), tree.scale});
    quads_.insert(quads_.end(), tree.quads.begin(), tree.quads.end());
  }
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

WarpTree WarpTrees::make_tree(const Brdf& brdf, std::size_t index) const {
  const auto phi_count = static_cast<std::size_t>(settings_.phi_count);
  const auto row = static_cast<float>(index / phi_count);
  const float radius = settings_.theta_count > 1 ? LastRadius * row * radius_step() : 0.5F;
  const Target target(brdf, is_isotropic_, radius, azimuth(index % phi_count));
  const ColumnFunction function = [&](const ColumnPoint& point, float size) {
    return target.at(point, size);
  };
  // The tree serves the views around its own, too, for which no column is without width.
  const float least = std::min(radius_step(), 1.0F) / 2;
  const ViewColumns columns(std::clamp(radius, least, 1 - least), is_isotropic_);
  return WarpTree::build(function, columns.widths(), target.probes(), settings_.limits);
}

float WarpTrees::radius_step() const {
  return 1 / static_cast<float>(std::max(settings_.theta_count - 1, 1));
}

float WarpTrees::azimuth(std::size_t index) const {
  if (settings_.phi_count == 1) return 0;
  const float period = symmetry_.half_turn ? Pi : 2 * Pi;
  const auto place = static_cast<float>(index);
  const auto count = static_cast<float>(settings_.phi_count);
  return symmetry_.mirror ? period / 2 * place / (count - 1) : period * place / count;
}

WarpTrees::Azimuth WarpTrees::azimuth_of(const Vec3f& u) const {
  Azimuth azimuth;
  if (settings_.phi_count == 1) return azimuth;
  float turns = std::atan2(u.y, u.x) / (symmetry_.half_turn ? Pi : 2 * Pi);
  turns -= std::floor(turns);
  azimuth.is_mirrored = symmetry_.mirror && turns > 0.5F;
  if (azimuth.is_mirrored) turns = 1 - turns;
  const auto count = static_cast<std::size_t>(settings_.phi_count);
  const float place = turns * static_cast<float>(symmetry_.mirror ? 2 * (count - 1) : count);
  azimuth.low = std::min(static_cast<std::size_t>(place), count - 1);
  azimuth.high = symmetry_.mirror ? std::min(azimuth.low + 1, count - 1) : (azimuth.low + 1) % count;
  azimuth.high_share = std::min(place - static_cast<float>(azimuth.low), 1.0F);
  return azimuth;
}

void WarpTrees::add(Blend& blend, std::size_t theta, std::size_t phi, float weight) const {
  const Tree& tree = trees_[theta * static_cast<std::size_t>(settings_.phi_count) + phi];
  const float scaled = weight * tree.scale;
  if (!(scaled > 0)) return;
  const WarpQuad* quads = quads_.data() + tree.first_quad;
  blend.parts[blend.count++] = {quads, scaled};
  const std::array<float, 4> widths = blend.columns.widths();
  for (std::size_t k = 0; k < 4; ++k) blend.masses[k] += scaled * widths[k] * (*quads)[k].mean();
}

WarpTrees::Blend WarpTrees::blend_for(const Vec3f& u) const {
  const float radius = square_radius(u);
  Blend blend{ViewColumns(radius, is_isotropic_)};
  const float row = std::min(radius / LastRadius, 1.0F) * static_cast<float>(settings_.theta_count - 1);
  const auto low_row = static_cast<std::size_t>(row);
  const float high_share = row - static_cast<float>(low_row);
  const Azimuth azimuth = azimuth_of(u);
  blend.is_mirrored = azimuth.is_mirrored;
  for (const std::size_t i : {std::size_t(0), std::size_t(1)}) {
    const float row_share = i == 0 ? 1 - high_share : high_share;
    if (!(row_share > 0)) continue;
    add(blend, low_row + i, azimuth.low, row_share * (1 - azimuth.high_share));
    if (azimuth.high_share > 0) add(blend, low_row + i, azimuth.high, row_share * azimuth.high_share);
  }
  return blend;
}

std::optional<DrawnDirection> WarpTrees::sample(const Vec3f& u, const Vec2f& xi) const {
  if (!(u.z > 0)) return std::nullopt;
  const Blend blend = blend_for(u);
  if (!(blend.mass() > 0)) return std::nullopt;
  WarpDescent descent{xi};
  bool is_mirrored = blend.is_mirrored;
  if (is_isotropic_) {
    // One number for the half space and the place in it, without a jump where they meet.
    is_mirrored = xi.y < 0.5F;
    descent.rest.y = std::min(std::abs(2 * xi.y - 1), 0x1.fffffep-1F);
  }
  descent.choose_column(blend.masses);
  const BilinearPatch patch =
      is_isotropic_ ? walk_down<2>(blend.parts, descent) : walk_down<4>(blend.parts, descent);
  const Vec2f local = warped(patch, descent.rest);
  const float density = value_at(patch, local) / (blend.mass() * Pi);
  const Vec3f v = blend.columns.direction({descent.column, descent.corner + descent.side * local});
  if (!(v.z > 0) || !(density > 0)) return std::nullopt;
  return DrawnDirection{Turn(u).from_plane(mirrored_if(is_mirrored, v)), density};
}

float WarpTrees::density(const Vec3f& u, const Vec3f& v) const {
  if (!(u.z > 0) || !(v.z > 0)) return 0;
  const Blend blend = blend_for(u);
  if (!(blend.mass() > 0)) return 0;
  const ColumnPoint point = blend.columns.point(mirrored_if(blend.is_mirrored, Turn(u).to_plane(v)));
  float sum = 0;
  for (const Part& part : std::span(blend.parts.data(), blend.count)) {
    sum += part.weight * value_at(part.quads, point);
  }
  return sum / (blend.mass() * Pi);
}

std::size_t WarpTrees::bytes() const {
  return sizeof *this + trees_.capacity() * sizeof(Tree) + quads_.capacity() * sizeof(WarpQuad);
}

}  // namespace reflectance
