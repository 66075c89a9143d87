#include "tests/benchmarks/render/pictures.h"

#include <stdexcept>
#include <string>

#include "renderer/image/image_file.h"

namespace benchmark {

using image::Image;

Image read_picture(const std::filesystem::path& path) {
  grf::Diagnostics diagnostics;
  auto image = image::read_image(path.string(), diagnostics);
  if (!image) throw std::runtime_error(diagnostics.to_text());
  return std::move(*image);
}

void write_side_by_side(const std::vector<Image>& images, const std::filesystem::path& path) {
  write_grid({images}, path);
}

void write_grid(const std::vector<std::vector<Image>>& rows, const std::filesystem::path& path) {
  Image all{0, 0, {}};
  for (const Image& image : rows.front()) all.width += image.width;
  for (const std::vector<Image>& images : rows) {
    const int height = images.front().height;
    all.height += height;
    for (int y = 0; y < height; ++y) {
      for (const Image& image : images) {
        const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(y) * image.width;
        all.pixels.insert(all.pixels.end(), row, row + image.width);
      }
    }
  }
  grf::Diagnostics diagnostics;
  if (!image::write_image({all}, path.string(), diagnostics)) {
    throw std::runtime_error(diagnostics.to_text());
  }
}

}  // namespace benchmark
