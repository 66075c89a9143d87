#pragma once

#include <functional>
#include <string>
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

/// Samples drawn as dots, in one colour.
struct SampleCloud {
  std::vector<reflectance::Vec3f> directions;
  std::vector<double> values;  ///< one for each direction, in 1/sr
  std::string_view colour;
};

/// The lobe of a BRDF for one view direction, with samples of it. The largest value of a sample has a radius
/// of 1. Some models grow without bound towards the horizon, where there are no samples: what is much longer
/// is cut.
class SampledLobe {
 public:
  SampledLobe(const reflectance::Brdf& brdf, const reflectance::Vec3f& u, const plot::LobeStyle& style,
              std::vector<SampleCloud> clouds, const std::function<bool()>& is_stopped = {});

  /// Returns where a value in a direction is drawn.
  reflectance::Vec3f position(const reflectance::Vec3f& direction, double value) const;

  /// Draws the unit disc of the surface with its axes, the lobe with its samples, of which those behind the
  /// lobe are hidden, the specular part as a line whose length is the fraction of light that it reflects,
  /// and the normal, the view direction and the mirror direction.
  void draw(const HemisphereView& view, plot::Svg& svg) const;

  /// Describes the scale: "radius 1 is 1.5 1/sr".
  std::string scale_text() const;

 private:
  reflectance::Vec3f u_;
  bool is_logarithmic_;
  std::vector<SampleCloud> clouds_;
  double unit_ = 0;  ///< the value of radius 1
  plot::LobeMesh mesh_;
};

}  // namespace studies
