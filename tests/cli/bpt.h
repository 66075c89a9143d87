// Runs the program `bpt` for tests of its command line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace test {

class Bpt : public testing::Test {
 protected:
  TemporaryFolder folder_;

  std::string write(const std::string& name, const std::string& text) const {
    return folder_.add(name, text);
  }
  std::string path(const std::string& name) const { return folder_.path(name); }

  Outcome bpt(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), GRANADA_BIN_DIR "/bpt");
    return run(arguments);
  }

  /// Expects that a render fails with one message that contains the text, exit code 1 and no image.
  void expect_bad_input(const std::string& scene, const std::string& message) const {
    const std::string output = path("image.png");
    const Outcome outcome = bpt({"render", scene, "--output", output, "--samples", "1"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    std::size_t errors = 0;
    for (std::size_t at = 0; (at = outcome.err.find("error: ", at)) != std::string::npos; ++at) ++errors;
    EXPECT_EQ(errors, 1U) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(std::filesystem::exists(output));
  }
};

/// A square under a light.
inline const std::string Quad =
    "begin mesh brdf diffuse kd=0.5\n"
    "begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end vertexs\n"
    "begin faces (0,1,2,3) end faces end mesh\n"
    "light begin (0,0,1) (0,1,0) (1,0,0) end\n";

}  // namespace test
