#pragma once

#include <cstddef>
#include <string>

namespace convert {

/// Shows on standard error how many files are done: a bar on a terminal, else one line a file.
class Progress {
 public:
  /// Shows nothing unless `is_shown`.
  Progress(std::size_t files, bool is_shown);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// The line of the bar is left empty for something else to be printed.
  void clear() const;
  void add(const std::string& file, bool is_converted);

 private:
  std::size_t files_;
  bool is_shown_;
  bool is_bar_;
  std::size_t done_ = 0;
  std::size_t failed_ = 0;
};

}  // namespace convert
