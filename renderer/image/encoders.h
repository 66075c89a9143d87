// `write_image` uses these encoders. All of them throw std::runtime_error if a library fails.
#pragma once

#include <string>

#include "renderer/image/image_file.h"

namespace image {

/// OpenEXR with 32-bit floats, lossless.
std::string encode_exr(const ImageFile& file);

// Linear radiance

/// Radiance's RGBE: 8 bits of mantissa for the largest component, within 0.4 % of it. Negative values become
/// 0.
std::string encode_radiance(const ImageFile& file);
/// Portable float map, little-endian.
std::string encode_pfm(const ImageFile& file);
/// Width and height as uint32, then rows from the top, RGB as floats, all little-endian.
std::string encode_raw(const ImageFile& file);

// 8 bits, sRGB-encoded (IEC 61966-2-1) after the exposure, with 1 as white

std::string encode_png(const ImageFile& file);
/// Quality 95, colour at full resolution.
std::string encode_jpeg(const ImageFile& file);
std::string encode_tga(const ImageFile& file);

}  // namespace image
