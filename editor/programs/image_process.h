#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <stop_token>

#include "editor/programs/bundled_program.h"
#include "renderer/transport/image/image.h"

namespace editor {

/// Reads images that strangers made by the program `bpt`, one process an image: a file that crashes a
/// decoder, keeps it busy or wants all memory is an error of that image. May be called from any thread, and
/// from several at once.
class ImageProcess {
 public:
  /// What one image may take.
  struct Limits {
    double seconds = 60;
    std::uint64_t memory = std::uint64_t(4) << 30U;  ///< bytes
  };

  explicit ImageProcess(QString program = bundled_program("bpt")) : ImageProcess(std::move(program), {}) {}
  ImageProcess(QString program, const Limits& limits) : program_(std::move(program)), limits_(limits) {}

  /// As transport::read_image does. Asked to stop, it ends the process, and returns nothing without an error.
  std::optional<transport::Image> read(const std::string& path, grf::Diagnostics& diagnostics,
                                       const grf::SourceLocation& asked_for_at = {},
                                       const std::stop_token& stop = {}) const;

 private:
  /// An image, or why there is none.
  struct Result {
    std::optional<transport::Image> image;
    QString problem;
  };

  Result decode(const QString& path, const std::stop_token& stop) const;

  QString program_;
  Limits limits_;
};

}  // namespace editor
