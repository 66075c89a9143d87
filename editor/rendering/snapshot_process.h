#pragma once

#include <QObject>
#include <QTemporaryDir>
#include <memory>

#include "editor/jobs/background_job.h"
#include "editor/rendering/final_render.h"
#include "editor/rendering/renderer_process.h"

namespace editor {

/// Runs `bpt` in the background on a snapshot of the scene, unsaved edits included.
class SnapshotProcess : public QObject {
  Q_OBJECT

 public:
  /// With the lowest priority a preview is not slowed down; see nice(2).
  static constexpr int LowestPriority = 19;

  explicit SnapshotProcess(QString program = bundled_program("bpt"), QObject* parent = nullptr,
                           int niceness = LowestPriority);
  ~SnapshotProcess() override { stop(); }

  /// Runs a command, such as `plan`, with the flags. It replaces the one that is running.
  void start(FinalRenderRequest request, const QString& command, const QStringList& flags);
  /// Asks the program to stop and keep its results. `finished` or `failed` follows.
  void interrupt();
  /// Kills the program. No signal follows.
  void stop();
  bool is_running() const { return is_running_; }
  /// A folder for files of the program, which exists as long as this.
  QString folder() const { return folder_->path(); }

 signals:
  /// Emitted with a line of standard output.
  void reported(const QByteArray& line);
  void finished();
  /// Emitted with the reason, without a full stop, if the program failed.
  void failed(const QString& why);

 private:
  void end(const RendererEnd& end);
  void give_up(const QString& why);

  const std::shared_ptr<const QTemporaryDir> folder_;  ///< writing may outlive this
  bool is_running_ = false;
  BackgroundJob<QString> writing_{this};  ///< of the problem
  RendererProcess process_;
};

}  // namespace editor
