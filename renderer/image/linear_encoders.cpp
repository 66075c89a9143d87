// Encoders for formats with linear radiance.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "renderer/image/encoders.h"

namespace image {
namespace {

using grf::Colour;

static_assert(std::endian::native == std::endian::little, "floats and sizes are written as they stand");
static_assert(sizeof(Colour) == 3 * sizeof(float));

std::string_view bytes_of(const Colour* pixels, int count) {
  return {reinterpret_cast<const char*>(pixels), sizeof(Colour) * static_cast<std::size_t>(count)};
}

/// Returns an RGBE pixel whose largest component is at least 128 (Ward 1991, "Real pixels"). Rounded, where
/// Ward's own code truncates and adds a half when reading: other readers do not add it.
std::array<std::uint8_t, 4> to_rgbe(const Colour& radiance) {
  constexpr float Largest = 1.69e38F;  // the exponent is one byte
  constexpr float Smallest = 1e-32F;
  const auto component = [&](int i) { return radiance[i] > 0 ? std::min(radiance[i], Largest) : 0.0F; };
  const float largest = std::max({component(0), component(1), component(2)});
  if (largest < Smallest) return {0, 0, 0, 0};
  int exponent = 0;
  if (256 * std::frexp(largest, &exponent) > 255.5F) ++exponent;
  std::array<std::uint8_t, 4> rgbe = {};
  for (int i = 0; i < 3; ++i) {
    rgbe[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>(std::lround(std::ldexp(component(i), 8 - exponent)));
  }
  rgbe[3] = static_cast<std::uint8_t>(exponent + 128);
  return rgbe;
}

}  // namespace

// Without run-length encoding, which saves little where neighbours differ by noise. No pixel can be mistaken
// for the start of a run, which would be two bytes of 2, or three of 1.
std::string encode_radiance(const ImageFile& file) {
  const Image& image = file.image;
  std::string bytes =
      fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.height, image.width);
  bytes.reserve(bytes.size() + 4 * image.pixels.size());
  for (const Colour& pixel : image.pixels) {
    for (const std::uint8_t byte : to_rgbe(pixel)) bytes += static_cast<char>(byte);
  }
  return bytes;
}

std::string encode_pfm(const ImageFile& file) {
  const Image& image = file.image;
  std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
  bytes.reserve(bytes.size() + sizeof(Colour) * image.pixels.size());
  for (int y = image.height - 1; y >= 0; --y) bytes += bytes_of(&image.at(0, y), image.width);
  return bytes;
}

std::string encode_raw(const ImageFile& file) {
  const Image& image = file.image;
  const std::array<std::int32_t, 2> size = {image.width, image.height};
  std::string bytes(reinterpret_cast<const char*>(size.data()), sizeof(size));
  bytes.reserve(bytes.size() + sizeof(Colour) * image.pixels.size());
  for (int y = 0; y < image.height; ++y) bytes += bytes_of(&image.at(0, y), image.width);
  return bytes;
}

}  // namespace image
