#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "renderer/plot/chart.h"
#include "renderer/plot/lobe_mesh.h"

namespace studies {

/// An orthographic view of the hemisphere over a surface, from an azimuth and an elevation in degrees. The
/// unit disc of the surface fits the place at any azimuth.
class HemisphereView {
 public:
  HemisphereView(double azimuth, double elevation, const plot::Rectangle& place);

  plot::Point point(const reflectance::Vec3f& position) const;
  /// Returns the distance towards the eye.
  double nearness(const reflectance::Vec3f& position) const { return position.dot(to_eye_); }
  const reflectance::Vec3f& to_eye() const { return to_eye_; }

 private:
  plot::Point centre_;
  double scale_;
  reflectance::Vec3f right_, up_, to_eye_;
};

/// Points drawn as dots, in one colour.
struct PointCloud {
  std::vector<reflectance::Vec3f> positions;
  std::string_view colour;
};

/// Draws the unit disc of the surface with its axes, a lobe from the far side to the near side, and clouds of
/// points, of which those behind the lobe are hidden.
void draw_lobe(const plot::LobeMesh& mesh, const plot::LobeGrid& grid, std::string_view colour,
               std::span<const PointCloud> clouds, const HemisphereView& view, plot::Svg& svg);

/// Draws a direction as a line from the centre to the hemisphere, with a name at its end.
void draw_direction(const reflectance::Vec3f& direction, std::string_view name, std::string_view dashes,
                    const HemisphereView& view, plot::Svg& svg);

/// Draws the normal, the view direction and its mirror direction.
void draw_view_directions(const reflectance::Vec3f& u, const HemisphereView& view, plot::Svg& svg);

}  // namespace studies
