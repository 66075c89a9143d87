#include "renderer/reflectance/schemes/rejection_trees.h"

#include <cmath>

#include "renderer/parallel/loops.h"
#include "renderer/reflectance/schemes/azimuth_rotation.h"

namespace reflectance {
namespace {

constexpr int AnisotropicPhis = 16;

Vec3f over_disc(double x, double y) {
  return {static_cast<float>(x), static_cast<float>(y),
          static_cast<float>(std::sqrt(std::max(0.0, 1 - x * x - y * y)))};
}

/// Evaluates f at a point of the disc in the frame of a tree.
float scalar(const Brdf& brdf, const Vec3f& tree_u, const Vec2f& azimuth, double x, double y) {
  const AzimuthRotation turn(azimuth.x, azimuth.y);
  return mean(evaluate(brdf, turn.from_plane(tree_u), turn.from_plane(over_disc(x, y))));
}

/// Returns the centre of the part of a cell inside the disc.
Vec2f middle(const Box& cell) {
  constexpr double Inside = 1 - 1e-6;
  const Box box = inside_disc(cell);
  const double x = (box.x0 + box.x1) / 2;
  const double y = (box.y0 + box.y1) / 2;
  const double radius = std::hypot(x, y);
  const double scale = radius > Inside ? Inside / radius : 1;
  return {static_cast<float>(x * scale), static_cast<float>(y * scale)};
}

}  // namespace

std::vector<float> disc_values(const Brdf& brdf, const Vec3f& plane_u, const Vec2f& azimuth,
                               const DiscGrid& grid) {
  const int resolution = grid.resolution();
  std::vector<float> values(static_cast<std::size_t>(resolution) * resolution);
  parallel::for_each_index(resolution, [&](int y) {
    for (int x = 0; x < resolution; ++x) {
      if (!(grid.area(x, y) > 0)) continue;
      const Vec2f point = middle(DiscGrid::box({x, y, x + 1, y + 1}, resolution));
      values[grid.index(x, y)] = scalar(brdf, plane_u, azimuth, point.x, point.y);
    }
  });
  return values;
}

RejectionTrees::RejectionTrees(const Brdf& brdf, const RejectionSettings& settings)
    : thetas_(settings.thetas), phis_(settings.phis) {
  if (phis_ == 0) phis_ = is_anisotropic(brdf) ? AnisotropicPhis : 1;
  if (!has_nonspecular_part(brdf)) return;
  const DiscGrid grid(settings.resolution);
  trees_.resize(static_cast<std::size_t>(thetas_) * phis_);
  parallel::for_each_index(trees_.size(), [&](std::size_t i) {
    const int theta = static_cast<int>(i) % thetas_;
    const int phi = static_cast<int>(i) / thetas_;
    const std::vector<float> values = disc_values(brdf, view_direction(theta), azimuth(phi), grid);
    trees_[i] = RejectionTree(values, grid, settings.most_tries, settings.keep_table);
  });
}

/// Returns the centre of one of equal intervals of theta, so that the nearest view is at most half a step off
/// and none is at the horizon, where f is 0.
Vec3f RejectionTrees::view_direction(int theta) const {
  const double angle = (theta + 0.5) / thetas_ * (std::numbers::pi / 2);
  return {static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle))};
}

Vec2f RejectionTrees::azimuth(int phi) const {
  const double angle = 2 * std::numbers::pi * phi / phis_;
  return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

std::optional<RejectionTrees::View> RejectionTrees::view_of(const Vec3f& u) const {
  if (!(u.z > 0) || trees_.empty()) return std::nullopt;
  const float radius = std::hypot(u.x, u.y);
  const Vec2f direction = radius > 0 ? Vec2f(u.x / radius, u.y / radius) : Vec2f(1, 0);
  const float theta_steps = std::atan2(radius, u.z) / (Pi / 2) * static_cast<float>(thetas_);
  const float phi_steps = std::atan2(direction.y, direction.x) / (2 * Pi) * static_cast<float>(phis_);
  const int theta = std::min(static_cast<int>(theta_steps), thetas_ - 1);
  const int phi = (static_cast<int>(std::lround(phi_steps)) + phis_) % phis_;
  const RejectionTree& tree = trees_[static_cast<std::size_t>(phi) * thetas_ + theta];
  return View{&tree, view_direction(theta), direction.x, direction.y, azimuth(phi)};
}

float RejectionTrees::value(const Brdf& brdf, const View& view, double x, double y) const {
  const RejectionTree& tree = *view.tree;
  if (tree.has_table()) return tree.at(x, y);
  const Vec2f point = middle(tree.cell_box(x, y));
  return tree.tabulated(scalar(brdf, view.tree_u, view.tree_azimuth, point.x, point.y));
}

std::optional<SampledDirection> RejectionTrees::draw(const Brdf& brdf, const Vec3f& u,
                                                     const Uniforms& xi) const {
  const auto view = view_of(u);
  if (!view) return std::nullopt;
  SplitMix more(xi);
  // The choice has 24 bits, which a deep tree uses up.
  const RejectionTree::Leaf leaf = view->tree->leaf_of(xi.choice + 0x1p-24 * more.next());
  const auto point = draw_point(brdf, *view, leaf, xi.direction, more);
  if (!point) return std::nullopt;
  return drawn(brdf, u, *view, *point);
}

std::vector<SampledDirection> RejectionTrees::draw_many(const Brdf& brdf, const Vec3f& u,
                                                        std::span<const Uniforms> xi) const {
  std::vector<SampledDirection> all;
  const auto view = view_of(u);
  if (!view || xi.empty()) return all;
  all.reserve(xi.size());
  SplitMix more(xi.front());
  std::size_t next = 0;
  view->tree->distribute(static_cast<int>(xi.size()), more, [&](const RejectionTree::Leaf& leaf, int count) {
    for (int i = 0; i < count; ++i) {
      const auto point = draw_point(brdf, *view, leaf, xi[next++].direction, more);
      if (point) all.push_back(drawn(brdf, u, *view, *point));
    }
  });
  return all;
}

std::optional<RejectionTree::Point> RejectionTrees::draw_point(const Brdf& brdf, const View& view,
                                                               const RejectionTree::Leaf& leaf,
                                                               const Vec2f& first, SplitMix& more) const {
  return view.tree->draw(leaf, first, more, [&](double x, double y) { return value(brdf, view, x, y); });
}

/// Returns the sample with the pdf of the direction as rounded, which may be in the next cell.
SampledDirection RejectionTrees::drawn(const Brdf& brdf, const Vec3f& u, const View& view,
                                       const RejectionTree::Point& point) const {
  const Vec3f v = AzimuthRotation(view.cosine, view.sine).from_plane(over_disc(point.x, point.y));
  return {v, pdf(brdf, u, v)};
}

float RejectionTrees::pdf(const Brdf& brdf, const Vec3f& u, const Vec3f& v) const {
  const auto view = view_of(u);
  if (!view || !(v.z > 0)) return 0;
  const Vec3f local = AzimuthRotation(view->cosine, view->sine).to_plane(v);
  return value(brdf, *view, local.x, local.y) * view->tree->pdf_of_one() * v.z;
}

std::size_t RejectionTrees::bytes() const {
  std::size_t sum = sizeof(*this);
  for (const RejectionTree& tree : trees_) sum += tree.bytes();
  return sum;
}

}  // namespace reflectance
