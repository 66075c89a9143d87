#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "confinement/confinement.h"
#include "renderer/image/image_file.h"
#include "tests/cli/bpt.h"

namespace {

using std::string_literals::operator""s;
using std::string_view_literals::operator""sv;
using test::Outcome;

// An image of 2 x 2 pixels by hand. PFM has rows from the bottom, here in big-endian; raw has width and
// height, then rows from the top, all in little-endian. The floats 1, 2, 0.5, -1, 0 and 1/3 are 3f800000,
// 40000000, 3f000000, bf800000, 0 and 3eaaaaab.

constexpr std::string_view Pfm =
    "PF\n2 2\n1\n"
    "\xbf\x80\x00\x00\x00\x00\x00\x00\x3e\xaa\xaa\xab"
    "\x3f\x00\x00\x00\x3f\x00\x00\x00\x3f\x00\x00\x00"
    "\x3f\x80\x00\x00\x40\x00\x00\x00\x3f\x00\x00\x00"
    "\x00\x00\x00\x00\x3f\x80\x00\x00\x40\x00\x00\x00"sv;

constexpr std::string_view Raw =
    "\x02\x00\x00\x00\x02\x00\x00\x00"
    "\x00\x00\x80\x3f\x00\x00\x00\x40\x00\x00\x00\x3f"
    "\x00\x00\x00\x00\x00\x00\x80\x3f\x00\x00\x00\x40"
    "\x00\x00\x80\xbf\x00\x00\x00\x00\xab\xaa\xaa\x3e"
    "\x00\x00\x00\x3f\x00\x00\x00\x3f\x00\x00\x00\x3f"sv;

class BptDecode : public test::Bpt {
 protected:
  /// Expects a failure with one line on standard error, as for programs that name the file themselves.
  void expect_error(const std::string& image, const std::string& line) const {
    const Outcome outcome = bpt({"decode", image});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, line + "\n");
  }
};

TEST_F(BptDecode, WritesARawFileToStandardOutput) {
  const Outcome outcome = bpt({"decode", write("image.pfm", std::string(Pfm))});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, Raw);
  EXPECT_EQ(bpt({"decode", write("image.raw", outcome.out)}).out, Raw);
}

TEST_F(BptDecode, TakesNamesThatBeginWithAHyphen) {
  const std::string image = write("image.pfm", std::string(Pfm));
  EXPECT_EQ(bpt({"decode", "--", image}).out, Raw);
  EXPECT_EQ(bpt({"decode", "--", "-none.pfm"}).exit_code, 1);
}

// A layer "z" of the channel "z", which has no letter, and a layer "n" of X and Y, of one pixel.
TEST_F(BptDecode, AppendsTheLayersOfAnExr) {
  image::ImageFile file{{1, 1, {grf::Colour(1, 2, 0.5F)}}};
  file.layers = {{"n", "XY", {0.5F, -1}}, {"z", "", {2}}};
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(image::write_image(file, path("layers.exr"), diagnostics)) << diagnostics.to_text();
  const std::string_view raw =
      "\x01\x00\x00\x00\x01\x00\x00\x00\x00\x00\x80\x3f\x00\x00\x00\x40\x00\x00\x00\x3f"sv;
  const std::string_view layers =
      "\x01\x00\x00\x00\x02\x00\x00\x00nXY\x00\x00\x00\x3f\x00\x00\x80\xbf"
      "\x01\x00\x00\x00\x00\x00\x00\x00z\x00\x00\x00\x40"sv;
  EXPECT_EQ(bpt({"decode", path("layers.exr")}).out, raw);
  EXPECT_EQ(bpt({"decode", "--layers", path("layers.exr")}).out, std::string(raw) + std::string(layers));
  EXPECT_EQ(bpt({"decode", "--layers", write("image.pfm", std::string(Pfm))}).out, Raw);
}

// A pixel of red with an alpha of 0.2, in a TGA file: bottom up, blue first.
TEST_F(BptDecode, AppendsTheAlphaOfAnImage) {
  const std::string image = write("leaf.tga", std::string("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x20\x08"
                                                          "\0\0\xff\x33",
                                                          22));
  const std::string_view size = "\x01\x00\x00\x00\x01\x00\x00\x00"sv;
  const std::string_view fifth = "\xcd\xcc\x4c\x3e"sv;
  const std::string_view zeros = "\0\0\0\0\0\0\0\0"sv;
  const std::string_view layer =
      "\x01\x00\x00\x00\x00\x00\x00\x00"
      "A"sv;
  EXPECT_EQ(
      bpt({"decode", "--alpha", image}).out,
      std::string(size) + std::string(fifth) + std::string(zeros) + std::string(layer) + std::string(fifth));
  EXPECT_EQ(bpt({"decode", image}).out, std::string(size) + "\x00\x00\x80\x3f"s + std::string(zeros))
      << "TGA files have it beside";
  EXPECT_EQ(bpt({"decode", "--alpha", write("image.pfm", std::string(Pfm))}).out, Raw);
}

TEST_F(BptDecode, SaysWhyItCannot) {
  expect_error(write("cut.pfm", std::string(Pfm.substr(0, Pfm.size() - 1))),
               "cannot read the image: it is damaged (unexpected end of file)");
  expect_error(write("text.txt", "no image"),
               "cannot read the image: unknown format, expected OpenEXR, Radiance (hdr), pfm, raw, PNG, "
               "JPEG, TGA or WebP");
  expect_error(write("empty.pfm", ""), "cannot read the image: the file is empty");
  expect_error(path("none.pfm"), "cannot read the file: No such file or directory");
  expect_error(folder_.path(), "cannot read the file: it is a directory, expected a file");
  EXPECT_EQ(bpt({"decode"}).exit_code, 2);
}

/// Returns the line of a process's status (proc(5)) that begins with the key; empty if it has ended.
std::string status_of(pid_t process, std::string_view key) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  std::string line;
  while (std::getline(status, line)) {
    if (line.starts_with(key)) return line;
  }
  return {};
}

// It waits at the full pipe, confined.
TEST_F(BptDecode, IsConfined) {
  if (!confinement::available().has_seccomp) GTEST_SKIP();
  const std::string image =
      write("image.pfm", "Pf\n256 256\n-1\n" + std::string(256 * 256 * sizeof(float), '\0'));
  std::array<int, 2> ends = {};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const pid_t process = ::fork();
  ASSERT_GE(process, 0);
  if (process == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::execl(GRANADA_BIN_DIR "/bpt", "bpt", "decode", image.c_str(), nullptr);
    ::_exit(1);
  }
  pollfd has_begun = {ends[0], POLLIN, 0};
  EXPECT_EQ(::poll(&has_begun, 1, 60'000), 1);
  EXPECT_EQ(status_of(process, "Seccomp:"), "Seccomp:\t2");  // with a filter
  EXPECT_EQ(status_of(process, "NoNewPrivs:"), "NoNewPrivs:\t1");
  for (const int end : ends) ::close(end);
  ::waitpid(process, nullptr, 0);
}

}  // namespace
