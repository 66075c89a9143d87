#include "renderer/transport/lights/environment_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace transport {
namespace {

using grf::Vec2f;
using grf::Vec3f;
using reflectance::Rgb;

/// Of linear RGB with the primaries of sRGB. In double: three channels near the largest float add up to more.
double luminance(const Rgb& rgb) {
  return 0.2126 * double(rgb.x) + 0.7152 * double(rgb.y) + 0.0722 * double(rgb.z);
}

/// Turns weights into the cumulative shares up to and including each, and gives their sum. The last is 1.
double accumulate(std::span<const double> weights, float* shares) {
  double total = 0;
  for (const double weight : weights) total += weight;
  double sum = 0;
  for (const double weight : weights) {
    sum += weight;
    *shares++ = total > 0 ? static_cast<float>(sum / total) : 1.0F;
  }
  return total;
}

struct Chosen {
  std::size_t index = 0;
  float place = 0;  ///< within it, 0..1
};

/// Entries for about every 16 shares, as a power of 2: then a product with a float is exact.
std::size_t guide_size(std::size_t count) { return std::bit_ceil(std::max<std::size_t>(count / 16, 1)); }

/// For each k in 0..size: the first share over k / size. It keeps the search for a share to a cache line or
/// two (Chen and Asau 1974, "On generating random variates from an empirical distribution").
void guide(const float* shares, std::size_t count, std::uint32_t* guides) {
  const std::size_t size = guide_size(count);
  std::size_t i = 0;
  for (std::size_t k = 0; k <= size; ++k) {
    while (i < count && shares[i] <= static_cast<float>(k) / static_cast<float>(size)) ++i;
    guides[k] = static_cast<std::uint32_t>(i);
  }
}

/// The first whose cumulative share is over xi: its own share is not 0, since the one before is at most xi.
Chosen choose(const float* shares, std::size_t count, const std::uint32_t* guides, float xi) {
  const auto k = static_cast<std::size_t>(xi * static_cast<float>(guide_size(count)));
  const float* above = std::upper_bound(shares + guides[k], shares + guides[k + 1], xi);
  const float before = above == shares ? 0.0F : *(above - 1);
  return {static_cast<std::size_t>(above - shares), (xi - before) / (*above - before)};
}

}  // namespace

EnvironmentMap::EnvironmentMap(Image image) : image_(std::move(image)) {
  repair();
  build();
}

void EnvironmentMap::repair() {
  for (Rgb& texel : image_.pixels) {
    bool is_wrong = false;
    for (int k = 0; k < 3; ++k) {
      if (std::isfinite(texel[k]) && texel[k] >= 0) continue;
      texel[k] = 0;
      is_wrong = true;
    }
    if (is_wrong) ++wrong_texels_;
  }
}

void EnvironmentMap::build() {
  const auto width = static_cast<std::size_t>(image_.width);
  const auto height = static_cast<std::size_t>(image_.height);
  for (std::size_t row = 0; row <= height; ++row) {
    cosines_.push_back(std::cos(std::numbers::pi * double(row) / double(height)));
  }
  rows_.resize(height);
  row_guide_.resize(guide_size(height) + 1);
  column_guides_.resize((guide_size(width) + 1) * height);
  columns_.resize(width * height);
  std::vector<double> luminances(width);
  std::vector<double> row_sums(height);
  for (std::size_t row = 0; row < height; ++row) {
    const double solid_angle = 2 * std::numbers::pi / double(width) * (cosines_[row] - cosines_[row + 1]);
    for (std::size_t x = 0; x < width; ++x) luminances[x] = luminance(image_.pixels[row * width + x]);
    row_sums[row] = accumulate(luminances, &columns_[row * width]) * solid_angle;
    guide(&columns_[row * width], width, &column_guides_[row * (guide_size(width) + 1)]);
  }
  total_ = accumulate(row_sums, rows_.data());
  guide(rows_.data(), height, row_guide_.data());
  if (!is_black()) warps_ = CosineWarps([this](const Vec2f& xi) { return sample(xi)->direction; });
}

EnvironmentMap::Place EnvironmentMap::place_of(const Vec3f& direction) const {
  // By the arc tangent and not the arc cosine, which has few digits at the poles.
  const float theta =
      std::atan2(std::sqrt(direction.x * direction.x + direction.z * direction.z), direction.y);
  const float phi = std::atan2(direction.x, -direction.z);
  const double y = double(theta) / std::numbers::pi * image_.height;
  const double x = (0.5 + double(phi) / (2 * std::numbers::pi)) * image_.width;
  const auto index_of = [](double place, int count) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(place), 0, count - 1));
  };
  Place place;
  place.row = index_of(y, image_.height);
  place.column = index_of(x, image_.width);
  const double across =
      (cosines_[place.row] - double(direction.y)) / (cosines_[place.row] - cosines_[place.row + 1]);
  place.inside = {static_cast<float>(x - double(place.column)), static_cast<float>(across)};
  return place;
}

