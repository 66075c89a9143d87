#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grf/math.h"
#include "renderer/transport/image/image.h"
#include "renderer/transport/lights/cosine_warps.h"

namespace transport {

/// Radiance from infinitely far away.
struct EnvironmentSample {
  grf::Vec3f direction;  ///< towards where the light comes from, in the world
  reflectance::Rgb radiance;
  float density = 0;  ///< per solid angle, over 0
};

/// A latitude-longitude image around the scene: y is up, the centre looks down -z, and right of it is +x.
///
/// A texel is a rectangle of directions with one radiance: nothing is interpolated, so that a density can be
/// exactly the luminance, over 0 wherever there is light. Directions are drawn in proportion to luminance
/// times solid angle, row by a marginal and column by a conditional distribution, and evenly over the texel's
/// solid angle: sin(theta) is not taken at its centre, or texels at the poles would have more noise than
/// others.
class EnvironmentMap {
 public:
  /// Texels that are negative or not finite count as 0 in that channel.
  explicit EnvironmentMap(Image image);

  reflectance::Rgb radiance(const grf::Vec3f& direction) const { return image_.pixels[texel_at(direction)]; }

  /// Inverts the distributions: one pair in [0,1), one direction, and near pairs give near directions unless
  /// there is black between them. Nothing if the whole map is black.
  std::optional<EnvironmentSample> sample(const grf::Vec2f& xi) const;

  /// The density of `sample` per solid angle.
  float density(const grf::Vec3f& direction) const;

  /// The same for a surface with this unit normal: nearly in proportion to the cosine with it too.
  std::optional<EnvironmentSample> sample(const grf::Vec3f& normal, const grf::Vec2f& xi) const;
  float density(const grf::Vec3f& normal, const grf::Vec3f& direction) const {
    return seen(normal, direction).density;
  }

  struct Seen {
    reflectance::Rgb radiance;
    float density = 0;
  };
  /// `radiance` and `density` in one, for what they share.
  Seen seen(const grf::Vec3f& normal, const grf::Vec3f& direction) const;

  /// Luminance integrated over all directions.
  double total() const { return total_; }

  bool is_black() const { return !(total_ > 0); }
  const Image& image() const { return image_; }

  /// Texels of which a channel was negative or not finite.
  std::size_t wrong_texels() const { return wrong_texels_; }

 private:
  /// A line of the processor's cache. Which one has a share is found among their ends, which stay in a nearer
  /// cache than the lines do.
  struct alignas(64) Line {
    static constexpr std::size_t Size = 16;
    std::array<float, Size> shares;
  };

  /// A place on the image: a texel, and where in it, 0..1, from the upper left corner.
  struct Place {
    std::size_t row = 0;
    std::size_t column = 0;
    grf::Vec2f inside;
  };
  Place place_of(const grf::Vec3f& direction) const;
  std::size_t texel_at(const grf::Vec3f& direction) const;
  grf::Vec2f pair_of(const Place& place) const;
  grf::Vec3f direction_in(std::size_t row, std::size_t column, const grf::Vec2f& place) const;
  bool is_near_border(std::size_t row, const grf::Vec2f& place) const;
  void repair();
  void build();
  void prefetch(std::size_t row, std::size_t line) const;

  Image image_;
  std::size_t wrong_texels_ = 0;
  double total_ = 0;         ///< luminance over the whole sphere
  std::vector<float> rows_;  ///< cumulative share of rows, up to and including each
  /// Of columns within their row, row after row; all 1 in a black one, and behind a row's last.
  std::vector<Line> columns_;
  std::vector<float> line_ends_;  ///< the last share of each line
  std::size_t lines_across_ = 0;
  CosineWarps warps_;
  std::vector<double> cosines_;  ///< of the angles from the y axis between rows, one more than rows
};

/// Reads a map, and warns of texels that count as 0.
std::optional<EnvironmentMap> read_environment_map(const std::string& path, grf::Diagnostics& diagnostics,
                                                   const grf::SourceLocation& asked_for_at = {},
                                                   const ImageReader& image_reader = read_image);

}  // namespace transport
