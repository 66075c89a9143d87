// Slow operations on images: plain functions, to be run in threads.
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "editor/image/image_statistics.h"
#include "grf/diagnostics.h"
#include "renderer/image/image.h"
#include "renderer/image/image_error.h"
#include "renderer/image/image_file.h"

namespace editor {

using SharedImage = std::shared_ptr<const image::Image>;
using SharedLayers = std::shared_ptr<const std::vector<image::ImageLayer>>;

struct ImageEntry {
  QString name;  ///< display name
  QString path;  ///< path of its file; empty if it has none
  SharedImage image;
  SharedLayers layers = {};  ///< of its file, besides the image; null if it has none
};

struct LoadedImage {
  QString path;
  SharedImage image;  ///< null after an error
  SharedLayers layers;
  grf::Diagnostics diagnostics;
};

LoadedImage load_image(const QString& path);

struct SavedImage {
  QString path;
  bool is_written = false;
  grf::Diagnostics diagnostics;
};

/// Saves an image with its layers, if the format has layers; 8-bit formats are exposed by `exposure` stops.
SavedImage save_image(const ImageEntry& entry, float exposure, const QString& path);

/// Statistics of an image, and its error against a reference.
struct ImageAnalysis {
  SharedImage image;
  SharedImage reference;
  std::optional<Difference> kind;
  ImageStatistics statistics;
  std::optional<image::ImageError> error;
  SharedImage difference;                 ///< if a kind of difference was requested
  ImageStatistics difference_statistics;  ///< of the difference
};

/// Computes the statistics. The reference may be null or of another size: then there is no comparison.
ImageAnalysis analysis_of(const SharedImage& image, const SharedImage& reference,
                          std::optional<Difference> kind);

}  // namespace editor
