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

/// What a bake left besides the scene.
struct IrradianceBakeResult {
  BakeSummary summary;
  QString messages;         ///< what is to be known of it, as `bpt` prints it; may be empty
  bool is_stopped = false;  ///< before it had all samples, or its target
};

/// Estimates the irradiance at the vertices of a scene with the program `bpt`, from a snapshot: editing goes
/// on meanwhile. One at a time.
class IrradianceBake : public QObject {
  Q_OBJECT

 public:
  explicit IrradianceBake(QString program = bundled_program("bpt"), QObject* parent = nullptr);
  /// A bake that goes on is given up.
  ~IrradianceBake() override;

  /// The path is that of the scene's file; empty: it has none yet. Of the options count those of light
  /// (surroundings, depth, sampling scheme), of effort (samples, which are a vertex's here, target error,
  /// time, threads), the seed, and the eye, which is noted as the observer of a scene that names none.
  /// What keeps it from that is said by `failed`.
  void start(const grf::Scene& scene, const QString& path, options::RenderOptions render_options = {});
  /// Ends it with what there is.
  void stop();
  bool is_running() const { return is_running_; }

 signals:
  void progressed(double done, std::optional<double> seconds_left);
  /// The bake has irradiance for the scene of `start`, which may be another one by now.
  void finished(const editor::BakedIrradiance& irradiance, const editor::IrradianceBakeResult& result);
  /// There is no irradiance, and why; a text without its stop.
  void failed(const QString& why);

 private:
  /// A baked file holds irradiance, or something is wrong with it.
  struct Baked {
    std::optional<BakedIrradiance> irradiance;
    QString problem;
  };

  /// The snapshot's files, by extension.
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
