#pragma once

#include "editor/rendering/render_report.h"
#include "editor/rendering/snapshot_process.h"

namespace editor {

/// Forecasts the time of a final render until some target errors, by a probe of a few seconds: `bpt render
/// --forecast` on a snapshot of the scene, with its final size and options. It counts processor time, so that
/// a preview does not falsify it.
class RenderForecast : public QObject {
  Q_OBJECT

 public:
  explicit RenderForecast(QString program = bundled_program("bpt"), QObject* parent = nullptr);

  /// Starts a forecast, which replaces the one that is being made.
  void start(FinalRenderRequest request);
  /// Cancels the forecast that is being made. No signal follows.
  void stop() { process_.stop(); }
  bool is_running() const { return process_.is_running(); }

 signals:
  /// Emitted several times, at first with wide intervals.
  void forecast(const std::vector<editor::ForecastTime>& times);
  /// Emitted with the reason, without a full stop, if there is no forecast.
  void failed(const QString& why);

 private:
  SnapshotProcess process_;
};

}  // namespace editor
