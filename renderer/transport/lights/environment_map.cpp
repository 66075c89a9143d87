#include "renderer/transport/lights/environment_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "grf/wording.h"
#include "renderer/reflectance/glsl_functions.h"

namespace transport {
namespace {

using grf::Vec2f;
using grf::Vec3f;
using reflectance::luminance;
using reflectance::Rgb;

/// The part of the mean luminance that compensation removes from each texel's weight.
constexpr double Compensation = 2.0 / 3;
/// The part of a texel's luminance that remains at least.
constexpr double LeastWeight = 0.01;

/// Turns weights into a CDF, whose last value is 1, and returns their sum.
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

/// Works as std::upper_bound, without branches that depend on a random number.
std::size_t first_over(const float* shares, std::size_t count, float xi) {
  const float* from = shares;
  while (count > 1) {
    const std::size_t half = count / 2;
    from += from[half - 1] <= xi ? half : 0;
    count -= half;
  }
  return static_cast<std::size_t>(from - shares) + (count == 1 && *from <= xi ? 1 : 0);
}

/// Returns the same angle from -pi to pi, of one from -2 pi to 2 pi.
double within_half_turn(double angle) {
  constexpr double Turn = 2 * std::numbers::pi;
  constexpr double Half = std::numbers::pi_v<float>;  // float angles may be a little over pi
  return angle > Half ? angle - Turn : angle < -Half ? angle + Turn : angle;
}

/// The position of xi between a CDF value and the previous one, 0..1.
float place_between(float before, float above, float xi) { return (xi - before) / (above - before); }

}  // namespace

EnvironmentMap::EnvironmentMap(image::Image image, float rotation, Weights weights)
    : image_(std::move(image)), longitude_(-std::remainder(double(rotation), 360) * std::numbers::pi / 180) {
  repair();
  build(weights);
}

void EnvironmentMap::repair() {
  for (Rgb& texel : image_.pixels) {
    bool is_wrong = false;
    for (int k = 0; k < 3; ++k) {
      if (std::isfinite(texel[k]) && texel[k] >= 0) continue;
      texel[k] = 0;
      is_wrong = true;
    }
    if (is_wrong) ++invalid_texels_;
  }
}

double EnvironmentMap::solid_angle_of_texel(std::size_t row) const {
  return 2 * std::numbers::pi / image_.width * (cosines_[row] - cosines_[row + 1]);
}

double EnvironmentMap::weight_of(const Rgb& radiance) const {
  const double l = luminance(radiance);
  return std::max(l - removed_, LeastWeight * l);
}

void EnvironmentMap::build(Weights weights) {
  const auto width = static_cast<std::size_t>(image_.width);
  const auto height = static_cast<std::size_t>(image_.height);
  for (std::size_t row = 0; row <= height; ++row) {
    cosines_.push_back(std::cos(std::numbers::pi * double(row) / double(height)));
  }
  for (std::size_t row = 0; row < height; ++row) {
    double sum = 0;
    for (std::size_t x = 0; x < width; ++x) sum += double(luminance(image_.pixels[row * width + x]));
    total_ += sum * solid_angle_of_texel(row);
  }
  if (weights == Weights::Compensated) removed_ = Compensation * total_ / (4 * std::numbers::pi);
  rows_.resize(height);
  lines_across_ = (width + Line::Size - 1) / Line::Size;
  columns_.resize(lines_across_ * height);
  line_ends_.resize(columns_.size());
  std::vector<double> row_weights(lines_across_ * Line::Size);
  std::vector<float> shares(row_weights.size());
  std::vector<double> row_sums(height);
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t x = 0; x < width; ++x) row_weights[x] = weight_of(image_.pixels[row * width + x]);
    row_sums[row] = accumulate(row_weights, shares.data()) * solid_angle_of_texel(row);
    for (std::size_t i = 0; i < lines_across_; ++i) {
      Line& line = columns_[row * lines_across_ + i];
      std::copy_n(shares.begin() + static_cast<std::ptrdiff_t>(i * Line::Size), Line::Size,
                  line.shares.begin());
      line_ends_[row * lines_across_ + i] = line.shares.back();
    }
  }
  total_weight_ = accumulate(row_sums, rows_.data());
  if (!is_black()) warps_ = CosineWarps([this](const Vec2f& xi) { return sample(xi)->direction; });
}

