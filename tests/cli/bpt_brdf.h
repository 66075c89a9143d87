// Runs `bpt brdf` for tests of its command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace test {

class BptBrdf : public testing::Test {
 protected:
  TemporaryFolder folder_;

  static Outcome brdf(std::vector<std::string> arguments, std::string_view input = {}) {
    arguments.insert(arguments.begin(), {GRANADA_BIN_DIR "/bpt", "brdf"});
    return run(arguments, input);
  }

  /// Returns the output of a command, which has to succeed.
  static std::string out(const std::vector<std::string>& arguments, std::string_view input = {}) {
    const Outcome outcome = brdf(arguments, input);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }
  static nlohmann::json json(std::vector<std::string> arguments, std::string_view input = {}) {
    arguments.emplace_back("--json");
    return nlohmann::json::parse(out(arguments, input));
  }
  static std::vector<double> albedo(const std::string& instance, const std::string& u) {
    return json({"albedo", instance, "--u", u})["albedo"].get<std::vector<double>>();
  }

  static void expect_failure(const std::vector<std::string>& arguments, int exit_code,
                             const std::string& message, std::string_view input = {}) {
    const Outcome outcome = brdf(arguments, input);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
};

}  // namespace test
