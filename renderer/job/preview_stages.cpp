#include "renderer/job/preview_stages.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace job {
namespace {

using image::Image;
using transport::CropWindow;
using transport::Render;
using transport::RenderSettings;

/// The whole image as a crop window, if there is none.
CropWindow window_of(const RenderSettings& settings) {
  return settings.crop.value_or(CropWindow{0, 0, settings.width, settings.height});
}

/// Fills a tile from a whole image of another size.
void fill(const transport::TileBounds& bounds, const RenderSettings& settings, const Image& from,
          Image& image) {
  const CropWindow window = window_of(settings);
  const auto nearest = [](int place, int size, int size_there) {
    return static_cast<int>((2 * static_cast<std::int64_t>(place) + 1) * size_there / (2 * size));
  };
  for (int y = bounds.y; y < bounds.y + bounds.height; ++y) {
    for (int x = bounds.x; x < bounds.x + bounds.width; ++x) {
      const auto to =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
      image.pixels[to] = from.at(nearest(window.x + x, settings.width, from.width),
                                 nearest(window.y + y, settings.height, from.height));
    }
  }
}

}  // namespace

CropWindow pixels_of(const PreviewRegion& region, int width, int height) {
  // The first and the last pixel from a fraction on and before one.
  const auto first = [](double place, int size) {
    return std::clamp(static_cast<int>(std::floor(place * size)), 0, size - 1);
  };
  const auto end = [](double place, int size) {
    return std::clamp(static_cast<int>(std::ceil(place * size)), 1, size);
  };
  const int x = first(region.left, width);
  const int y = first(region.top, height);
  return {x, y, std::max(1, end(region.right, width) - x), std::max(1, end(region.bottom, height) - y)};
}

std::vector<RenderSettings> preview_stages(const RenderSettings& whole,
                                           const std::optional<PreviewRegion>& region) {
  constexpr int FewPixels = 12;
  std::vector<RenderSettings> stages;
  for (const int divisor : {8, 4, 2}) {
    RenderSettings coarse = whole;
    coarse.width = (whole.width + divisor - 1) / divisor;
    coarse.height = (whole.height + divisor - 1) / divisor;
    if (region) coarse.crop = pixels_of(*region, coarse.width, coarse.height);
    const CropWindow window = window_of(coarse);
    if (std::min(window.width, window.height) < FewPixels) continue;
    coarse.samples = 1;
    coarse.adaptive = false;
    coarse.target_error = std::nullopt;
    coarse.max_seconds = std::nullopt;
    stages.push_back(coarse);
  }
  stages.push_back(whole);
  if (region) stages.back().crop = pixels_of(*region, whole.width, whole.height);
  return stages;
}

Image completed(const Render& render, const Image& before) {
  std::vector<int> empty;
  for (int tile = 0; !before.pixels.empty() && tile < render.film().tile_count(); ++tile) {
    if (render.sample_count_of(tile) == 0) empty.push_back(tile);
  }
  Image image = render.snapshot().mean;
  for (const int tile : empty) fill(render.film().bounds_of(tile), render.settings(), before, image);
  return image;
}

Image in_whole_image(Image cropped, const RenderSettings& settings) {
  if (!settings.crop) return cropped;
  const CropWindow& window = *settings.crop;
  const auto width = static_cast<std::size_t>(settings.width);
  Image whole = {
      settings.width, settings.height,
      std::vector<reflectance::Rgb>(width * static_cast<std::size_t>(settings.height), reflectance::Rgb(0))};
  for (int row = 0; row < window.height; ++row) {
    const auto from = cropped.pixels.begin() + static_cast<std::ptrdiff_t>(row) * window.width;
    const auto to = static_cast<std::ptrdiff_t>(window.y + row) * settings.width + window.x;
    std::copy_n(from, window.width, whole.pixels.begin() + to);
  }
  return whole;
}

}  // namespace job
