#pragma once

#include <QByteArray>
#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <cstdint>

namespace editor {

/// Priority and resource limits of a child process.
struct ChildSettings {
  int niceness = 0;              ///< see nice(2): above 0, the editor's window has priority
  int terminate_timeout = 2000;  ///< timeout after SIGTERM, milliseconds
  /// Limit of address space, which sanitizers ignore, and of each written file, bytes; 0: no limit.
  std::uint64_t memory = 0;
  /// File descriptors that become its standard output and error; -1: they are read here.
  int output = -1;
  int errors = -1;
};

/// How a child process ended.
struct ChildEnd {
  enum class Cause { Returned, NotStarted, Crashed, Cancelled };
  Cause cause = Cause::Returned;
  int code = 0;  ///< exit code
  QString why;   ///< error message if it could not be started
};

/// Runs another program, one command at a time, and reads its output line by line. The child is killed with
/// the editor, even after a crash, and leaves no core dumps.
class ChildProcess : public QObject {
  Q_OBJECT

 public:
  explicit ChildProcess(const ChildSettings& settings = {}, QObject* parent = nullptr);
  /// Cancels a running child and waits for it; no signal follows.
  ~ChildProcess() override;

  void start(const QString& program, const QStringList& arguments);
  bool is_running() const { return process_.state() != QProcess::NotRunning; }
  /// For threads without an event loop: waits at most so many milliseconds for `ended`, which is emitted
  /// before this returns true.
  bool wait(int milliseconds) { return process_.waitForFinished(milliseconds); }
  /// Sends SIGINT: the child stops and keeps its results. `ended` follows.
  void interrupt();
  /// Sends SIGTERM, and SIGKILL after the timeout. `ended` follows.
  void cancel();
  /// Cancels and waits: `ended` is emitted before this returns.
  void finish();
  /// Sends SIGKILL. No signal follows.
  void kill();

 signals:
  /// Emitted with a line of standard output or standard error, including its line end if it has one.
  void wrote(const QByteArray& line);
  void logged(const QByteArray& line);
  void ended(const editor::ChildEnd& end);

 private:
  void ask_to_end(int signal);
  void read_lines(bool are_last);
  void end(int code, QProcess::ExitStatus status);

  const ChildSettings settings_;
  QProcess process_;
  QTimer deadline_;  // of a child that was cancelled
  int asked_ = 0;    // the signal that asked it to end
};

}  // namespace editor
