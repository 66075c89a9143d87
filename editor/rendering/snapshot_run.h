#pragma once

#include <QObject>
#include <QTemporaryDir>

#include "editor/jobs/background_job.h"
#include "editor/rendering/final_render.h"
#include "editor/rendering/renderer_process.h"

namespace editor {

/// Runs a command of `bpt` on a snapshot of the scene, with its unsaved edits and options, in the background.
/// It has the lowest priority, so that a preview is not slowed down.
class SnapshotRun : public QObject {
  Q_OBJECT

 public:
  explicit SnapshotRun(QString program = bundled_program("bpt"), QObject* parent = nullptr);
  ~SnapshotRun() override { stop(); }

  /// Starts a command, such as `render`, with the snapshot's OP file and more arguments after it. Replaces
  /// the one that is running.
  void start(const QString& command, FinalRenderRequest request, const QStringList& arguments);
  /// Cancels the command that is running. No signal follows.
  void stop();
  bool is_running() const { return is_running_; }

 signals:
  /// Emitted with a line of standard output.
  void reported(const QByteArray& line);
  /// Emitted at the end, with an error message without a full stop, or an empty one.
  void ended(const QString& problem);

 private:
  /// The input files of the program.
  struct Files {
    QString options;  ///< path of an OP file; empty if it could not be written
    QString problem;
  };

  void end(const QString& problem);

  QTemporaryDir folder_;
  bool is_running_ = false;
  BackgroundJob<Files> writing_{this};
  RendererProcess process_;
};

}  // namespace editor
