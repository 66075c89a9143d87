// What the plots show: values, densities and albedos of a BRDF over angles. No windows here.
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "editor/brdf/background_job.h"
#include "renderer/reflectance/scheme.h"

namespace editor {

using SharedBrdf = std::shared_ptr<const reflectance::Brdf>;

enum class Channel { Luminance, Red, Green, Blue };

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

struct LobeCurves {
  std::vector<LobeCurve> curves;
  QString scheme_mistake;  ///< why there is no density though one was asked for
};

/// The scheme's tables are made first, which may take seconds and is not stopped half-way; values are without
/// it quick. Half a result, which nobody sees, if the flag is set.
LobeCurves lobe_curves(const reflectance::Brdf& brdf, const std::vector<double>& views,
                       const std::optional<grf::PdfModel>& scheme, const StopFlag& stop);

/// The share of light that is reflected, over the angle of view.
struct AlbedoCurve {
  std::vector<double> degrees;
  std::vector<reflectance::Rgb> along_x;
  std::vector<reflectance::Rgb> along_y;  ///< empty for isotropic BRDFs
  grf::LargestAlbedo largest;
};

AlbedoCurve albedo_curve(const reflectance::Brdf& brdf, int samples, const StopFlag& stop);

/// In the model's own words: what is said of energy, and where it reflects more than it receives.
struct EnergyWords {
  QString text;
  bool is_warning = false;
};
EnergyWords energy_words(const reflectance::Brdf& brdf, const grf::LargestAlbedo& largest);

/// Comma-separated columns: angles, then f of each view in three channels, and densities where there are any.
QString curves_csv(const LobeCurves& curves);
QString albedo_csv(const AlbedoCurve& curve);

}  // namespace editor
