// The study of `bpt cost`, as the editor reads it.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "renderer/options/render_options.h"

namespace editor {

/// A row of a study: the mean over its rounds.
struct CostMeasurement {
  int samples = 0;  ///< per pixel
  double seconds = 0;
  double error = 0;  ///< sqrt(relMSE)
};

/// An efficiency, 1 / (relMSE x seconds), with its 95 % interval.
struct EfficiencyInterval {
  double value = 0;
  double low = 0;
  double high = 0;
};

struct CostCurve {
  QString name;
  std::vector<CostMeasurement> rows;             ///< ascending in samples
  std::optional<EfficiencyInterval> efficiency;  ///< nothing while it is unknown
  std::optional<double> seconds_for_1_percent;
  /// error = factor N^-exponent over samples; nothing without a fit.
  std::optional<double> factor, exponent;
  QStringList op;  ///< OP lines of its settings; empty if only a PDF of a scene has them
  QString grf;     ///< PDF of a scene; empty where each BRDF has its own
};

/// A study, or what has been measured of it so far.
struct CostStudy {
  std::vector<CostCurve> curves;
  std::optional<std::size_t> winner;  ///< index of the curve that is clearly more efficient than all others
};

/// Reads a line of `bpt cost --progress json`, or the file that it writes; nothing if it is no study.
std::optional<CostStudy> cost_study_of(const QByteArray& json);

/// Sample counts at which two curves can be compared.
struct SamplePair {
  int a = 0;
  int b = 0;
};

/// Returns the samples of the largest row of A, and of B in the same time: the time per sample is that of
/// their largest rows.
std::optional<SamplePair> samples_at_equal_time(const CostCurve& a, const CostCurve& b);
/// Returns the samples of the largest row of A, and of B at the same error, by the curves; nothing without
/// curves that fall, or if B would need more than a million samples.
std::optional<SamplePair> samples_at_equal_error(const CostCurve& a, const CostCurve& b);

/// Returns the options with the settings of a curve; unchanged by lines that are no options.
options::RenderOptions with_settings(options::RenderOptions render_options, const QStringList& op);

/// Sets the samples per pixel, which for `naive` are rays from the first hit: the nearest square. Returns
/// that number.
int set_samples(options::RenderOptions& render_options, int samples);

}  // namespace editor
