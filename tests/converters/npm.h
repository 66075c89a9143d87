// Tests use packages of npm: what others read and check of the files that are written.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace convert {

/// Programs of Node.js with packages that are installed in a folder of the build. Tests are skipped where npm
/// reaches no registry.
class NpmTest : public testing::Test {
 protected:
  explicit NpmTest(std::vector<std::string> packages) : packages_(std::move(packages)) {}

  void SetUp() override {
    std::filesystem::create_directories(Folder);
    std::string command =
        "cd '" + Folder + "' && flock lock npm install --no-audit --no-fund --loglevel=error";
    for (const std::string& package : packages_) command += " '" + package + "'";
    const test::Outcome installed = test::run({"/bin/sh", "-c", command});
    if (is_unreachable(installed.err)) GTEST_SKIP() << "npm reaches no registry: " << installed.err;
    ASSERT_EQ(installed.exit_code, 0) << installed.err;
  }

  /// Runs a program, an ECMAScript module.
  test::Outcome run_program(std::string_view text, const std::vector<std::string>& arguments) const {
    const std::string path =
        Folder + "/" + std::filesystem::path(folder_.path()).filename().string() + ".mjs";
    std::ofstream(path) << text;
    std::vector<std::string> command = {"/usr/bin/env", "node", path};
    command.insert(command.end(), arguments.begin(), arguments.end());
    test::Outcome outcome = test::run(command);
    std::filesystem::remove(path);
    return outcome;
  }

  const test::TemporaryFolder folder_;

 private:
  /// Returns whether npm says that it cannot reach a registry.
  static bool is_unreachable(std::string_view text) {
    for (const char* code :
         {"ENOTFOUND", "EAI_AGAIN", "ECONNREFUSED", "ECONNRESET", "ENETUNREACH", "ETIMEDOUT"}) {
      if (text.find(code) != std::string_view::npos) return true;
    }
    return false;
  }

  const std::string Folder = GRANADA_BIN_DIR "/npm";
  std::vector<std::string> packages_;
};

}  // namespace convert
