// BRDF charts show lobes, albedo and samples of a BRDF. `bpt` draws them as SVG without a GUI library, and
// the editor draws the same charts with QCustomPlot, where they can be zoomed. The values, labels and axis
// ranges are computed here for both.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/plot/chart.h"
#include "renderer/reflectance/reflector.h"

namespace plot {

enum class Channel { Luminance, Red, Green, Blue, Mean };

/// Returns a channel of a linear RGB value; luminance is that of sRGB's primaries.
double channel_of(const reflectance::Rgb& rgb, Channel channel);

/// Returns the direction at an angle to the normal in the plane of incidence, in degrees; positive is right.
reflectance::Vec3f direction_at(double degrees);

/// A BRDF over the light's angle in the plane of incidence. The view is on the left, so that the mirror
/// direction is at the view's own angle on the right.
struct LobeCurve {
  double view = 0;  ///< view angle, degrees
  std::vector<double> degrees;
  std::vector<reflectance::Rgb> values;  ///< f in 1/sr, at each of the angles
  std::vector<double> pdfs;              ///< solid-angle pdf of the scheme; empty without one
  reflectance::Rgb specular_weight;      ///< the weight of the delta part
};

/// Samples the BRDF, and the pdf of a reflector's scheme unless that is null.
LobeCurve lobe_curve(const reflectance::Brdf& brdf, double view,
                     const reflectance::Reflector* reflector = nullptr);

/// Directional albedo over the view angle.
struct AlbedoCurve {
  std::vector<double> degrees;
  std::vector<reflectance::Rgb> along_x;
  std::vector<reflectance::Rgb> along_y;  ///< empty for isotropic BRDFs
  grf::LargestAlbedo largest;
};

/// Computes the albedo on several threads. Values are omitted once it is stopped.
AlbedoCurve albedo_curve(const reflectance::Reflector& reflector, int samples,
                         const std::function<bool()>& is_stopped = {});

struct LobeStyle {
  Channel channel = Channel::Luminance;
  bool with_cosine = false;
  bool is_logarithmic = false;
};

/// Makes a cartesian chart over the light's angle. Pdfs are dashed.
Chart lobe_chart(std::span<const LobeCurve> curves, const LobeStyle& style);

/// Adds the delta parts to such a chart, as lines whose length is their albedo; the peak is 1.
void add_specular_lines(Chart& chart, std::span<const LobeCurve> curves, Channel channel);

/// Makes a polar chart with values as radii. Lobes much longer than another are clipped.
PolarChart polar_lobe_chart(std::span<const LobeCurve> curves, const LobeStyle& style);

/// Makes a chart of each channel, or of one line if they are equal.
Chart albedo_chart(const AlbedoCurve& curve);

/// Makes a chart of the spectrum in the mirror direction of each of these view angles, in degrees. Nothing if
/// the BRDF has RGB alone. Models are evaluated from 380 to 780 nm, data at their own wavelengths.
std::optional<Chart> spectrum_chart(const reflectance::Brdf& brdf, std::span<const double> views);

}  // namespace plot
