// The viewer's side of `packets.h` decodes packets of tev's network protocol.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grf/math.h"
#include "renderer/transport/tile_bounds.h"

namespace display {

struct CloseImagePacket {
  std::string name;
};

struct CreateImagePacket {
  std::string name;
  int width = 0;
  int height = 0;
};

struct UpdateImagePacket {
  std::string name;
  transport::TileBounds bounds;
  /// Linear radiance, rows from the top. Without channels called R, G and B, the first channel is shown in
  /// grey.
  std::vector<grf::Colour> pixels;
  /// Which of R, G and B are in the packet; the others keep their values in the image.
  std::array<bool, 3> has_channel = {true, true, true};
};

/// A packet with an operation that Granada's viewer does not support, such as opening a file.
struct OtherPacket {};

using Packet = std::variant<CloseImagePacket, CreateImagePacket, UpdateImagePacket, OtherPacket>;

/// The number of bytes of the length with which a packet starts.
inline constexpr std::size_t LengthBytes = 4;

/// Returns the size of the packet that starts with these bytes, of which there must be at least
/// `LengthBytes`.
std::size_t packet_size(std::string_view bytes);

/// Decodes a complete packet; empty if it is malformed.
std::optional<Packet> read_packet(std::string_view bytes);

}  // namespace display
