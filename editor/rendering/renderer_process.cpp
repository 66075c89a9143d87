#include "editor/rendering/renderer_process.h"

#include <QCoreApplication>
#include <utility>

#include "grf/exit_code.h"

namespace editor {
namespace {

/// A run that is cancelled when the editor quits has some seconds to save.
constexpr int TerminateTimeout = 5000;

}  // namespace

RendererProcess::RendererProcess(QString program, QObject* parent, int niceness)
    : QObject(parent),
      program_(std::move(program)),
      process_({.niceness = niceness, .terminate_timeout = TerminateTimeout}) {
  connect(&process_, &ChildProcess::wrote, this, &RendererProcess::reported);
  connect(&process_, &ChildProcess::logged, this, &RendererProcess::log);
  connect(&process_, &ChildProcess::ended, this, &RendererProcess::end);
}

QString RendererProcess::why_missing() const {
  if (!program_.isEmpty()) return {};
  return tr("cannot find the renderer 'bpt': put it into the folder %1, or into one of PATH")
      .arg(QCoreApplication::applicationDirPath());
}

void RendererProcess::start(const QStringList& arguments) {
  log_.clear();
  process_.start(program_, arguments);
}

void RendererProcess::log(const QByteArray& bytes) {
  QString line = QString::fromUtf8(bytes);
  while (line.endsWith('\n')) line.chop(1);
  if (line.isEmpty()) return;
  log_.append(line);
  emit logged(line);
}

void RendererProcess::end(const ChildEnd& end) {
  using Cause = ChildEnd::Cause;
  RendererEnd result;
  result.is_interrupted =
      end.cause == Cause::Cancelled || end.code == static_cast<int>(grf::ExitCode::Interrupted);
  if (end.cause == Cause::NotStarted) {
    result.problem = tr("cannot start the renderer %1: %2").arg(program_, end.why);
  } else if (end.cause == Cause::Crashed) {
    result.problem = tr("the renderer was terminated by a signal");
  } else if (!result.is_interrupted && end.code != 0) {
    result.problem = log_.isEmpty() ? tr("the renderer exited with code %1").arg(end.code) : log_.join('\n');
  }
  emit ended(result);
}

}  // namespace editor
