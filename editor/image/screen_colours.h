// Tone mapping converts radiance to colours of the screen.
#pragma once

#include <QImage>
#include <QRect>
#include <array>
#include <cstdint>
#include <vector>

#include "renderer/image/image.h"
#include "renderer/plot/colour_scale.h"

namespace editor {

enum class ToneCurve {
  Srgb,      ///< clipped at 1
  Filmic,    ///< the fit to ACES of Narkowicz (2015): highlights roll off
  Reinhard,  ///< x / (1 + x) per channel (Reinhard et al. 2002): no clipping
};

enum class ImageChannel { Colour, Red, Green, Blue, Luminance };

enum class Colouring {
  Natural,
  FalseColour,  ///< logarithmic luminance, dark blue to light yellow
  Signed,       ///< blue below 0, black at 0, orange above
};

struct ScreenSettings {
  float exposure = 0;  ///< stops
  ToneCurve curve = ToneCurve::Srgb;
  ImageChannel channel = ImageChannel::Colour;
  Colouring colouring = Colouring::Natural;
  /// Luminance range of false colours, before exposure, in the image's unit. The larger one is also the
  /// saturation point of either sign.
  double least = 0.01;
  double largest = 1;
  /// The values that are black and white, before exposure.
  float black = 0;
  float white = 1;
  bool is_radiance = true;         ///< false for layers such as a depth, whose luminance is not in cd/m2
  bool is_relative_error = false;  ///< labels the scale in percent

  bool operator==(const ScreenSettings&) const = default;
};

/// The colours of NaN and of infinite pixels, which renders seldom have.
inline constexpr QRgb NanColour = 0xffff00ff;
inline constexpr QRgb InfiniteColour = 0xff00ffff;

/// Luminance in cd/m2 of a white radiance of 1 W/(sr m2), as in Radiance (Ward 1994).
inline constexpr double CandelasPerWatt = 179;

/// An increasing curve from linear values to encoded bytes, as a table: the byte at the start of each short
/// interval of floats, and a threshold inside it, which gives exactly the byte of the formula at the cost of
/// a lookup.
class ByteCurve {
 public:
  explicit ByteCurve(ToneCurve curve);

  /// Returns 0 for negative values and NaN.
  std::uint8_t operator()(float linear) const;

 private:
  std::array<float, 257> thresholds_ = {};  ///< the least value with that byte
  std::vector<std::uint8_t> starts_;
  std::uint32_t first_ = 0;  ///< the upper bits of the first float in the table
};

class ScreenColours {
 public:
  explicit ScreenColours(const ScreenSettings& settings);

  QRgb operator()(const grf::Colour& pixel) const;

  /// Converts a part of an image, averaging `block` x `block` pixels per output pixel; at the right and the
  /// lower edge, the pixels that are there.
  QImage convert(const image::Image& image, const QRect& part, int block = 1) const;

  /// The scale of false colours, in the image's unit, with the exposure.
  const plot::ColourScale& scale() const { return scale_; }
  /// The false colour of a luminance.
  QRgb false_colour(double luminance) const;

 private:
  QRgb natural(const grf::Colour& pixel) const;
  QRgb signed_colour(double value) const;
  QRgb false_colour_by_table(float luminance) const;
  void make_false_colours();

  ScreenSettings settings_;
  float factor_;            ///< of exposure, for a range of 1
  const ByteCurve* curve_;  ///< one of a few static curves
  plot::ColourScale scale_;
  std::vector<QRgb> false_colours_;  ///< indexed by the upper bits of a luminance
  std::uint32_t first_false_colour_ = 0;
};

}  // namespace editor
