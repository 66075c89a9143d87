#pragma once

#include <cstdint>
#include <string>

#include "renderer/image/image.h"

namespace command {

/// Resource limits of decoding one image.
struct DecodingLimits {
  double seconds = 600;
  /// Bytes of address space, enough for the largest image; ignored under sanitizers.
  std::uint64_t memory = std::uint64_t(16) << 30U;
};

/// Reads images as image::read_image does, with the same messages. Formats that libraries decode, where most
/// faults are found, are decoded by `bpt decode` in a confined process per image. Thread-safe. `bpt` is the
/// path of the program; the default is this one.
image::ImageReader isolated_image_reader(const std::string& bpt = "/proc/self/exe",
                                         const DecodingLimits& limits = {});

}  // namespace command
