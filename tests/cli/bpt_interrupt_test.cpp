// Tests of `bpt render` as a render farm runs it: interrupted, resumed, with progress as JSON lines.
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/listener.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace {

using nlohmann::json;
using test::Outcome;

class BptInterrupt : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  const std::string scene_ = folder_.add("scene.grf",
                                         "include \"quad.grf\"\n"
                                         "light begin (0,0,1) (0,1,0) (1,0,0) end\n");
  const std::string quad_ = folder_.add("quad.grf",
                                        "begin mesh brdf diffuse kd=0.5\n"
                                        "begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end vertexs\n"
                                        "begin faces (0,1,2,3) end faces end mesh\n");

  std::string path(const std::string& name) const { return folder_.path(name); }

  Outcome render(std::vector<std::string> arguments,
                 const std::vector<test::Interruption>& interruptions = {},
                 const std::string& size = "64x48") const {
    arguments.insert(arguments.begin(), {GRANADA_BIN_DIR "/bpt", "render", scene_, "--size", size});
    return test::run(arguments, {}, interruptions);
  }

  static std::vector<json> lines_of(const std::string& out) {
    std::vector<json> lines;
    std::istringstream stream(out);
    for (std::string line; std::getline(stream, line);) lines.push_back(json::parse(line));
    return lines;
  }
};

TEST_F(BptInterrupt, ResumesToTheSameBytes) {
  const std::vector<std::string> common = {"--samples", "3000", "--checkpoint", path("state")};
  ASSERT_EQ(render({"--samples", "3000", "--output", path("whole.pfm")}).exit_code, 0);
  auto arguments = common;
  arguments.insert(arguments.end(), {"--output", path("part.pfm"), "--json"});
  for (const int signal : {SIGINT, SIGTERM}) {
    // On a busy machine it may take longer until there is something to write.
    Outcome outcome;
    for (int wait = 150; wait < 5000 && outcome.out.empty(); wait *= 2) {
      outcome = render(arguments, {{signal, std::chrono::milliseconds(wait)}});
    }
    ASSERT_EQ(outcome.exit_code, 130) << outcome.err << outcome.out;
    EXPECT_LT(json::parse(outcome.out)["samples"].get<double>(), 3000);
    ASSERT_TRUE(std::filesystem::exists(path("state")) && std::filesystem::exists(path("part.pfm")));
  }
  EXPECT_FALSE(test::bytes_of(path("part.pfm")) == test::bytes_of(path("whole.pfm")));
  const Outcome outcome = render(arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["samples"], 3000);
  EXPECT_TRUE(test::bytes_of(path("part.pfm")) == test::bytes_of(path("whole.pfm")));
  EXPECT_EQ(folder_.names(),
            (std::vector<std::string>{"part.pfm", "quad.grf", "scene.grf", "state", "whole.pfm"}));
}

// A finished render waits two seconds for a viewer that does not receive its data.
TEST_F(BptInterrupt, EndsAtOnceAtTheSecondSignal) {
  const test::Interruption first = {SIGINT, std::chrono::milliseconds(1000)};
  const test::Interruption second = {SIGTERM, std::chrono::milliseconds(200)};
  for (const bool is_patient : {true, false}) {
    const test::Listener viewer;
    const std::string image = path(is_patient ? "kept.pfm" : "lost.pfm");
    const Outcome outcome =
        render({"--samples", "1000000", "--display-server", "127.0.0.1:" + viewer.port(), "--output", image},
               is_patient ? std::vector{first} : std::vector{first, second}, "700x700");
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_EQ(std::filesystem::exists(image), is_patient) << outcome.err;
  }
}

