// Tests that `grfconvert` survives files that crash Assimp, make it hang or run out of memory.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/grfconvert.h"
#include "tests/support/temporary_folder.h"

namespace {

using nlohmann::json;
using test::grfconvert;
using test::TemporaryFolder;
using test::Triangle;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAreArray;

// Files that break Assimp 5.2.5. Reading an MD5 mesh writes past its buffer; reading the joints of an SMD
// file runs past the file's end.
const std::string Crashing = "MD5Version 10\n}\nmesh {\nnumverts 1\nnumtris 1\n}\n";
const std::string Greedy = "MD5Version 10\n}\nmesh {\nnumverts 2147483647\nnumtris 1\n}\n";
const std::string Endless = "version 1\nnodes\n0 \"";

/// A folder with files of all three kinds, and a valid one.
class GrfconvertIsolation : public testing::Test {
 protected:
  static void SetUpTestSuite() { test::crash_on_findings(); }

  TemporaryFolder folder_;
  std::string crashing_ = folder_.add("in/crashing.md5mesh", Crashing);
  std::string endless_ = folder_.add("in/endless.smd", Endless);
  std::string greedy_ = folder_.add("in/greedy.md5mesh", Greedy);
  std::string good_ = folder_.add("in/good.obj", Triangle);

  std::string crash_error() const { return crashing_ + ": error: the conversion crashed ("; }
  std::string time_error() const { return endless_ + ": error: exceeded the time limit of 0.5 s\n"; }
  std::string memory_error() const { return greedy_ + ": error: exceeded the memory limit of 4 GB\n"; }

  /// Runs the commands convert, info and check on a file, with further options.
  void expect_error_of_all_commands(const std::string& path, const std::string& error,
                                    const std::vector<std::string>& options = {}) const {
    for (std::vector<std::string> command :
         {std::vector<std::string>{path, "-o", folder_.path("out.grf")}, {"info", path}, {"check", path}}) {
      command.insert(command.end(), options.begin(), options.end());
      const test::Outcome outcome = grfconvert(command);
      EXPECT_EQ(outcome.exit_code, 1) << command[0];
      EXPECT_THAT(outcome.err, HasSubstr(error)) << command[0];
    }
    EXPECT_THAT(folder_.names(), ElementsAre("in")) << "nothing half done is left";
  }
};

TEST_F(GrfconvertIsolation, TellsOfACrash) { expect_error_of_all_commands(crashing_, crash_error()); }

TEST_F(GrfconvertIsolation, TellsOfARunaway) {
  expect_error_of_all_commands(endless_, time_error(), {"--max-time", "0.5"});
}

TEST_F(GrfconvertIsolation, TellsOfAHugeAllocation) {
  if (!test::LimitsMemory) GTEST_SKIP();
  expect_error_of_all_commands(greedy_, memory_error());
}

TEST_F(GrfconvertIsolation, LosesTheFilesAloneThatAreToBlame) {
  std::vector<std::string> bad = {crashing_, endless_};
  if (test::LimitsMemory) bad.push_back(greedy_);
  for (const std::string jobs : {"1", "4"}) {
    const std::string output = folder_.path("out" + jobs);
    std::vector<std::string> command = bad;
    // Long enough for the valid file even on a busy machine.
    command.insert(command.end(), {good_, "-o", output, "--max-time", "5", "--jobs", jobs, "--json"});
    const test::Outcome outcome = grfconvert(command);
    EXPECT_EQ(outcome.exit_code, 1);
    const json report = json::parse(outcome.out);
    ASSERT_EQ(report["conversions"].size(), 1U);
    EXPECT_EQ(report["conversions"][0]["input"], good_);
    EXPECT_THAT(report["failed"].get<std::vector<std::string>>(), UnorderedElementsAreArray(bad));
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(output)) {
      names.push_back(entry.path().filename().string());
    }
    EXPECT_THAT(names, ElementsAre("good.grf"));
  }
}

}  // namespace
