// Computes the curves of BRDF plots in threads, without any window.
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "editor/jobs/background_job.h"
#include "renderer/plot/brdf_charts.h"

namespace editor {

using SharedBrdf = std::shared_ptr<const reflectance::Brdf>;

struct LobeCurves {
  std::vector<plot::LobeCurve> curves;
  QString scheme_error;  ///< why there is no pdf though one was requested
};

/// Evaluates the BRDF and the pdf along the plane of incidence. Building the scheme's tables may take seconds
/// and is not interruptible; evaluation is fast. The result is incomplete if the flag was set.
LobeCurves lobe_curves(const reflectance::Brdf& brdf, const std::vector<double>& views,
                       const std::optional<grf::PdfModel>& scheme, const StopFlag& stop);

/// The model's statement about energy conservation, and where it reflects more light than it receives.
struct EnergyNote {
  QString text;
  bool is_warning = false;
};
EnergyNote energy_note(const reflectance::Brdf& brdf, const grf::LargestAlbedo& largest);

/// Formats comma-separated columns: angles, then f of each view in three channels, and pdfs if there are any.
QString curves_csv(const LobeCurves& curves);
QString albedo_csv(const plot::AlbedoCurve& curve);

}  // namespace editor
