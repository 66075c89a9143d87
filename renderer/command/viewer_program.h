#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

namespace command {

/// The editor's image view as a program of its own, for renders that show themselves. It is nobody's servant:
/// it stays when this program ends, or is interrupted.
class ViewerProgram {
 public:
  /// Starts it at the first call; says what is in its way, then or later, or nothing if it runs. It is
  /// `wannabe` in the folder of this program, or else in PATH.
  std::optional<std::string> keep();

 private:
  std::optional<std::string> start();
  std::optional<std::string> ending() const;

  pid_t process_ = 0;  // 0: not started
};

}  // namespace command
