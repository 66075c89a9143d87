#include "editor/rendering/renderer_process.h"

#include <QCoreApplication>
#include <csignal>
#include <utility>

#include <sys/prctl.h>
#include <unistd.h>

#include "grf/exit_code.h"

namespace editor {
namespace {

/// For keeping what there is of a run that is ended as the editor quits.
constexpr int QuitMilliseconds = 5000;

}  // namespace

RendererProcess::RendererProcess(QString program, QObject* parent)
    : QObject(parent), program_(std::move(program)) {
  connect(&process_, &QProcess::started, this, [this] {
    if (is_to_end_) interrupt();
  });
  connect(&process_, &QProcess::readyReadStandardOutput, this, &RendererProcess::read_reports);
  connect(&process_, &QProcess::readyReadStandardError, this, &RendererProcess::read_log);
  connect(&process_, &QProcess::finished, this, &RendererProcess::end);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;
    emit ended({false, tr("the renderer %1 does not start: %2").arg(program_, process_.errorString())});
  });
  // The window comes first; and a render must not outlive an editor that crashed.
  process_.setChildProcessModifier([] {
    static_cast<void>(::nice(5));
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  });
}

RendererProcess::~RendererProcess() {
  process_.disconnect(this);
  if (process_.state() == QProcess::NotRunning) return;
  process_.terminate();
  if (!process_.waitForFinished(QuitMilliseconds)) kill();
}

QString RendererProcess::why_missing() const {
  if (!program_.isEmpty()) return {};
  return tr("the renderer 'bpt' is missing: it belongs into the folder %1, or into one of PATH")
      .arg(QCoreApplication::applicationDirPath());
}

void RendererProcess::start(const QStringList& arguments) {
  log_.clear();
  is_to_end_ = false;
  process_.start(program_, arguments);
}

void RendererProcess::interrupt() {
  is_to_end_ = true;
  if (process_.state() == QProcess::Running) ::kill(static_cast<pid_t>(process_.processId()), SIGINT);
}

void RendererProcess::kill() {
  const QSignalBlocker silence(process_);
  process_.kill();
  process_.waitForFinished();
}

void RendererProcess::read_reports() {
  process_.setReadChannel(QProcess::StandardOutput);
  while (process_.canReadLine()) emit reported(process_.readLine());
}

void RendererProcess::read_log() {
  process_.setReadChannel(QProcess::StandardError);
  while (process_.canReadLine()) log(process_.readLine());
}

void RendererProcess::log(const QByteArray& bytes) {
  QString line = QString::fromUtf8(bytes);
  while (line.endsWith('\n')) line.chop(1);
  if (line.isEmpty()) return;
  log_.append(line);
  emit logged(line);
}

void RendererProcess::end(int exit_code, QProcess::ExitStatus status) {
  read_reports();
  read_log();
  log(process_.readAllStandardError());  // a last line without its end
  RendererEnd end;
  const bool has_crashed = status == QProcess::CrashExit;
  // A program that has only just started does not yet know how to end in order.
  end.is_interrupted = has_crashed ? is_to_end_ : exit_code == static_cast<int>(grf::ExitCode::Interrupted);
  if (!end.is_interrupted && has_crashed) {
    end.problem = tr("the renderer was ended by a signal");
  } else if (!end.is_interrupted && exit_code != 0) {
    end.problem = log_.isEmpty() ? tr("the renderer ended with code %1").arg(exit_code) : log_.join('\n');
  }
  emit ended(end);
}

}  // namespace editor
