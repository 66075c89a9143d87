#include "renderer/job/preview_stages.h"

#include <algorithm>

namespace job {
namespace {

using transport::Image;
using transport::Render;
using transport::RenderSettings;

/// Fills a tile from an image of another size.
void fill(const transport::TileBounds& bounds, const Image& from, Image& image) {
  const auto nearest = [](int place, int size, int size_there) {
    return static_cast<int>((2 * static_cast<std::int64_t>(place) + 1) * size_there / (2 * size));
  };
  for (int y = bounds.y; y < bounds.y + bounds.height; ++y) {
    for (int x = bounds.x; x < bounds.x + bounds.width; ++x) {
      const auto to =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
      image.pixels[to] = from.at(nearest(x, image.width, from.width), nearest(y, image.height, from.height));
    }
  }
}

}  // namespace

std::vector<RenderSettings> preview_stages(const RenderSettings& whole) {
  constexpr int FewPixels = 12;
  std::vector<RenderSettings> stages;
  for (const int divisor : {8, 4, 2}) {
    RenderSettings coarse = whole;
    coarse.width = (whole.width + divisor - 1) / divisor;
    coarse.height = (whole.height + divisor - 1) / divisor;
    if (std::min(coarse.width, coarse.height) < FewPixels) continue;
    coarse.samples = 1;
    coarse.adaptive = false;
    coarse.target_error = std::nullopt;
    coarse.max_seconds = std::nullopt;
    stages.push_back(coarse);
  }
  stages.push_back(whole);
  return stages;
}

Image completed(const Render& render, const Image& before) {
  std::vector<int> empty;
  for (int tile = 0; !before.pixels.empty() && tile < render.film().tile_count(); ++tile) {
    if (render.sample_count_of(tile) == 0) empty.push_back(tile);
  }
  Image image = render.snapshot().mean;
  for (const int tile : empty) fill(render.film().bounds_of(tile), before, image);
  return image;
}

}  // namespace job
