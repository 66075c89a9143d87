#pragma once

#include <QObject>
#include <optional>

#include "editor/rendering/cost_study.h"
#include "editor/rendering/snapshot_process.h"
#include "renderer/transport/camera.h"

namespace editor {

/// These settings say what a cost study compares: lists as on the command line of `bpt cost`; an empty one
/// keeps the options.
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

  /// Starts a study, or continues that of a JSON file.
  void start(const FinalRenderRequest& request, const CostSettings& settings, const QString& continued = {});
  /// Ends the study, and keeps what was measured. `ended` follows.
  void stop() { process_.interrupt(); }
  bool is_running() const { return process_.is_running(); }

  /// The JSON of the last study that ended; it exists if anything was measured. The table, the figure and the
  /// reference are beside it.
  QString file() const { return process_.folder() + "/study.json"; }

 signals:
  /// Emitted with the study so far after each measurement.
  void measured(const editor::CostStudy& study);
  void progressed(double done);
  /// Emitted at the end; the problem is empty unless it failed.
  void ended(const QString& problem);

 private:
  void read(const QByteArray& line);

  SnapshotProcess process_;
};

}  // namespace editor
