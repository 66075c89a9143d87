#include "renderer/command/progress_bar.h"

#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace command {

ProgressBar::ProgressBar() : is_terminal_(::isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (is_terminal_) fmt::print(stderr, "\r\x1b[K");  // the line is left empty for what comes next
}

void ProgressBar::show(const transport::RenderProgress& progress) {
  if (!is_terminal_) return;
  constexpr int Width = 40;
  const int filled = static_cast<int>(progress.done * Width);
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {:3.0f} %  {} left\x1b[K", "", filled, "", Width - filled,
             100 * progress.done, progress.seconds_left ? duration_text(*progress.seconds_left) : "...");
  std::fflush(stderr);
}

std::string duration_text(double seconds) {
  if (seconds < 60) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace command
