// Tests of the options and messages of `bpt render`.
#include "tests/cli/bpt.h"

#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/image/image.h"
#include "tests/support/paths.h"

namespace {

using test::Bpt;
using test::Outcome;
using test::Quad;

TEST_F(Bpt, RendersAnOpFileAndSaysHowItWent) {
  write("scene.grf", Quad);
  const std::string op = write("scene.op",
                               "BPT_Scene scene.grf\nBPT_Output_Image image.exr\n"
                               "BPT_Image_Resolution 40 30\nBPT_Samples 8\n");
  const Outcome outcome = bpt({op});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("40x30 pixels, 8 samples per pixel"), std::string::npos);
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
  const auto interval = summary["estimated_error_interval"].get<std::vector<double>>();
  ASSERT_EQ(interval.size(), 2U);
  EXPECT_LT(interval[0], summary["estimated_error"].get<double>());
  EXPECT_GT(interval[1], summary["estimated_error"].get<double>());
  EXPECT_EQ(summary["effects"], (std::vector<std::string>{"area_lights"}));
  const auto& visible = summary["visible_difference"];
  EXPECT_GT(visible["percentile_95"].get<double>(), 0);
  EXPECT_GT(visible["samples_needed"].get<double>(), 0);
  EXPECT_EQ(visible["exposure"], 0);
  EXPECT_EQ(visible["pixels_per_degree"], 40);
  EXPECT_TRUE(std::filesystem::exists(path("a.png")) && std::filesystem::exists(path("b.exr")));
}

TEST_F(Bpt, WritesBesideTheSceneUnlessTold) {
  const std::string scene = write("scene.grf", Quad);
  const Outcome outcome = bpt({"render", scene, "--size", "8x8", "--samples", "1"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("8x8 pixels, 1 sample per pixel"), std::string::npos) << outcome.out;
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
                                      {}, {{signal, std::chrono::milliseconds(1500)}});
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    ASSERT_TRUE(std::filesystem::exists(output));
    const double samples = nlohmann::json::parse(outcome.out)["samples"].get<double>();
    EXPECT_GT(samples, 1);
    EXPECT_LT(samples, 1e8);
  }
}

/// An environment map of two texels, 1 and 2.
const std::string SmallMap = std::string("Pf 2 1 -1\n\0\0\x80\x3f\0\0\0\x40", 18);

TEST_F(Bpt, LightsByAnEnvironmentMap) {
  write("maps/sky.pfm", SmallMap);
  write("scene.grf", Quad);
  const std::string op = write("scene.op",
                               "BPT_Scene scene.grf\nBPT_EM_Background maps/sky.pfm\n"
                               "BPT_Image_Resolution 16 16\nBPT_Samples 4\nBPT_RIS 8 2\n");
  EXPECT_EQ(bpt({op}).err, "");
  const std::string with_map = test::bytes_of(path("scene.exr"));
  ASSERT_NE(with_map, "");
  EXPECT_EQ(bpt({"render", op, "--environment", "none"}).err,
            path("scene.op") + ":5:9: warning: BPT_RIS has no effect: no BPT_EM_Background is given\n" +
                "  BPT_RIS 8 2\n          ^\n");
  EXPECT_NE(test::bytes_of(path("scene.exr")), with_map);
  EXPECT_EQ(bpt({"render", op, "--ris", "8"}).exit_code, 2);
  EXPECT_EQ(bpt({"render", op, "--ris", "16x4"}).exit_code, 0);
}

const std::string SmallOp = "BPT_Scene scene.grf\nBPT_Image_Resolution 8 8\nBPT_Samples 2\n";

