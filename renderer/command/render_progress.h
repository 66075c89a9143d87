#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "renderer/transport/render.h"

namespace command {

enum class ProgressStyle {
  Bar,   ///< on standard error, where that is a terminal
  Json,  ///< one JSON object a line on standard output
  None
};

/// Shows how far a render is.
class ProgressReport {
 public:
  explicit ProgressReport(ProgressStyle style);
  ~ProgressReport();
  ProgressReport(const ProgressReport&) = delete;
  ProgressReport& operator=(const ProgressReport&) = delete;

  /// May be called as often as one likes: shows it four times a second.
  void show(const transport::RenderProgress& progress);

  /// The last time, with where the image was written.
  void finish(const transport::RenderProgress& progress, const std::string& image);

 private:
  void clear();

  ProgressStyle style_;
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now();
};

/// A duration as people say it: `12.3 s`, `4 min 05 s`, `2 h 07 min`.
std::string duration_text(double seconds);

}  // namespace command
