#include "editor/image/screen_colours.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "editor/jobs/parallel_rows.h"
#include "grf/srgb.h"
#include "renderer/reflectance/geometry.h"

namespace editor {
namespace {

using grf::Colour;

/// Floats with the same upper half differ by less than 1 %.
constexpr unsigned TableShift = 16;

double mapped(ToneCurve curve, double x) {
  switch (curve) {
    case ToneCurve::Srgb:
      break;
    case ToneCurve::Filmic:
      x = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
      break;
    case ToneCurve::Reinhard:
      x = x / (1 + x);
      break;
  }
  return grf::srgb_encoded(std::min(x, 1.0));
}

const ByteCurve& byte_curve(ToneCurve curve) {
  static const std::array curves = {ByteCurve(ToneCurve::Srgb), ByteCurve(ToneCurve::Filmic),
                                    ByteCurve(ToneCurve::Reinhard)};
  return curves[static_cast<std::size_t>(curve)];
}

int byte_of(float encoded_value) {
  return static_cast<int>(std::lround(255 * std::clamp(encoded_value, 0.0F, 1.0F)));
}

Colour mean_of(const image::Image& image, const QRect& block) {
  Colour sum(0);
  for (int y = block.top(); y <= block.bottom(); ++y) {
    const Colour* row = &image.at(block.left(), y);
    for (int x = 0; x < block.width(); ++x) sum += row[x];
  }
  return sum / static_cast<float>(block.width() * block.height());
}

}  // namespace

ByteCurve::ByteCurve(ToneCurve curve) {
  // The bit patterns of positive floats are ordered: the first float of each byte is found by bisection.
  const auto reaches = [curve](std::uint32_t bits, int byte) {
    return 255 * mapped(curve, std::bit_cast<float>(bits)) >= byte - 0.5;
  };
  std::uint32_t low = 0;
  for (int byte = 1; byte < 256; ++byte) {
    std::uint32_t high = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::max());
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      (reaches(middle, byte) ? high : low) = middle;
    }
    thresholds_[static_cast<std::size_t>(byte)] = std::bit_cast<float>(high);
  }
  thresholds_[256] = std::numeric_limits<float>::infinity();
  first_ = std::bit_cast<std::uint32_t>(thresholds_[1]) >> TableShift;
  const std::uint32_t last = std::bit_cast<std::uint32_t>(thresholds_[255]) >> TableShift;
  for (std::uint32_t upper = first_; upper <= last; ++upper) {
    const auto value = std::bit_cast<float>(upper << TableShift);
    const auto above = std::upper_bound(thresholds_.begin() + 1, thresholds_.end(), value);
    starts_.push_back(static_cast<std::uint8_t>(above - thresholds_.begin() - 1));
  }
}

std::uint8_t ByteCurve::operator()(float linear) const {
  if (!(linear >= thresholds_[1])) return 0;
  const std::uint32_t index = (std::bit_cast<std::uint32_t>(linear) >> TableShift) - first_;
  if (index >= starts_.size()) return 255;
  std::size_t byte = starts_[index];
  while (linear >= thresholds_[byte + 1]) ++byte;
  return static_cast<std::uint8_t>(byte);
}

ScreenColours::ScreenColours(const ScreenSettings& settings)
    : settings_(settings),
      factor_(std::exp2(settings.exposure) / (settings.white - settings.black)),
      curve_(&byte_curve(settings.curve)),
      scale_(settings.least / std::exp2(settings.exposure), settings.largest / std::exp2(settings.exposure)) {
  if (settings.colouring == Colouring::FalseColour) make_false_colours();
}

void ScreenColours::make_false_colours() {
  const auto upper_bits = [](double value) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(value)) >> TableShift;
  };
  first_false_colour_ = upper_bits(scale_.lowest());
  for (std::uint32_t upper = first_false_colour_; upper <= upper_bits(scale_.highest()); ++upper) {
    // The middle of the interval.
    const std::uint32_t bits = (upper << TableShift) + (1U << (TableShift - 1));
    false_colours_.push_back(false_colour(std::bit_cast<float>(bits)));
  }
}

