#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "renderer/transport/render.h"

namespace command {

enum class ProgressStyle {
  Bar,   ///< a progress bar on standard error, if that is a terminal
  Json,  ///< JSON lines on standard output, one object per line
  None
};

/// Shows the progress of a render.
class ProgressReport {
 public:
  explicit ProgressReport(ProgressStyle style);
  ~ProgressReport();
  ProgressReport(const ProgressReport&) = delete;
  ProgressReport& operator=(const ProgressReport&) = delete;

  /// Whether `show` would show something now.
  bool is_due() const { return style_ != ProgressStyle::None && std::chrono::steady_clock::now() >= next_; }
  /// Whether forecasts are shown.
  bool has_forecasts() const { return style_ == ProgressStyle::Json; }
  /// Shows the progress at most four times a second, however often it is called.
  void show(const transport::RenderProgress& progress);

  /// Shows the final progress, with the path of the image that was written.
  void finish(const transport::RenderProgress& progress, const std::string& image);

 private:
  void clear();

  ProgressStyle style_;
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now();
};

/// Formats a duration: `12.3 s`, `4 min 05 s`, `2 h 07 min`.
std::string duration_text(double seconds);

/// Formats a mean number of samples: `1 sample`, `1.5 samples`.
std::string samples_text(double samples);

/// The beginning of a warning of samples that were not finite, which ends by the place of the first.
std::string rejected_samples_text(std::uint64_t count);

}  // namespace command
