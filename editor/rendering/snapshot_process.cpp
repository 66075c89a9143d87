#include "editor/rendering/snapshot_process.h"

#include <utility>

#include "editor/document/op_files.h"
#include "editor/rendering/render_files.h"

namespace editor {

SnapshotProcess::SnapshotProcess(QString program, QObject* parent, int niceness)
    : QObject(parent),
      folder_(std::make_shared<const QTemporaryDir>()),
      process_(std::move(program), nullptr, niceness) {
  connect(&process_, &RendererProcess::reported, this, &SnapshotProcess::reported);
  connect(&process_, &RendererProcess::ended, this, &SnapshotProcess::end);
}

void SnapshotProcess::start(FinalRenderRequest request, const QString& command, const QStringList& flags) {
  stop();
  if (const QString why = process_.why_missing(); !why.isEmpty()) return emit failed(why);
  is_running_ = true;
  const QString base = folder_->filePath("scene");
  request.options = with_absolute_paths(std::move(request.options), request.path);
  request.options.scene = (base + ".grf").toStdString();
  request.options.checkpoint.clear();
  request.options.shows_window = false;
  writing_.start(
      [request = std::move(request), base, folder = folder_](const StopFlag&) {
        return write_snapshot_files(request.scene, request.path, request.options, base);
      },
      [this, command, flags, base](const QString& problem) {
        if (!problem.isEmpty()) return give_up(problem);
        process_.start(QStringList{command, base + ".op"} + flags);
      });
}

void SnapshotProcess::interrupt() {
  if (!writing_.is_busy()) return process_.interrupt();
  stop();
  emit finished();
}

void SnapshotProcess::stop() {
  writing_.stop();
  process_.kill();
  is_running_ = false;
}

void SnapshotProcess::end(const RendererEnd& end) {
  if (!end.problem.isEmpty()) return give_up(end.problem);
  is_running_ = false;
  emit finished();
}

void SnapshotProcess::give_up(const QString& why) {
  is_running_ = false;
  emit failed(why);
}

}  // namespace editor
