// Tests of the glTF reader on geometry, nodes and skins.
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/visit.h"
#include "tests/converters/gltf/gltf_maker.h"

namespace convert {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::vector<float> Square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

std::vector<std::uint32_t> corners_of(const grf::Mesh& mesh) { return mesh.geometry->corners; }

/// All positions of faces in the world, in order.
std::vector<grf::Vec3d> world_corners(const grf::Scene& scene) {
  std::vector<grf::Vec3d> corners;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    for (const std::uint32_t corner : mesh.geometry->corners) {
      grf::Vec3d moved;
      placement.to_world.multVecMatrix(grf::Vec3d(mesh.geometry->positions[corner]), moved);
      corners.push_back(moved);
    }
  };
  grf::visit(scene, visitor);
  return corners;
}

void expect_near(const grf::Vec3d& a, const grf::Vec3d& b) {
  EXPECT_LE((a - b).length(), 1e-6) << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y
                                    << ' ' << b.z;
}

std::vector<std::uint32_t> read_mode(int mode, const std::vector<std::uint16_t>& indices) {
  GltfMaker maker;
  const int positions = maker.floats(Square, "VEC3");
  maker.add_mesh(
      {{"attributes", {{"POSITION", positions}}}, {"mode", mode}, {"indices", maker.indices(indices)}});
  return corners_of(only_mesh(maker.read()));
}

