// GRF -> glTF -> GRF: the same scene for every scene; and what other programs see of it.
#include <cmath>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "converters/gltf/gltf_check.h"
#include "converters/text_encoding.h"
#include "grf/read.h"
#include "grf/relocate.h"
#include "grf/write.h"
#include "tests/converters/gltf/assimp_count.h"
#include "tests/converters/gltf/gltf_maker.h"
#include "tests/grf/scene_generator.h"

namespace convert {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// The scene as text that is UTF-8 has it: JSON has no other. Nothing if quotes of a name are none then.
std::optional<grf::Scene> in_utf8(const grf::Scene& scene) {
  grf::Diagnostics diagnostics;
  return grf::read_text(to_utf8(grf::to_text(scene)), "scene.grf", diagnostics);
}

std::string write(const grf::Scene& scene, const test::TemporaryFolder& folder, const std::string& name) {
  grf::Diagnostics diagnostics;
  std::string path = folder.path(name);
  EXPECT_TRUE(format_of_name(name)->write(scene, path, diagnostics)) << diagnostics.to_text();
  return path;
}

grf::Scene scene_of_text(const std::string& text) {
  grf::Diagnostics diagnostics;
  auto scene = grf::read_text(text, "scene.grf", diagnostics);
  EXPECT_TRUE(scene.has_value()) << diagnostics.to_text();
  return scene.value_or(grf::Scene());
}

RC_GTEST_PROP(GltfRoundTrip, EveryScene, ()) {
  const auto readable = in_utf8(grf::SceneGenerator(false).scene());
  RC_PRE(readable.has_value());
  const grf::Scene& scene = *readable;
  const test::TemporaryFolder folder;
  for (const char* name : {"a.gltf", "a.glb"}) {
    const Reading again = read_path(write(scene, folder, name));
    RC_ASSERT(again.scene.has_value());
    RC_ASSERT(grf::to_text(*again.scene) == grf::to_text(scene));
    RC_ASSERT(*again.scene == scene);
    RC_ASSERT(!again.diagnostics.has_errors());
  }
}

const std::string Room = R"(
def steel = brdf torrance rough=0.3 nreal=2.485 nimag=3.433 ks=1 kd=0
def clay = brdf oren s=0.4 r=(0.6, 0.4, 0.3)
def mixed = brdf combine 0.5 steel, 0.5 clay
def stool = begin mesh "stool" brdf steel pdf adaptive
  begin vertexs normal (0,0,1) (0,0,0) normal (0,0,1) (1,0,0) normal (0,0,1) (1,1,0) normal (0,0,1) (0,1,0) (0,0,2) end vertexs
  begin faces (0,1,2,3) brdf clay light rgb (5,4,3) (0,1,4) brdf none (1,2,4) end faces end mesh
begin
  // two of them
  transform rotation (0.1,0.2,0.3) scale (1,2,3) translation (4,5,6) begin use stool end
  use stool
  begin mesh "wall" rgb (0.5,2,0.25) brdf mixed texture "wood.png"
  begin vertexs uv (0,0.1) (0,0,0) uv (1,0.3) rgb (2,0,0) (1,0,0) uv (0.7,1) irad (1,2,3) (0.2,0.2,0) uv (0,1) (0,1,0)
   end vertexs begin faces (0,1,2,3) end faces end mesh
  light begin (0,0,3) (1,0,0) (0,-1,0) rgb (10,10,10) end
  mesh light begin rgb (2,0,0) begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs begin faces (0,1,2) end faces end
  params begin dependent view (1,2,3) end
end
)";

TEST(GltfRoundTrip, IncludesStandInTheirPlace) {
  const test::TemporaryFolder folder;
  folder.add("part.grf",
             "begin mesh begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs "
             "begin faces (0,1,2) end faces end mesh");
  const Reading reading = read_path(folder.add("whole.grf", "include \"part.grf\""));
  const Reading again = read_path(write(*reading.scene, folder, "whole.glb"));
  EXPECT_EQ(*again.scene, grf::flatten(*reading.scene, folder.path("whole.grf")));
}

