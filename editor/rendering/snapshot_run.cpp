#include "editor/rendering/snapshot_run.h"

#include <utility>

#include "editor/controls/text.h"
#include "editor/document/op_files.h"
#include "editor/rendering/render_files.h"

namespace editor {
namespace {

constexpr int LowestPriority = 19;

}  // namespace

SnapshotRun::SnapshotRun(QString program, QObject* parent)
    : QObject(parent), process_(std::move(program), nullptr, LowestPriority) {
  connect(&process_, &RendererProcess::reported, this, &SnapshotRun::reported);
  connect(&process_, &RendererProcess::ended, this,
          [this](const RendererEnd& result) { end(result.problem); });
}

void SnapshotRun::start(const QString& command, FinalRenderRequest request, const QStringList& arguments) {
  stop();
  if (const QString why = process_.why_missing(); !why.isEmpty()) return emit ended(why);
  is_running_ = true;
  const QString base = folder_.filePath("snapshot");
  request.options = with_absolute_paths(std::move(request.options), request.path);
  request.options.scene = (base + ".grf").toStdString();
  request.options.checkpoint.clear();
  writing_.start(
      [request = std::move(request), base](const StopFlag&) {
        grf::Diagnostics diagnostics;
        const bool is_written = write_snapshot(request.scene, request.path, base + ".grf", diagnostics) &&
                                write_op_file(request.options, base + ".op", diagnostics);
        return is_written ? Files{base + ".op", {}} : Files{{}, text_of(diagnostics)};
      },
      [this, command, arguments](const Files& files) {
        if (files.options.isEmpty()) return end(files.problem);
        process_.start(QStringList{command, files.options} + arguments);
      });
}

void SnapshotRun::stop() {
  writing_.stop();
  process_.kill();
  is_running_ = false;
}

void SnapshotRun::end(const QString& problem) {
  is_running_ = false;
  emit ended(problem);
}

}  // namespace editor
