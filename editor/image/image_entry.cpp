#include "editor/image/image_entry.h"

#include "editor/programs/image_process.h"

namespace editor {

LoadedImage load_image(const QString& path) {
  LoadedImage loaded;
  loaded.path = path;
  auto file = ImageProcess().read_file(path.toStdString(), loaded.diagnostics);
  if (!file) return loaded;
  loaded.image = std::make_shared<const image::Image>(std::move(file->image));
  if (file->layers.empty()) return loaded;
  loaded.layers = std::make_shared<const std::vector<image::ImageLayer>>(std::move(file->layers));
  return loaded;
}

SavedImage save_image(const ImageEntry& entry, float exposure, const QString& path) {
  SavedImage saved;
  saved.path = path;
  image::ImageFile file{*entry.image};
  if (entry.layers) file.layers = *entry.layers;
  file.exposure = exposure;
  saved.is_written = image::write_image(file, path.toStdString(), saved.diagnostics);
  return saved;
}

ImageAnalysis analysis_of(const SharedImage& image, const SharedImage& reference,
                          std::optional<Difference> kind) {
  ImageAnalysis analysis;
  analysis.image = image;
  analysis.reference = reference;
  analysis.kind = kind;
  if (!image) return analysis;
  analysis.statistics = statistics_of(*image);
  if (!reference || reference->width != image->width || reference->height != image->height) return analysis;
  analysis.error = image::error_of(*image, *reference);
  if (!kind) return analysis;
  analysis.difference = std::make_shared<const image::Image>(difference_of(*image, *reference, *kind));
  analysis.difference_statistics = statistics_of(*analysis.difference);
  return analysis;
}

}  // namespace editor
