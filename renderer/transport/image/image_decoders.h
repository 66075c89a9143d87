// What `read_image` is made of. All of these throw std::runtime_error for what cannot be read.
#pragma once

#include <cstdint>
#include <string_view>

#include "renderer/transport/image/image.h"

namespace transport {

/// An image of that size, black. Files that say more of themselves than any memory holds are not believed.
/// That of a file that holds at most so many pixels a byte may need no more of them than there can be.
Image blank_image(std::int64_t width, std::int64_t height);
Image blank_image(std::int64_t width, std::int64_t height, std::string_view file, std::size_t pixels_a_byte);

/// Fills an image from sRGB-encoded bytes (IEC 61966-2-1), three a pixel, white being 1.
void decode_srgb(const std::uint8_t* bytes, Image& image);

/// Radiance's RGBE (Ward 1991, "Real pixels"), with run lengths of the old and the new kind.
Image decode_radiance(std::string_view bytes);

Image decode_tga(std::string_view bytes);

}  // namespace transport
