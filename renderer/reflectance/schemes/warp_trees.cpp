#include "renderer/reflectance/schemes/warp_trees.h"

#include <algorithm>
#include <cmath>

#include "renderer/parallel/loops.h"
#include "renderer/reflectance/halton.h"
#include "renderer/reflectance/schemes/azimuth_rotation.h"
#include "renderer/reflectance/schemes/warp_descent.h"

namespace reflectance {
namespace {

/// The views of trees are evenly spaced in the square's radius: nearly even in theta, too, without an arc
/// function. The last view is not at the horizon itself, where f is 0.
constexpr float LastRadius = 0.9996F;  // 89.95 degrees

/// The minimum number of quads per tree, however many trees there are.
constexpr int LeastQuads = 64;

/// Evaluates f cos in the columns, for one view.
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
    // Measured data may differ on both sides.
    return (value(v) + value({v.x, -v.y, v.z})) / 2;
  }

  /// Returns points where the BRDF's own sampler finds light.
  std::vector<ColumnPoint> probes() const {
    constexpr std::uint32_t Count = 128;
    std::vector<ColumnPoint> points;
    for (std::uint32_t i = 0; i < Count; ++i) {
      const auto drawn =
          std::visit([&](const auto& model) { return model.sample(u_, halton_point(i)); }, brdf_);
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
  AzimuthRotation turn_;
  Vec3f u_;
};

}  // namespace

WarpTrees::WarpTrees(const Brdf& brdf, const WarpTreesSettings& settings)
    : settings_(settings), is_isotropic_(!is_anisotropic(brdf)) {
  if (is_isotropic_) {
    settings_.phi_count = 1;
  } else {
    symmetry_ = symmetry_of(brdf);
    if (settings_.phi_count == 0) settings_.phi_count = phi_count_for(brdf);
    // So many trees no longer fit in the cache: smaller ones are faster at little more variance.
    if (settings_.phi_count > 1) settings_.limits.error *= 3;
  }
  const int count = settings_.theta_count * settings_.phi_count;
  constexpr int MostQuadsOfAll = 1 << 19;  // 16 MB
  settings_.limits.most_quads = std::clamp(MostQuadsOfAll / count, LeastQuads, settings_.limits.most_quads);
  std::vector<WarpTree> trees(static_cast<std::size_t>(count));
  parallel::for_each_index(trees.size(), [&](std::size_t i) { trees[i] = make_tree(brdf, i); });
  for (const WarpTree& tree : trees) {
    tops_.push_back(tree.top);
    first_quads_.push_back(static_cast<std::uint32_t>(quads_.size()));
    quads_.insert(quads_.end(), tree.quads.begin(), tree.quads.end());
  }
  tops_.shrink_to_fit();
  first_quads_.shrink_to_fit();
  quads_.shrink_to_fit();
}

// Tests the symmetries numerically, since a BRDF need not declare them.
WarpTrees::Symmetry WarpTrees::symmetry_of(const Brdf& brdf) {
  constexpr std::uint32_t Trials = 256;
  Symmetry symmetry{true, true};
  for (std::uint32_t i = 0; i < Trials; ++i) {
    const Vec3f u = cosine_direction(halton_point(i).direction);
    const Vec3f v = cosine_direction(halton_point(Trials + i).direction);
    const float value = mean(evaluate(brdf, u, v));
    const auto changes = [&](const Vec3f& factors) {
      return std::abs(mean(evaluate(brdf, u * factors, v * factors)) - value) > 1e-3F * value;
    };
    if (changes({-1, -1, 1})) symmetry.half_turn = false;
    if (changes({1, -1, 1})) symmetry.mirror = false;
  }
  return symmetry;
}

// Measures weights halfway between the azimuths of two trees, where they vary most.
int WarpTrees::phi_count_for(const Brdf& brdf) const {
  constexpr int Most = 16;
  constexpr float MostVariance = 0.06F;
  constexpr std::uint32_t Samples = 512;
  WarpTreesSettings settings = settings_;
  settings.theta_count = 1;
  settings.phi_count = symmetry_.mirror ? Most / 2 + 1 : Most / 2;
  const WarpTrees some(brdf, settings);
  const int gaps = symmetry_.mirror ? settings.phi_count - 1 : settings.phi_count;
  for (int gap = 0; gap < gaps; ++gap) {
    const float step = some.azimuth(1) - some.azimuth(0);
    const Vec3f u = direction_at(0.5F, (static_cast<float>(gap) + 0.5F) * step);
    double sum = 0;
    double squares = 0;
    for (std::uint32_t i = 0; i < Samples; ++i) {
      const auto drawn = some.sample(u, halton_point(i).direction);
      if (!drawn) continue;
      const double weight = mean(evaluate(brdf, u, drawn->direction)) * drawn->direction.z / drawn->pdf;
      sum += weight;
      squares += weight * weight;
    }
    if (squares * Samples > (1 + MostVariance) * sum * sum) return Most;
  }
  return settings.phi_count;
}

WarpTree WarpTrees::make_tree(const Brdf& brdf, std::size_t index) const {
  const auto phi_count = static_cast<std::size_t>(settings_.phi_count);
  const auto row = static_cast<float>(index / phi_count);
  const float radius = settings_.theta_count > 1 ? LastRadius * row * radius_step() : 0.5F;
  const Target target(brdf, is_isotropic_, radius, azimuth(index % phi_count));
  const ColumnFunction function = [&](const ColumnPoint& point, float size) {
    return target.at(point, size);
  };
  // The tree also serves the views around its own, for which no column has zero width.
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
  float turns = angle_of(u.x, u.y) / (symmetry_.half_turn ? Pi : 2 * Pi);
  turns -= std::floor(turns);
  if (symmetry_.mirror) {
    azimuth.side = std::copysign(1.0F, 0.5F - turns);
    turns = 0.5F - std::abs(0.5F - turns);
  }
  const auto count = static_cast<std::size_t>(settings_.phi_count);
  const float place = turns * static_cast<float>(symmetry_.mirror ? 2 * (count - 1) : count);
  const std::size_t last = count - 1;
  azimuth.low = std::min(static_cast<std::size_t>(static_cast<int>(place)), last);
  azimuth.high = azimuth.low < last ? azimuth.low + 1 : (symmetry_.mirror ? last : 0);
  azimuth.high_fraction = std::min(place - static_cast<float>(azimuth.low), 1.0F);
  return azimuth;
}

WeightedTree WarpTrees::part(std::size_t theta, std::size_t phi, float weight) const {
  const std::size_t tree = theta * static_cast<std::size_t>(settings_.phi_count) + phi;
  return {&tops_[tree], quads_.data() + first_quads_[tree], weight};
}

WarpTrees::Blend WarpTrees::blend_for(const Vec3f& u) const {
  const float radius = square_radius(u);
  Blend blend{ViewColumns(radius, is_isotropic_)};
  const int last = settings_.theta_count - 1;
  const float row = std::min(radius / LastRadius, 1.0F) * static_cast<float>(last);
  const int low = static_cast<int>(row);
  const float fraction = row - static_cast<float>(low);
  const auto low_row = static_cast<std::size_t>(low);
  const auto high_row = static_cast<std::size_t>(std::min(low + 1, last));
  if (settings_.phi_count == 1) {
    blend.parts = {part(low_row, 0, 1 - fraction), part(high_row, 0, fraction), part(low_row, 0, 0)};
  } else {
    // The blend is barycentric on one of the two triangles of the four views around it.
    const Azimuth azimuth = azimuth_of(u);
    blend.side = azimuth.side;
    const float across = azimuth.high_fraction;
    const float beyond = fraction + across - 1;
    const std::size_t third_row = beyond > 0 ? high_row : low_row;
    const std::size_t third_azimuth = beyond > 0 ? azimuth.high : azimuth.low;
    blend.parts = {part(high_row, azimuth.low, std::min(fraction, 1 - across)),
                   part(low_row, azimuth.high, std::min(across, 1 - fraction)),
                   part(third_row, third_azimuth, std::abs(beyond))};
  }
  const std::array<float, 4> widths = blend.columns.widths();
  for (const WeightedTree& one : blend.parts) {
    for (std::size_t k = 0; k < 4; ++k) blend.masses[k] += one.weight * widths[k] * one.top->column_means[k];
  }
  return blend;
}

std::optional<SampledDirection> WarpTrees::sample(const Vec3f& u, const Vec2f& xi) const {
  if (!(u.z > 0)) return std::nullopt;
  const Blend blend = blend_for(u);
  if (!(blend.mass() > 0)) return std::nullopt;
  Vec2f rest = xi;
  float side = blend.side;
  if (is_isotropic_) {
    // One number selects the half space and the position in it, continuously where they meet.
    const float both = 2 * xi.y - 1;
    side = std::copysign(1.0F, both);
    rest.y = std::min(std::abs(both), 0x1.fffffep-1F);
  }
  WarpDescent descent(rest);
  const std::size_t column = descent.choose_column(_mm_loadu_ps(blend.masses.data()));
  const auto& [first, second, third] = blend.parts;
  const BilinearPatch patch = settings_.phi_count == 1
                                  ? walk_down<2>({first, second}, column, descent)
                                  : walk_down<3>({first, second, third}, column, descent);
  const Vec2f local = warped(patch, descent.rest());
  const float pdf = value_at(patch, local) / (blend.mass() * Pi);
  const Vec3f v = blend.columns.direction({column, descent.to_column(local)});
  if (!(v.z > 0) || !(pdf > 0)) return std::nullopt;
  return SampledDirection{AzimuthRotation(u).from_plane({v.x, side * v.y, v.z}), pdf};
}

float WarpTrees::pdf(const Vec3f& u, const Vec3f& v) const {
  if (!(u.z > 0) || !(v.z > 0)) return 0;
  const Blend blend = blend_for(u);
  if (!(blend.mass() > 0)) return 0;
  const Vec3f relative = AzimuthRotation(u).to_plane(v);
  const ColumnPoint point = blend.columns.point({relative.x, blend.side * relative.y, relative.z});
  float sum = 0;
  for (const WeightedTree& one : blend.parts) {
    if (one.weight > 0) sum += one.weight * value_at(*one.top, one.quads, point);
  }
  return sum / (blend.mass() * Pi);
}

std::size_t WarpTrees::bytes() const {
  return sizeof *this + tops_.capacity() * sizeof(WarpTop) + first_quads_.capacity() * sizeof(std::uint32_t) +
         quads_.capacity() * sizeof(WarpQuad);
}

}  // namespace reflectance
