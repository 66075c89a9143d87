#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <ImathBox.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "tests/benchmarks/render/outdoor_map.h"
#include "tests/benchmarks/render/report.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/sanitizers.h"
#include "tests/support/temporary_folder.h"

namespace {

using benchmark::Measurement;
using benchmark::to_csv;
using benchmark::to_json;
using benchmark::to_markdown;
using image::Image;
namespace fs = std::filesystem;

/// What a scene places, with what its included files place.
struct Contents {
  int lamps = 0;
  int instances = 0;  ///< of meshes that are defined by name
  std::set<std::string> textures;
  std::vector<grf::BrdfModel> brdfs;  ///< of faces, distinct
  Imath::Box2f uv;
  int mirrored = 0;  ///< faces whose texture is mirrored

  void add(const grf::BlockList& list) {
    for (const grf::Block& block : list.blocks) {
      std::visit([&](const auto& content) { add(content); }, block.content);
    }
  }

  std::map<std::string, int> keywords() const {
    std::map<std::string, int> counts;
    for (const grf::BrdfModel& brdf : brdfs) ++counts[brdf.keyword];
    return counts;
  }

 private:
  void add(const grf::AreaLight& /*light*/) { ++lamps; }
  void add(const grf::MeshLight& /*light*/) {}
  void add(const grf::Params& /*params*/) {}
  void add(const grf::Use& /*use*/) { ++instances; }
  void add(const grf::Include& include) { add(*include.contents); }
  void add(const grf::Transform& transform) { add(transform.body); }
  void add(const grf::DefinitionScope& scope) {
    const auto outer = definitions_;
    for (const grf::Definition& definition : scope.definitions) {
      if (const auto* brdf = std::get_if<grf::BrdfModel>(&definition.body))
        definitions_[definition.name] = *brdf;
    }
    add(scope.body);
    definitions_ = outer;
  }
  void add(const grf::Shared<grf::Mesh>& mesh) {
    for (const grf::Surface& surface : mesh->surfaces) {
      if (surface.texture) textures.insert(std::get<grf::Texture>(*surface.texture).file);
      if (surface.brdf) add(definitions_.at(std::get<grf::Reference>(*surface.brdf).name));
    }
    for (std::size_t face = 0; face < mesh->face_count(); ++face) add_uv(*mesh, mesh->face(face));
  }
  void add(const grf::BrdfModel& brdf) {
    if (std::find(brdfs.begin(), brdfs.end(), brdf) == brdfs.end()) brdfs.push_back(brdf);
  }
  void add_uv(const grf::Mesh& mesh, std::span<const std::uint32_t> corners) {
    std::vector<Imath::V2f> uvs;
    for (const std::uint32_t corner : corners) {
      if (mesh.geometry->uvs.has(corner)) uvs.push_back(mesh.geometry->uvs[corner]);
    }
    if (uvs.size() < 3) return;
    for (const Imath::V2f& at : uvs) uv.extendBy(at);
    if ((uvs[1] - uvs[0]).cross(uvs[2] - uvs[0]) < 0) ++mirrored;
  }