QRgb ScreenColours::false_colour(double luminance) const {
  // The scale of documents runs from light to dark, for paper; on the screen brighter is lighter.
  const double mirrored = scale_.lowest() * scale_.highest() / std::max(luminance, scale_.lowest());
  const grf::Colour colour = scale_.colour(mirrored);
  return qRgb(byte_of(colour.x), byte_of(colour.y), byte_of(colour.z));
}

QRgb ScreenColours::false_colour_by_table(float luminance) const {
  const std::uint32_t upper = std::bit_cast<std::uint32_t>(std::max(luminance, 0.0F)) >> TableShift;
  if (upper <= first_false_colour_) return false_colours_.front();
  return false_colours_[std::min<std::size_t>(upper - first_false_colour_, false_colours_.size() - 1)];
}

QRgb ScreenColours::signed_colour(double value) const {
  // Orange and sky blue of Okabe and Ito, in linear light, to which the tone curve is applied.
  static const std::array poles = {Colour(0.79F, 0.35F, 0.0F), Colour(0.093F, 0.456F, 0.815F)};
  const Colour colour = poles[value < 0 ? 1 : 0] * std::min(static_cast<float>(std::abs(value)), 1.0F);
  return qRgb((*curve_)(colour.x), (*curve_)(colour.y), (*curve_)(colour.z));
}

QRgb ScreenColours::natural(const Colour& pixel) const {
  const auto byte = [this](float value) { return (*curve_)((value - settings_.black) * factor_); };
  const auto grey = [&byte](float value) { return qRgb(byte(value), byte(value), byte(value)); };
  switch (settings_.channel) {
    case ImageChannel::Colour:
      break;
    case ImageChannel::Red:
      return grey(pixel.x);
    case ImageChannel::Green:
      return grey(pixel.y);
    case ImageChannel::Blue:
      return grey(pixel.z);
    case ImageChannel::Luminance:
      return grey(static_cast<float>(reflectance::luminance(pixel)));
  }
  return qRgb(byte(pixel.x), byte(pixel.y), byte(pixel.z));
}

QRgb ScreenColours::operator()(const Colour& pixel) const {
  // The sum is NaN or infinite if a component is; it may also overflow.
  if (!std::isfinite(pixel.x + pixel.y + pixel.z)) {
    if (std::isnan(pixel.x) || std::isnan(pixel.y) || std::isnan(pixel.z)) return NanColour;
    if (std::isinf(pixel.x) || std::isinf(pixel.y) || std::isinf(pixel.z)) return InfiniteColour;
  }
  switch (settings_.colouring) {
    case Colouring::Natural:
      break;
    case Colouring::FalseColour:
      return false_colour_by_table(static_cast<float>(reflectance::luminance(pixel)));
    case Colouring::Signed:
      return signed_colour(reflectance::luminance(pixel) / scale_.highest());
  }
  return natural(pixel);
}

QImage ScreenColours::convert(const image::Image& image, const QRect& part, int block) const {
  const int width = (part.width() + block - 1) / block;
  const int height = (part.height() + block - 1) / block;
  QImage converted(width, height, QImage::Format_RGB32);
  uchar* bits = converted.bits();
  const auto stride = converted.bytesPerLine();
  const auto convert_row = [&](int row) {
    auto* to = reinterpret_cast<QRgb*>(bits + stride * row);
    const int y = part.top() + row * block;
    for (int column = 0; column < width; ++column) {
      const int x = part.left() + column * block;
      const QRect square = QRect(x, y, block, block).intersected(part);
      to[column] = (*this)(block == 1 ? image.at(x, y) : mean_of(image, square));
    }
  };
  for_each_row(height, convert_row);
  return converted;
}

}  // namespace editor
