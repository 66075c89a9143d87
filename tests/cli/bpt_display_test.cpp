// Tests of `bpt render` with BPT_DisplayWindow without an image viewer. The viewer of a full installation is
// tested in tests/editor/image/display_window_test.cpp.
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/bpt.h"
#include "tests/support/listener.h"
#include "tests/support/paths.h"

namespace {

namespace fs = std::filesystem;
using test::Outcome;

/// A copy of `bpt` in a separate folder, with or without a viewer beside it.
class BptDisplay : public test::Bpt {
 protected:
  BptDisplay() {
    fs::create_directories(path("bin"));
    fs::create_directories(path("other"));
    fs::copy_file(GRANADA_BIN_DIR "/bpt", path("bin/bpt"));
    write("scene.grf", test::Quad);
    ::setenv("GRANADA_DISPLAY_PORT", port_.c_str(), 1);
    ::setenv("DISPLAY", ":nowhere", 1);
    ::setenv("PATH", path("other").c_str(), 1);
    ::unsetenv("WAYLAND_DISPLAY");
  }

  /// Adds a viewer that writes a file and exits at once.
  void add_viewer(const std::string& folder, int exit_code) const {
    const std::string program = write(folder + "/wannabe", "#!/bin/sh\necho \"$@\" > '" + path("started") +
                                                               "'\nexit " + std::to_string(exit_code) + "\n");
    fs::permissions(program, fs::perms::owner_all);
  }

  Outcome render(const std::string& more = {}) const {
    const std::string options = write("scene.op",
                                      "BPT_Scene scene.grf\nBPT_Output_Image image.pfm\nBPT_Samples 1\n"
                                      "BPT_Image_Resolution 64 48\nBPT_DisplayWindow true\n" +
                                          more);
    return test::run({path("bin/bpt"), "render", options});
  }

  /// Expects the image, and this warning only.
  void expect_warning(const std::string& reason) const {
    const Outcome outcome = render();
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "warning: no viewer listens at 127.0.0.1:" + port_ +
                               ", and none can be started (" + reason +
                               "): rendering continues without one\n");
    EXPECT_EQ(fs::file_size(path("image.pfm")), std::string("PF\n64 48\n-1.0\n").size() + 64 * 48 * 12);
  }

  std::string port_ = std::to_string(test::free_port());
};

TEST_F(BptDisplay, DoesWithoutAScreen) {
  add_viewer("bin", 0);
  ::setenv("DISPLAY", "", 1);
  expect_warning("there is no display: neither DISPLAY nor WAYLAND_DISPLAY is set");
  ::unsetenv("DISPLAY");
  expect_warning("there is no display: neither DISPLAY nor WAYLAND_DISPLAY is set");
  EXPECT_FALSE(fs::exists(path("started")));
}

TEST_F(BptDisplay, DoesWithoutAProgram) {
  expect_warning("`wannabe` is neither in " + path("bin") + " nor in PATH");
}

TEST_F(BptDisplay, TellsOfAProgramThatEnds) {
  add_viewer("other", 4);
  expect_warning("`wannabe` exited with code 4");
  EXPECT_EQ(test::bytes_of(path("started")), "--tool image\n");
  add_viewer("bin", 3);
  expect_warning("`wannabe` exited with code 3");
}

TEST_F(BptDisplay, StartsNothingWhereAnotherViewerIsMeant) {
  add_viewer("bin", 0);
  const Outcome outcome = render("BPT_DisplayServer 127.0.0.1:1\n");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err.find("warning: no viewer listens at 127.0.0.1:1 ("), 0U) << outcome.err;
  EXPECT_FALSE(fs::exists(path("started")));
  EXPECT_TRUE(fs::exists(path("image.pfm")));
}

TEST_F(BptDisplay, LooksForTheViewerOfItsUser) {
  ::unsetenv("GRANADA_DISPLAY_PORT");
  ::setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1);
  EXPECT_THAT(render().err,
              testing::StartsWith("warning: no viewer listens at " + path("granada-display") + ", and none"));
  EXPECT_THAT(
      render("BPT_DisplayServer " + path("other") + "\n").err,
      testing::StartsWith("warning: no viewer listens at " + path("other") + " (Connection refused)"));
  ::unsetenv("XDG_RUNTIME_DIR");
}

TEST_F(BptDisplay, StartsNothingWhereAViewerListens) {
  add_viewer("bin", 0);
  const test::Listener viewer(std::stoi(port_));
  std::string bytes;
  std::thread receiver([&] { bytes = viewer.receive(); });
  const Outcome outcome = render();
  receiver.join();
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_GT(bytes.size(), 64U * 48 * 12);
  EXPECT_FALSE(fs::exists(path("started")));
}

}  // namespace
