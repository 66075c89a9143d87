// Renderers send images to the viewer tev (https://github.com/Tom94/tev) in packets, which other viewers
// understand too. A packet holds its total length (uint32), its type (a byte) and its fields, all
// little-endian; strings are zero-terminated.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grf/math.h"
#include "renderer/transport/tile_bounds.h"

namespace display {

/// The operation that a packet requests from the viewer.
enum class PacketType : std::uint8_t {
  CloseImage = 2,
  UpdateImage = 3,
  CreateImage = 4,
  UpdateImageOfChannels = 5,
  UpdateImageWithStrides = 6
};

/// Closes the image of that name in the viewer, if it is open.
std::string close_image_packet(std::string_view name);

/// Creates a black image with the channels R, G and B, and shows it.
std::string create_image_packet(std::string_view name, int width, int height);

/// Replaces a rectangle of the image.
std::string update_image_packet(std::string_view name, const transport::TileBounds& bounds,
                                const std::vector<grf::Colour>& pixels);

}  // namespace display
