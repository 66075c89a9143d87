#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grf/math.h"
#include "renderer/image/image.h"
#include "renderer/reflectance/geometry.h"
#include "renderer/transport/lights/cosine_warps.h"

namespace transport {

/// A sampled direction to the environment, at infinity.
struct EnvironmentSample {
  grf::Vec3f direction;  ///< towards the light, in world space
  reflectance::Rgb radiance;
  float pdf = 0;  ///< solid-angle pdf, 1/sr, over 0
};

/// An environment map in latitude-longitude format: y is up, the centre looks down -z, and +x is right of it,
/// unless it is rotated.
///
/// Texels are constant over their rectangles of directions: without interpolation, the pdf can be an exact
/// function of luminance, and over 0 wherever there is light. Rows are sampled by a marginal and columns by a
/// conditional distribution of the texels' weights times solid angle, and directions uniformly over the
/// texel's solid angle: sin(theta) is not taken at the texel's centre, which would add noise at the poles.
class EnvironmentMap {
 public:
  /// The weights by which directions are sampled.
  enum class Weights {
    Luminance,
    /// MIS compensation (Karlik, Sik, Vevoda, Skrivan and Krivanek 2019, "MIS compensation: optimizing
    /// sampling techniques in multiple importance sampling"): what exceeds two thirds of the mean luminance.
    /// The rest is found by BRDF sampling, of which a path has two directions for each light sample. At least
    /// a hundredth of the luminance remains, so that no light is lost where a BRDF's sampler never goes.
    Compensated
  };

  /// Channels of texels that are negative or not finite count as 0. The map is rotated about the y axis by an
  /// angle in degrees, counter-clockwise seen from above.
  explicit EnvironmentMap(image::Image image, float rotation = 0, Weights weights = Weights::Luminance);

  reflectance::Rgb radiance(const grf::Vec3f& direction) const { return image_.pixels[texel_at(direction)]; }

  /// Inverts the distributions: maps one 2D sample in [0,1) to a direction, continuously except across black
  /// texels. Empty if the whole map is black.
  std::optional<EnvironmentSample> sample(const grf::Vec2f& xi) const;

  /// The solid-angle pdf of `sample`.
  float pdf(const grf::Vec3f& direction) const;
  /// The same of all directions with this radiance, on which alone it depends.
  float pdf_of(const reflectance::Rgb& radiance) const;

  /// Samples the map for a surface with this unit normal: nearly proportional to the cosine as well.
  std::optional<EnvironmentSample> sample(const grf::Vec3f& normal, const grf::Vec2f& xi) const;
  float pdf(const grf::Vec3f& normal, const grf::Vec3f& direction) const {
    return radiance_and_pdf(normal, direction).pdf;
  }

  struct RadianceAndPdf {
    reflectance::Rgb radiance;
    float pdf = 0;
  };
  /// Returns `radiance` and `pdf` together, which share work.
  RadianceAndPdf radiance_and_pdf(const grf::Vec3f& normal, const grf::Vec3f& direction) const;

  /// Luminance integrated over all directions.
  double total() const { return total_; }

  bool is_black() const { return !(total_ > 0); }
  const image::Image& image() const { return image_; }

  /// The number of texels of which a channel was negative or not finite.
  std::size_t invalid_texels() const { return invalid_texels_; }

 private:
  /// A cache line of a CDF. A search first goes through the last values of the lines, which are more likely
  /// to be cached than the lines themselves.
  struct alignas(64) Line {
    static constexpr std::size_t Size = 16;
    std::array<float, Size> shares;
  };

  /// A position on the image: a texel, and the position in it, 0..1, from the upper left corner.
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
  double solid_angle_of_texel(std::size_t row) const;
  double weight_of(const reflectance::Rgb& radiance) const;
  void build(Weights weights);
  void prefetch(std::size_t row, std::size_t line) const;

  image::Image image_;
  double longitude_;  ///< of the image's centre, radians, -pi to pi, from -z towards +x
  std::size_t invalid_texels_ = 0;
  double total_ = 0;         ///< luminance integrated over the sphere
  double removed_ = 0;       ///< from the luminance of each texel, for its weight
  double total_weight_ = 0;  ///< weights integrated over the sphere
  std::vector<float> rows_;  ///< marginal CDF of the rows, up to and including each
  /// Conditional CDFs of the columns, row after row; all 1 in a black row, and past the end of a row.
  std::vector<Line> columns_;
  std::vector<float> line_ends_;  ///< last CDF value of each line
  std::size_t lines_across_ = 0;
  CosineWarps warps_;
  std::vector<double>
      cosines_;  ///< of the angles between the y axis and the row boundaries, one more than rows
};

/// Reads an environment map, rotated by degrees about the y axis, and warns of texels that count as 0.
std::optional<EnvironmentMap> read_environment_map(
    const std::string& path, grf::Diagnostics& diagnostics, const grf::SourceLocation& asked_for_at = {},
    const image::ImageReader& image_reader = image::read_image, float rotation = 0,
    EnvironmentMap::Weights weights = EnvironmentMap::Weights::Luminance);

}  // namespace transport
