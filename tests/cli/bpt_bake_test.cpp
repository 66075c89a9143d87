// Tests of the command line of `bpt bake`.
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "grf/read.h"
#include "grf/visit.h"
#include "renderer/image/image.h"
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
  // One camera ray per sample and no other rays.
  EXPECT_LT(json::parse(render.out)["rays_per_second"].get<double>(),
            1.001 * json::parse(render.out)["paths_per_second"].get<double>());
}

/// Reads the irradiance at all vertices of a file.
std::vector<grf::Colour> irradiance_in(const std::string& file) {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read(file, diagnostics);
  if (!scene) throw std::runtime_error(diagnostics.to_text());
  std::vector<grf::Colour> values;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement&, const grf::Block&) {
    for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
      values.push_back(std::get<grf::Colour>((*mesh.irradiance)[i]));
    }
  };
  grf::visit(*scene, visitor);
  return values;
}

// A closed furnace whose walls emit 1/2 and reflect 1/2: after eight bounces the irradiance is
// pi (1/2 + 1/4 + ... + 1/256), and a wall's radiance is its own 1/2 plus half of the irradiance over pi.
TEST_F(BptBake, HoldsTheLightOfAClosedBox) {
  const std::string scene = write(
      "box.grf",
      "begin mesh brdf diffuse kd=0.5 light rgb (0.5,0.5,0.5) begin vertexs (-1,-1,-1) (1,-1,-1) (1,1,-1) "
      "(-1,1,-1) (-1,-1,1) (1,-1,1) (1,1,1) (-1,1,1) end vertexs begin faces (0,1,2,3) (4,7,6,5) (0,4,5,1) "
      "(2,6,7,3) (0,3,7,4) (1,5,6,2) end faces end mesh\n");
  ASSERT_EQ(bpt({"bake", scene, "-o", path("box.igrf"), "--samples", "1024", "--depth", "8"}).exit_code, 0);
  const double arriving = 1 - std::pow(0.5, 8);
  const std::vector<grf::Colour> values = irradiance_in(path("box.igrf"));
  ASSERT_EQ(values.size(), 8U);
  for (const grf::Colour& value : values) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(value[k] / std::numbers::pi, arriving, 0.03);
  }
  write("box.op",
        "BPT_Scene box.igrf\nBPT_Viewer 0 0 0.5\nBPT_VLook 0 0 0\nBPT_Irradiance true\nBPT_Samples 2\n"
        "BPT_Image_Resolution 8 8\n");
  ASSERT_EQ(bpt({"render", path("box.op"), "--output", path("box.pfm")}).exit_code, 0);
  grf::Diagnostics diagnostics;
  const auto image = image::read_image(path("box.pfm"), diagnostics);
  ASSERT_TRUE(image) << diagnostics.to_text();
  for (const auto& pixel : image->pixels) EXPECT_NEAR(pixel.x, 0.5 + 0.5 * arriving, 0.02);
}

TEST_F(BptBake, TakesOptionsOfAnOpFile) {
  write("scene.grf", Quad);
  const std::string op = write("scene.op", "BPT_Scene scene.grf\nBPT_Samples 32\nBPT_Viewer 1 2 3\n");
  const Outcome outcome = bpt({"bake", op, "-o", path("a.igrf"), "--directions", "3", "--progress", "none"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("irradiance at 4 vertices, 32 samples per vertex"), std::string::npos)
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
            "use tile transform translation (0,0,1) begin use tile end end\n"
            "light begin rgb (5,5,5) (0,0,3) (0,1,0) (1,0,0) end\n");
  const Outcome outcome = bpt({"bake", scene, "-o", path("a.igrf"), "--samples", "4"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("1 mesh is placed by 'use' more than once"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("2 vertices have no irradiance"), std::string::npos) << outcome.err;
  EXPECT_NE(test::bytes_of(path("a.igrf")).find("use tile$2"), std::string::npos);
}

// 100 instances of 60,000 vertices each.
TEST_F(BptBake, RefusesToWriteHugeCopies) {
  std::string text = "def tile = begin mesh brdf diffuse begin vertexs\n";
  for (int i = 0; i < 60'000; ++i) text += fmt::format("({},{},0)\n", i % 300, i / 300);
  text += "end vertexs begin faces (0,1,301) end faces end mesh begin\n";
  for (int i = 0; i < 100; ++i) text += "use tile\n";
  const Outcome outcome = bpt({"bake", write("scene.grf", text + "end\n"), "-o", path("a.igrf")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("copies with 5940000 vertices would be written, more than 5000000: 'use' "
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
  // On a busy machine it may take longer until there is something to write.
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
