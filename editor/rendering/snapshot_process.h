#pragma once

#include <QObject>
#include <QTemporaryDir>
#include <memory>

#include "editor/jobs/background_job.h"
#include "editor/rendering/final_render.h"
#include "editor/rendering/renderer_process.h"

namespace editor {

/// Runs `bpt` in the background on a snapshot of the scene, unsaved edits included. It has the lowest
/// priority, so that a preview is not slowed down.
class SnapshotProcess : public QObject {
  Q_OBJECT

 public:
  explicit SnapshotProcess(QString program = bundled_program("bpt"), QObject* parent = nullptr);
  ~SnapshotProcess() override { stop(); }

  /// Runs a command, such as `plan`, with the flags. It replaces the one that is running.
  void start(FinalRenderRequest request, const QString& command, const QStringList& flags);
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
  /// The input files of the program.
  struct Files {
    QString options;  ///< path of an OP file; empty if it could not be written
    QString problem;
  };

  void end(const RendererEnd& end);
  void give_up(const QString& why);

  const std::shared_ptr<const QTemporaryDir> folder_;  ///< writing may outlive this
  bool is_running_ = false;
  BackgroundJob<Files> writing_{this};
  RendererProcess process_;
};

}  // namespace editor
