#include "converters/command/progress.h"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace convert {

Progress::Progress(std::size_t files, bool is_shown)
    : files_(files), is_shown_(is_shown), is_bar_(is_shown && ::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { clear(); }

void Progress::clear() const {
  if (is_bar_) std::fputs("\r\x1b[K", stderr);
}

void Progress::add(const std::string& file, bool is_converted) {
  ++done_;
  if (!is_converted) ++failed_;
  if (!is_shown_) return;
  if (!is_bar_) {
    fmt::print(stderr, "[{}/{}] {}: {}\n", done_, files_, file, is_converted ? "converted" : "failed");
    return;
  }
  constexpr std::size_t Width = 30;
  const std::size_t filled = done_ * Width / files_;
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {} of {} files{}\x1b[K", "", filled, "", Width - filled, done_,
             files_, failed_ > 0 ? fmt::format(", {} failed", failed_) : "");
  std::fflush(stderr);
}

}  // namespace convert
