// Encoders for 8-bit display formats.
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <png.h>
#include <turbojpeg.h>

#include "renderer/image/encoders.h"
#include "renderer/image/srgb.h"

namespace image {
namespace {

using grf::Colour;

/// Three bytes per pixel, rows from the top.
std::vector<std::uint8_t> srgb_bytes(const ImageFile& file) {
  const float scale = std::exp2(file.exposure);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * file.image.pixels.size());
  for (const Colour& pixel : file.image.pixels) {
    for (int i = 0; i < 3; ++i) bytes.push_back(to_srgb_byte(scale * pixel[i]));
  }
  return bytes;
}

}  // namespace

std::string encode_png(const ImageFile& file) {
  const std::vector<std::uint8_t> bytes = srgb_bytes(file);
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(file.image.width);
  png.height = static_cast<png_uint_32>(file.image.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string encoded(size, '\0');
  if (png_image_write_to_memory(&png, encoded.data(), &size, 0, bytes.data(), 0, nullptr) == 0) {
    throw std::runtime_error(fmt::format("libpng: {}", png.message));
  }
  encoded.resize(size);
  return encoded;
}

std::string encode_jpeg(const ImageFile& file) {
  constexpr int Quality = 95;
  const std::vector<std::uint8_t> bytes = srgb_bytes(file);
  const auto destroy = [](void* handle) { tjDestroy(handle); };
  const std::unique_ptr<void, decltype(destroy)> encoder(tjInitCompress(), destroy);
  if (!encoder) throw std::bad_alloc();
  unsigned char* data = nullptr;
  unsigned long size = 0;
  const int result = tjCompress2(encoder.get(), bytes.data(), file.image.width, 0, file.image.height,
                                 TJPF_RGB, &data, &size, TJSAMP_444, Quality, TJFLAG_ACCURATEDCT);
  const std::unique_ptr<unsigned char, decltype(&tjFree)> owner(data, tjFree);
  if (result != 0) throw std::runtime_error(fmt::format("turbojpeg: {}", tjGetErrorStr2(encoder.get())));
  return {reinterpret_cast<const char*>(data), size};
}

// Uncompressed true colour, rows from the top, BGR (Truevision 1991, "TGA File Format Specification").
std::string encode_tga(const ImageFile& file) {
  constexpr char TrueColour = 2;
  constexpr char BitsPerPixel = 24;
  constexpr char FromTheTop = 0x20;
  const auto low = [](int number) { return static_cast<char>(number & 0xFF); };
  const auto high = [](int number) { return static_cast<char>(number >> 8); };
  const int width = file.image.width;
  const int height = file.image.height;
  std::string encoded = {0, 0, TrueColour, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  encoded += {low(width), high(width), low(height), high(height), BitsPerPixel, FromTheTop};
  const std::vector<std::uint8_t> bytes = srgb_bytes(file);
  encoded.reserve(encoded.size() + bytes.size());
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    for (const std::size_t k : {2, 1, 0}) encoded += static_cast<char>(bytes[i + k]);
  }
  return encoded;
}

}  // namespace image