TEST_F(Bpt, RendersTheCameraThatIsNamed) {
  write("scene.grf", Quad);
  const std::string op =
      write("scene.op", SmallOp +
                            "BPT_Cameras \"the front\" .5 .5 .9  .5 .5 0  0 1 0  45 0 0\n"
                            "BPT_Cameras away .5 .5 .9  9 .5 .9  0 1 0  45 0 0  # sees nothing\n");
  ASSERT_EQ(bpt({"render", op, "--camera", "the front", "--output", path("front.pfm")}).err, "");
  ASSERT_EQ(bpt({"render", op, "--camera", "away", "--output", path("away.pfm")}).err, "");
  grf::Diagnostics diagnostics;
  const auto front = image::read_image(path("front.pfm"), diagnostics);
  const auto away = image::read_image(path("away.pfm"), diagnostics);
  ASSERT_TRUE(front && away);
  EXPECT_GT(front->at(4, 4).x, 0);
  EXPECT_EQ(away->at(4, 4).x, 0);
  const Outcome unknown = bpt({"render", op, "--camera", "side"});
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_NE(unknown.err.find("there is no camera 'side', expected one of the front, away"), std::string::npos)
      << unknown.err;
}

TEST_F(Bpt, ReportsMistakesInCamerasAtTheirLine) {
  write("scene.grf", Quad);
  const std::string op = write("scene.op", SmallOp + "BPT_Cameras a 0 0 3  0 0 0  0 1 0  45 0 0\n" +
                                               "BPT_Cameras b 0 0 3  0 0 0  0 1 0  45 0\n" +
                                               "BPT_Cameras a 0 0 4  0 0 0  0 1 0  45 0 0\n");
  const Outcome outcome = bpt({"render", op});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("scene.op:5:13: error: BPT_Cameras: found 12 values, expected 13"),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("scene.op:6:13: error: BPT_Cameras: two cameras have the name 'a'"),
            std::string::npos)
      << outcome.err;
}

TEST_F(Bpt, RendersFramesOfAnAnimation) {
  write("scene.grf", Quad);
  const std::string op =
      write("scene.op", SmallOp + "BPT_Frames 3\nBPT_Viewer 0.5 1 3\nBPT_VLook 0.4 0.5 0\n");
  ASSERT_EQ(bpt({"render", op, "--output", path("turn.pfm")}).err, "");
  const std::string second = test::bytes_of(path("turn_0002.pfm"));
  for (const char* other : {"turn_0001.pfm", "turn_0003.pfm"}) {
    EXPECT_NE(test::bytes_of(path(other)), "");
    EXPECT_FALSE(test::bytes_of(path(other)) == second) << other;
  }
  EXPECT_FALSE(std::filesystem::exists(path("turn.pfm")));
  ASSERT_EQ(bpt({"render", op, "--frame", "2", "--output", path("one.pfm")}).err, "");
  EXPECT_TRUE(test::bytes_of(path("one_0002.pfm")) == second);
  EXPECT_FALSE(std::filesystem::exists(path("one_0001.pfm")));
}

TEST_F(Bpt, ReportsEnvironmentMapsThatAreNone) {
  write("scene.grf", Quad);
  write("cut.pfm", SmallMap.substr(0, 15));
  expect_bad_input(write("a.op", "BPT_Scene scene.grf\nBPT_EM_Background cut.pfm\n"),
                   path("a.op") + ":2:19: error: cannot read the image '" + path("cut.pfm") +
                       "': it is damaged (unexpected end of file)");
  expect_bad_input(write("b.op", "BPT_Scene scene.grf\nBPT_EM_Background none.exr\n"),
                   path("b.op") + ":2:19: error: cannot read '" + path("none.exr") + "': No such file");
}

