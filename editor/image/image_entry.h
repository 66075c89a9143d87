// Work on images that takes longer than a frame: plain functions, to be run on threads.
#pragma once

#include <QString>
#include <memory>
#include <optional>

#include "editor/image/image_figures.h"
#include "grf/diagnostics.h"
#include "renderer/transport/image/image.h"
#include "renderer/transport/image/image_error.h"

namespace editor {

using SharedImage = std::shared_ptr<const transport::Image>;

struct ImageEntry {
  QString name;  ///< what the user calls it
  QString path;  ///< of its file; empty: it has none
  SharedImage image;
};

struct LoadedImage {
  QString path;
  SharedImage image;  ///< null after an error
  grf::Diagnostics diagnostics;
};

LoadedImage load_image(const QString& path);

struct SavedImage {
  QString path;
  bool is_written = false;
  grf::Diagnostics diagnostics;
};

/// 8-bit types of file get the exposure, in stops.
SavedImage save_image(const SharedImage& image, float exposure, const QString& path);

/// What is said of an image, and of it against another one.
struct ImageAnalysis {
  SharedImage image;
  SharedImage reference;
  std::optional<Difference> kind;
  ImageFigures figures;
  std::optional<transport::ImageError> error;
  SharedImage difference;           ///< if a kind was asked for
  ImageFigures difference_figures;  ///< of that
};

/// The reference may be null, or of another size: then nothing is said of differences.
ImageAnalysis analysis_of(const SharedImage& image, const SharedImage& reference,
                          std::optional<Difference> kind);

}  // namespace editor
