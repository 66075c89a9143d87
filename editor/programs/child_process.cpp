#include "editor/programs/child_process.h"

#include <csignal>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "confinement/address_space.h"

namespace editor {
namespace {

/// Runs in the child before the program starts.
void prepare_child(const ChildSettings& settings) {
  static_cast<void>(::nice(settings.niceness));
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  const rlimit none = {0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  if (settings.output >= 0) ::dup2(settings.output, STDOUT_FILENO);
  if (settings.errors >= 0) ::dup2(settings.errors, STDERR_FILENO);
  if (settings.memory == 0) return;
  const rlimit memory = {settings.memory, settings.memory};
  ::setrlimit(RLIMIT_FSIZE, &memory);
  if (confinement::CanLimitAddressSpace) ::setrlimit(RLIMIT_AS, &memory);
}

}  // namespace

ChildProcess::ChildProcess(const ChildSettings& settings, QObject* parent)
    : QObject(parent), settings_(settings) {
  deadline_.setSingleShot(true);
  connect(&deadline_, &QTimer::timeout, &process_, &QProcess::kill);
  connect(&process_, &QProcess::started, this, [this] {
    if (asked_ != 0) ask_to_end(asked_);
  });
  connect(&process_, &QProcess::readyReadStandardOutput, this, [this] { read_lines(false); });
  connect(&process_, &QProcess::readyReadStandardError, this, [this] { read_lines(false); });
  connect(&process_, &QProcess::finished, this, &ChildProcess::end);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;
    deadline_.stop();
    emit ended({ChildEnd::Cause::NotStarted, 0, process_.errorString()});
  });
  process_.setChildProcessModifier([settings] { prepare_child(settings); });
}

ChildProcess::~ChildProcess() {
  blockSignals(true);
  finish();
  process_.disconnect(this);
}

void ChildProcess::start(const QString& program, const QStringList& arguments) {
  asked_ = 0;
  process_.start(program, arguments);
}

void ChildProcess::interrupt() { ask_to_end(SIGINT); }

void ChildProcess::cancel() {
  if (!is_running()) return;
  ask_to_end(SIGTERM);
  deadline_.start(settings_.terminate_timeout);
}

void ChildProcess::finish() {
  if (!is_running()) return;
  cancel();
  if (process_.state() == QProcess::Starting) process_.waitForStarted(settings_.terminate_timeout);
  if (process_.waitForFinished(settings_.terminate_timeout)) return;
  process_.kill();
  process_.waitForFinished();
}

void ChildProcess::kill() {
  const QSignalBlocker silence(process_);
  deadline_.stop();
  process_.kill();
  process_.waitForFinished();
}

void ChildProcess::ask_to_end(int signal) {
  asked_ = signal;
  // A child that is still starting is signalled as soon as it runs.
  if (process_.state() == QProcess::Running) ::kill(static_cast<pid_t>(process_.processId()), signal);
}

void ChildProcess::read_lines(bool are_last) {
  process_.setReadChannel(QProcess::StandardOutput);
  while (process_.canReadLine() || (are_last && process_.bytesAvailable() > 0))
    emit wrote(process_.readLine());
  process_.setReadChannel(QProcess::StandardError);
  while (process_.canReadLine() || (are_last && process_.bytesAvailable() > 0))
    emit logged(process_.readLine());
}

void ChildProcess::end(int code, QProcess::ExitStatus status) {
  deadline_.stop();
  read_lines(true);
  ChildEnd end;
  if (status == QProcess::CrashExit) {
    // A program that has just started may not handle the signal yet.
    end.cause = asked_ != 0 ? ChildEnd::Cause::Cancelled : ChildEnd::Cause::Crashed;
  } else {
    end.code = code;
  }
  emit ended(end);
}

}  // namespace editor
