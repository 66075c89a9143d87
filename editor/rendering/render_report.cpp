#include "editor/rendering/render_report.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

#include "editor/rendering/json_number.h"

namespace editor {
namespace {

std::vector<ForecastTime> forecasts(const QJsonObject& object) {
  std::vector<ForecastTime> times;
  for (const auto& value : object.value(QLatin1String("forecasts")).toArray()) {
    const QJsonObject forecast = value.toObject();
    const QJsonArray interval = forecast.value(QLatin1String("seconds_interval")).toArray();
    const auto bound = [&](int i) {
      return interval.at(i).isDouble() ? std::optional(interval.at(i).toDouble()) : std::nullopt;
    };
    const double target = number_in(forecast, "target_error").value_or(0);
    if (target > 0) times.push_back({target, number_in(forecast, "seconds"), bound(0), bound(1)});
  }
  return times;
}

std::optional<VisibleNoiseReport> visible_noise(const QJsonObject& summary) {
  const QJsonObject noise = summary.value(QLatin1String("visible_difference")).toObject();
  const auto percentile = number_in(noise, "percentile_95");
  if (!percentile) return std::nullopt;
  return VisibleNoiseReport{*percentile, number_in(noise, "samples_needed").value_or(0)};
}

std::optional<ShareInterval> share(const QJsonValue& value) {
  const QJsonObject object = value.toObject();
  const QJsonArray interval = object.value(QLatin1String("interval")).toArray();
  const auto share = number_in(object, "share");
  if (!share || interval.size() != 2) return std::nullopt;
  return ShareInterval{*share, interval.at(0).toDouble(), interval.at(1).toDouble()};
}

class ReportText {
  Q_DECLARE_TR_FUNCTIONS(editor::RenderReport)
};

}  // namespace

std::optional<RenderReport> render_report_of(const QByteArray& line) {
  const QJsonObject object = QJsonDocument::fromJson(line).object();
  if (const auto parts_done = number_in(object, "parts_done")) {
    const FarmReport farm = {static_cast<int>(number_in(object, "parts").value_or(0)),
                             static_cast<int>(*parts_done),
                             static_cast<int>(number_in(object, "workers").value_or(0))};
    const double done = farm.parts > 0 ? *parts_done / farm.parts : 0;
    return RenderReport{done, 0,   number_in(object, "seconds_left"), number_in(object, "estimated_error"),
                        {},   farm};
  }
  const auto done = number_in(object, "done");
  if (!done) return std::nullopt;
  return RenderReport{*done, number_in(object, "seconds").value_or(0), number_in(object, "seconds_left"),
                      number_in(object, "estimated_error"), forecasts(object)};
}

std::vector<ForecastTime> forecast_times_of(const QByteArray& line) {
  return forecasts(QJsonDocument::fromJson(line).object());
}

std::optional<RenderSummary> render_summary_of(const QByteArray& line) {
  const QJsonObject object = QJsonDocument::fromJson(line).object();
  const auto samples = number_in(object, "samples");
  if (!samples || !object.contains(QLatin1String("output"))) return std::nullopt;
  return RenderSummary{static_cast<int>(number_in(object, "width").value_or(0)),
                       static_cast<int>(number_in(object, "height").value_or(0)),
                       *samples,
                       number_in(object, "render_seconds").value_or(0),
                       number_in(object, "estimated_error"),
                       visible_noise(object)};
}

std::optional<BakeSummary> bake_summary_of(const QByteArray& line) {
  const QJsonObject object = QJsonDocument::fromJson(line).object();
  const auto vertices = number_in(object, "vertices");
  if (!vertices) return std::nullopt;
  return BakeSummary{*vertices, number_in(object, "samples").value_or(0),
                     number_in(object, "render_seconds").value_or(0), number_in(object, "estimated_error")};
}

std::optional<EffectShares> effect_shares_of(const QByteArray& line) {
  const QJsonObject all = QJsonDocument::fromJson(line).object();
  const QJsonObject object = all.value(QLatin1String("measured")).toObject();
  if (object.isEmpty()) return std::nullopt;
  return EffectShares{object.value(QLatin1String("name")).toString(),
                      share(object.value(QLatin1String("light"))), share(object.value(QLatin1String("time"))),
                      number_in(object, "difference")};
}

QString duration_text(double seconds) {
  if (seconds < 10) return ReportText::tr("%1 s").arg(seconds, 0, 'f', 1);
  const auto whole = std::lround(seconds);
  if (whole < 60) return ReportText::tr("%1 s").arg(whole);
  const auto two_digits = [](long value) { return QStringLiteral("%1").arg(value, 2, 10, QChar('0')); };
  if (whole < 3600) return ReportText::tr("%1 min %2 s").arg(whole / 60).arg(two_digits(whole % 60));
  return ReportText::tr("%1 h %2 min").arg(whole / 3600).arg(two_digits(whole % 3600 / 60));
}

QString visible_noise_text(const VisibleNoiseReport& noise) {
  const QString difference = QString::number(noise.percentile_95, 'f', noise.percentile_95 < 10 ? 1 : 0);
  if (noise.percentile_95 < 1) return ReportText::tr("The eye sees no noise: ΔE %1").arg(difference);
  const double digits = std::pow(10, std::floor(std::log10(std::max(noise.samples_needed, 1.0))) - 1);
  const double rounded =
      digits < 1 ? noise.samples_needed : std::round(noise.samples_needed / digits) * digits;
  return ReportText::tr("The eye sees noise: ΔE %1, until about %2 samples")
      .arg(difference)
      .arg(rounded, 0, 'f', 0);
}

QString percent_text(double fraction) { return ReportText::tr("%1 %").arg(100 * fraction, 0, 'g', 3); }

}  // namespace editor
