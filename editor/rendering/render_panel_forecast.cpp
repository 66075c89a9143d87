// The forecast of the Render dock: what the final render will cost.
#include <algorithm>
#include <cmath>

#include "editor/document/document.h"
#include "editor/document/op_document.h"
#include "editor/rendering/forecast_row.h"
#include "editor/rendering/render_panel.h"

namespace editor {

using options::RenderOptions;

namespace {

/// How long scene and options must stay as they are before a forecast is made.
constexpr std::chrono::milliseconds SettlingTime(1000);

/// The options without those that do not change a forecast.
RenderOptions forecast_options_of(RenderOptions all) {
  const RenderOptions defaults;
  all.target_error.reset();
  all.samples.reset();
  all.max_seconds.reset();
  all.output.clear();
  all.checkpoint.clear();
  all.exposure = defaults.exposure;
  all.layers = defaults.layers;
  return all;
}

}  // namespace

void RenderPanel::connect_forecast() {
  forecast_timer_.setSingleShot(true);
  forecast_timer_.setInterval(SettlingTime);
  connect(&forecast_timer_, &QTimer::timeout, this, &RenderPanel::make_forecast);
  connect(forecast_row_, &ForecastRow::became_visible, this, &RenderPanel::follow_forecast);
  connect(forecast_row_, &ForecastRow::target_chosen, this, [this](double error) {
    RenderOptions now = options_.valid_options();
    now.target_error = static_cast<float>(error);
    now.samples.reset();
    options_.set_options(tr("Set target error"), now);
  });
  connect(&forecast_, &RenderForecast::forecast, forecast_row_, &ForecastRow::set_forecasts);
  connect(&forecast_, &RenderForecast::failed, forecast_row_, &ForecastRow::set_problem);
  connect(&final_, &FinalRender::started, this, [this] {
    is_forecast_outdated_ = is_forecast_outdated_ || forecast_.is_running();  // the render has priority
    forecast_timer_.stop();
    forecast_.stop();
  });
  connect(&final_, &FinalRender::progressed, this, [this](const RenderReport& report) {
    if (!report.forecasts.empty()) forecast_row_->set_forecasts(report.forecasts);
  });
  connect(&document_, &Document::changed, this, &RenderPanel::outdate_forecast);
  connect(&document_, &Document::path_changed, this, &RenderPanel::outdate_forecast);
}

void RenderPanel::outdate_forecast() {
  is_forecast_outdated_ = true;
  follow_forecast();
}

/// Makes a new forecast once edits have settled, if the old one is outdated and shown.
void RenderPanel::follow_forecast() {
  if (!is_forecast_outdated_ || !forecast_row_->isVisible() || final_.is_running()) return;
  forecast_.stop();
  forecast_row_->set_measuring();
  forecast_timer_.start();
}

void RenderPanel::show_forecast_options() {
  const RenderOptions now = options_with_threads();
  forecast_row_->set_target(now.target_error);
  const auto& known = forecast_row_->forecasts();
  const bool has_target =
      !now.target_error || std::any_of(known.begin(), known.end(), [&](const ForecastTime& time) {
        return std::abs(time.target_error - *now.target_error) < 1e-5 * time.target_error;
      });
  RenderOptions wanted = forecast_options_of(now);
  if (has_target && wanted == forecast_options_) return;
  forecast_options_ = std::move(wanted);
  outdate_forecast();
}

void RenderPanel::make_forecast() {
  if (!forecast_row_->isVisible() || final_.is_running()) return;
  is_forecast_outdated_ = false;
  forecast_.start(final_request());
}

}  // namespace editor
