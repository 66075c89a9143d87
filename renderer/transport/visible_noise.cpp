#include "renderer/transport/visible_noise.h"

#include <cmath>
#include <cstdint>

#include "renderer/parallel/loops.h"

namespace transport {
namespace {

constexpr std::int64_t MostPixels = std::int64_t{8192} * 4096;

/// An image, and the difference of its halves with the variance of the image.
struct HalvedImage {
  Image mean;
  Image difference;

  Image with(float factor) const {
    Image image = mean;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] += difference.pixels[i] * factor;
    return image;
  }
};

std::optional<HalvedImage> halved_image(const Render& render) {
  const Film& film = render.film();
  if (static_cast<std::int64_t>(film.width()) * film.height() > MostPixels) return std::nullopt;
  const Image black{
      film.width(), film.height(),
      std::vector<Rgb>(static_cast<std::size_t>(film.width()) * static_cast<std::size_t>(film.height()))};
  HalvedImage image{black, black};
  FilmTile tile;
  for (int i = 0; i < film.tile_count(); ++i) {
    render.copy_tile(i, tile);
    if (tile.counts[0] == 0 || tile.counts[1] == 0) return std::nullopt;
    write_tile(
        tile.bounds, [&](std::size_t p) { return tile.mean(p); }, image.mean);
    write_tile(
        tile.bounds, [&](std::size_t p) { return tile.half_difference(p); }, image.difference);
  }
  return image;
}

/// The differences if the samples were so many that those of the halves were `factor` times as large.
VisibleDifference difference_with(const HalvedImage& image, const SeenImage& mean, const Viewing& viewing,
                                  float factor) {
  std::vector<float> differences = visible_differences(seen(image.with(factor), viewing), mean);
  const std::vector<float> others = visible_differences(seen(image.with(-factor), viewing), mean);
  differences.insert(differences.end(), others.begin(), others.end());
  return summary_of(std::move(differences));
}

VisibleNoise noise_of(const HalvedImage& image, const Viewing& viewing, double samples) {
  const SeenImage mean = seen(image.mean, viewing);
  VisibleNoise noise{difference_with(image, mean, viewing, 1), 0};
  if (!(noise.difference.percentile_95 > 0)) return noise;
  // Large differences are clipped or weigh less than small ones, so that a second step is needed.
  double factor = 1 / noise.difference.percentile_95;
  const double there = difference_with(image, mean, viewing, static_cast<float>(factor)).percentile_95;
  if (there > 0) factor /= there;
  noise.samples_needed = samples / (factor * factor);
  return noise;
}

}  // namespace

std::optional<VisibleNoise> visible_noise(const Render& render, const Viewing& viewing) {
  const auto image = halved_image(render);
  if (!image) return std::nullopt;
  VisibleNoise noise;
  parallel::run_with_threads(render.settings().threads,
                             [&] { noise = noise_of(*image, viewing, render.samples_per_pixel()); });
  return noise;
}

}  // namespace transport
