#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QTemporaryDir>
#include <optional>

#include "editor/rendering/cost_study.h"
#include "editor/rendering/final_render.h"
#include "renderer/transport/camera.h"

namespace editor {

/// What a cost study compares: lists as on the command line of `bpt cost`; an empty one keeps the options.
struct CostSettings {
  QStringList schemes;
  QStringList integrators;
  QString ways;
  QString samples;
  int rounds = 4;
  std::optional<transport::CropWindow> crop;
};

/// Measures a snapshot of the scene with `bpt cost`, while editing continues. Its files stay in a temporary
/// folder until the next study.
class CostRun : public QObject {
  Q_OBJECT

 public:
  explicit CostRun(QString program = bundled_program("bpt"), QObject* parent = nullptr);
  ~CostRun() override;

  /// Starts a study, or continues that of a JSON file.
  void start(const FinalRenderRequest& request, const CostSettings& settings, const QString& continued = {});
  /// Ends the study, and keeps what was measured. `ended` follows.
  void stop();
  bool is_running() const { return is_running_; }

  /// The JSON of the last study that ended; it exists if anything was measured. The table, the figure and the
  /// reference are beside it.
  QString file() const { return folder_.filePath("study.json"); }

 signals:
  /// Emitted with the study so far after each measurement.
  void measured(const editor::CostStudy& study);
  void progressed(double done);
  /// Emitted at the end; the problem is empty unless it failed.
  void ended(const QString& problem);

 private:
  void run(const QString& problem);
  void read(const QByteArray& line);
  void end(const QString& problem);

  QTemporaryDir folder_;
  QStringList arguments_;
  QFutureWatcher<QString> writing_;
  bool is_running_ = false;
  bool is_stopped_ = false;
  RendererProcess process_;
};

}  // namespace editor