TEST(GltfRoundTrip, OtherProgramsSeeTheSameShapes) {
  const grf::Scene scene = scene_of_text(Room);
  const test::TemporaryFolder folder;
  folder.add("wood.png", "\x89PNG and so on");
  for (const char* name : {"room.gltf", "room.glb"}) {
    const auto counted = assimp_count(write(scene, folder, name));
    ASSERT_TRUE(counted.has_value());
    // As triangles: 2 stools of 4, a wall of 2, a light of 2 and one of 1.
    EXPECT_EQ(counted->faces, 13U);
    ModelCount expected = count_of(scene);
    expected.area += 1;  // the parallelogram, which is no mesh
    EXPECT_NEAR(counted->area, expected.area, 1e-5 * expected.area);
  }
}

json json_of(const std::string& path) { return json::parse(test::bytes_of(path)); }

TEST(GltfRoundTrip, AMeshThatIsUsedTwiceIsWrittenOnce) {
  const test::TemporaryFolder folder;
  const json file = json_of(write(scene_of_text(Room), folder, "room.gltf"));
  EXPECT_EQ(file["meshes"].size(), 4U);
  EXPECT_EQ(file["nodes"][0]["mesh"], 0);
  EXPECT_EQ(file["nodes"][0]["name"], "stool");
  // A turn before the scale cannot stand in one node.
  EXPECT_TRUE(file["nodes"][1].contains("rotation"));
  EXPECT_TRUE(file["nodes"][2].contains("scale"));
  EXPECT_TRUE(file["nodes"][2].contains("translation"));
}

