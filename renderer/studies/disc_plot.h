// Functions of a direction are plotted on the unit disc: v is at (v.x, v.y), the normal at the centre.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "renderer/plot/colour_scale.h"
#include "renderer/reflectance/geometry.h"

namespace studies {

/// Returns where the disc has a direction with these x and y, in a square around it.
plot::Point point_on_disc(double x, double y, const plot::Rectangle& place);

/// The means of a function over the pixels of a square around the disc.
class DiscMap {
 public:
  explicit DiscMap(const std::function<double(const reflectance::Vec3f&)>& function);

  // Extremes over the pixels inside the disc; 0 if no value is positive.
  double least() const { return least_; }  ///< the least positive value
  double largest() const { return largest_; }

  /// Pixels along a side.
  static constexpr int Side = 240;
  struct Pixel {
    float value = 0;     ///< mean over the part inside the disc
    float coverage = 0;  ///< fraction of the pixel inside the disc
  };
  const std::vector<Pixel>& pixels() const { return pixels_; }

 private:
  std::vector<Pixel> pixels_;
  double least_ = 0;
  double largest_ = 0;
};

void draw(const DiscMap& map, const plot::ColourScale& scale, const plot::Rectangle& place, plot::Svg& svg);

/// Draws a dot per direction.
void draw_directions(std::span<const reflectance::Vec3f> directions, const plot::Rectangle& place,
                     std::string_view colour, plot::Svg& svg);

/// Draws a ring at the view direction.
void mark_view(const reflectance::Vec3f& u, const plot::Rectangle& place, plot::Svg& svg);

}  // namespace studies
