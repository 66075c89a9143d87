#include "renderer/transport/film.h"

#include <cmath>

namespace transport {
namespace {

template <class Pixels, class Function>
Image image_of(int width, int height, const Pixels& pixels, Function function) {
  Image image{width, height, {}};
  image.pixels.reserve(pixels.size());
  for (const auto& pixel : pixels) image.pixels.emplace_back(function(pixel));
  return image;
}

}  // namespace

Film::Film(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

bool Film::add(int x, int y, int scrambling, const Rgb& radiance) {
  Pixel& target = pixels_[index_of(x, y)];
  const bool finite = std::isfinite(radiance.x) && std::isfinite(radiance.y) && std::isfinite(radiance.z);
  if (finite) target.sum[scrambling] += Imath::V3d(radiance);
  ++target.count[scrambling];
  return finite;
}

std::uint32_t Film::sample_count(int x, int y) const {
  const Pixel& counted = pixels_[index_of(x, y)];
  return counted.count[0] + counted.count[1];
}

Imath::V3d Film::mean_of(const Pixel& pixel) {
  const std::uint32_t count = pixel.count[0] + pixel.count[1];
  return count == 0 ? Imath::V3d(0) : (pixel.sum[0] + pixel.sum[1]) / count;
}

// The halves are independent estimates of the same value: the variance of their average is a quarter of the
// squared difference, on average.
Imath::V3d Film::variance_of(const Pixel& pixel) {
  if (pixel.count[0] == 0 || pixel.count[1] == 0) return Imath::V3d(0);
  const Imath::V3d difference = pixel.sum[0] / pixel.count[0] - pixel.sum[1] / pixel.count[1];
  return difference * difference / 4;
}

Image Film::mean() const {
  return image_of(width_, height_, pixels_, [](const Pixel& p) { return Rgb(mean_of(p)); });
}

Image Film::variance() const {
  return image_of(width_, height_, pixels_, [](const Pixel& p) { return Rgb(variance_of(p)); });
}

std::optional<double> Film::estimated_error() const {
  double sum = 0;
  std::size_t counted = 0;
  for (const Pixel& p : pixels_) {
    if (p.count[0] == 0 || p.count[1] == 0) continue;
    const Imath::V3d average = mean_of(p);
    const Imath::V3d variance = variance_of(p);
    for (int i = 0; i < 3; ++i) sum += variance[i] / (average[i] * average[i] + 0.01);
    counted += 3;
  }
  if (counted == 0) return std::nullopt;
  return std::sqrt(sum / static_cast<double>(counted));
}

}  // namespace transport
