#include "renderer/plot/colour_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace plot {
namespace {

constexpr std::array<std::uint32_t, 9> Colours = {0xffffd9, 0xedf8b1, 0xc7e9b4, 0x7fcdbb, 0x41b6c4,
                                                  0x1d91c0, 0x225ea8, 0x253494, 0x081d58};
constexpr std::array<std::uint32_t, 9> DivergingColours = {0x2166ac, 0x4393c3, 0x92c5de, 0xd1e5f0, 0xf7f7f7,
                                                           0xfddbc7, 0xf4a582, 0xd6604d, 0xb2182b};

grf::Colour decoded(std::uint32_t rgb) {
  const auto channel = [rgb](unsigned shift) { return static_cast<float>((rgb >> shift) & 0xffU) / 255; };
  return {channel(16), channel(8), channel(0)};
}

/// Interpolates a palette at a fraction from 0 to 1.
grf::Colour interpolated(std::span<const std::uint32_t> colours, double fraction) {
  const double place = fraction * static_cast<double>(colours.size() - 1);
  const auto index = std::min(static_cast<std::size_t>(place), colours.size() - 2);
  const auto rest = static_cast<float>(place - static_cast<double>(index));
  return decoded(colours[index]) * (1 - rest) + decoded(colours[index + 1]) * rest;
}

constexpr std::array<double, 4> RoundFactors = {1, 2, 5, 10};
constexpr double Slack = 1e-6;  // of a value that is round already

double rounded_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  return power * *std::find_if(RoundFactors.begin(), RoundFactors.end(), [&](double factor) {
           return factor == 10 || value <= factor * power * (1 + Slack);
         });
}

double rounded_down(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  return power * *std::find_if(RoundFactors.rbegin(), RoundFactors.rend(), [&](double factor) {
           return factor == 1 || value >= factor * power * (1 - Slack);
         });
}

/// Formats a tick as `5e-4` or `0.02`.
std::string tick_label(double value) {
  if (value >= 0.01 * (1 - Slack) && value < 1e4) return fmt::format("{:.4g}", value);
  const double exponent = std::floor(std::log10(value) + Slack);
  return fmt::format("{:.0f}e{:.0f}", value / std::pow(10, exponent), exponent);
}

/// Returns powers of ten, and 2 and 5 times those if they are few.
std::vector<double> ticks_of(const ColourScale& scale) {
  constexpr double FewPowers = 101;
  std::vector<double> ticks;
  for (double power = std::floor(std::log10(scale.lowest()) - Slack);
       std::pow(10, power) <= scale.highest() * (1 + Slack); ++power) {
    for (const double factor : {1, 2, 5}) {
      const double tick = factor * std::pow(10, power);
      const bool is_in = tick >= scale.lowest() * (1 - Slack) && tick <= scale.highest() * (1 + Slack);
      if (is_in && (factor == 1 || scale.highest() < FewPowers * scale.lowest())) ticks.push_back(tick);
    }
  }
  return ticks;
}

/// Draws a vertical bar of the colours at fractions of its height, from below.
template <class ColourAt>
void draw_bar(ColourAt colour_at, const Rectangle& place, Svg& svg) {
  constexpr int Strips = 64;
  const double height = place.height / Strips;
  const double bottom = place.corner.y + place.height;
  for (int i = 0; i < Strips; ++i) {
    // Strips overlap the next, so that no seam shows.
    const double overlap = i + 1 < Strips ? height / 2 : 0;
    svg.rectangle({place.corner.x, bottom - (i + 1) * height - overlap}, place.width, height + overlap,
                  hexadecimal(colour_at((i + 0.5) / Strips)));
  }
}

void draw_tick(double fraction, const std::string& label, const Rectangle& place, Svg& svg) {
  const double x = place.corner.x + place.width;
  const double y = place.corner.y + place.height * (1 - fraction);
  svg.line({x, y}, {x + 4, y}, {"#888", 1});
  svg.text({x + 7, y + 4}, label, {11, "#333", Anchor::Start, 0});
}

}  // namespace

ColourScale::ColourScale(double least, double largest) {
  constexpr double LeastRange = 10;
  constexpr double MostRange = 1e4;
  if (!(largest > 0) || !std::isfinite(largest)) return;
  highest_ = rounded_up(largest);
  lowest_ = std::clamp(least > 0 ? rounded_down(least) : 0, highest_ / MostRange, highest_ / LeastRange);
}

grf::Colour ColourScale::colour(double value) const {
  const double range = std::log(highest_ / lowest_);
  const double fraction = std::clamp(std::log(std::max(value, lowest_) / lowest_) / range, 0.0, 1.0);
  return interpolated(Colours, fraction);
}

LinearColourScale::LinearColourScale(double lowest, double highest, Palette palette)
    : lowest_(lowest), highest_(highest), palette_(palette) {}

grf::Colour LinearColourScale::colour(double value) const {
  const double fraction =
      highest_ > lowest_ ? std::clamp((value - lowest_) / (highest_ - lowest_), 0.0, 1.0) : 0.0;
  const std::span<const std::uint32_t> colours = palette_ == Palette::Diverging ? DivergingColours : Colours;
  return interpolated(colours, fraction);
}

void draw(const ColourScale& scale, const Rectangle& place, Svg& svg) {
  const double range = std::log(scale.highest() / scale.lowest());
  draw_bar([&](double fraction) { return scale.colour(scale.lowest() * std::exp(range * fraction)); }, place,
           svg);
  for (const double tick : ticks_of(scale))
    draw_tick(std::log(tick / scale.lowest()) / range, tick_label(tick), place, svg);
}

void draw(const LinearColourScale& scale, const Rectangle& place, Svg& svg) {
  constexpr int Steps = 4;
  const auto value = [&](double fraction) {
    return scale.lowest() + (scale.highest() - scale.lowest()) * fraction;
  };
  draw_bar([&](double fraction) { return scale.colour(value(fraction)); }, place, svg);
  for (int i = 0; i <= Steps; ++i) {
    const double fraction = static_cast<double>(i) / Steps;
    draw_tick(fraction, fmt::format("{:.3g}", value(fraction)), place, svg);
  }
}

}  // namespace plot