TEST_F(BptInterrupt, RefusesACheckpointOfAnotherImage) {
  const std::vector<std::string> common = {"--samples",   "4",        "--checkpoint",
                                           path("state"), "--output", path("image.pfm")};
  ASSERT_EQ(render(common).exit_code, 0);
  const std::string state = test::bytes_of(path("state"));
  std::filesystem::remove(path("image.pfm"));
  const auto expect_refusal = [&](const std::vector<std::string>& more, const std::string& why) {
    auto arguments = common;
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = render(arguments);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find(path("state") + ": error: cannot resume from the checkpoint: "),
              std::string::npos);
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    EXPECT_TRUE(test::bytes_of(path("state")) == state);
    EXPECT_FALSE(std::filesystem::exists(path("image.pfm")));
  };
  expect_refusal({"--depth", "2"}, "with other options");
  expect_refusal({"--seed", "2"}, "with other options");
  // An included file is part of the scene.
  const std::string quad = test::bytes_of(quad_);
  folder_.add("quad.grf", quad + "// changed\n");
  expect_refusal({}, "of a scene with other contents");
  folder_.add("quad.grf", quad);
  EXPECT_EQ(render(common).exit_code, 0);
}

TEST_F(BptInterrupt, ThreadsAndOutputsAreNoOtherImage) {
  const std::string state = path("state");
  ASSERT_EQ(render({"--samples", "4", "--checkpoint", state, "--output", path("a.pfm"), "--threads", "1"})
                .exit_code,
            0);
  const Outcome more =
      render({"--samples", "9", "--checkpoint", state, "--output", path("b.pfm"), "--threads", "2"});
  EXPECT_EQ(more.exit_code, 0) << more.err;
  ASSERT_EQ(render({"--samples", "9", "--output", path("c.pfm")}).exit_code, 0);
  EXPECT_TRUE(test::bytes_of(path("b.pfm")) == test::bytes_of(path("c.pfm")));
}

TEST_F(BptInterrupt, ReportsProgressAsLinesOfJson) {
  const std::string image = path("image.pfm");
  const Outcome outcome = render({"--time", "0.8", "--progress", "json", "--json", "--output", image});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::vector<json> lines = lines_of(outcome.out);
  ASSERT_GE(lines.size(), 4U);
  EXPECT_LE(lines.size(), 8U);
  EXPECT_EQ(lines.back()["output"], image);
  EXPECT_GT(lines.back()["samples"].get<double>(), 100);  // not the default: time decides
  lines.pop_back();
  double done = -1;
  for (const json& line : lines) {
    for (const char* field : {"seconds", "seconds_left", "estimated_error"})
      EXPECT_TRUE(line.contains(field));
    EXPECT_GE(line["done"].get<double>(), done);
    done = line["done"].get<double>();
    const bool is_last = &line == &lines.back();
    EXPECT_EQ(line["image"], is_last ? json(image) : json(nullptr));
    EXPECT_EQ(done == 1, is_last);
  }
}

TEST_F(BptInterrupt, StopsAtATargetError) {
  const Outcome outcome = render({"--target-error", "0.01", "--json", "--output", path("image.pfm")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json summary = json::parse(outcome.out);
  EXPECT_LE(summary["estimated_error"].get<double>(), 0.01);
  EXPECT_TRUE(summary["samples"].is_number_integer());
}

TEST_F(BptInterrupt, ReportsWhatIsNotThere) {
  const Outcome viewer =
      render({"--samples", "1", "--display-server", "127.0.0.1:1", "--output", path("a.pfm")});
  EXPECT_EQ(viewer.exit_code, 0);
  EXPECT_EQ(viewer.err.find("warning: no viewer listens at 127.0.0.1:1"), 0U) << viewer.err;
  EXPECT_EQ(render({"--display-server", "host:port", "--samples", "1"}).exit_code, 2);
  EXPECT_EQ(render({"--progress", "loud", "--samples", "1"}).exit_code, 2);
  EXPECT_EQ(render({"--target-error", "0", "--samples", "1"}).exit_code, 2);
  const Outcome folder = render({"--checkpoint", path("no/such/state"), "--samples", "1"});
  EXPECT_EQ(folder.exit_code, 1);
  EXPECT_NE(folder.err.find("cannot write into the folder"), std::string::npos) << folder.err;
}

}  // namespace
