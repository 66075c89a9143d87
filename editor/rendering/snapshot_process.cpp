#include "editor/rendering/snapshot_process.h"

#include <utility>

#include "editor/controls/text.h"
#include "editor/document/op_files.h"
#include "editor/rendering/render_files.h"

namespace editor {
namespace {

constexpr int LowestPriority = 19;

}  // namespace

SnapshotProcess::SnapshotProcess(QString program, QObject* parent)
    : QObject(parent),
      folder_(std::make_shared<const QTemporaryDir>()),
      process_(std::move(program), nullptr, LowestPriority) {
  connect(&process_, &RendererProcess::reported, this, &SnapshotProcess::reported);
  connect(&process_, &RendererProcess::ended, this, &SnapshotProcess::end);
}

void SnapshotProcess::start(FinalRenderRequest request, const QString& command, const QStringList& flags) {
  stop();
  if (const QString why = process_.why_missing(); !why.isEmpty()) return emit failed(why);
  is_running_ = true;
  const QString base = folder_->filePath("snapshot");
  request.options = with_absolute_paths(std::move(request.options), request.path);
  request.options.scene = (base + ".grf").toStdString();
  request.options.checkpoint.clear();
  writing_.start(
      [request = std::move(request), base, folder = folder_](const StopFlag&) {
        grf::Diagnostics diagnostics;
        const bool is_written = write_snapshot(request.scene, request.path, base + ".grf", diagnostics) &&
                                write_op_file(request.options, base + ".op", diagnostics);
        return is_written ? Files{base + ".op", {}} : Files{{}, text_of(diagnostics)};
      },
      [this, command, flags](const Files& files) {
        if (files.options.isEmpty()) return give_up(files.problem);
        process_.start(QStringList{command, files.options} + flags);
      });
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
