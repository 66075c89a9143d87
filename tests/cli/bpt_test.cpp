// The program `bpt` as its users meet it.
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace {

using test::Outcome;

class Bpt : public testing::Test {
 protected:
  test::TemporaryFolder folder_;

  std::string write(const std::string& name, const std::string& text) const {
    return folder_.add(name, text);
  }
  std::string path(const std::string& name) const { return folder_.path(name); }

  Outcome bpt(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), GRANADA_BIN_DIR "/bpt");
    return test::run(arguments);
  }

  /// Renders something that is wrong: one message that contains the text, exit 1, and no image.
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

const std::string Quad =
    "begin mesh brdf diffuse kd=0.5\n"
    "begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end vertexs\n"
    "begin faces (0,1,2,3) end faces end mesh\n"
    "light begin (0,0,1) (0,1,0) (1,0,0) end\n";

TEST_F(Bpt, RendersAnOpFileAndSaysHowItWent) {
  write("scene.grf", Quad);
  const std::string op = write("scene.op",
                               "BPT_Scene scene.grf\nBPT_Output_Image image.exr\n"
                               "BPT_Image_Resolution 40 30\nBPT_Samples 8\n");
  const Outcome outcome = bpt({op});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("40x30 pixels, 8 samples a pixel"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(path("image.exr")));
}

TEST_F(Bpt, SummarisesAsJson) {
  const std::string scene = write("scene.grf", Quad);
  const Outcome outcome =
      bpt({"render", scene, "--size", "32x24", "--samples", "4", "--output", path("a.png"), "--output",
           path("b.exr"), "--json", "--depth", "3", "--seed", "7", "--threads", "1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto summary = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(summary["output"], path("a.png"));
  EXPECT_EQ(summary["width"], 32);
  EXPECT_EQ(summary["height"], 24);
  EXPECT_EQ(summary["samples"], 4);
  for (const char* field : {"setup_seconds", "render_seconds", "paths_per_second", "rays_per_second",
                            "estimated_error", "peak_memory_bytes"}) {
    EXPECT_GT(summary[field].get<double>(), 0) << field;
  }
  EXPECT_EQ(summary["effects"], (std::vector<std::string>{"area_lights", "diffuse_reflection"}));
  EXPECT_TRUE(std::filesystem::exists(path("a.png")) && std::filesystem::exists(path("b.exr")));
}

TEST_F(Bpt, WritesBesideTheSceneUnlessTold) {
  const std::string scene = write("scene.grf", Quad);
  EXPECT_EQ(bpt({"render", scene, "--size", "8x8", "--samples", "1"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("scene.exr")));
}

TEST_F(Bpt, ReportsFilesThatAreNone) {
  expect_bad_input(path("none.grf"), path("none.grf") + ": error: cannot read the file: No such file");
  expect_bad_input(path("none.op"), path("none.op") + ": error: cannot read the file: No such file");
  expect_bad_input(folder_.path(), folder_.path() + ": error: cannot read the file: it is a directory");
  expect_bad_input(write("empty.grf", ""), path("empty.grf") + ": error: the file is empty");
  expect_bad_input(write("empty.op", ""), path("empty.op") + ": error: the file is empty");
  expect_bad_input(write("missing.op", "BPT_Scene nothing.grf\n"),
                   path("nothing.grf") + ": error: cannot read");
}

TEST_F(Bpt, ReportsMistakesInScenesAtTheirPlace) {
  expect_bad_input(write("open.grf", "\n begin mesh begin vertexs (0,0,0)\n"),
                   path("open.grf") + ":2:13: error: ");
  expect_bad_input(write("index.grf",
                         "begin mesh begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs\n"
                         "begin faces (0,1,9) end faces end mesh\n"),
                   path("index.grf") + ":2:18: error: ");
  expect_bad_input(write("brdf.grf",
                         "begin mesh brdf wrad sx=0.1\n"
                         "begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs\n"
                         "begin faces (0,1,2) end faces end mesh\n"),
                   path("brdf.grf") +
                       ":1:17: error: unknown BRDF 'wrad': did you mean 'ward'?\n"
                       "  begin mesh brdf wrad sx=0.1\n"
                       "                  ^\n");
  expect_bad_input(write("nothing.grf", "// no blocks\n"), "the scene has nothing to render");
}

TEST_F(Bpt, ReportsMistakesInOptions) {
  write("scene.grf", Quad);
  expect_bad_input(write("key.op", "BPT_Scene scene.grf\nBPT_Sampels 4\n"),
                   path("key.op") +
                       ":2:1: error: unknown option 'BPT_Sampels': did you mean 'BPT_Samples'?\n"
                       "  BPT_Sampels 4\n"
                       "  ^\n");
  expect_bad_input(write("view.op", "BPT_Scene scene.grf\nBPT_Viewer 1 1 1\nBPT_VLook 1 1 1\n"),
                   "BPT_Viewer and BPT_VLook are the same point");
}

TEST_F(Bpt, RefusesOutputsBeforeItRenders) {
  const std::string scene = write("scene.grf", Quad);
  write("folder.png/file", "");
  for (const std::string& output :
       {path("image.bmp"), path("image"), path("no/such/folder/image.png"), path("folder.png")}) {
    const Outcome outcome = bpt({"render", scene, "--output", output, "--samples", "1000000"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find(output + ": error: "), std::string::npos) << outcome.err;
  }
}

TEST_F(Bpt, SaysWhenTheCommandLineIsBad) {
  const std::string scene = write("scene.grf", Quad);
  EXPECT_EQ(bpt({}).exit_code, 2);
  EXPECT_EQ(bpt({"render"}).exit_code, 2);
  EXPECT_EQ(bpt({"render", scene, "--sample", "4"}).exit_code, 2);
  EXPECT_EQ(bpt({"render", scene, "--samples", "many"}).exit_code, 2);
  EXPECT_EQ(bpt({"render", scene, "--size", "40"}).exit_code, 2);
  EXPECT_EQ(bpt({"--help"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(path("scene.exr")));
}

TEST_F(Bpt, KeepsTheImageWhenItIsInterrupted) {
  const std::string scene = write("scene.grf", Quad);
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string output = path("image" + std::to_string(signal) + ".png");
    const Outcome outcome = test::run({GRANADA_BIN_DIR "/bpt", "render", scene, "--output", output,
                                       "--samples", "100000000", "--size", "64x64", "--json"},
                                      {}, test::Interruption{signal, std::chrono::milliseconds(1500)});
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    ASSERT_TRUE(std::filesystem::exists(output));
    const double samples = nlohmann::json::parse(outcome.out)["samples"].get<double>();
    EXPECT_GT(samples, 1);
    EXPECT_LT(samples, 1e8);
  }
}

TEST_F(Bpt, GivesTheSameBytesForTheSameSeed) {
  const std::string scene = write("scene.grf", Quad);
  std::vector<std::string> images;
  for (const char* threads : {"1", "2", "7"}) {
    const std::string output = path(std::string("image") + threads + ".exr");
    ASSERT_EQ(
        bpt({"render", scene, "--output", output, "--size", "50x40", "--samples", "8", "--threads", threads})
            .exit_code,
        0);
    images.push_back(test::bytes_of(output));
  }
  EXPECT_TRUE(images[0] == images[1]);
  EXPECT_TRUE(images[0] == images[2]);
}

}  // namespace