EnvironmentMap::Place EnvironmentMap::place_of(const Vec3f& direction) const {
  // By the arc tangent, because the arc cosine is inaccurate at the poles.
  const float theta =
      reflectance::glsl::atan2(std::sqrt(direction.x * direction.x + direction.z * direction.z), direction.y);
  const double phi =
      within_half_turn(double(reflectance::glsl::atan2(direction.x, -direction.z)) - longitude_);
  const double y = double(theta) / std::numbers::pi * image_.height;
  const double x = (0.5 + phi / (2 * std::numbers::pi)) * image_.width;
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

/// Inverts `sample`: returns the 2D sample of a position.
Vec2f EnvironmentMap::pair_of(const Place& place) const {
  const Line* lines = &columns_[place.row * lines_across_];
  const auto column_share = [&](std::size_t column) {
    return lines[column / Line::Size].shares[column % Line::Size];
  };
  const auto row_share = [&](std::size_t row) { return rows_[row]; };
  const auto between = [](const auto& share, std::size_t index, float inside) {
    const float before = index == 0 ? 0 : share(index - 1);
    return std::clamp(before + (share(index) - before) * inside, 0.0F, 0x1.fffffep-1F);
  };
  return {between(column_share, place.column, place.inside.x), between(row_share, place.row, place.inside.y)};
}

Vec3f EnvironmentMap::direction_in(std::size_t row, std::size_t column, const Vec2f& place) const {
  const double cosine = cosines_[row] + double(place.y) * (cosines_[row + 1] - cosines_[row]);
  const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
  const double phi = within_half_turn(
      2 * std::numbers::pi * ((double(column) + double(place.x)) / image_.width - 0.5) + longitude_);
  if (is_near_border(row, place)) {
    return {static_cast<float>(sine * std::sin(phi)), static_cast<float>(cosine),
            static_cast<float>(-sine * std::cos(phi))};
  }
  const auto rounded = static_cast<float>(phi);
  return {static_cast<float>(sine) * reflectance::glsl::sin(rounded), static_cast<float>(cosine),
          static_cast<float>(-sine) * reflectance::glsl::cos(rounded)};
}

/// False only if a direction at this position in a texel certainly maps back to that texel. The angles of a
/// float direction are accurate to 2e-6.
bool EnvironmentMap::is_near_border(std::size_t row, const Vec2f& place) const {
  const double across = 2e-6 * image_.width / (2 * std::numbers::pi);
  const double down = 2e-6 / (cosines_[row] - cosines_[row + 1]);
  return std::abs(double(place.x) - 0.5) > 0.5 - across || std::abs(double(place.y) - 0.5) > 0.5 - down;
}

/// Prefetches the texels of a line while the search among them goes on.
void EnvironmentMap::prefetch(std::size_t row, std::size_t line) const {
  const auto width = static_cast<std::size_t>(image_.width);
  constexpr std::size_t Step = 5;  // texels per cache line
  const std::size_t end = std::min((line + 1) * Line::Size, width);
  for (std::size_t x = line * Line::Size; x < end; x += Step) {
    __builtin_prefetch(&image_.pixels[row * width + x]);
  }
}

// In each distribution, selects the first CDF value over xi: its probability is not 0, since the value before
// is at most xi.
std::optional<EnvironmentSample> EnvironmentMap::sample(const Vec2f& xi) const {
  if (is_black()) return std::nullopt;
  const std::size_t row = first_over(rows_.data(), rows_.size(), xi.y);
  const float* ends = &line_ends_[row * lines_across_];
  const std::size_t line = first_over(ends, lines_across_, xi.x);
  prefetch(row, line);
  const auto& shares = columns_[row * lines_across_ + line].shares;
  const std::size_t in_line = first_over(shares.data(), shares.size(), xi.x);
  const float before = in_line > 0 ? shares[in_line - 1] : line > 0 ? ends[line - 1] : 0;
  const Vec2f place(place_between(before, shares[in_line], xi.x),
                    place_between(row > 0 ? rows_[row - 1] : 0, rows_[row], xi.y));
  const std::size_t column = line * Line::Size + in_line;
  Vec3f direction = direction_in(row, column, place);
  const std::size_t texel = row * static_cast<std::size_t>(image_.width) + column;
  // Rounding may move a direction across the texel's border. Such a direction is replaced by the texel's
  // centre, so that light next to black is not lost and `radiance` and `pdf` agree with the sample.
  if (is_near_border(row, place) && texel_at(direction) != texel) {
    direction = direction_in(row, column, Vec2f(0.5F));
  }
  const Rgb& radiance = image_.pixels[texel];
  return EnvironmentSample{direction, radiance, pdf_of(radiance)};
}

float EnvironmentMap::pdf(const Vec3f& direction) const { return pdf_of(radiance(direction)); }

float EnvironmentMap::pdf_of(const Rgb& radiance) const {
  return is_black() ? 0 : static_cast<float>(weight_of(radiance) / total_weight_);
}

std::optional<EnvironmentSample> EnvironmentMap::sample(const Vec3f& normal, const Vec2f& xi) const {
  if (is_black()) return std::nullopt;
  const auto [warped, pdf] = warps_.warp(normal, xi);
  auto drawn = sample(warped);
  if (drawn) drawn->pdf *= pdf;
  return drawn;
}

EnvironmentMap::RadianceAndPdf EnvironmentMap::radiance_and_pdf(const Vec3f& normal,
                                                                const Vec3f& direction) const {
  const Place place = place_of(direction);
  const Rgb& radiance = image_.pixels[place.row * static_cast<std::size_t>(image_.width) + place.column];
  if (is_black()) return {radiance, 0};
  return {radiance, pdf_of(radiance) * warps_.pdf(normal, pair_of(place))};
}

std::optional<EnvironmentMap> read_environment_map(const std::string& path, grf::Diagnostics& diagnostics,
                                                   const grf::SourceLocation& asked_for_at,
                                                   const image::ImageReader& image_reader, float rotation,
                                                   EnvironmentMap::Weights weights) {
  auto image = image_reader(path, diagnostics, asked_for_at, image::Alpha::OverBlack);
  if (!image) return std::nullopt;
  EnvironmentMap map(std::move(*image), rotation, weights);
  if (map.invalid_texels() > 0) {
    diagnostics.warning(asked_for_at.file ? asked_for_at : grf::whole_file(path),
                        fmt::format("{} of {} of the environment map {} as 0 there", map.invalid_texels(),
                                    grf::counted(map.image().pixels.size(), "texel", "texels"),
                                    map.invalid_texels() == 1 ? "is negative or not finite, and counts"
                                                              : "are negative or not finite, and count"));
  }
  return map;
}

}  // namespace transport
