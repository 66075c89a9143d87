#include "renderer/transport/visible_noise.h"

#include <cmath>
#include <cstdint>

#include "renderer/parallel/loops.h"

namespace transport {
namespace {

using image::Image;
using image::SeenImage;
using image::Viewing;
using image::VisibleDifference;

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

/// The differences if the samples were so many that those of the halves were `factor` times as large; empty
/// if `stops` returns true.
std::optional<VisibleDifference> difference_with(const HalvedImage& image, const SeenImage& mean,
                                                 const Viewing& viewing, float factor,
                                                 const std::function<bool()>& stops) {
  std::vector<float> differences;
  for (const float sign : {1.0F, -1.0F}) {
    if (stops()) return std::nullopt;
    const SeenImage other = image::seen(image.with(sign * factor), viewing);
    if (stops()) return std::nullopt;
    const std::vector<float> of_sign = image::visible_differences(other, mean);
    differences.insert(differences.end(), of_sign.begin(), of_sign.end());
  }
  return image::summary_of(std::move(differences));
}

std::optional<VisibleNoise> noise_of(const HalvedImage& image, const Viewing& viewing, double samples,
                                     const std::function<bool()>& stops) {
  const SeenImage mean = image::seen(image.mean, viewing);
  const auto difference = difference_with(image, mean, viewing, 1, stops);
  if (!difference) return std::nullopt;
  if (!(difference->percentile_95 > 0)) return VisibleNoise{*difference, 0};
  // Large differences are clipped or weigh less than small ones, so that a second step is needed.
  double factor = 1 / difference->percentile_95;
  const auto there = difference_with(image, mean, viewing, static_cast<float>(factor), stops);
  if (!there) return std::nullopt;
  if (there->percentile_95 > 0) factor /= there->percentile_95;
  return VisibleNoise{*difference, samples / (factor * factor)};
}

}  // namespace

std::optional<VisibleNoise> visible_noise(const Render& render, const Viewing& viewing,
                                          const std::function<bool()>& stops) {
  const auto image = halved_image(render);
  if (!image) return std::nullopt;
  std::optional<VisibleNoise> noise;
  parallel::run_with_threads(render.settings().threads,
                             [&] { noise = noise_of(*image, viewing, render.samples_per_pixel(), stops); });
  return noise;
}

}  // namespace transport
