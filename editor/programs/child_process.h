#pragma once

#include <QByteArray>
#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <cstdint>

namespace editor {

/// How a child process is treated.
struct ChildManners {
  int niceness = 0;     ///< see nice(2): the window comes before a child with more
  int patience = 2000;  ///< milliseconds to end by itself once it is cancelled
  /// Bytes of address space, which sanitizers do not heed, and of each file that it writes; 0: no limit.
  std::uint64_t memory = 0;
  /// Descriptors that become its standard output and standard error; -1: these are heard.
  int output = -1;
  int errors = -1;
};

/// How a child process ended.
struct ChildEnd {
  enum class Cause { Returned, NotStarted, Crashed, Cancelled };
  Cause cause = Cause::Returned;
  int code = 0;  ///< what it returned
  QString why;   ///< it was not started
};

/// Runs another program, one command at a time, and hears it line by line. It ends with the editor, even if
/// that crashes, and leaves no core dumps.
class ChildProcess : public QObject {
  Q_OBJECT

 public:
  explicit ChildProcess(const ChildManners& manners = {}, QObject* parent = nullptr);
  /// A child that still runs is cancelled, and waited for; no signal comes.
  ~ChildProcess() override;

  void start(const QString& program, const QStringList& arguments);
  bool is_running() const { return process_.state() != QProcess::NotRunning; }
  /// For threads without an event loop: waits so many milliseconds at most for `ended`, which comes before
  /// this returns true.
  bool wait(int milliseconds) { return process_.waitForFinished(milliseconds); }
  /// Asks for what there is so far, by SIGINT. `ended` follows.
  void interrupt();
  /// Asks it to end, by SIGTERM, and ends it if its patience is over. `ended` follows.
  void cancel();
  /// The same, and waits for it: `ended` comes before this returns.
  void finish();
  /// Ends it at once. No signal comes.
  void kill();

 signals:
  /// A line of standard output or of standard error, with its end if it has one.
  void wrote(const QByteArray& line);
  void logged(const QByteArray& line);
  void ended(const editor::ChildEnd& end);

 private:
  void ask_to_end(int signal);
  void read_lines(bool are_last);
  void end(int code, QProcess::ExitStatus status);

  const ChildManners manners_;
  QProcess process_;
  QTimer deadline_;  // of a child that was cancelled
  int asked_ = 0;    // the signal that asked it to end
};

}  // namespace editor
