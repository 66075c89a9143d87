#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include <half.h>

#include "renderer/image/image.h"
#include "renderer/image/srgb.h"
#include "renderer/reflectance/geometry.h"

namespace transport {

/// How a byte of a texel is a value: by sRGB, or as a fraction of 255.
enum class TexelEncoding { Srgb, Linear };

/// An image texture, with or without alpha, that repeats over the plane, with mip levels (Williams 1983,
/// "Pyramidal parametrics"). (0,0) is the lower left corner of the image and (1,1) the upper right one, as in
/// `grf::Mesh`.
///
/// Texels are stored as compactly as is possible without loss: a byte per channel if all values are those of
/// bytes in the encoding, else halves, which keep 3 digits of values up to 65504.
class Texture {
 public:
  /// Channels that are negative or not finite count as 0, as in environment maps; an alpha over 1 counts
  /// as 1.
  explicit Texture(image::Image image, TexelEncoding encoding = TexelEncoding::Srgb);

  /// The filtered colour at a point for a footprint of this width in uv coordinates: 0 for bilinear
  /// interpolation of the image itself, else trilinear. Texels count by their alpha.
  reflectance::Rgb lookup(const grf::Vec2f& uv, float footprint) const;

  /// The filtered alpha; 1 if the image has none.
  float alpha(const grf::Vec2f& uv, float footprint) const;

  int width() const { return levels_.front().width; }
  int height() const { return levels_.front().height; }
  std::size_t level_count() const { return levels_.size(); }
  /// Bilinear interpolation of a mip level, premultiplied by alpha; 0 is the image.
  reflectance::Rgb lookup_level(const grf::Vec2f& uv, std::size_t level) const;
  bool has_bytes() const { return std::holds_alternative<std::vector<std::uint8_t>>(channels_); }
  std::size_t bytes() const;
  /// The number of texels with a channel that was negative or not finite.
  std::size_t invalid_texels() const { return invalid_texels_; }

 private:
  struct Level {
    int width = 1;
    int height = 1;
    std::size_t first = 0;  ///< index of its first texel
  };

  void repair(image::Image& image);
  template <class Channel, class Encode>
  void store(image::Image image, std::vector<Channel> channels, const Encode& encode);
  std::size_t index_of(const Level& level, int x, int y) const {
    return level.first + static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) +
           static_cast<std::size_t>(x);
  }
  reflectance::Rgb texel(std::size_t index) const;
  float texels_across(float footprint) const;

  const image::SrgbTable* value_of_byte_;
  std::vector<Level> levels_;
  std::variant<std::vector<std::uint8_t>, std::vector<half>> channels_;  ///< three per texel
  std::vector<float> alpha_;  ///< per texel of all levels; empty: 1
  std::size_t invalid_texels_ = 0;
};

/// Halves the image's size, rounded up; each texel is the mean of those it covers, and so is
/// its alpha. The mean is preserved.
image::Image halved(const image::Image& image);

}  // namespace transport