std::size_t EnvironmentMap::texel_at(const Vec3f& direction) const {
  const Place place = place_of(direction);
  return place.row * static_cast<std::size_t>(image_.width) + place.column;
}

/// The pair of numbers from which `sample` makes a place.
Vec2f EnvironmentMap::pair_of(const Place& place) const {
  const float* columns = &columns_[place.row * static_cast<std::size_t>(image_.width)];
  const auto between = [](const float* shares, std::size_t index, float inside) {
    const float before = index == 0 ? 0 : shares[index - 1];
    return std::clamp(before + (shares[index] - before) * inside, 0.0F, 0x1.fffffep-1F);
  };
  return {between(columns, place.column, place.inside.x), between(rows_.data(), place.row, place.inside.y)};
}

Vec3f EnvironmentMap::direction_in(std::size_t row, std::size_t column, const Vec2f& place) const {
  const double cosine = cosines_[row] + double(place.y) * (cosines_[row + 1] - cosines_[row]);
  const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
  const double phi = 2 * std::numbers::pi * ((double(column) + double(place.x)) / image_.width - 0.5);
  if (is_near_border(row, place)) {
    return {static_cast<float>(sine * std::sin(phi)), static_cast<float>(cosine),
            static_cast<float>(-sine * std::cos(phi))};
  }
  const auto rounded = static_cast<float>(phi);
  return {static_cast<float>(sine) * std::sin(rounded), static_cast<float>(cosine),
          static_cast<float>(-sine) * std::cos(rounded)};
}

/// True unless a direction at this place in a texel is surely found there again. The angles of a direction in
/// float are off by less than 1e-6.
bool EnvironmentMap::is_near_border(std::size_t row, const Vec2f& place) const {
  const double across = 1e-6 * image_.width / (2 * std::numbers::pi);
  const double down = 1e-6 / (cosines_[row] - cosines_[row + 1]);
  return std::abs(double(place.x) - 0.5) > 0.5 - across || std::abs(double(place.y) - 0.5) > 0.5 - down;
}

std::optional<EnvironmentSample> EnvironmentMap::sample(const Vec2f& xi) const {
  if (is_black()) return std::nullopt;
  const auto width = static_cast<std::size_t>(image_.width);
  const Chosen row = choose(rows_.data(), rows_.size(), row_guide_.data(), xi.y);
  const Chosen column =
      choose(&columns_[row.index * width], width, &column_guides_[row.index * (guide_size(width) + 1)], xi.x);
  Vec3f direction = direction_in(row.index, column.index, {column.place, row.place});
  const std::size_t texel = row.index * width + column.index;
  // Rounding may put a direction at the border across it. That one counts as from the middle, so that light
  // beside black is not lost and what is said of a direction is what `radiance` and `density` say.
  if (is_near_border(row.index, {column.place, row.place}) && texel_at(direction) != texel) {
    direction = direction_in(row.index, column.index, Vec2f(0.5F));
  }
  const Rgb& radiance = image_.pixels[texel];
  return EnvironmentSample{direction, radiance, static_cast<float>(luminance(radiance) / total_)};
}

float EnvironmentMap::density(const Vec3f& direction) const {
  return is_black() ? 0 : static_cast<float>(luminance(radiance(direction)) / total_);
}

std::optional<EnvironmentSample> EnvironmentMap::sample(const Vec3f& normal, const Vec2f& xi) const {
  if (is_black()) return std::nullopt;
  const auto [warped, density] = warps_.warp(normal, xi);
  auto drawn = sample(warped);
  if (drawn) drawn->density *= density;
  return drawn;
}

float EnvironmentMap::density(const Vec3f& normal, const Vec3f& direction) const {
  if (is_black()) return 0;
  const Place place = place_of(direction);
  const Rgb& radiance = image_.pixels[place.row * static_cast<std::size_t>(image_.width) + place.column];
  return static_cast<float>(luminance(radiance) / total_) * warps_.density(normal, pair_of(place));
}

std::optional<EnvironmentMap> read_environment_map(const std::string& path, grf::Diagnostics& diagnostics,
                                                   const grf::SourceLocation& asked_for_at) {
  auto image = read_image(path, diagnostics, asked_for_at);
  if (!image) return std::nullopt;
  EnvironmentMap map(std::move(*image));
  if (map.wrong_texels() > 0) {
    diagnostics.warning(
        asked_for_at.file ? asked_for_at : grf::whole_file(path),
        fmt::format(
            "{} of {} texels of the environment map are negative or no finite numbers there, and count "
            "as 0",
            map.wrong_texels(), map.image().pixels.size()));
  }
  return map;
}

}  // namespace transport
