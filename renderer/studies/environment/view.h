// Functions over all directions are shown on the outside of a sphere, and unrolled as an environment map.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "renderer/plot/chart.h"
#include "renderer/studies/environment/file.h"

namespace studies {

/// The latitude-longitude rectangle of all directions, in the orientation of environment maps.
class UnrolledView {
 public:
  explicit UnrolledView(const plot::Rectangle& place) : place_(place) {}

  const plot::Rectangle& place() const { return place_; }
  plot::Point point(const reflectance::Vec3f& direction) const;
  /// Returns the direction at a point, or nothing outside.
  std::optional<reflectance::Vec3f> direction(const plot::Point& point) const;

 private:
  plot::Rectangle place_;
};

/// An orthographic view of the unit sphere from outside, y up. The azimuth of the eye is from the x axis
/// towards -z, its elevation over the xz plane; both in degrees.
class SphereView {
 public:
  SphereView(double azimuth, double elevation, const plot::Point& centre, double radius);

  const plot::Point& centre() const { return centre_; }
  double radius() const { return radius_; }
  plot::Point point(const reflectance::Vec3f& position) const;
  bool is_in_front(const reflectance::Vec3f& direction) const { return direction.dot(to_eye_) >= 0; }
  /// Returns the direction of the front side at a point, or nothing outside.
  std::optional<reflectance::Vec3f> direction(const plot::Point& point) const;

 private:
  plot::Point centre_;
  double radius_;
  reflectance::Vec3f right_, up_, to_eye_;
};

/// The linear colours of the cells of a grid.
struct ColouredSphere {
  SphereGrid grid;
  std::vector<reflectance::Rgb> colours;

  /// Interpolates between the centres of cells.
  reflectance::Rgb colour(const reflectance::Vec3f& direction) const;
};

/// Draws the sphere in both views.
void draw(const ColouredSphere& sphere, const SphereView& view, const UnrolledView& unrolled, plot::Svg& svg);

/// Draws the border of the unrolled sphere with ticks at multiples of 90 and 30 degrees, and the axes' names.
void draw_axes(const UnrolledView& view, plot::Svg& svg);

/// Draws the great circle of directions at right angles to a normal, hidden parts fainter.
void draw_horizon(const reflectance::Vec3f& normal, const UnrolledView& view, plot::Svg& svg);
void draw_horizon(const reflectance::Vec3f& normal, const SphereView& view, plot::Svg& svg);

/// How a set of directions is drawn.
struct DotStyle {
  double radius = 1;
  std::string_view colour;
  std::string_view faint;  ///< colour on the hidden half of the sphere
  std::string_view rim;    ///< colour of a thin line around each dot; empty: none
};
void draw_dots(std::span<const reflectance::Vec3f> directions, const DotStyle& style,
               const UnrolledView& view, plot::Svg& svg);
void draw_dots(std::span<const reflectance::Vec3f> directions, const DotStyle& style, const SphereView& view,
               plot::Svg& svg);

}  // namespace studies
