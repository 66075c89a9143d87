// `read_image` uses these decoders. All of them throw std::runtime_error for malformed input.
#pragma once

#include <cstdint>
#include <string_view>

#include "renderer/image/image_file.h"

namespace image {

/// Returns a black image of that size; throws if its size exceeds any memory. With `file`: also if the size
/// exceeds what so many bytes can encode with at most `pixels_a_byte` pixels per byte.
Image blank_image(std::int64_t width, std::int64_t height);
Image blank_image(std::int64_t width, std::int64_t height, std::string_view file, std::size_t pixels_a_byte);

/// Fills an image from sRGB-encoded bytes (IEC 61966-2-1), three per pixel; 255 is 1.
void decode_srgb(const std::uint8_t* bytes, Image& image);

/// Fills an image and its alpha likewise, from four bytes per pixel, whose colours are not multiplied by it.
void decode_srgb_with_alpha(const std::uint8_t* bytes, Image& image);

/// OpenEXR: the image, from the channels R, G and B, or Y if there are none of these, and A.
Image decode_exr(std::string_view bytes, Alpha alpha);
/// OpenEXR with its layers, see `read_image_file`.
ImageFile decode_exr_file(std::string_view bytes);

/// Radiance's RGBE (Ward 1991, "Real pixels"), with old and new run-length encoding.
Image decode_radiance(std::string_view bytes, Alpha);

Image decode_tga(std::string_view bytes, Alpha alpha);

/// WebP, lossy and lossless; animations are refused.
Image decode_webp(std::string_view bytes, Alpha alpha);

}  // namespace image
