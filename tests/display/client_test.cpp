// A test viewer that decodes tev's protocol from its specification, independently of the code that sends.
#include "renderer/display/client.h"

#include <cstring>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/listener.h"
#include "tests/transport/scene_helpers.h"

namespace {

using display::Address;
using display::Client;
using transport::Render;

Address address_of(const test::Listener& viewer) { return {"127.0.0.1", viewer.port()}; }

/// Reads the fields of a packet one by one.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : rest_(bytes) {}

  template <class Number>
  Number number() {
    Number value;
    if (rest_.size() < sizeof(value)) throw std::runtime_error("a packet is too short");
    std::memcpy(&value, rest_.data(), sizeof(value));
    rest_.remove_prefix(sizeof(value));
    return value;
  }
  std::string text() {
    const std::size_t end = rest_.find('\0');
    if (end == std::string_view::npos) throw std::runtime_error("a text does not end");
    std::string value(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return value;
  }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

/// What a viewer shows after some packets.
struct Viewer {
  std::string name;
  std::vector<std::string> channels;
  int width = 0;
  int height = 0;
  std::vector<std::vector<float>> values;  ///< per channel
  int updates = 0;
  bool closed_first = false;

  void show(std::string_view bytes) {
    while (!bytes.empty()) {
      const auto length = Fields(bytes).number<std::uint32_t>();
      if (length < 5 || length > bytes.size()) throw std::runtime_error("a packet has a wrong length");
      Fields fields(bytes.substr(4, length - 4));
      bytes.remove_prefix(length);
      const int type = fields.number<std::uint8_t>();
      if (type == 2) closed_first = name.empty() && !fields.text().empty();
      if (type == 4) create(fields);
      if (type == 6) update(fields);
      if (type != 2 && type != 4 && type != 6) throw std::runtime_error("an unknown packet");
    }
  }

  void create(Fields fields) {
    fields.number<std::uint8_t>();
    name = fields.text();
    width = fields.number<std::int32_t>();
    height = fields.number<std::int32_t>();
    const int count = fields.number<std::int32_t>();
    for (int i = 0; i < count; ++i) channels.push_back(fields.text());
    values.assign(channels.size(), std::vector<float>(static_cast<std::size_t>(width * height)));
  }

  void update(Fields fields) {
    ++updates;
    fields.number<std::uint8_t>();
    ASSERT_EQ(fields.text(), name);
    const int count = fields.number<std::int32_t>();
    ASSERT_EQ(count, static_cast<int>(channels.size()));
    for (const std::string& channel : channels) ASSERT_EQ(fields.text(), channel);
    std::array<std::int32_t, 4> box = {};
    for (auto& side : box) side = fields.number<std::int32_t>();
    std::vector<std::int64_t> offsets;
    std::vector<std::int64_t> strides;
    for (int i = 0; i < count; ++i) offsets.push_back(fields.number<std::int64_t>());
    for (int i = 0; i < count; ++i) strides.push_back(fields.number<std::int64_t>());
    const auto [x, y, w, h] = box;
    ASSERT_TRUE(x >= 0 && y >= 0 && x + w <= width && y + h <= height);
    ASSERT_EQ(fields.rest().size(), 3 * sizeof(float) * static_cast<std::size_t>(w * h));
    for (std::size_t c = 0; c < channels.size(); ++c) {
      for (int i = 0; i < w * h; ++i) {
        const std::int64_t at = (offsets[c] + i * strides[c]) * static_cast<std::int64_t>(sizeof(float));
        const std::int64_t pixel = std::int64_t{y + i / w} * width + x + i % w;
        std::memcpy(&values[c][static_cast<std::size_t>(pixel)], fields.rest().data() + at, sizeof(float));
      }
    }
  }
};

class Display : public testing::Test {
 protected:
  transport::CompiledScene scene_ = test::scene_of(test::LitFloor);

  static transport::RenderSettings settings(int samples) {
    test::RenderSetup setup = test::floor_setup(150, 61, samples);
    setup.background = 0.25F;
    return test::settings_of(setup);
  }
};

TEST_F(Display, ShowsTheFinalImageAndStatesBefore) {
  const test::Listener server;
  std::string bytes;
  std::thread viewer([&] { bytes = server.receive(); });
  Render render(scene_, settings(150));
  {
    Client client(render, address_of(server), "a picture.exr");
    render.run();
    client.finish(std::chrono::seconds(30));
    EXPECT_EQ(client.take_problem(), std::nullopt);
  }
  viewer.join();
  Viewer shown;
  shown.show(bytes);
  EXPECT_TRUE(shown.closed_first);
  EXPECT_EQ(shown.name, "a picture.exr");
  EXPECT_EQ(shown.channels, (std::vector<std::string>{"R", "G", "B"}));
  ASSERT_EQ(shown.width, 150);
  ASSERT_EQ(shown.height, 61);
  EXPECT_GT(shown.updates, 8);  // more than the four rows of tiles twice
  const image::Image image = render.film().mean();
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_EQ(shown.values[c][i], image.pixels[i][static_cast<int>(c)]) << "pixel " << i;
    }
  }
}

TEST_F(Display, DoesWithoutAViewer) {
  Address nobody;
  {
    const test::Listener gone;
    nobody = address_of(gone);
  }
  Render render(scene_, settings(2));
  Client client(render, nobody, "image");
  render.run();
  client.finish();
  const auto problem = client.take_problem();
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->find("no viewer listens at " + nobody.text()), std::string::npos) << *problem;
  EXPECT_EQ(client.take_problem(), std::nullopt);
}

