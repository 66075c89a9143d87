#include "renderer/studies/environment/file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <system_error>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "renderer/studies/angles.h"

namespace studies {
namespace {

using image::Image;
using reflectance::Rgb;
using reflectance::Vec3f;
using transport::EnvironmentMap;

/// Returns the means of a row of texels over `count` equal parts of it.
std::vector<Rgb> filtered_row(const Image& image, int row, int count) {
  std::vector<Rgb> means;
  means.reserve(static_cast<std::size_t>(count));
  const double texels_per_part = static_cast<double>(image.width) / count;
  for (int part = 0; part < count; ++part) {
    const double from = part * texels_per_part;
    const double to = from + texels_per_part;
    Imath::V3d sum(0);
    for (int x = static_cast<int>(from); x < image.width && x < to; ++x) {
      const double overlap = std::min(to, x + 1.0) - std::max(from, static_cast<double>(x));
      if (overlap > 0) sum += Imath::V3d(image.at(x, row)) * overlap;
    }
    means.emplace_back(sum / texels_per_part);
  }
  return means;
}

/// Returns a text that differs once a file has changed.
std::string version_of(const std::string& path) {
  std::error_code error;
  const auto bytes = std::filesystem::file_size(path, error);
  const auto time = std::filesystem::last_write_time(path, error);
  return fmt::format("{} {} {}", path, bytes, time.time_since_epoch().count());
}

std::shared_ptr<const FilteredMap> read_filtered(const ToolState::File& file, grf::Diagnostics& diagnostics) {
  auto map = transport::read_environment_map(file.path, diagnostics, file.location);
  if (!map) return nullptr;
  if (map->is_black()) {
    diagnostics.error(
        file.location,
        fmt::format("the environment map '{}' is black: there is nothing to sample", file.path));
    return nullptr;
  }
  return std::make_shared<FilteredMap>(std::move(*map), grf::file_name(file.path));
}

/// Reads a map, unless the cache has it of the same version of the file.
std::shared_ptr<const FilteredMap> cached_map(const ToolState::File& file, StudyCache* cache,
                                              grf::Diagnostics& diagnostics) {
  const std::string key = "map " + version_of(file.path);
  if (auto known = cache != nullptr ? cache->find<FilteredMap>(key) : nullptr) return known;
  auto map = read_filtered(file, diagnostics);
  // Reading a map with invalid texels again repeats the warning of them.
  if (cache != nullptr && map && map->map.invalid_texels() == 0)
    cache->keep(key, map, map->map.image().pixels.size() * sizeof(Rgb));
  return map;
}

}  // namespace

Vec3f map_direction(double across, double down) {
  const double theta = std::numbers::pi * down;
  const double phi = 2 * std::numbers::pi * (across - 0.5);
  return Vec3f(
      Imath::V3d(std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)));
}

MapPosition map_position(const Vec3f& direction) {
  const double x = direction.x;
  const double z = direction.z;
  return {0.5 + std::atan2(x, -z) / (2 * std::numbers::pi),
          std::atan2(std::hypot(x, z), double(direction.y)) / std::numbers::pi};
}

double SphereGrid::solid_angle(double top, double bottom, double across) const {
  const double row = std::numbers::pi / height;
  return 2 * std::numbers::pi * across / width * (std::cos(top * row) - std::cos(bottom * row));
}

std::size_t SphereGrid::index_of(const Vec3f& direction) const {
  const MapPosition at = map_position(direction);
  const int x = std::clamp(static_cast<int>(at.across * width), 0, width - 1);
  const int y = std::clamp(static_cast<int>(at.down * height), 0, height - 1);
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

std::vector<Rgb> box_filtered(const Image& image, const SphereGrid& grid) {
  std::vector<Imath::V3d> sums(grid.size(), Imath::V3d(0));
  const auto height_at = [](double row, int rows) { return std::cos(std::numbers::pi * row / rows); };
  for (int row = 0; row < image.height; ++row) {
    const std::vector<Rgb> means = filtered_row(image, row, grid.width);
    const double top = height_at(row, image.height);
    const double bottom = height_at(row + 1, image.height);
    const double rows_per_texel = static_cast<double>(grid.height) / image.height;
    const int last = std::min(grid.height - 1, static_cast<int>((row + 1) * rows_per_texel));
    for (int y = static_cast<int>(row * rows_per_texel); y <= last; ++y) {
      const double cell_top = height_at(y, grid.height);
      const double cell_bottom = height_at(y + 1, grid.height);
      const double overlap = std::min(top, cell_top) - std::max(bottom, cell_bottom);
      if (!(overlap > 0)) continue;
      const double share = overlap / (cell_top - cell_bottom);
      const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width);
      for (std::size_t x = 0; x < means.size(); ++x) sums[first + x] += Imath::V3d(means[x]) * share;
    }
  }
  return {sums.begin(), sums.end()};
}

FilteredMap::FilteredMap(EnvironmentMap of, std::string called)
    : map(std::move(of)), cells(box_filtered(map.image(), Grid)), name(std::move(called)) {}

Image built_in_sky() {
  constexpr SphereGrid Texels = {512, 256};
  const Vec3f sun = map_direction(0.5 + 30.0 / 360, (90.0 - 35.0) / 180);
  const double edge = std::cos(3 * Degree);
  Image image{Texels.width, Texels.height, {}};
  image.pixels.reserve(Texels.size());
  for (int y = 0; y < Texels.height; ++y) {
    for (int x = 0; x < Texels.width; ++x) {
      const Vec3f direction = Texels.direction(x + 0.5, y + 0.5);
      const float haze = std::pow(1 - std::abs(direction.y), 3.0F);
      const float glow = 1.5F * std::pow(std::max(0.0F, direction.dot(sun)), 60.0F);
      Rgb radiance = direction.y > 0 ? Rgb(0.16F, 0.3F, 0.6F) * (1 - haze) + Rgb(0.8F, 0.85F, 0.9F) * haze +
                                           Rgb(1, 0.9F, 0.7F) * glow
                                     : Rgb(0.1F, 0.085F, 0.07F) * (1 + haze);
      if (double(direction.dot(sun)) > edge) radiance = Rgb(150, 135, 110);
      image.pixels.push_back(radiance);
    }
  }
  return image;
}

std::shared_ptr<const FilteredMap> open_environment(const ToolState& state, StudyCache* cache,
                                                    grf::Diagnostics& diagnostics) {
  if (state.files.size() > 1) {
    diagnostics.error(state.files[1].location,
                      fmt::format("'{}' shows one environment map, and the state has {} files",
                                  state.settings.keyword, state.files.size()));
    return nullptr;
  }
  if (!state.files.empty()) return cached_map(state.files.front(), cache, diagnostics);
  static const auto sky =
      std::make_shared<const FilteredMap>(EnvironmentMap(built_in_sky()), "the built-in sky");
  return sky;
}

}  // namespace studies
