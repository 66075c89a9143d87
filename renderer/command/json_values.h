// Several commands print these JSON values.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/math.h"
#include "grf/write.h"
#include "renderer/image/visible_difference.h"
#include "renderer/transport/error_estimate.h"
#include "renderer/transport/forecast.h"

namespace command {

/// Returns a JSON value as text, indented or on one line. Names of files and scenes are bytes: what is no
/// UTF-8 in them is replaced.
template <class Json>
std::string json_text(const Json& json, bool is_one_line) {
  return json.dump(is_one_line ? -1 : 2, ' ', false, Json::error_handler_t::replace);
}

/// Returns the number, or null where there is none or it is not finite.
inline nlohmann::ordered_json number_or_null(const std::optional<double>& number) {
  return number && std::isfinite(*number) ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

/// Returns an array of the three components, each with the fewest digits that read back to the same float.
inline nlohmann::ordered_json json_array(const grf::Vec3f& vector) {
  return {grf::shortest(vector.x), grf::shortest(vector.y), grf::shortest(vector.z)};
}

/// Returns an array of forecasts, with null for what no render reaches.
inline nlohmann::ordered_json json_of(const std::vector<transport::TargetForecast>& forecasts) {
  const auto interval = [](const transport::ForecastValue& value) {
    return nlohmann::ordered_json{number_or_null(value.low), number_or_null(value.high)};
  };
  auto array = nlohmann::ordered_json::array();
  for (const transport::TargetForecast& forecast : forecasts) {
    array.push_back({{"target_error", forecast.target_error},
                     {"seconds", number_or_null(forecast.seconds.median)},
                     {"seconds_interval", interval(forecast.seconds)},
                     {"samples", number_or_null(forecast.samples.median)},
                     {"samples_interval", interval(forecast.samples)}});
  }
  return array;
}

/// Adds the estimated error of an image and its 95 % interval to a summary; null if there is none.
template <class Json>
void add_estimate(const std::optional<transport::ErrorEstimate>& estimate, Json& summary) {
  summary["estimated_error"] = nullptr;
  summary["estimated_error_interval"] = nullptr;
  if (!estimate) return;
  summary["estimated_error"] = estimate->error;
  summary["estimated_error_interval"] = {estimate->low, estimate->high};
}

/// Adds the bias of an image whose paths were truncated, and its 95 % interval, to a summary; 0 of others.
template <class Json>
void add_bias(const transport::ErrorEstimate& bias, Json& summary) {
  summary["bias"] = bias.error;
  summary["bias_interval"] = {bias.low, bias.high};
}

/// Prints a line of what `add_estimate` added, if there is an error.
template <class Json>
void print_estimate(const Json& summary) {
  if (summary.at("estimated_error").is_null()) return;
  const auto [low, high] = summary.at("estimated_error_interval").template get<std::array<double, 2>>();
  fmt::print("  estimated error {:.3g} %, with 95 % confidence {:.3g} to {:.3g} %\n",
             100 * summary.at("estimated_error").template get<double>(), 100 * low, 100 * high);
}

/// Returns what is visible of a difference, and how it is seen.
inline nlohmann::ordered_json json_of(const image::VisibleDifference& difference,
                                      const image::Viewing& viewing) {
  return {{"mean", number_or_null(difference.mean)},
          {"percentile_95", number_or_null(difference.percentile_95)},
          {"exposure", viewing.exposure},
          {"pixels_per_degree", viewing.pixels_per_degree}};
}

}  // namespace command