  std::map<std::string, grf::BrdfModel> definitions_;
};

/// The contents of the benchmark's scenes with small meshes, by name.
std::map<std::string, Contents> contents_of_scenes() {
  const test::TemporaryFolder folder;
  std::map<std::string, Contents> contents;
  for (const benchmark::SceneFiles& scene : benchmark::make_scenes(folder.path("scenes"), true)) {
    grf::Diagnostics diagnostics;
    const auto read = grf::read(fs::path(scene.op).replace_extension(".grf"), diagnostics);
    EXPECT_TRUE(read && diagnostics.to_text().empty()) << diagnostics.to_text();
    if (read) contents[scene.name].add(read->contents);
  }
  return contents;
}

/// Expects the recorded rays to be those that bpt counts; a path that hits the triangle it leaves queries
/// twice.
void expect_all_rays(const nlohmann::json& row) {
  const nlohmann::json& rays = row.at("rays");
  const double camera = rays.at("camera").at("rays");
  const double recorded =
      camera + rays.at("shadow").at("rays").get<double>() + rays.at("bounce").at("rays").get<double>();
  EXPECT_EQ(camera, 24 * 24 * 2);
  EXPECT_GT(rays.at("shadow").at("rays"), 100);
  EXPECT_GT(rays.at("bounce").at("rays"), 100);
  EXPECT_NEAR(recorded, rays.at("counted").get<double>(), 1e-3 * recorded);
  for (const char* kind : {"camera", "shadow", "bounce"}) {
    EXPECT_GT(rays.at(kind).at("embree_per_second").get<double>(), 1e4) << kind;
  }
}

TEST(RenderBenchmark, MeasuresAllScenes) {
  const test::TemporaryFolder folder;
  std::vector<std::string> command = {GRANADA_BIN_DIR "/render_benchmark", "--quick", "--folder",
                                      folder.path("run")};
  // A library that is preloaded before the sanitizers' own prevents them from starting.
  if (test::HasSanitizers) command.emplace_back("--without-embree-share");
  const test::Outcome outcome = test::run(command);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::ifstream file(folder.path("run/results.json"));
  const auto rows = nlohmann::json::parse(file);
  ASSERT_EQ(rows.size(), 10U);
  for (const auto& row : rows) {
    SCOPED_TRACE(row.dump());
    for (const char* name : {"paths_per_second", "rays_per_second", "relmse", "peak_memory_bytes"}) {
      EXPECT_GT(row.at(name).get<double>(), 0) << name;
    }
    for (const auto& channel : row.at("mean")) EXPECT_GT(channel.get<double>(), 0.003);
    const double efficiency = row.at("efficiency");
    const double product = row.at("relmse").get<double>() * row.at("render_seconds").get<double>();
    EXPECT_NEAR(efficiency * product, 1, 1e-9);
    if (test::HasSanitizers) continue;
    // Copies of the trees of `instances` would be 1.6 million triangles, of more than 100 bytes with
    // Embree's.
    EXPECT_LT(row.at("peak_memory_bytes").get<double>(), 130e6);
    EXPECT_GT(row.at("embree_share").get<double>(), 0.01);
    EXPECT_LT(row.at("embree_share").get<double>(), 0.99);
    expect_all_rays(row);
  }
}

TEST(RenderBenchmark, HasWhatTheNamesOfScenesSay) {
  std::map<std::string, Contents> contents = contents_of_scenes();
  EXPECT_EQ(contents.at("many_lamps_100").lamps, 100);
  EXPECT_EQ(contents.at("many_lamps_400").lamps, 400);
  EXPECT_EQ(contents.at("instances").instances, 10'000);

  const Contents& brdfs = contents.at("many_brdfs");
  EXPECT_EQ(brdfs.brdfs.size(), 20U);
  const auto keywords = brdfs.keywords();
  EXPECT_EQ(keywords.at("he"), 2);
  EXPECT_EQ(keywords.at("westin"), 1);
  EXPECT_EQ(keywords.at("combine"), 2);
  EXPECT_EQ(keywords.at("measured"), 1);

  const Contents& textured = contents.at("textured");
  EXPECT_EQ(textured.textures.size(), 50U);
  EXPECT_LT(textured.uv.min.x, -2);
  EXPECT_LT(textured.uv.min.y, -1);
  EXPECT_GT(textured.uv.max.x, 2);
  EXPECT_GT(textured.uv.max.y, 1);
  EXPECT_GT(textured.mirrored, 500);

  EXPECT_EQ(contents.at("interior").lamps, 0);
}

TEST(RenderBenchmark, SaysWhichSceneItDoesNotHave) {
  const test::TemporaryFolder folder;
  const auto outcome = test::run(
      {GRANADA_BIN_DIR "/render_benchmark", "--quick", "--folder", folder.path("run"), "--scenes", "teapot"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "error: unknown scene 'teapot'\n");
}

TEST(OutdoorMap, HasASunThatIsMostOfItsLight) {
  const Image map = benchmark::outdoor_map();
  float brightest = 0;
  for (const auto& pixel : map.pixels) brightest = std::max(brightest, pixel.x);
  EXPECT_EQ(map.pixels.size(), 1024U * 512);
  EXPECT_EQ(brightest, 9000);
  // Half a degree in radius covers a fraction of 1.9e-5 of the sphere, here stretched by 1/sin(theta).
  const auto suns = std::count_if(map.pixels.begin(), map.pixels.end(),
                                  [&](const auto& pixel) { return pixel.x == brightest; });
  EXPECT_NEAR(static_cast<double>(suns), 9.8, 4);
}

TEST(Report, ComparesWithCyclesSceneByScene) {
  Measurement ours;
  ours.scene = "box";
  ours.seconds = 2;
  ours.relmse = 0.01;
  ours.paths_per_second = 3e6;
  ours.mean = grf::Colour(1, 1, 1);
  Measurement theirs = ours;
  theirs.renderer = benchmark::Renderer::Cycles;
  theirs.seconds = 4;
  theirs.relmse = 0.03;
  theirs.paths_per_second = 1.5e6;
  theirs.mean = grf::Colour(1, 1.25F, 1);
  const std::vector<Measurement> alone = {ours};
  Measurement unpaired = ours;
  unpaired.scene = "hall";
  const std::string both = to_markdown({ours, theirs, unpaired});
  EXPECT_NE(both.find("| box | 6.00 | 2.00 | 3.00 | 20.0 |\n"), std::string::npos) << both;
  EXPECT_NE(both.find("| hall | not in Cycles | | | |\n"), std::string::npos) << both;
  EXPECT_EQ(to_markdown(alone).find("Ratios of bpt to Cycles"), std::string::npos);
  EXPECT_NE(to_csv(alone).find("box,bpt,3e+06,,,2,0.01,50,0,0,,,,,,\n"), std::string::npos) << to_csv(alone);
  EXPECT_TRUE(to_json(alone)[0].at("embree_share").is_null());
  EXPECT_TRUE(to_json(alone)[0].at("rays").is_null());
  EXPECT_EQ(to_markdown(alone).find("Embree only"), std::string::npos);
}

TEST(Report, ComparesRaysOfEachKindWithEmbree) {
  Measurement measured;
  measured.scene = "box";
  measured.seconds = 2;
  measured.ray_kinds = {{"camera", 2e6, 10e6}, {"shadow", 8e6, 4e6}, {"bounce", 6e6, 2e6}};
  measured.counted_rays = 16e6;
  // Embree takes 0.2, 2 and 3 s: 16 million rays in 5.2 s, of which bpt needs only 2 as a test of the
  // arithmetic.
  const std::string text = to_markdown({measured});
  const std::string row = "| box | 1.00 | 4.00 | 3.00 | 8.00 | 10.00 | 4.00 | 2.00 | 3.08 | 260 |\n";
  EXPECT_NE(text.find(row), std::string::npos) << text;
  EXPECT_NE(to_csv({measured}).find(",1000000,4000000,3000000,10000000,4000000,2000000\n"),
            std::string::npos);
  EXPECT_EQ(to_json({measured})[0].at("rays").at("shadow").at("per_second"), 4e6);
}

}  // namespace
