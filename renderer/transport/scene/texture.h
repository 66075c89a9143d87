#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include <half.h>

#include "renderer/transport/image/image.h"

namespace transport {

/// An image that repeats over the plane, with the mip levels of it (Williams 1983, "Pyramidal parametrics").
/// (0,0) is the lower left corner of the image and (1,1) the upper right one, as `grf::Mesh` says.
///
/// Texels take as little memory as they can without loss: a byte a channel where all of them are values that
/// sRGB-encoded bytes stand for, and else halves, which keep 3 digits of values up to 65504.
class Texture {
 public:
  /// Values that are negative or not finite count as 0 in that channel, as in environment maps.
  explicit Texture(Image image);

  /// The mean about a place over a region as wide as `footprint`, in uv coordinates: 0 for the bilinear
  /// interpolation of the image itself, else trilinear.
  reflectance::Rgb lookup(const grf::Vec2f& uv, float footprint) const;

  int width() const { return levels_.front().width; }
  int height() const { return levels_.front().height; }
  std::size_t level_count() const { return levels_.size(); }
  /// The bilinear interpolation of a level, of which 0 is the image.
  reflectance::Rgb lookup_level(const grf::Vec2f& uv, std::size_t level) const;
  bool has_bytes() const { return std::holds_alternative<std::vector<std::uint8_t>>(channels_); }
  std::size_t bytes() const;
  /// Texels of which a channel was negative or not finite.
  std::size_t wrong_texels() const { return wrong_texels_; }

 private:
  struct Level {
    int width = 1;
    int height = 1;
    std::size_t first = 0;  ///< texel
  };

  void repair(Image& image);
  template <class Channel, class Encode>
  void store(Image image, std::vector<Channel> channels, const Encode& encode);
  reflectance::Rgb texel(const Level& level, int x, int y) const;

  std::vector<Level> levels_;
  std::variant<std::vector<std::uint8_t>, std::vector<half>> channels_;  ///< three a texel
  std::size_t wrong_texels_ = 0;
};

/// The image in half the size, rounded up, each texel the mean of what it covers. The mean stays.
Image halved(const Image& image);

}  // namespace transport