TEST_F(Bpt, TakesTheSchemeFromOptions) {
  write("scene.grf", Quad);
  const std::string op = write("scene.op",
                               "BPT_Scene scene.grf\nBPT_Pdf_Name Diffuse\nBPT_QT_avgnmax 2\n"
                               "BPT_Image_Resolution 8 8\nBPT_Samples 2\nBPT_Pdf_memstat true\n");
  EXPECT_EQ(bpt({op}).err,
            path("scene.op") +
                ":3:16: warning: BPT_QT_avgnmax has no effect: the scheme 'diffuse' does not use "
                "it\n  BPT_QT_avgnmax 2\n                 ^\n");
  EXPECT_EQ(test::bytes_of(path("mem.op")), "# brdf\tpdf\tbytes\ndiffuse kd=0.5\tdiffuse\t0\nsum\t\t0\n");
  const Outcome refused = bpt({"render", op, "--pdf", "Specular"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.err.find("error: the scheme 'specular' cannot sample the BRDF 'diffuse'"),
            std::string::npos)
      << refused.err;
  EXPECT_EQ(bpt({"render", op, "--pdf", "auto"}).exit_code, 0);
  EXPECT_NE(test::bytes_of(path("mem.op")).find("\tauto\t"), std::string::npos);
  EXPECT_EQ(bpt({"render", op, "--pdf", "best"}).exit_code, 2);
}

TEST_F(Bpt, SavesFactorsAndLoadsThem) {
  write("scene.grf", Quad);
  const std::string op = write("scene.op",
                               "BPT_Scene scene.grf\nBPT_Pdf_Name Factored\nBPT_Pdf_Factors_File clay\n"
                               "BPT_Image_Resolution 8 8\nBPT_Samples 2\nBPT_Output_Image scene.pfm\n");
  ASSERT_EQ(bpt({op}).err, "");
  const std::string image = test::bytes_of(path("scene.pfm"));
  const std::string factors = test::bytes_of(path("clay.txt"));
  EXPECT_NE(factors.find("diffuse kd=0.5"), std::string::npos);
  EXPECT_NE(test::bytes_of(path("clay_cdf.txt")), "");
  ASSERT_EQ(bpt({op}).err, "");
  EXPECT_TRUE(test::bytes_of(path("scene.pfm")) == image);
  EXPECT_EQ(test::bytes_of(path("clay.txt")), factors);
  write("clay.txt", "clay\n");
  const Outcome broken = bpt({op});
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_NE(broken.err.find(path("clay.txt") + ":1:"), std::string::npos) << broken.err;
}

TEST_F(Bpt, SaysWhatItsTablesHoldAndWhatASchemeMisses) {
  write("scene.grf", Quad);
  const std::string op = write("scene.op",
                               "BPT_Scene scene.grf\nBPT_Pdf_Name Disk\nBPT_QT_Precomputed 30\n"
                               "BPT_Image_Resolution 8 8\nBPT_Samples 2\nBPT_Pdf_memstat true\n");
  EXPECT_EQ(bpt({op}).err, "");
  std::istringstream lines(test::bytes_of(path("mem.op")));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  EXPECT_EQ(line.rfind("diffuse kd=0.5\tadaptive", 0), 0U) << line;
  EXPECT_GT(std::stoi(line.substr(line.rfind('\t'))), 10000) << line;
  const Outcome narrow = bpt({"render", op, "--pdf", "Sphere"});
  EXPECT_EQ(narrow.exit_code, 0);
  EXPECT_NE(narrow.err.find("the scheme 'sphere' hardly samples part of the BRDF 'diffuse'"),
            std::string::npos)
      << narrow.err;
}

TEST_F(Bpt, AppendsTheSecondsThatItTook) {
  write("scene.grf", Quad);
  const std::string op =
      write("scene.op",
            "BPT_Scene scene.grf\nBPT_Image_Resolution 16 16\nBPT_Samples 8\n"
            "BPT_Output_Image out/image.png\n"
            "BPT_Chrono_Sampling true\nBPT_Chrono_Rendering true\nBPT_Chrono_Prebuild true\n");
  write("out/samplingTime", "1\n");
  ASSERT_EQ(bpt({op}).exit_code, 0);
  ASSERT_EQ(bpt({op}).exit_code, 0);
  for (const auto& [name, lines] :
       {std::pair("samplingTime", 3), {"renderingTime", 2}, {"prebuildTime", 2}}) {
    std::istringstream file(test::bytes_of(path(std::string("out/") + name)));
    int count = 0;
    for (double seconds = 0; file >> seconds; ++count) {
      EXPECT_GT(seconds, 0) << name;
      EXPECT_LT(seconds, 60) << name;
    }
    EXPECT_EQ(count, lines) << name;
  }
}

TEST_F(Bpt, GivesTheSameBytesForTheSameSeed) {
  const std::string scene = write("scene.grf", Quad);
  std::vector<std::string> images;
  for (const char* threads : {"1", "2", "7"}) {
    const std::string output = path(std::string("image") + threads + ".pfm");
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
