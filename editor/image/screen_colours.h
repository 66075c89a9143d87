// From radiance to what a screen shows.
#pragma once

#include <QImage>
#include <QRect>
#include <array>
#include <cstdint>
#include <vector>

#include "renderer/plot/colour_scale.h"
#include "renderer/transport/image/image.h"

namespace editor {

enum class ToneCurve {
  Srgb,      ///< white is 1, what is brighter is cut
  Filmic,    ///< the fit to ACES of Narkowicz (2015): highlights roll off
  Reinhard,  ///< x / (1 + x), of each channel (Reinhard et al. 2002): nothing is cut
};

enum class ImageChannel { Colour, Red, Green, Blue, Luminance };

enum class Colouring {
  Natural,
  FalseColour,  ///< luminance over powers of ten, dark blue to light yellow
  Signed,       ///< blue below 0, black at 0, orange above
};

struct ScreenSettings {
  float exposure = 0;  ///< stops
  ToneCurve curve = ToneCurve::Srgb;
  ImageChannel channel = ImageChannel::Colour;
  Colouring colouring = Colouring::Natural;
  /// Luminances between which false colours lie, before the exposure, in the image's unit. The larger one is
  /// also that of full colours of either sign.
  double least = 0.01;
  double largest = 1;

  bool operator==(const ScreenSettings&) const = default;
};

/// What pixels show that are no number, or infinite: a colour that renders seldom have.
inline constexpr QRgb NanColour = 0xffff00ff;
inline constexpr QRgb InfiniteColour = 0xff00ffff;

/// Of linear RGB with the primaries of sRGB (ITU-R BT.709).
double luminance_of(const reflectance::Rgb& pixel);

/// What a radiance of 1 W/(sr m2) of white light has in cd/m2, as Radiance counts it (Ward 1994).
inline constexpr double CandelasPerWatt = 179;

/// A rising curve from linear values to encoded bytes. A table says for each short run of floats the byte at
/// its start, and thresholds the rest: the byte is exactly that of the formula, at the cost of a look.
class ByteCurve {
 public:
  explicit ByteCurve(ToneCurve curve);

  /// 0 for what is negative or no number.
  std::uint8_t operator()(float linear) const;

 private:
  std::array<float, 257> thresholds_ = {};  ///< the least value with that byte
  std::vector<std::uint8_t> starts_;
  std::uint32_t first_ = 0;  ///< the upper bits of the first float in the table
};

class ScreenColours {
 public:
  explicit ScreenColours(const ScreenSettings& settings);

  QRgb operator()(const reflectance::Rgb& pixel) const;

  /// A part of an image, each of its pixels the mean of a square of `block` pixels; at the right and the
  /// lower edge, of those that are there.
  QImage convert(const transport::Image& image, const QRect& part, int block = 1) const;

  /// That of false colours, in the image's unit, with the exposure.
  const plot::ColourScale& scale() const { return scale_; }
  /// The false colour of a luminance.
  QRgb false_colour(double luminance) const;

 private:
  QRgb natural(const reflectance::Rgb& pixel) const;
  QRgb signed_colour(double value) const;
  QRgb false_colour_by_table(float luminance) const;
  void make_false_colours();

  ScreenSettings settings_;
  float factor_;
  const ByteCurve* curve_;  ///< one of a few that are always there
  plot::ColourScale scale_;
  std::vector<QRgb> false_colours_;  ///< by the upper bits of a luminance
  std::uint32_t first_false_colour_ = 0;
};

}  // namespace editor
