#pragma once

#include <cstddef>
#include <string>

namespace convert {

/// Shows progress on standard error: a bar on a terminal, else one line per file.
class Progress {
 public:
  /// Shows nothing unless `is_shown`.
  Progress(std::size_t files, bool is_shown);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Clears the line of the bar so that something else can be printed.
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
