// The viewer's side of `display_packets.h` decodes packets of tev's network protocol.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "renderer/transport/film.h"

namespace transport {

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
  TileBounds bounds;
  /// Linear radiance, rows from the top. Without channels called R, G and B, the first channel is shown in
  /// grey.
  std::vector<Rgb> pixels;
  /// Which of R, G and B are in the packet; the others keep their values in the image.
  std::array<bool, 3> has_channel = {true, true, true};
};

/// A packet with an operation that Granada's viewer does not support, such as opening a file.
struct OtherPacket {};

using DisplayPacket = std::variant<CloseImagePacket, CreateImagePacket, UpdateImagePacket, OtherPacket>;

/// The number of bytes of the length with which a packet starts.
inline constexpr std::size_t DisplayLengthBytes = 4;

/// Returns the size of the packet that starts with these bytes, of which there must be at least
/// `DisplayLengthBytes`.
std::size_t display_packet_size(std::string_view bytes);

/// Decodes a complete packet; empty if it is malformed.
std::optional<DisplayPacket> read_display_packet(std::string_view bytes);

}  // namespace transport