TEST_F(Display, WaitsForAViewerThatIsStarted) {
  const int port = test::free_port();
  std::optional<test::Listener> server;
  std::string bytes;
  std::thread viewer;
  int calls = 0;
  const auto start_at_third_call = [&]() -> std::optional<std::string> {
    if (++calls == 3) {
      server.emplace(port);
      viewer = std::thread([&] { bytes = server->receive(); });
    }
    return std::nullopt;
  };
  Render render(scene_, settings(1));
  {
    Client client(render, {"127.0.0.1", std::to_string(port)}, "image", start_at_third_call);
    render.run();
    while (client.is_connecting()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    client.finish(std::chrono::seconds(30));
    EXPECT_EQ(client.take_problem(), std::nullopt);
  }
  ASSERT_EQ(calls, 3);
  viewer.join();
  Viewer shown;
  shown.show(bytes);
  EXPECT_EQ(shown.name, "image");
  EXPECT_GE(shown.updates, 4) << "a row of tiles each";
}

TEST_F(Display, SaysOnceWhyNoViewerCanBeStarted) {
  const std::string port = std::to_string(test::free_port());
  for (const int good_calls : {0, 2}) {
    int calls = 0;
    const auto fail = [&] { return ++calls > good_calls ? std::optional<std::string>("why") : std::nullopt; };
    Render render(scene_, settings(2));
    Client client(render, {"127.0.0.1", port}, "image", fail);
    render.run();
    while (client.is_connecting()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(calls, good_calls + 1);
    EXPECT_EQ(client.take_problem(), "no viewer listens at 127.0.0.1:" + port +
                                         ", and none can be started (why): rendering continues without one");
    EXPECT_EQ(client.take_problem(), std::nullopt);
  }
}

TEST_F(Display, LeavesAViewerThatDoesNotComeInTime) {
  Render render(scene_, settings(2));
  const auto start = std::chrono::steady_clock::now();
  Client client(render, {"127.0.0.1", std::to_string(test::free_port())}, "image",
                [] { return std::optional<std::string>(); });
  render.run();
  client.finish(std::chrono::milliseconds(100));
  EXPECT_FALSE(client.is_connecting());
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(8));
}

TEST_F(Display, GoesOnWhenTheViewerIsGone) {
  const test::Listener server;
  std::thread viewer([&] { ::close(server.accept()); });
  Render render(scene_, settings(300));
  Client client(render, address_of(server), "image");
  render.run();
  viewer.join();
  client.finish();
  EXPECT_EQ(render.end(), transport::RenderEnd::Samples);
  const auto problem = client.take_problem();
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->find("connection to the viewer"), std::string::npos) << *problem;
}

// The socket's buffers are full before the whole image is sent.
TEST_F(Display, WaitsForNoViewerThatDoesNotRead) {
  const test::Listener server;
  transport::RenderSettings large = settings(1);
  large.width = large.height = 1500;
  Render render(scene_, large);
  const auto start = std::chrono::steady_clock::now();
  Client client(render, address_of(server), "image");
  render.run();
  client.finish(std::chrono::milliseconds(100));
  EXPECT_EQ(render.end(), transport::RenderEnd::Samples);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

TEST(DisplayAddress, IsReadFromText) {
  const auto text_of = [](std::string_view text) {
    const auto address = display::address_of(text);
    return address ? address->host + " " + address->port : "";
  };
  EXPECT_EQ(text_of("example:80"), "example 80");
  EXPECT_EQ(text_of("example"), "example 14158");
  EXPECT_EQ(text_of(":80"), "127.0.0.1 80");
  EXPECT_EQ(text_of("[::1]:80"), "::1 80");
  EXPECT_EQ(text_of("[::1]"), "::1 14158");
  for (const char* wrong : {"", "a:", "a:b", "a:0", "a:65536", "a:1234567", "[::1", "a:-1", "[::1]80"}) {
    EXPECT_EQ(text_of(wrong), "") << wrong;
  }
}

TEST(DisplayAddress, IsThePathOfASocket) {
  const auto address = display::address_of("/run/user/1000/granada-display");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->path, "/run/user/1000/granada-display");
  EXPECT_EQ(address->text(), address->path);
  // unix(7): at most 108 bytes with the zero that ends it
  EXPECT_TRUE(display::address_of("/" + std::string(106, 'x')));
  EXPECT_FALSE(display::address_of("/" + std::string(107, 'x')));
}

TEST(DisplayAddress, BelongsToTheUserUnlessAPortIsAskedFor) {
  ::unsetenv("GRANADA_DISPLAY_PORT");
  ::setenv("XDG_RUNTIME_DIR", "/run/user/7", 1);
  EXPECT_EQ(display::default_address().text(), "/run/user/7/granada-display");
  EXPECT_EQ(display::free_address().text(), "/run/user/7/granada-display-" + std::to_string(::getpid()));
  const std::string shared = "/tmp/granada-display-" + std::to_string(::getuid());
  for (const std::string& unusable : {std::string(), std::string("run"), "/" + std::string(90, 'x')}) {
    ::setenv("XDG_RUNTIME_DIR", unusable.c_str(), 1);
    EXPECT_EQ(display::default_address().text(), shared);
  }
  ::unsetenv("XDG_RUNTIME_DIR");
  EXPECT_EQ(display::default_address().text(), shared);
  ::setenv("GRANADA_DISPLAY_PORT", "12345", 1);
  EXPECT_EQ(display::default_address().text(), "127.0.0.1:12345");
  EXPECT_EQ(display::free_address().text(), "127.0.0.1:0");
  ::setenv("GRANADA_DISPLAY_PORT", "none", 1);
  EXPECT_EQ(display::default_address().text(), shared);
  ::unsetenv("GRANADA_DISPLAY_PORT");
}

}  // namespace
