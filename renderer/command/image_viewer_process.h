#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

namespace command {

/// The image viewer, `wannabe --tool image`, started as a detached process for renders that display their
/// image. It stays open when this program ends or is interrupted.
class ImageViewerProcess {
 public:
  /// Starts the viewer at the first call, from the folder of this program or else from PATH. Returns why it
  /// could not start or has exited, or nothing while it runs.
  std::optional<std::string> ensure_running();

 private:
  std::optional<std::string> start();
  std::optional<std::string> exit_reason() const;

  pid_t process_ = 0;  ///< 0: not started
};

}  // namespace command
