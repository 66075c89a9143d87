// Charts of BRDFs. `bpt` draws them as SVG, without a library of windows, and the editor draws the same
// charts with QCustomPlot, in which they can be looked at closely: the values, the names and the ends of axes
// are found here, once for both.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "renderer/plot/chart.h"
#include "renderer/reflectance/reflector.h"

namespace plot {

enum class Channel { Luminance, Red, Green, Blue, Mean };

/// The channel of a linear RGB value; luminance is that of sRGB's primaries.
double channel_of(const reflectance::Rgb& rgb, Channel channel);

/// The direction at so many degrees from the normal in the plane of incidence, on the right if positive.
reflectance::Vec3f direction_at(double degrees);

/// A BRDF over the light's angle in the plane of incidence. The view is on the left, so that the mirror
/// direction is at the view's own angle on the right.
struct LobeCurve {
  double view = 0;  ///< degrees
  std::vector<double> degrees;
  std::vector<reflectance::Rgb> values;  ///< f in 1/sr, at each of the angles
  std::vector<double> densities;         ///< per solid angle; empty without a scheme
  reflectance::Rgb mirror;               ///< the weight of the Dirac part
};

/// With the density of a reflector's scheme, unless that is null.
LobeCurve lobe_curve(const reflectance::Brdf& brdf, double view,
                     const reflectance::Reflector* reflector = nullptr);

/// The share of light that is reflected, over the angle of view.
struct AlbedoCurve {
  std::vector<double> degrees;
  std::vector<reflectance::Rgb> along_x;
  std::vector<reflectance::Rgb> along_y;  ///< empty for isotropic BRDFs
  grf::LargestAlbedo largest;
};

/// On several threads. Values are left out from when it is stopped.
AlbedoCurve albedo_curve(const reflectance::Reflector& reflector, int samples,
                         const std::function<bool()>& is_stopped = {});

struct LobeStyle {
  Channel channel = Channel::Luminance;
  bool with_cosine = false;
  bool is_logarithmic = false;
};

/// The values over the light's angle. Densities are dashed.
Chart lobe_chart(std::span<const LobeCurve> curves, const LobeStyle& style);

/// Adds the mirror parts to such a chart: lines that are as long as their share of the light, if the highest
/// value is all of it.
void add_mirror_lines(Chart& chart, std::span<const LobeCurve> curves, Channel channel);

/// The values as distances. Lobes that are far longer than another are cut, so that all can be seen.
PolarChart polar_lobe_chart(std::span<const LobeCurve> curves, const LobeStyle& style);

/// Each channel, or all in one where they are equal.
Chart albedo_chart(const AlbedoCurve& curve);

}  // namespace plot
