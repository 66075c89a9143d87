#include "renderer/studies/environment/map_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

#include "renderer/studies/angles.h"
#include "renderer/studies/environment/file.h"

namespace studies {
namespace {

using image::Image;
using reflectance::luminance;
using reflectance::Rgb;

constexpr SphereGrid MostTexels = {2048, 1024};
/// The limit of the rest over the mean luminance.
constexpr double LimitOverMean = 16;
constexpr double SmallestExtent = 4 * Degree;

/// What a texel adds to the irradiance of a surface that faces it, above the limit.
struct BrightTexel {
  int x = 0;
  int y = 0;
  Imath::V3d irradiance;
  double energy = 0;  ///< its luminance
};

double energy_of(std::span<const BrightTexel> texels) {
  double sum = 0;
  for (const BrightTexel& texel : texels) sum += texel.energy;
  return sum;
}

/// Bright texels that become one light.
class Region {
 public:
  Region(std::span<BrightTexel> texels, const SphereGrid& grid)
      : texels_(texels), grid_(grid), energy_(energy_of(texels)) {
    int left = grid.width;
    int right = 0;
    int top = grid.height;
    int bottom = 0;
    for (const BrightTexel& texel : texels) {
      left = std::min(left, texel.x);
      right = std::max(right, texel.x + 1);
      top = std::min(top, texel.y);
      bottom = std::max(bottom, texel.y + 1);
    }
    down_ = (bottom - top) * std::numbers::pi / grid.height;
    // A degree of longitude is shorter towards the poles.
    const double theta = (top + bottom) / 2.0 * std::numbers::pi / grid.height;
    across_ = (right - left) * 2 * std::numbers::pi / grid.width * std::sin(theta);
  }

  double energy() const { return energy_; }
  bool can_be_cut() const { return texels_.size() > 1 && std::max(across_, down_) > SmallestExtent; }

  /// Cuts across the longer side, so that both parts have about half of the energy.
  std::pair<Region, Region> cut() const {
    const bool is_across = across_ > down_;
    std::ranges::sort(texels_, {}, [is_across](const BrightTexel& texel) {
      return is_across ? std::tuple(texel.x, texel.y) : std::tuple(texel.y, texel.x);
    });
    std::size_t count = 0;
    for (double sum = 0; count + 1 < texels_.size() && sum < energy_ / 2; ++count)
      sum += texels_[count].energy;
    count = std::max<std::size_t>(count, 1);
    return {Region(texels_.first(count), grid_), Region(texels_.subspan(count), grid_)};
  }

  reflectance::DistantLight light() const {
    Imath::V3d irradiance(0);
    Imath::V3d centroid(0);
    for (const BrightTexel& texel : texels_) {
      irradiance += texel.irradiance;
      centroid += Imath::V3d(grid_.direction(texel.x + 0.5, texel.y + 0.5)) * texel.energy;
    }
    return {reflectance::Vec3f(centroid.normalized()), Rgb(irradiance)};
  }

 private:
  std::span<BrightTexel> texels_;
  SphereGrid grid_;
  double energy_;
  double across_ = 0;  ///< extents in radians
  double down_ = 0;
};

double mean_luminance(const Image& image, const SphereGrid& grid) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y) {
    double row = 0;
    for (int x = 0; x < image.width; ++x) row += luminance(image.at(x, y));
    sum += row * grid.solid_angle(y, y + 1, 1);
  }
  return sum / (4 * std::numbers::pi);
}

std::vector<BrightTexel> bright_texels(const Image& image, const SphereGrid& grid, float limit) {
  std::vector<BrightTexel> bright;
  for (int y = 0; y < image.height; ++y) {
    const double solid_angle = grid.solid_angle(y, y + 1, 1);
    for (int x = 0; x < image.width; ++x) {
      const Rgb& texel = image.at(x, y);
      if (luminance(texel) <= double(limit)) continue;
      const Rgb excess = texel - below_limit(texel, limit);
      bright.push_back({x, y, Imath::V3d(excess) * solid_angle, luminance(excess) * solid_angle});
    }
  }
  return bright;
}

}  // namespace

Rgb below_limit(const Rgb& radiance, float limit) {
  const double bright = luminance(radiance);
  if (bright <= double(limit)) return radiance;
  return radiance * static_cast<float>(double(limit) / bright);
}

MapLights map_lights(const Image& image, int most_lights) {
  const SphereGrid grid = {image.width, image.height};
  MapLights found;
  found.limit = static_cast<float>(LimitOverMean * mean_luminance(image, grid));
  std::vector<BrightTexel> bright = bright_texels(image, grid, found.limit);
  if (bright.empty() || most_lights < 1) return found;
  std::vector<Region> regions = {Region(bright, grid)};
  while (static_cast<int>(regions.size()) < most_lights) {
    const auto strongest = std::ranges::max_element(
        regions, {}, [](const Region& region) { return region.can_be_cut() ? region.energy() : -1; });
    if (!strongest->can_be_cut()) break;
    const auto [first, second] = strongest->cut();
    *strongest = first;
    regions.push_back(second);
  }
  for (const Region& region : regions) found.lights.push_back(region.light());
  return found;
}

Image reduced_map(Image image) {
  for (Rgb& texel : image.pixels) {
    for (int k = 0; k < 3; ++k) {
      if (!(std::isfinite(texel[k]) && texel[k] >= 0)) texel[k] = 0;
    }
  }
  const SphereGrid grid = {std::min(image.width, MostTexels.width),
                           std::min(image.height, MostTexels.height)};
  if (grid.width == image.width && grid.height == image.height) return image;
  return {grid.width, grid.height, box_filtered(image, grid)};
}

}  // namespace studies
