// Tests the images that `bpt` decodes in another process against those that it decodes in its own.
#include "renderer/command/isolated_images.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/image/decoded_image.h"
#include "renderer/image/image_file.h"
#include "tests/cli/bpt.h"

namespace {

namespace fs = std::filesystem;
using command::DecodingLimits;
using command::isolated_image_reader;
using std::string_literals::operator""s;
using testing::HasSubstr;

class IsolatedImages : public test::Bpt {
 protected:
  /// Returns a program that does something else than `bpt decode`.
  std::string program(const std::string& commands) const {
    const std::string path = write("program", "#!/bin/sh\n" + commands + "\n");
    fs::permissions(path, fs::perms::owner_all);
    return path;
  }
  std::string write_image(const std::string& name, int width = 5, int height = 3) const {
    image::Image image{width, height, {}};
    for (int i = 0; i < width * height; ++i)
      image.pixels.emplace_back(0.01F * float(i % 100), 0.5F, 1 - 0.01F * float(i % 90));
    grf::Diagnostics diagnostics;
    EXPECT_TRUE(image::write_image({image}, path(name), diagnostics)) << diagnostics.to_text();
    return path(name);
  }
  /// Returns the message for an image that a program is to decode.
  std::string message_of(const std::string& bpt, const std::string& image,
                         const DecodingLimits& limits = {}) const {
    grf::Diagnostics diagnostics;
    EXPECT_FALSE(isolated_image_reader(bpt, limits)(image, diagnostics, {}, image::Alpha::OverBlack));
    EXPECT_TRUE(diagnostics.files().empty());
    return diagnostics.entries().empty() ? "" : diagnostics.entries().front().message;
  }

  const std::string bpt_ = GRANADA_BIN_DIR "/bpt";
};

TEST_F(IsolatedImages, AreThoseOfOneProcess) {
  for (const char* name : {"a.exr", "a.png", "a.jpg", "a.hdr", "a.pfm", "a.tga", "a.raw"}) {
    const std::string path = write_image(name);
    for (const image::Alpha alpha : {image::Alpha::OverBlack, image::Alpha::Kept}) {
      grf::Diagnostics diagnostics;
      const auto expected = image::read_image(path, diagnostics, {}, alpha);
      grf::Diagnostics isolated_diagnostics;
      const auto isolated = isolated_image_reader(bpt_)(path, isolated_diagnostics, {}, alpha);
      ASSERT_TRUE(expected && isolated) << name << isolated_diagnostics.to_text();
      EXPECT_EQ(isolated->width, expected->width);
      EXPECT_EQ(isolated->pixels, expected->pixels);
      EXPECT_EQ(isolated->alpha, expected->alpha);
      EXPECT_EQ(isolated_diagnostics.files(), diagnostics.files());
    }
  }
}

// A PNG of one red pixel with an alpha of 128, made with Python's zlib.
TEST_F(IsolatedImages, KeepTheirAlpha) {
  const std::string png =
      write("half.png",
            "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000\001\000\000\000\001"
            "\010\006\000\000\000\037\025\304\211\000\000\000\015\111\104\101\124\170\234\143\370\317\300\320"
            "\000\000\004\201\001\200\054\125\316\260\000\000\000\000\111\105\116\104\256\102\140\202"s);
  grf::Diagnostics diagnostics;
  const auto image = isolated_image_reader(bpt_)(png, diagnostics, {}, image::Alpha::Kept);
  ASSERT_TRUE(image) << diagnostics.to_text();
  ASSERT_EQ(image->alpha.size(), 1U);
  EXPECT_NEAR(image->alpha[0], 128 / 255.0, 1e-6);
  EXPECT_NEAR(image->pixels[0].x, 128 / 255.0, 1e-6);
}

TEST_F(IsolatedImages, HaveTheMessagesOfOneProcess) {
  std::string damaged = test::bytes_of(write_image("a.png"));
  damaged.resize(damaged.size() / 2);
  for (const std::string& path :
       {write("damaged.png", damaged), path("none.png"), folder_.path(), write("empty.png", "")}) {
    for (const grf::SourceLocation& location : {grf::SourceLocation(), grf::whole_file("scene.grf")}) {
      grf::Diagnostics expected;
      EXPECT_FALSE(image::read_image(path, expected, location));
      grf::Diagnostics diagnostics;
      EXPECT_FALSE(isolated_image_reader(bpt_)(path, diagnostics, location, image::Alpha::OverBlack));
      EXPECT_EQ(diagnostics.to_text(), expected.to_text());
    }
  }
}

TEST_F(IsolatedImages, AreErrorsIfTheDecoderFails) {
  const std::string image = write_image("a.png");
  EXPECT_EQ(message_of(program("kill -SEGV $$"), image),
            "cannot read the image: it is damaged (its decoder crashed)");
  EXPECT_EQ(message_of(program("exit 0"), image),
            "cannot read the image: it is damaged (its decoder wrote no image)");
  // 9 pixels and the bytes of one
  EXPECT_EQ(message_of(program("printf '\\003\\0\\0\\0\\003\\0\\0\\0123456789012'"), image),
            "cannot read the image: it is damaged (its decoder wrote no image)");
  EXPECT_EQ(message_of(path("nothing"), image),
            "cannot read the image: its decoder cannot be started: No such file or directory");
}

TEST_F(IsolatedImages, HaveLimitsOfTimeAndMemory) {
  const auto start = std::chrono::steady_clock::now();
  DecodingLimits limits;
  limits.seconds = 0.2;
  EXPECT_EQ(message_of(program("exec sleep 100"), write_image("a.png"), limits),
            "cannot read the image: decoding takes longer than 0.2 s");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(50));
  limits.seconds = 60;
  limits.memory = 50'000'000;
  EXPECT_EQ(message_of(program("exec head -c 60000008 /dev/zero"), path("a.png"), limits),
            "cannot read the image: it is damaged (its decoder crashed)");
}

/// Returns whether a process runs with these arguments.
bool is_running(const std::string& arguments) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc", error)) {
    std::ifstream file(entry.path() / "cmdline", std::ios::binary);
    const std::string line((std::istreambuf_iterator<char>(file)), {});
    if (line == arguments) return true;
  }
  return false;
}

TEST_F(IsolatedImages, AreThoseOfARender) {
  const std::string texture = write_image("texture.png", 512, 512);
  const std::string scene =
      write("scene.grf",
            "begin mesh texture \"texture.png\" brdf diffuse kd=1"
            " begin vertexs uv (0, 0) (0, 0, 0) uv (1, 0) (1, 0, 0) uv (0, 1) (0, 1, 0) end vertexs"
            " begin faces (0, 1, 2) end faces end mesh\n");
  const pid_t process = ::fork();
  ASSERT_GE(process, 0);
  if (process == 0) {
    ::execl(bpt_.c_str(), "bpt", "render", scene.c_str(), "--samples", "1", "--size", "8x8", "--output",
            path("a.pfm").c_str(), nullptr);
    ::_exit(1);
  }
  bool was_seen = false;
  int status = 0;
  while (::waitpid(process, &status, WNOHANG) == 0)
    was_seen = was_seen || is_running("bpt\0decode\0--\0"s + texture + "\0"s);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(was_seen);
}

}  // namespace
