#include "editor/rendering/render_forecast.h"

#include <utility>

#include "editor/controls/text.h"
#include "editor/document/op_files.h"
#include "editor/rendering/render_files.h"

namespace editor {
namespace {

constexpr int LowestPriority = 19;

}  // namespace

RenderForecast::RenderForecast(QString program, QObject* parent)
    : QObject(parent), process_(std::move(program), nullptr, LowestPriority) {
  connect(&process_, &RendererProcess::reported, this, &RenderForecast::read);
  connect(&process_, &RendererProcess::ended, this, &RenderForecast::end);
}

void RenderForecast::start(FinalRenderRequest request) {
  stop();
  if (const QString why = process_.why_missing(); !why.isEmpty()) return emit failed(why);
  is_running_ = true;
  const QString base = folder_.filePath("forecast");
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
      [this](const Files& files) { run(files); });
}

void RenderForecast::stop() {
  writing_.stop();
  process_.kill();
  is_running_ = false;
}

void RenderForecast::run(const Files& files) {
  if (files.options.isEmpty()) return give_up(files.problem);
  process_.start({"render", files.options, "--forecast", "--progress", "json", "--json"});
}

void RenderForecast::read(const QByteArray& line) {
  if (const auto times = forecast_times_of(line); !times.empty()) emit forecast(times);
}

void RenderForecast::end(const RendererEnd& end) {
  is_running_ = false;
  if (!end.problem.isEmpty()) emit failed(end.problem);
}

void RenderForecast::give_up(const QString& why) {
  is_running_ = false;
  emit failed(why);
}

}  // namespace editor
