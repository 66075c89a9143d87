#pragma once

#include <string>

#include "renderer/transport/render.h"

namespace command {

/// A bar with the time left on standard error, where that is a terminal; nothing elsewhere.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const transport::RenderProgress& progress);

 private:
  bool is_terminal_;
};

/// A duration as people say it: `12.3 s`, `4 min 05 s`, `2 h 07 min`.
std::string duration_text(double seconds);

}  // namespace command
