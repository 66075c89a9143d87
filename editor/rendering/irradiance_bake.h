#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QTemporaryDir>
#include <memory>
#include <optional>

#include "editor/rendering/baked_irradiance.h"
#include "editor/rendering/render_report.h"
#include "editor/rendering/renderer_process.h"
#include "grf/scene.h"
#include "renderer/options/render_options.h"

namespace editor {

/// The result of a bake besides the scene.
struct IrradianceBakeResult {
  BakeSummary summary;
  QString messages;         ///< log of `bpt`; may be empty
  bool is_stopped = false;  ///< before it had all samples or reached its target error
};

/// Bakes the irradiance at the vertices of a snapshot of the scene with the program `bpt`, while editing
/// continues. One bake at a time.
class IrradianceBake : public QObject {
  Q_OBJECT

 public:
  explicit IrradianceBake(QString program = bundled_program("bpt"), QObject* parent = nullptr);
  /// Cancels a running bake.
  ~IrradianceBake() override;

  /// Starts a bake. The path is that of the scene's file; empty if it has none. The options used are those of
  /// light (environment, depth, sampling scheme), of effort (samples per vertex, target error, time,
  /// threads), the seed, and the eye, which becomes the observer of a scene without one. `failed` reports why
  /// the bake cannot start.
  void start(const grf::Scene& scene, const QString& path, options::RenderOptions render_options = {});
  /// Stops the bake and keeps what was computed.
  void stop();
  bool is_running() const { return is_running_; }

 signals:
  void progressed(double done, std::optional<double> seconds_left);
  /// Emitted with the irradiance for the scene of `start`, which may have been edited meanwhile.
  void finished(const editor::BakedIrradiance& irradiance, const editor::IrradianceBakeResult& result);
  /// Emitted with the reason, without a full stop, when there is no irradiance.
  void failed(const QString& why);

 private:
  /// The baked file, or the diagnostics of reading it.
  struct Baked {
    std::optional<BakedIrradiance> irradiance;
    QString problem;
  };

  /// The snapshot's file with an extension.
  QString file(const char* extension) const;
  void run(const QString& problem);
  void read(const QByteArray& line);
  void end(const RendererEnd& end);
  void finish();
  void give_up(const QString& why);
  QString without_snapshot(QString text) const;

  QTemporaryDir folder_;
  bool is_running_ = false;
  bool is_stopped_ = false;
  grf::Scene snapshot_;
  QFutureWatcher<QString> writing_;
  QFutureWatcher<std::shared_ptr<Baked>> reading_;
  RendererProcess process_;
  std::optional<BakeSummary> summary_;
  IrradianceBakeResult result_;
};

}  // namespace editor
