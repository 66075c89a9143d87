#pragma once

#include <QCoreApplication>
#include <QString>
#include <cstdint>
#include <optional>
#include <stop_token>

#include "editor/programs/bundled_program.h"
#include "renderer/image/image_file.h"

namespace editor {

/// Decodes untrusted images with the program `bpt`, one process per image: a file that crashes a decoder, or
/// exceeds its time or memory limit, is an error of that image. Thread-safe.
class ImageProcess {
  Q_DECLARE_TR_FUNCTIONS(editor::ImageProcess)

 public:
  /// Resource limits per image.
  struct Limits {
    double seconds = 60;
    std::uint64_t memory = std::uint64_t(4) << 30U;  ///< bytes
  };

  explicit ImageProcess(QString program = bundled_program("bpt")) : ImageProcess(std::move(program), {}) {}
  ImageProcess(QString program, const Limits& limits) : program_(std::move(program)), limits_(limits) {}

  /// Decodes an image as image::read_image does. If cancelled, it kills the process, and returns nothing
  /// without an error.
  std::optional<image::Image> read(const std::string& path, grf::Diagnostics& diagnostics,
                                   const grf::SourceLocation& asked_for_at = {},
                                   const std::stop_token& stop = {},
                                   image::Alpha alpha = image::Alpha::OverBlack) const;
  /// Decodes an image with its layers as image::read_image_file does.
  std::optional<image::ImageFile> read_file(const std::string& path, grf::Diagnostics& diagnostics) const;

 private:
  /// An image, or an error message.
  struct Result {
    std::optional<image::ImageFile> file;
    QString problem;
  };

  /// `option` is that of `bpt decode`; empty: none.
  std::optional<image::ImageFile> read(const std::string& path, const QString& option,
                                       grf::Diagnostics& diagnostics, const grf::SourceLocation& asked_for_at,
                                       const std::stop_token& stop) const;
  Result decode(const QString& path, const QString& option, const std::stop_token& stop) const;

  QString program_;
  Limits limits_;
};

}  // namespace editor
