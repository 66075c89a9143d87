// The viewer's side of `display_packets.h`: what a packet of tev's network protocol asks for.
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
  /// Linear radiance, rows from the top. What has no channels called R, G and B shows its first one in grey.
  std::vector<Rgb> pixels;
  /// Which of R, G and B are in the packet: the others stay as they are in the image.
  std::array<bool, 3> has_channel = {true, true, true};
};

/// A packet that asks for what a viewer of renders does not do, such as opening a file.
struct OtherPacket {};

using DisplayPacket = std::variant<CloseImagePacket, CreateImagePacket, UpdateImagePacket, OtherPacket>;

/// Bytes of a packet's length, with which it starts.
inline constexpr std::size_t DisplayLengthBytes = 4;

/// How many bytes the packet has with which these bytes start; they must be `DisplayLengthBytes` or more.
std::size_t display_packet_size(std::string_view bytes);

/// What a whole packet says, or nothing if it is damaged.
std::optional<DisplayPacket> read_display_packet(std::string_view bytes);

}  // namespace transport
