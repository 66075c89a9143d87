// Computes in threads what the plots of a BRDF show, without any window.
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
  QString scheme_mistake;  ///< why there is no density though one was asked for
};

/// The scheme's tables are made first, which may take seconds and is not stopped half-way; values are without
/// it quick. Half a result, which nobody sees, if the flag is set.
LobeCurves lobe_curves(const reflectance::Brdf& brdf, const std::vector<double>& views,
                       const std::optional<grf::PdfModel>& scheme, const StopFlag& stop);

/// In the model's own words: what is said of energy, and where it reflects more than it receives.
struct EnergyWords {
  QString text;
  bool is_warning = false;
};
EnergyWords energy_words(const reflectance::Brdf& brdf, const grf::LargestAlbedo& largest);

/// Comma-separated columns: angles, then f of each view in three channels, and densities where there are any.
QString curves_csv(const LobeCurves& curves);
QString albedo_csv(const plot::AlbedoCurve& curve);

}  // namespace editor
