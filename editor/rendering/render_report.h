// Parses the progress reports of `bpt`, one line of JSON each.
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>
#include <vector>

namespace editor {

/// The forecast time of a render until its error is at most a target. Times without a value are beyond any
/// render.
struct ForecastTime {
  double target_error = 0;        ///< sqrt(relMSE)
  std::optional<double> seconds;  ///< the median
  std::optional<double> low;      ///< bounds of an interval with 90 % probability; none without a forecast
  std::optional<double> high;
};

/// Progress of a render on a farm.
struct FarmReport {
  int parts = 0;
  int parts_done = 0;
  int workers = 0;  ///< that work for the image
};

/// Progress of a render.
struct RenderReport {
  double done = 0;  ///< 0..1
  double seconds = 0;
  std::optional<double> seconds_left;     ///< none if unknown
  std::optional<double> estimated_error;  ///< sqrt(relMSE)
  std::vector<ForecastTime> forecasts;    ///< of the whole render; empty while there are none
  std::optional<FarmReport> farm = {};    ///< none of a render on this machine
};

/// The visible noise of an image is what the eye sees of it, see transport::VisibleNoise.
struct VisibleNoiseReport {
  double percentile_95 = 0;   ///< of the differences, in units of CIEDE2000
  double samples_needed = 0;  ///< per pixel, until it is not seen
};

/// Summary of a render.
struct RenderSummary {
  int width = 0;  ///< pixels
  int height = 0;
  double samples = 0;  ///< per pixel
  double seconds = 0;
  std::optional<double> estimated_error;
  std::optional<VisibleNoiseReport> visible_noise = {};
};

/// The part of something that is lost without an effect, with its 95 % confidence interval.
struct ShareInterval {
  double share = 0;
  double low = 0;
  double high = 0;
};

/// An effect contributes a share of the light and costs a share of the time, as `bpt plan --measure` measures
/// them; see renderer/EFFECTS.md.
struct EffectShares {
  QString name;                        ///< as in renderer/EFFECTS.md
  std::optional<ShareInterval> light;  ///< none if the image is black
  std::optional<ShareInterval> time;
  std::optional<double>
      difference;  ///< of pixels, RMS, as a fraction of the mean; none if the image is black
};

/// Summary of a bake of irradiance.
struct BakeSummary {
  double vertices = 0;  ///< number of vertices with irradiance
  double samples = 0;   ///< per vertex
  double seconds = 0;
  std::optional<double> estimated_error;  ///< sqrt(relMSE)
};

/// Parses a progress report; nothing if the line is another one.
std::optional<RenderReport> render_report_of(const QByteArray& line);
/// Parses the forecasts of a progress report or of `bpt render --forecast`; empty if the line has none.
std::vector<ForecastTime> forecast_times_of(const QByteArray& line);
std::optional<RenderSummary> render_summary_of(const QByteArray& line);
std::optional<BakeSummary> bake_summary_of(const QByteArray& line);

/// Parses the line of a measured effect; nothing if the line is another one.
std::optional<EffectShares> effect_shares_of(const QByteArray& line);

/// Formats a duration: `12 s`, `4 min 05 s`, `2 h 07 min`.
QString duration_text(double seconds);
/// Says what is visible of the noise, and from how many samples on nothing is.
QString visible_noise_text(const VisibleNoiseReport& noise);
/// Formats a fraction in percent with three digits: `1.25 %`.
QString percent_text(double fraction);

}  // namespace editor
