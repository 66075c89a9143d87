// Decoding of packets: the client's, other programs', and malformed ones.
#include "renderer/display/reader.h"

#include <cstring>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "renderer/display/packets.h"

namespace {

using display::CloseImagePacket;
using display::CreateImagePacket;
using display::OtherPacket;
using display::UpdateImagePacket;
using grf::Colour;

template <class Packet>
Packet read(const std::string& bytes) {
  EXPECT_EQ(display::packet_size(bytes), bytes.size());
  const auto packet = display::read_packet(bytes);
  EXPECT_TRUE(packet && std::holds_alternative<Packet>(*packet));
  return packet ? std::get<Packet>(*packet) : Packet();
}

template <class... Parts>
std::string packet_of(std::uint8_t type, const Parts&... parts) {
  std::string bytes(5, static_cast<char>(type));
  [[maybe_unused]] const auto add = [&](const auto& part) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(part)>>) {
      bytes.append(reinterpret_cast<const char*>(&part), sizeof(part));
    } else {
      bytes.append(part).push_back('\0');
    }
  };
  (add(parts), ...);
  const auto size = static_cast<std::uint32_t>(bytes.size());
  std::memcpy(bytes.data(), &size, sizeof(size));
  return bytes;
}

constexpr std::uint8_t Focus = 1;

TEST(DisplayReader, ReadsWhatTheClientWrites) {
  EXPECT_EQ(read<CloseImagePacket>(display::close_image_packet("a b.exr")).name, "a b.exr");
  const auto created = read<CreateImagePacket>(display::create_image_packet("x", 640, 480));
  EXPECT_EQ(created.name, "x");
  EXPECT_EQ(created.width, 640);
  EXPECT_EQ(created.height, 480);
  const std::vector<Colour> pixels = {Colour(1, 2, 3), Colour(4, 5, 6)};
  const auto updated = read<UpdateImagePacket>(display::update_image_packet("x", {7, 8, 2, 1}, pixels));
  EXPECT_EQ(updated.bounds.x, 7);
  EXPECT_EQ(updated.bounds.y, 8);
  EXPECT_EQ(updated.bounds.width, 2);
  EXPECT_EQ(updated.pixels, pixels);
  EXPECT_EQ(updated.has_channel, (std::array{true, true, true}));
}

TEST(DisplayReader, ReadsOtherPrograms) {
  const auto one = read<UpdateImagePacket>(
      packet_of(3, Focus, std::string("x"), std::string("G"), 0, 0, 2, 1, 0.5F, 0.25F));
  EXPECT_EQ(one.pixels, (std::vector<Colour>{Colour(0, 0.5F, 0), Colour(0, 0.25F, 0)}));
  EXPECT_EQ(one.has_channel, (std::array{false, true, false}));
  const auto planes = read<UpdateImagePacket>(packet_of(
      5, Focus, std::string("x"), 2, std::string("B"), std::string("R"), 0, 0, 1, 2, 1.0F, 2.0F, 3.0F, 4.0F));
  EXPECT_EQ(planes.pixels, (std::vector<Colour>{Colour(3, 0, 1), Colour(4, 0, 2)}));
  const auto grey =
      read<UpdateImagePacket>(packet_of(3, Focus, std::string("x"), std::string("depth"), 0, 0, 1, 1, 7.0F));
  EXPECT_EQ(grey.pixels, std::vector<Colour>{Colour(7)});
  read<OtherPacket>(packet_of(7, std::string("/etc/passwd"), std::string("")));
}

TEST(DisplayReader, RefusesDamage) {
  const auto is_refused = [](const std::string& bytes) { return !display::read_packet(bytes); };
  const std::string name = "x";
  EXPECT_TRUE(is_refused(packet_of(4, Focus, name, 0, 5, 0)));
  EXPECT_TRUE(is_refused(packet_of(4, Focus, name, 1 << 20, 1 << 20, 0)));
  EXPECT_TRUE(is_refused(packet_of(2)));
  EXPECT_TRUE(is_refused(packet_of(3, Focus, name, name, -1, 0, 1, 1, 1.0F)));
  EXPECT_TRUE(is_refused(packet_of(3, Focus, name, name, 0, 0, 2, 1, 1.0F)));
  const std::int64_t far = std::int64_t(1) << 62;
  EXPECT_TRUE(is_refused(packet_of(6, Focus, name, 1, name, 0, 0, 2, 1, std::int64_t(0), far, 1.0F, 2.0F)));
  EXPECT_TRUE(is_refused(packet_of(6, Focus, name, 1, name, 0, 0, 2, 1, -far, std::int64_t(1), 1.0F, 2.0F)));
  std::string longer = display::close_image_packet("a");
  longer.push_back('b');
  EXPECT_TRUE(is_refused(longer));
}

RC_GTEST_PROP(DisplayReader, SurvivesAnyBytes, ()) {
  std::string bytes = display::update_image_packet("x", {0, 0, 2, 1}, {Colour(1), Colour(2)});
  const int changes = *rc::gen::inRange(1, 6);
  for (int i = 0; i < changes; ++i) {
    bytes[*rc::gen::inRange<std::size_t>(4, bytes.size())] = *rc::gen::arbitrary<char>();
  }
  const auto packet = display::read_packet(bytes);
  const auto* update = packet ? std::get_if<UpdateImagePacket>(&*packet) : nullptr;
  if (update != nullptr) RC_ASSERT(update->pixels.size() == update->bounds.pixel_count());
}

}  // namespace
