// What `bpt` says of a render or a bake, a line of JSON at a time.
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>

namespace editor {

/// How far a render is.
struct RenderReport {
  double done = 0;  ///< 0..1
  double seconds = 0;
  std::optional<double> seconds_left;     ///< nothing while that cannot be known
  std::optional<double> estimated_error;  ///< sqrt(relMSE)
};

/// What a render came to.
struct RenderSummary {
  int width = 0;  ///< pixels
  int height = 0;
  double samples = 0;  ///< a pixel
  double seconds = 0;
  std::optional<double> estimated_error;
};

/// What a bake of irradiance came to.
struct BakeSummary {
  double vertices = 0;  ///< that have irradiance
  double samples = 0;   ///< a vertex
  double seconds = 0;
  std::optional<double> estimated_error;  ///< sqrt(relMSE)
};

/// Nothing if the line is another one.
std::optional<RenderReport> render_report_of(const QByteArray& line);
std::optional<RenderSummary> render_summary_of(const QByteArray& line);
std::optional<BakeSummary> bake_summary_of(const QByteArray& line);

/// A duration as people say it: `12 s`, `4 min 05 s`, `2 h 07 min`.
QString duration_text(double seconds);
/// A share in percent, in three digits: `1.25 %`.
QString percent_text(double share);

}  // namespace editor
