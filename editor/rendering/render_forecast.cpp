#include "editor/rendering/render_forecast.h"

#include <utility>

namespace editor {

RenderForecast::RenderForecast(QString program, QObject* parent) : QObject(parent), run_(std::move(program)) {
  connect(&run_, &SnapshotRun::reported, this, [this](const QByteArray& line) {
    if (const auto times = forecast_times_of(line); !times.empty()) emit forecast(times);
  });
  connect(&run_, &SnapshotRun::ended, this, [this](const QString& problem) {
    if (!problem.isEmpty()) emit failed(problem);
  });
}

void RenderForecast::start(FinalRenderRequest request) {
  run_.start("render", std::move(request), {"--forecast", "--progress", "json", "--json"});
}

}  // namespace editor
