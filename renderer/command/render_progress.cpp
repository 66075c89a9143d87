#include "renderer/command/render_progress.h"

#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "grf/wording.h"
#include "renderer/command/json_values.h"

namespace command {
namespace {

using transport::RenderProgress;

constexpr std::chrono::milliseconds Interval(250);

std::string bar_of(const RenderProgress& progress) {
  constexpr int Width = 30;
  const int filled = static_cast<int>(progress.done * Width);
  std::string bar =
      fmt::format("[{:#<{}}{:.<{}}] {:3.0f} %", "", filled, "", Width - filled, 100 * progress.done);
  if (progress.estimated_error) bar += fmt::format("  error {:.2f} %", 100 * *progress.estimated_error);
  return bar + (progress.seconds_left ? fmt::format("  {} left", duration_text(*progress.seconds_left)) : "");
}

void print_json(const RenderProgress& progress, const nlohmann::json& image) {
  nlohmann::ordered_json line;
  line["done"] = progress.done;
  line["seconds"] = progress.seconds;
  line["seconds_left"] = number_or_null(progress.seconds_left);
  line["estimated_error"] = number_or_null(progress.estimated_error);
  line["image"] = image;
  if (!progress.forecasts.empty()) line["forecasts"] = json_of(progress.forecasts);
  // Not fmt::print, which throws: a reader that closed the pipe is no reason to stop.
  std::fputs((json_text(line, true) + "\n").c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace

ProgressReport::ProgressReport(ProgressStyle style) : style_(style) {
  if (style == ProgressStyle::Bar && ::isatty(STDERR_FILENO) == 0) style_ = ProgressStyle::None;
}

ProgressReport::~ProgressReport() { clear(); }

// Clears the line for the next output.
void ProgressReport::clear() {
  if (style_ == ProgressStyle::Bar) fmt::print(stderr, "\r\x1b[K");
}

void ProgressReport::show(const RenderProgress& progress) {
  if (!is_due()) return;
  next_ = std::chrono::steady_clock::now() + Interval;
  if (style_ == ProgressStyle::Json) {
    // The last line reports that the render is done, once the image is written.
    if (progress.done < 1) print_json(progress, nullptr);
    return;
  }
  fmt::print(stderr, "\r{}\x1b[K", bar_of(progress));
  std::fflush(stderr);
}

void ProgressReport::finish(const RenderProgress& progress, const std::string& image) {
  if (style_ == ProgressStyle::Json) print_json(progress, image);
  clear();
  style_ = ProgressStyle::None;
}

std::string duration_text(double seconds) {
  if (seconds < 60) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string samples_text(double samples) {
  return fmt::format("{:.4g} {}", samples, samples == 1 ? "sample" : "samples");
}

std::string rejected_samples_text(std::uint64_t count) {
  return grf::counted(
      count, "sample was not finite (NaN or infinite) or above 1e12 and counts as black; it is",
      "samples were not finite (NaN or infinite) or above 1e12 and count as black; the first is");
}

}  // namespace command