TEST(GltfRoundTrip, MaterialsAreTheNearest) {
  const test::TemporaryFolder folder;
  const json file = json_of(write(scene_of_text(Room), folder, "room.gltf"));
  const json& steel = file["materials"][0];
  EXPECT_EQ(steel["name"], "steel");
  EXPECT_GT(steel["pbrMetallicRoughness"]["metallicFactor"], 0.99);
  EXPECT_NEAR(steel["pbrMetallicRoughness"]["roughnessFactor"].get<double>(), std::sqrt(0.3), 1e-5);
  const json& clay = file["materials"][1];
  EXPECT_EQ(clay["pbrMetallicRoughness"]["metallicFactor"], 0);
  EXPECT_EQ(clay["emissiveFactor"], json({1, 0.8, 0.6}));
  EXPECT_EQ(clay["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 5);
  EXPECT_EQ(file["images"][0]["uri"], "wood.png");
}

TEST(GltfRoundTrip, AChangedFileIsReadAsItIs) {
  const test::TemporaryFolder folder;
  json file = json_of(write(scene_of_text(Room), folder, "room.gltf"));
  file["nodes"].push_back({{"mesh", 0}, {"translation", {50, 0, 0}}});
  file["scenes"][0]["nodes"].push_back(file["nodes"].size() - 1);
  const Reading reading = read_path(folder.add("room.gltf", file.dump()));
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_THAT(reading.text(), HasSubstr("the file was changed since it was made of a GRF scene"));
  EXPECT_EQ(count_of(*reading.scene).faces, 17U);
  EXPECT_EQ(count_of(*reading.scene).bounds.max.x, 51);
}

TEST(GltfRoundTrip, BrdfsStayInAChangedFileUnlessTheirMaterialChanged) {
  const test::TemporaryFolder folder;
  json file = json_of(write(scene_of_text(Room), folder, "room.gltf"));
  file.erase("extras");
  Reading reading = read_path(folder.add("room.gltf", file.dump()));
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_EQ(brdf_text(definitions_of(*reading.scene)[0]),
            "torrance rough=0.3 nreal=2.485 nimag=3.433 ks=1 kd=0");
  EXPECT_EQ(brdf_text(definitions_of(*reading.scene)[1]), "oren s=0.4 r=(0.6, 0.4, 0.3)");
  file["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 0.5, 0.5, 1};
  reading = read_path(folder.add("room.gltf", file.dump()));
  EXPECT_EQ(brdf_text(definitions_of(*reading.scene)[1]), "diffuse kd=0.5");
  EXPECT_THAT(reading.text(), HasSubstr("1 material was changed"));
  EXPECT_THAT(reading.text(), HasSubstr("'clay'"));
}

/// What is read of the room if its extras, which state that nobody changed the file, say otherwise of their
/// meshes.
template <class Change>
Reading with_other_records(const Change& change) {
  const test::TemporaryFolder folder;
  json file = json_of(write(scene_of_text(Room), folder, "room.gltf"));
  change(file["extras"]["grf"]["meshes"]);
  std::string text = file.dump();
  const std::string check = check_of(text, test::bytes_of(folder.path("room.bin")));
  text.replace(text.find(CheckMember) + CheckMember.size(), check.size(), check);
  return read_path(folder.add("room.gltf", text));
}

void expect_gltf_itself(const Reading& reading, const std::string& reason) {
  EXPECT_THAT(reading.text(), HasSubstr("(" + reason + "): the glTF model itself is read"));
  ASSERT_TRUE(reading.scene.has_value()) << reason;
  // As triangles, see above; the GRF scene has 8 faces.
  EXPECT_EQ(count_of(*reading.scene).faces, 13U) << reason;
}

TEST(GltfRoundTrip, ExtrasThatContradictThemselvesArePassedOver) {
  expect_gltf_itself(with_other_records([](json& records) { records.erase(0); }),
                     "the extras have fewer meshes than their scene");
  expect_gltf_itself(with_other_records([](json& records) { records.push_back(records[0]); }),
                     "the extras have more meshes than their scene");
  expect_gltf_itself(with_other_records([](json& records) { records[0]["corners"] = 9999; }),
                     "there is no accessor 9999");
  expect_gltf_itself(with_other_records([](json& records) { records.back().erase("corners"); }),
                     "the lists of faces of a mesh differ in length");
}

TEST(GltfRoundTrip, WithoutExtrasTheShapesRemain) {
  const test::TemporaryFolder folder;
  json file = json_of(write(scene_of_text(Room), folder, "room.gltf"));
  file.erase("extras");
  const Reading reading = read_path(folder.add("room.gltf", file.dump()));
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_EQ(reading.diagnostics.warning_count(), 0U) << reading.text();
  const auto expected = assimp_count(folder.path("room.gltf"));
  EXPECT_EQ(count_of(*reading.scene).faces, expected->faces);
  EXPECT_NEAR(count_of(*reading.scene).area, expected->area, 1e-5 * expected->area);
}

TEST(GltfRoundTrip, ImagesGoIntoAGlbFileAndOut) {
  const test::TemporaryFolder folder;
  const std::string png = "\x89PNG, never decoded";
  folder.add("parts/wood.PNG", png);
  folder.add("wood.png", png + " another");
  const std::string wall =
      "begin mesh texture \"parts/wood.PNG\" begin vertexs uv (0,0) (0,0,0) uv (1,0) (1,0,0) uv (0,1) "
      "(0,1,0) end vertexs "
      "begin faces (0,1,2) texture \"wood.png\" (0,1,2) texture \"missing.png\" (0,1,2) end faces end mesh";
  const std::string path = folder.path("room.glb");
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(find_format("glb")->write(scene_of_text(wall), path, diagnostics));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("1 image cannot be read"));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("'" + folder.path("missing.png") + "'"));
  const Reading again = read_path(path);
  ASSERT_TRUE(again.scene.has_value());
  ASSERT_EQ(again.files.size(), 2U);
  EXPECT_EQ(again.files[0].name, "wood.png");
  EXPECT_EQ(again.files[0].bytes, png);
  EXPECT_EQ(again.files[1].name, "wood_2.png");
  const grf::Mesh mesh = meshes_of(*again.scene)[0];
  EXPECT_EQ(std::get<grf::Texture>(*mesh.surface(0).texture).file, "wood.png");
  EXPECT_EQ(std::get<grf::Texture>(*mesh.surface(1).texture).file, "wood_2.png");
  EXPECT_EQ(std::get<grf::Texture>(*mesh.surface(2).texture).file, "missing.png");
}

TEST(GltfRoundTrip, AFileThatCannotBeWrittenIsLeftAlone) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(find_format("glb")->write(scene_of_text(Room), folder.path("none/room.glb"), diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace convert
