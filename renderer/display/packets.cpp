#include "renderer/display/packets.h"

#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace display {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::array<std::string_view, 3> Channels = {"R", "G", "B"};

class PacketBytes {
 public:
  explicit PacketBytes(PacketType type) {
    add(std::uint32_t(0));
    add(type);
  }

  template <class Number>
  void add(Number number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }
  void add_text(std::string_view text) { bytes_.append(text).push_back('\0'); }
  void add_channels() {
    add(static_cast<std::int32_t>(Channels.size()));
    for (const std::string_view channel : Channels) add_text(channel);
  }
  void add_bytes(const void* bytes, std::size_t size) {
    bytes_.append(static_cast<const char*>(bytes), size);
  }

  std::string take() {
    const auto size = static_cast<std::uint32_t>(bytes_.size());
    std::memcpy(bytes_.data(), &size, sizeof(size));
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
};

constexpr std::uint8_t GrabsFocus = 1;
constexpr std::uint8_t LeavesFocus = 0;

}  // namespace

std::string close_image_packet(std::string_view name) {
  PacketBytes packet(PacketType::CloseImage);
  packet.add_text(name);
  return packet.take();
}

std::string create_image_packet(std::string_view name, int width, int height) {
  PacketBytes packet(PacketType::CreateImage);
  packet.add(GrabsFocus);
  packet.add_text(name);
  packet.add(std::int32_t(width));
  packet.add(std::int32_t(height));
  packet.add_channels();
  return packet.take();
}

std::string update_image_packet(std::string_view name, const transport::TileBounds& bounds,
                                const std::vector<grf::Colour>& pixels) {
  PacketBytes packet(PacketType::UpdateImageWithStrides);
  packet.add(LeavesFocus);
  packet.add_text(name);
  packet.add_channels();
  for (const int side : {bounds.x, bounds.y, bounds.width, bounds.height}) packet.add(std::int32_t(side));
  // The offset and stride of each channel, in floats: as they are in memory here.
  static_assert(sizeof(grf::Colour) == Channels.size() * sizeof(float));
  for (std::size_t i = 0; i < Channels.size(); ++i) packet.add(static_cast<std::int64_t>(i));
  for (std::size_t i = 0; i < Channels.size(); ++i) packet.add(static_cast<std::int64_t>(Channels.size()));
  packet.add_bytes(pixels.data(), pixels.size() * sizeof(grf::Colour));
  return packet.take();
}

}  // namespace display
