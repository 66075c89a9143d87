#include "editor/rendering/render_forecast.h"

#include <utility>

namespace editor {

RenderForecast::RenderForecast(QString program, QObject* parent)
    : QObject(parent), process_(std::move(program)) {
  connect(&process_, &SnapshotProcess::reported, this, [this](const QByteArray& line) {
    if (const auto times = forecast_times_of(line); !times.empty()) emit forecast(times);
  });
  connect(&process_, &SnapshotProcess::failed, this, &RenderForecast::failed);
}

void RenderForecast::start(FinalRenderRequest request) {
  process_.start(std::move(request), "render", {"--forecast", "--progress", "json", "--json"});
}

}  // namespace editor
