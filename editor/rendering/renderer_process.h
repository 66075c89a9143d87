#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QStringList>

#include "editor/programs/bundled_program.h"
#include "editor/programs/child_process.h"

namespace editor {

/// How a run of the renderer ended.
struct RendererEnd {
  bool is_interrupted = false;  ///< stopped early on request
  QString problem;              ///< error message, perhaps several lines; empty on success
};

/// Runs the program `bpt`, one command at a time, and reads its output line by line.
class RendererProcess : public QObject {
  Q_OBJECT

 public:
  /// The window has priority over a process with this niceness; see nice(2).
  static constexpr int DefaultNiceness = 5;

  explicit RendererProcess(QString program = bundled_program("bpt"), QObject* parent = nullptr,
                           int niceness = DefaultNiceness);
  /// Why the program cannot be run; empty if it was found.
  QString why_missing() const;
  void start(const QStringList& arguments);
  /// Asks the program to stop and keep its results. `ended` follows.
  void interrupt() { process_.interrupt(); }
  /// Kills the program and discards its results. No signal follows.
  void kill() { process_.kill(); }
  /// The log since the start.
  const QStringList& lines() const { return log_; }

 signals:
  /// Emitted with a line of standard output.
  void reported(const QByteArray& line);
  /// Emitted with a line of the log.
  void logged(const QString& line);
  void ended(const editor::RendererEnd& end);

 private:
  void log(const QByteArray& bytes);
  void end(const ChildEnd& end);

  const QString program_;
  ChildProcess process_;
  QStringList log_;
};

}  // namespace editor
