#include "renderer/display/reader.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "renderer/display/packets.h"

namespace display {
namespace {

constexpr std::int64_t MostPixels = std::int64_t(1) << 27;
constexpr std::int32_t MostChannels = 256;

/// Reads the fields of a packet one by one. Past the end all are 0, and `is_good` is false.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : rest_(bytes) {}

  bool is_good() const { return is_good_; }
  std::string_view rest() const { return rest_; }

  template <class Number>
  Number number() {
    Number value = {};
    if (rest_.size() < sizeof(value)) {
      is_good_ = false;
    } else {
      std::memcpy(&value, rest_.data(), sizeof(value));
      rest_.remove_prefix(sizeof(value));
    }
    return value;
  }

  std::string text() {
    const std::size_t end = rest_.find('\0');
    if (end == std::string_view::npos) {
      is_good_ = false;
      return {};
    }
    std::string value(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return value;
  }

 private:
  std::string_view rest_;
  bool is_good_ = true;
};

bool is_size(std::int64_t width, std::int64_t height) {
  return width > 0 && height > 0 && width <= MostPixels / height;
}

/// Where the values of a channel are in the data of an update: offset and stride.
struct Channel {
  std::string name;
  std::int64_t offset = 0;
  std::int64_t stride = 1;
};

std::optional<Packet> read_create(Fields fields) {
  fields.number<std::uint8_t>();  // whether the image grabs the focus
  CreateImagePacket packet;
  packet.name = fields.text();
  packet.width = fields.number<std::int32_t>();
  packet.height = fields.number<std::int32_t>();
  if (!fields.is_good() || !is_size(packet.width, packet.height)) return std::nullopt;
  return packet;
}

std::vector<Channel> read_channel_names(Fields& fields, PacketType type) {
  const auto count = type == PacketType::UpdateImage ? 1 : fields.number<std::int32_t>();
  std::vector<Channel> channels;
  for (std::int32_t i = 0; i < std::min(count, MostChannels) && fields.is_good(); ++i) {
    channels.push_back({fields.text()});
  }
  return channels;
}

/// Whether all values of the channel are within the data.
bool fits(const Channel& channel, std::int64_t pixels, std::size_t bytes) {
  const auto floats = static_cast<std::int64_t>(bytes / sizeof(float));
  return channel.offset >= 0 && channel.stride >= 1 && channel.offset < floats &&
         (pixels == 1 || channel.stride <= (floats - 1 - channel.offset) / (pixels - 1));
}

/// Returns which of R, G and B a channel is, or -1. The channel of a grey image counts as all of them.
int component_of(const Channel& channel) {
  constexpr std::array<std::string_view, 3> Names = {"R", "G", "B"};
  const auto found = std::find(Names.begin(), Names.end(), channel.name);
  return found == Names.end() ? -1 : static_cast<int>(found - Names.begin());
}

void copy(const Channel& channel, std::string_view data, int component, UpdateImagePacket& packet) {
  for (std::size_t i = 0; i < packet.pixels.size(); ++i) {
    const auto at = static_cast<std::size_t>(channel.offset) + i * static_cast<std::size_t>(channel.stride);
    std::memcpy(&packet.pixels[i][component], data.data() + at * sizeof(float), sizeof(float));
  }
  packet.has_channel[static_cast<std::size_t>(component)] = true;
}

std::optional<Packet> read_update(Fields fields, PacketType type) {
  fields.number<std::uint8_t>();
  UpdateImagePacket packet;
  packet.name = fields.text();
  std::vector<Channel> channels = read_channel_names(fields, type);
  for (int* side : {&packet.bounds.x, &packet.bounds.y, &packet.bounds.width, &packet.bounds.height}) {
    *side = fields.number<std::int32_t>();
  }
  const transport::TileBounds& bounds = packet.bounds;
  if (!fields.is_good() || channels.empty() || bounds.x < 0 || bounds.y < 0 ||
      !is_size(bounds.width, bounds.height)) {
    return std::nullopt;
  }
  const std::int64_t pixels = std::int64_t(bounds.width) * bounds.height;
  for (std::size_t i = 0; i < channels.size(); ++i)
    channels[i].offset = static_cast<std::int64_t>(i) * pixels;
  if (type == PacketType::UpdateImageWithStrides) {
    for (Channel& channel : channels) channel.offset = fields.number<std::int64_t>();
    for (Channel& channel : channels) channel.stride = fields.number<std::int64_t>();
  }
  const std::string_view data = fields.rest();
  const auto is_whole = [&](const Channel& channel) { return fits(channel, pixels, data.size()); };
  if (!fields.is_good() || !std::all_of(channels.begin(), channels.end(), is_whole)) return std::nullopt;
  packet.pixels.resize(static_cast<std::size_t>(pixels), grf::Colour(0));
  packet.has_channel = {};
  for (const Channel& channel : channels) {
    if (const int component = component_of(channel); component >= 0) copy(channel, data, component, packet);
  }
  if (packet.has_channel == std::array<bool, 3>{}) {
    for (int component = 0; component < 3; ++component) copy(channels[0], data, component, packet);
  }
  return packet;
}

}  // namespace

std::size_t packet_size(std::string_view bytes) { return Fields(bytes).number<std::uint32_t>(); }

std::optional<Packet> read_packet(std::string_view bytes) {
  Fields fields(bytes);
  if (fields.number<std::uint32_t>() != bytes.size()) return std::nullopt;
  const auto type = static_cast<PacketType>(fields.number<std::uint8_t>());
  if (!fields.is_good()) return std::nullopt;
  switch (type) {
    case PacketType::CloseImage: {
      CloseImagePacket packet{fields.text()};
      return fields.is_good() ? std::optional<Packet>(std::move(packet)) : std::nullopt;
    }
    case PacketType::CreateImage:
      return read_create(fields);
    case PacketType::UpdateImage:
    case PacketType::UpdateImageOfChannels:
    case PacketType::UpdateImageWithStrides:
      return read_update(fields, type);
  }
  return OtherPacket{};
}

}  // namespace display
