// `bpt bake` as its users meet it.
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/bpt.h"
#include "tests/support/paths.h"

namespace {

using nlohmann::json;
using test::Bpt;
using test::Outcome;
using test::Quad;

class BptBake : public Bpt {};

TEST_F(BptBake, WritesAnIgrfFileThatRenders) {
  std::filesystem::create_directory(path("parts"));
  write("parts/quad.grf", Quad);
  const std::string scene = write("scene.grf", "include \"parts/quad.grf\"\n");
  std::filesystem::create_directory(path("out"));
  const std::string output = path("out/scene.igrf");
  const Outcome outcome = bpt({"bake", scene, "-o", output, "--samples", "64", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const json summary = json::parse(outcome.out);
  EXPECT_EQ(summary["output"], output);
  EXPECT_EQ(summary["vertices"], 4);
  EXPECT_EQ(summary["samples"], 64);
  EXPECT_GT(summary["render_seconds"].get<double>(), 0);
  EXPECT_LT(summary["estimated_error"].get<double>(), 0.1);
  EXPECT_EQ(test::bytes_of(output).find("include"), std::string::npos);

  const Outcome render = bpt({"render", output, "--irradiance", "--samples", "2", "--size", "16x16",
                              "--output", path("image.pfm"), "--json"});
  ASSERT_EQ(render.exit_code, 0) << render.err;
  EXPECT_EQ(render.err, "") << "a baked scene is without a complaint";
  // A camera ray a sample and no more.
  EXPECT_LT(json::parse(render.out)["rays_per_second"].get<double>(),
            1.001 * json::parse(render.out)["paths_per_second"].get<double>());
}

TEST_F(BptBake, TakesOptionsOfAnOpFile) {
  write("scene.grf", Quad);
  const std::string op = write("scene.op", "BPT_Scene scene.grf\nBPT_Samples 32\nBPT_Viewer 1 2 3\n");
  const Outcome outcome = bpt({"bake", op, "-o", path("a.igrf"), "--directions", "3", "--progress", "none"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("irradiance at 4 vertices, 32 samples a vertex"), std::string::npos)
      << outcome.out;
  const std::string text = test::bytes_of(path("a.igrf"));
  EXPECT_NE(text.find("begin list ray"), std::string::npos);
  EXPECT_NE(text.find("dependent view (1, 2, 3)"), std::string::npos);
}

TEST_F(BptBake, WarnsOfMeshesInManyPlaces) {
  const std::string scene =
      write("scene.grf",
            "def tile = begin mesh brdf diffuse begin vertexs (0,0,0) (1,0,0) (0,1,0) (5,5,5) end vertexs\n"
            "begin faces (0,1,2) end faces end mesh begin\n"
            "use tile transform translation (0,0,1) begin use tile end end\n");
  const Outcome outcome = bpt({"bake", scene, "-o", path("a.igrf"), "--samples", "4"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("1 meshes are placed by 'use' more than once"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("2 vertices have no irradiance"), std::string::npos) << outcome.err;
  EXPECT_NE(test::bytes_of(path("a.igrf")).find("use tile$2"), std::string::npos);
}

// 100 places of 60,000 vertices each.
TEST_F(BptBake, RefusesToWriteHugeCopies) {
  std::string text = "def tile = begin mesh brdf diffuse begin vertexs\n";
  for (int i = 0; i < 60'000; ++i) text += fmt::format("({},{},0)\n", i % 300, i / 300);
  text += "end vertexs begin faces (0,1,301) end faces end mesh begin\n";
  for (int i = 0; i < 100; ++i) text += "use tile\n";
  const Outcome outcome = bpt({"bake", write("scene.grf", text + "end\n"), "-o", path("a.igrf")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("copies with 5940000 vertices would be written out, more than 5000000: 'use' "
                             "'tile', which is placed 100 times, less often"),
            std::string::npos)
      << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(path("a.igrf")));
}

TEST_F(BptBake, SaysWhatIsWrong) {
  const std::string scene = write("scene.grf", Quad);
  const Outcome name = bpt({"bake", scene, "-o", path("a.grf")});
  EXPECT_EQ(name.exit_code, 1);
  EXPECT_NE(name.err.find("expected the name of an IGRF file"), std::string::npos) << name.err;
  EXPECT_EQ(bpt({"bake", scene}).exit_code, 2);
  EXPECT_EQ(bpt({"bake", scene, "-o", path("a.igrf"), "--directions", "0"}).exit_code, 2);
  EXPECT_EQ(bpt({"bake", path("none.grf"), "-o", path("a.igrf")}).exit_code, 1);
  const std::string light = write("light.grf", "light begin (0,0,1) (0,1,0) (1,0,0) end\n");
  const Outcome lights = bpt({"bake", light, "-o", path("a.igrf")});
  EXPECT_EQ(lights.exit_code, 1);
  EXPECT_NE(lights.err.find("the scene has no mesh"), std::string::npos) << lights.err;
  EXPECT_FALSE(std::filesystem::exists(path("a.igrf")));
}

TEST_F(BptBake, ResumesAnInterruptedOneToTheSameBytes) {
  const std::string scene = write("scene.grf", Quad);
  const auto bake = [&](const std::string& output, std::vector<std::string> more,
                        const std::vector<test::Interruption>& interruptions = {}) {
    more.insert(more.begin(), {GRANADA_BIN_DIR "/bpt", "bake", scene, "-o", path(output), "--samples",
                               "2000000", "--json"});
    return test::run(more, {}, interruptions);
  };
  ASSERT_EQ(bake("whole.igrf", {}).exit_code, 0);
  // On a busy machine it may take longer until there is something to keep.
  Outcome part;
  for (int wait = 150; wait < 5000 && !std::filesystem::exists(path("part.igrf")); wait *= 2) {
    part = bake("part.igrf", {"--checkpoint", path("state")}, {{SIGINT, std::chrono::milliseconds(wait)}});
  }
  ASSERT_EQ(part.exit_code, 130) << part.err << part.out;
  EXPECT_TRUE(std::filesystem::exists(path("part.igrf")));
  EXPECT_LT(json::parse(part.out)["samples"].get<double>(), 2'000'000);
  ASSERT_EQ(bake("part.igrf", {"--checkpoint", path("state")}).exit_code, 0);
  EXPECT_TRUE(test::bytes_of(path("part.igrf")) == test::bytes_of(path("whole.igrf")));
}

}  // namespace