TEST(Gltf, TrianglesStripsAndFansAreFaces) {
  using Corners = std::vector<std::uint32_t>;
  EXPECT_EQ(read_mode(4, {0, 1, 2, 0, 2, 3}), (Corners{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(read_mode(5, {0, 1, 3, 2}), (Corners{0, 1, 3, 1, 2, 3}));
  EXPECT_EQ(read_mode(6, {0, 1, 2, 3}), (Corners{1, 2, 0, 2, 3, 0}));
}

TEST(Gltf, FacesWithoutIndicesTakeVerticesInOrder) {
  const grf::Mesh mesh = only_mesh(GltfMaker::triangle().read());
  EXPECT_EQ(mesh.geometry->corners, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(mesh.geometry->positions[1], grf::Vec3f(1, 0, 0));
  EXPECT_TRUE(mesh.geometry->normals.empty());
}

TEST(Gltf, PointsAndLinesAreCountedAsLost) {
  GltfMaker maker = GltfMaker::triangle();
  const int positions = maker.floats(Square, "VEC3");
  for (int mode = 0; mode < 4; ++mode) {
    maker.add_mesh({{"attributes", {{"POSITION", positions}}}, {"mode", mode}});
  }
  const Reading reading = maker.read();
  EXPECT_EQ(only_mesh(reading).face_count(), 1U);
  EXPECT_THAT(reading.text(), HasSubstr("9 lines were left out"));
  EXPECT_THAT(reading.text(), HasSubstr("4 points were left out"));
}

TEST(Gltf, VerticesThatNoFaceUsesAreLeftOut) {
  GltfMaker maker;
  const int positions = maker.floats(Square, "VEC3");
  maker.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", maker.indices({1, 2, 3})}});
  const grf::Mesh mesh = only_mesh(maker.read());
  EXPECT_EQ(mesh.geometry->positions.size(), 3U);
  EXPECT_EQ(mesh.geometry->positions[0], grf::Vec3f(1, 0, 0));
}

TEST(Gltf, PrimitivesShareTheVerticesThatTheyBothName) {
  GltfMaker maker;
  const int positions = maker.floats(Square, "VEC3");
  maker.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", maker.indices({0, 1, 2})}});
  maker.json["meshes"][0]["primitives"].push_back(
      {{"attributes", {{"POSITION", positions}}}, {"indices", maker.indices({0, 2, 3})}});
  const grf::Mesh mesh = only_mesh(maker.read());
  EXPECT_EQ(mesh.geometry->positions.size(), 4U);
  EXPECT_EQ(mesh.geometry->corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
}

TEST(Gltf, StridesAndOffsetsAreKept) {
  GltfMaker maker;
  const int interleaved = maker.floats({9, 9, 0, 0, 0, 9, 9, 1, 0, 0, 9, 9, 0, 1, 0}, "SCALAR");
  maker.json["bufferViews"][0]["byteStride"] = 20;
  maker.json["accessors"][0].update({{"byteOffset", 8}, {"count", 3}, {"type", "VEC3"}});
  maker.add_mesh({{"attributes", {{"POSITION", interleaved}}}});
  EXPECT_EQ(only_mesh(maker.read()).geometry->positions[2], grf::Vec3f(0, 1, 0));
}

TEST(Gltf, SparseValuesStandInForSome) {
  GltfMaker maker = GltfMaker::triangle();
  const int places = maker.add<std::uint8_t>({2}, "SCALAR", 5121);
  const int values = maker.floats({5, 6, 7}, "VEC3");
  maker.json["accessors"][0]["sparse"] = {{"count", 1},
                                          {"indices", {{"bufferView", places}, {"componentType", 5121}}},
                                          {"values", {{"bufferView", values}}}};
  EXPECT_EQ(only_mesh(maker.read()).geometry->positions[2], grf::Vec3f(5, 6, 7));
  maker.json["accessors"][0].erase("bufferView");  // the others are 0
  EXPECT_EQ(only_mesh(maker.read()).geometry->positions[1], grf::Vec3f(0, 0, 0));
}

TEST(Gltf, IntegersAreNumbersAndNormalisedOnesAreShares) {
  GltfMaker maker;
  const int positions = maker.add<std::int16_t>({0, 0, 0, 2, 0, 0, 0, -3, 0}, "VEC3", 5122);
  const int colours =
      maker.add<std::uint8_t>({255, 0, 51, 0, 0, 0, 0, 0, 0}, "VEC3", 5121, {{"normalized", true}});
  const int normals =
      maker.add<std::int8_t>({0, 0, -128, 0, 0, 127, 0, 0, 127}, "VEC3", 5120, {{"normalized", true}});
  maker.add_mesh({{"attributes", {{"POSITION", positions}, {"COLOR_0", colours}, {"NORMAL", normals}}}});
  maker.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const grf::Mesh mesh = only_mesh(maker.read());
  EXPECT_EQ(mesh.geometry->positions[2], grf::Vec3f(0, -3, 0));
  EXPECT_EQ(mesh.geometry->colours[0], grf::Colour(1, 0, 0.2F));
  EXPECT_EQ(mesh.geometry->normals[0], grf::Vec3f(0, 0, -1));
}

TEST(Gltf, TextureCoordinatesPointUp) {
  GltfMaker maker = GltfMaker::triangle();
  maker.attributes()["TEXCOORD_0"] = maker.floats({0, 0, 1, 0, 0.25F, 0.75F}, "VEC2");
  const grf::Mesh mesh = only_mesh(maker.read());
  EXPECT_EQ(mesh.geometry->uvs[0], grf::Vec2f(0, 1));
  EXPECT_EQ(mesh.geometry->uvs[2], grf::Vec2f(0.25F, 0.25F));
}

TEST(Gltf, TextureTransformsAreApplied) {
  GltfMaker maker = GltfMaker::triangle();
  maker.attributes()["TEXCOORD_0"] = maker.floats({9, 9, 9, 9, 9, 9}, "VEC2");
  maker.attributes()["TEXCOORD_1"] = maker.floats({0, 0, 1, 0, 0, 1}, "VEC2");
  maker.primitive()["material"] = 0;
  const json transform = {
      {"offset", {0.5, 0.25}}, {"scale", {2, 3}}, {"rotation", std::numbers::pi / 2}, {"texCoord", 1}};
  maker.json["materials"] = {
      {{"pbrMetallicRoughness",
        {{"baseColorTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}}}}};
  maker.json["textures"] = {{{"source", 0}}};
  maker.json["images"] = {{{"uri", "a.png"}}};
  const Reading reading = maker.read();
  const grf::Mesh mesh = only_mesh(reading);
  // The matrix of the extension: (x, y) -> offset + (cos sx x + sin sy y, cos sy y - sin sx x).
  const auto expect_uv = [&](std::size_t vertex, float u, float v) {
    EXPECT_NEAR(mesh.geometry->uvs[vertex].x, u, 1e-6);
    EXPECT_NEAR(mesh.geometry->uvs[vertex].y, 1 - v, 1e-6);
  };
  expect_uv(0, 0.5F, 0.25F);
  expect_uv(1, 0.5F, -1.75F);
  expect_uv(2, 3.5F, 0.25F);
  EXPECT_THAT(reading.text(), HasSubstr("1 face lost its additional sets of texture coordinates"));
}

TEST(Gltf, MorphTargetsStandAtTheirWeights) {
  GltfMaker maker = GltfMaker::triangle();
  const int target = maker.floats({0, 0, 1, 0, 0, 2, 0, 0, 4}, "VEC3");
  maker.primitive()["targets"] = {{{"POSITION", target}}};
  EXPECT_EQ(only_mesh(maker.read()).geometry->positions[2], grf::Vec3f(0, 1, 0));
  maker.json["meshes"][0]["weights"] = {0.5};
  EXPECT_EQ(only_mesh(maker.read()).geometry->positions[2], grf::Vec3f(0, 1, 2));
  maker.json["nodes"][0]["weights"] = {0.25};
  EXPECT_EQ(only_mesh(maker.read()).geometry->positions[2], grf::Vec3f(0, 1, 1));
}

TEST(Gltf, MorphTargetsThatLeadToInfinityAreAnError) {
  GltfMaker maker = GltfMaker::triangle();
  const int target = maker.floats({0, 0, 3e38F, 0, 0, 0, 0, 0, 0}, "VEC3");
  maker.primitive()["targets"] = {{{"POSITION", target}}};
  maker.json["meshes"][0]["weights"] = {1};
  EXPECT_TRUE(maker.read().scene);
  maker.json["meshes"][0]["weights"] = {2};
  const Reading reading = maker.read();
  EXPECT_FALSE(reading.scene);
  EXPECT_THAT(reading.text(), HasSubstr("make values that are infinite"));
}

TEST(Gltf, ANodeHasAMatrixOrThreeSteps) {
  const double half = std::sqrt(0.5);
  const Reading steps =
      GltfMaker::triangle(
          {{"translation", {1, 2, 3}}, {"rotation", {0, 0, half, half}}, {"scale", {2, 1, 1}}})
          .read();
  ASSERT_TRUE(steps.scene);
  expect_near(world_corners(*steps.scene)[1], {1, 4, 3});
  expect_near(world_corners(*steps.scene)[2], {0, 2, 3});
  const Reading matrix =
      GltfMaker::triangle({{"matrix", {0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1}}}).read();
  ASSERT_TRUE(matrix.scene);
  expect_near(world_corners(*matrix.scene)[1], {1, 4, 3});
}

TEST(Gltf, NodesStandInNodes) {
  GltfMaker maker = GltfMaker::triangle({{"translation", {1, 0, 0}}});
  maker.json["nodes"].push_back({{"children", {0}}, {"scale", {2, 2, 2}}});
  maker.json["scenes"][0]["nodes"] = {1};
  const Reading reading = maker.read();
  ASSERT_TRUE(reading.scene);
  expect_near(world_corners(*reading.scene)[1], {4, 0, 0});
}

TEST(Gltf, AMeshOfSeveralNodesIsDefinedOnce) {
  GltfMaker maker = GltfMaker::triangle({{"translation", {1, 0, 0}}});
  maker.json["meshes"][0]["name"] = "a leaf";
  maker.add_root({{"mesh", 0}, {"translation", {0, 5, 0}}});
  const Reading reading = maker.read();
  ASSERT_TRUE(reading.scene);
  const auto definitions = definitions_of(*reading.scene);
  ASSERT_EQ(definitions.size(), 1U);
  EXPECT_EQ(definitions[0].name, "a$20$leaf");
  const auto corners = world_corners(*reading.scene);
  ASSERT_EQ(corners.size(), 6U);
  expect_near(corners[0], {1, 0, 0});
  expect_near(corners[3], {0, 5, 0});
}

TEST(Gltf, AFlatNodeIsLeftOut) {
  GltfMaker maker = GltfMaker::triangle({{"scale", {1, 0, 1}}});
  maker.add_root({{"mesh", 0}});
  const Reading reading = maker.read();
  ASSERT_TRUE(reading.scene) << reading.text();
  EXPECT_EQ(world_corners(*reading.scene).size(), 3U);
  EXPECT_THAT(reading.text(), HasSubstr("1 mesh was left out: its transform is singular"));
}

TEST(Gltf, SkinnedMeshesStandWhereTheirJointsAre) {
  GltfMaker maker = GltfMaker::triangle({{"skin", 0}, {"translation", {100, 0, 0}}});
  maker.attributes()["JOINTS_0"] =
      maker.add<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 5121);
  maker.attributes()["WEIGHTS_0"] = maker.floats({1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0}, "VEC4");
  const std::vector<float> matrices = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,
                                       1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1};
  maker.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", maker.floats(matrices, "MAT4")}}};
  maker.json["nodes"].push_back({{"translation", {0, 10, 0}}});
  maker.json["nodes"].push_back({{"translation", {0, 0, 20}}});
  maker.json["scenes"][0]["nodes"] = {0, 1, 2};
  const Reading reading = maker.read();
  ASSERT_TRUE(reading.scene) << reading.text();
  const auto corners = world_corners(*reading.scene);
  expect_near(corners[0], {0, 10, 0});
  expect_near(corners[1], {0, 0, 20});     // (1,0,0) - (1,0,0) + (0,0,20)
  expect_near(corners[2], {-0.5, 6, 10});  // half of (0,11,0), half of (-1,1,20)
}

TEST(Gltf, ASkinMayHaveNoMatrices) {
  GltfMaker maker = GltfMaker::triangle({{"skin", 0}});
  maker.attributes()["JOINTS_0"] = maker.add<std::uint8_t>(std::vector<std::uint8_t>(12), "VEC4", 5121);
  maker.attributes()["WEIGHTS_0"] = maker.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  maker.json["skins"] = {{{"joints", {1}}}};
  maker.add_root({{"translation", {0, 0, 7}}});
  const Reading reading = maker.read();
  ASSERT_TRUE(reading.scene) << reading.text();
  expect_near(world_corners(*reading.scene)[0], {0, 0, 7});
}

/// The directions of the triangle's normals, and what they are read as.
std::vector<grf::Vec3d> normals_of(const GltfMaker& maker) {
  const Reading reading = maker.read();
  const grf::Mesh mesh = only_mesh(reading);
  std::vector<grf::Vec3d> normals;
  for (const std::uint32_t corner : mesh.geometry->corners) {
    EXPECT_TRUE(mesh.geometry->normals.has(corner));
    normals.push_back(grf::Vec3d(mesh.geometry->normals[corner]).normalized());
  }
  return normals;
}

grf::Vec3d along(double x, double y, double z) { return grf::Vec3d(x, y, z).normalized(); }

TEST(Gltf, NormalsOfMorphTargetsStandAtTheirWeights) {
  GltfMaker maker = GltfMaker::triangle();
  maker.attributes()["NORMAL"] = maker.floats({0, 0, 1, 0, 0, 1, 0, 1, 0}, "VEC3");
  const int target = maker.floats({2, 0, 0, 0, 4, 0, 0, -2, 2}, "VEC3");
  const int other = maker.floats({0, 2, 0, 0, 0, 0, 0, 0, 0}, "VEC3");
  maker.primitive()["targets"] = {{{"NORMAL", target}}, {{"NORMAL", other}}};
  maker.json["meshes"][0]["weights"] = {0.5, 1};
  const auto normals = normals_of(maker);
  expect_near(normals.at(0), along(1, 2, 1));
  expect_near(normals.at(1), along(0, 2, 1));
  expect_near(normals.at(2), along(0, 0, 1));
}

/// The triangle that follows two joints: one that stretches along x, and one that turns by a quarter about z.
GltfMaker skinned_triangle(const std::vector<float>& weights) {
  GltfMaker maker = GltfMaker::triangle({{"skin", 0}, {"scale", {1, 7, 1}}});
  maker.attributes()["JOINTS_0"] =
      maker.add<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4", 5121);
  maker.attributes()["WEIGHTS_0"] = maker.floats(weights, "VEC4");
  maker.attributes()["NORMAL"] = maker.floats({0.6F, 0.8F, 0, 0.6F, 0.8F, 0, 0, 1, 0}, "VEC3");
  maker.json["skins"] = {{{"joints", {1, 2}}}};
  const double half = std::sqrt(0.5);
  maker.json["nodes"].push_back({{"scale", {2, 1, 1}}});
  maker.json["nodes"].push_back({{"rotation", {0, 0, half, half}}, {"translation", {5, 6, 7}}});
  maker.json["scenes"][0]["nodes"] = {0, 1, 2};
  return maker;
}

// A normal is at right angles to what the joint makes of the tangents: of (0.8, -0.6, 0) and z, of which the
// first joint makes (1.6, -0.6, 0) and the second one (0.6, 0.8, 0). Half of both, the third normal's tangent
// x becomes (1, 0.5, 0).
TEST(Gltf, NormalsFollowTheJointsOfTheirMesh) {
  const auto normals = normals_of(skinned_triangle({1, 0, 0, 0, 0, 0.5F, 0, 0, 0.5F, 0.5F, 0, 0}));
  expect_near(normals.at(0), along(0.6, 1.6, 0));
  expect_near(normals.at(1), along(-0.8, 0.6, 0));
  expect_near(normals.at(2), along(-1, 2, 0));
}

TEST(Gltf, NormalsAreMorphedBeforeTheyFollowJoints) {
  GltfMaker maker = skinned_triangle({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  maker.primitive()["targets"] = {{{"NORMAL", maker.floats({0, 0, 0, 0, 0, 0, 2, 0, 0}, "VEC3")}}};
  maker.json["meshes"][0]["weights"] = {0.5};
  expect_near(normals_of(maker).at(2), along(0.5, 1, 0));
}

TEST(Gltf, TheDefaultSceneIsRead) {
  GltfMaker maker = GltfMaker::triangle();
  maker.add_root({{"mesh", 0}, {"translation", {0, 0, 3}}});
  maker.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  maker.json["scene"] = 1;
  const Reading reading = maker.read();
  ASSERT_TRUE(reading.scene);
  ASSERT_EQ(world_corners(*reading.scene).size(), 3U);
  expect_near(world_corners(*reading.scene)[0], {0, 0, 3});
  EXPECT_THAT(reading.text(), HasSubstr("1 further scene was left out"));
}

TEST(Gltf, WithoutAScenesListAllTreesAreRead) {
  GltfMaker maker = GltfMaker::triangle();
  maker.json.erase("scenes");
  maker.json.erase("scene");
  EXPECT_EQ(only_mesh(maker.read()).face_count(), 1U);
}

TEST(Gltf, BuffersAreInUrisBesideTheFileOrInside) {
  const GltfMaker maker = GltfMaker::triangle();
  EXPECT_EQ(only_mesh(GltfMaker::read_bytes("a.glb", maker.glb())).face_count(), 1U);
  const test::TemporaryFolder folder;
  json beside = maker.json;
  beside["buffers"] = {{{"byteLength", maker.buffer.size()}, {"uri", "parts/a%20b.bin"}}};
  folder.add("parts/a b.bin", maker.buffer);
  EXPECT_EQ(only_mesh(read_path(folder.add("a.gltf", beside.dump()))).face_count(), 1U);
}

TEST(Gltf, NormalsWithoutADirectionAreLost) {
  GltfMaker maker = GltfMaker::triangle();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  maker.attributes()["NORMAL"] = maker.floats({0, 0, 1, 0, 0, 0, nan, 0, 1}, "VEC3");
  const Reading reading = maker.read();
  const grf::Mesh mesh = only_mesh(reading);
  EXPECT_TRUE(mesh.geometry->normals.has(0));
  EXPECT_FALSE(mesh.geometry->normals.has(1));
  EXPECT_FALSE(mesh.geometry->normals.has(2));
  EXPECT_THAT(reading.text(), HasSubstr("2 vertices lost their normal: it has no direction"));
}

TEST(Gltf, WhatHasNoPlaceInAGrfSceneIsSaid) {
  GltfMaker maker = GltfMaker::triangle();
  maker.attributes()["_HEAT"] = maker.floats({1, 2, 3}, "SCALAR");
  maker.add_root({{"camera", 0}});
  maker.json["cameras"] = {
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 0.1}}}}};
  maker.add_root({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  maker.json["meshes"].push_back(maker.json["meshes"][0]);
  maker.json["meshes"][1]["name"] = "spare";
  maker.json["extensionsUsed"] = {"KHR_lights_punctual", "ACME_something"};
  const Reading reading = maker.read();
  EXPECT_EQ(only_mesh(reading).face_count(), 1U);
  for (const char* said : {"3 vertices lost attributes of an application", "1 camera was left out",
                           "1 light was left out", "'spare'", "'ACME_something'"}) {
    EXPECT_THAT(reading.text(), HasSubstr(said));
  }
  EXPECT_FALSE(reading.diagnostics.has_errors());
}

}  // namespace
}  // namespace convert
