#pragma once

#include <QObject>
#include <QTemporaryDir>

#include "editor/jobs/background_job.h"
#include "editor/rendering/final_render.h"
#include "editor/rendering/render_report.h"
#include "editor/rendering/renderer_process.h"

namespace editor {

/// Forecasts the time of a final render until some target errors, by a probe of a few seconds: `bpt render
/// --forecast` on a snapshot of the scene, with its final size and options. It has the lowest priority, so
/// that a preview is not slowed down, and counts processor time, so that a preview does not falsify it.
class RenderForecast : public QObject {
  Q_OBJECT

 public:
  explicit RenderForecast(QString program = bundled_program("bpt"), QObject* parent = nullptr);
  ~RenderForecast() override { stop(); }

  /// Starts a forecast, which replaces the one that is being made.
  void start(FinalRenderRequest request);
  /// Cancels the forecast that is being made. No signal follows.
  void stop();
  bool is_running() const { return is_running_; }

 signals:
  /// Emitted several times, at first with wide intervals.
  void forecast(const std::vector<editor::ForecastTime>& times);
  /// Emitted with the reason, without a full stop, if there is no forecast.
  void failed(const QString& why);

 private:
  /// The input files of the program.
  struct Files {
    QString options;  ///< path of an OP file; empty if it could not be written
    QString problem;
  };

  void run(const Files& files);
  void read(const QByteArray& line);
  void end(const RendererEnd& end);
  void give_up(const QString& why);

  QTemporaryDir folder_;
  bool is_running_ = false;
  BackgroundJob<Files> writing_{this};
  RendererProcess process_;
};

}  // namespace editor
