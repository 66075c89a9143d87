// Cameras of glTF files become those of OP files, and the other way round.
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/converters/gltf/gltf_maker.h"

namespace convert {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json perspective(double yfov, const std::string& name = "") {
  return {{"type", "perspective"}, {"name", name}, {"perspective", {{"yfov", yfov}, {"znear", 0.1}}}};
}

void expect_near(const grf::Vec3f& a, const grf::Vec3f& b) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-6) << i;
}

// A camera looks along its -z, and its y is up. A quarter turn about y makes -z to -x.
TEST(GltfCameras, HaveTheTransformsOfTheirNodes) {
  GltfMaker maker = GltfMaker::triangle();
  const double half = std::sqrt(0.5);
  maker.add_root(
      {{"camera", 0}, {"translation", {4, 2, 3}}, {"rotation", {0, half, 0, half}}, {"name", "side"}});
  maker.json["cameras"] = json::array({perspective(std::numbers::pi / 3)});
  const Reading reading = maker.read();
  ASSERT_EQ(reading.cameras.size(), 1U) << reading.text();
  const options::NamedCamera& camera = reading.cameras[0];
  EXPECT_EQ(camera.name, "side");
  EXPECT_NEAR(camera.field_of_view, 60, 1e-5);
  EXPECT_EQ(camera.lens_radius, 0);
  expect_near(camera.eye, {4, 2, 3});
  expect_near((camera.target - camera.eye).normalized(), {-1, 0, 0});
  expect_near(camera.up, {0, 1, 0});
  // The triangle is at x from 0 to 1, so that its middle is 3.5 in front of the camera.
  EXPECT_NEAR((camera.target - camera.eye).length(), 3.5, 1e-6);
  EXPECT_THAT(reading.text(), testing::Not(HasSubstr("camera")));
}

TEST(GltfCameras, FollowTheirParents) {
  GltfMaker maker = GltfMaker::triangle();
  // The parent turns y to z, doubles, and moves by (0, 0, 10).
  const double half = std::sqrt(0.5);
  const std::size_t parent = maker.json["nodes"].size();
  maker.add_root({{"children", {parent + 1}},
                  {"rotation", {half, 0, 0, half}},
                  {"scale", {2, 2, 2}},
                  {"translation", {0, 0, 10}}});
  maker.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 1, 0}}});
  maker.json["cameras"] = json::array({perspective(1, "seen from above")});
  const Reading reading = maker.read();
  ASSERT_EQ(reading.cameras.size(), 1U) << reading.text();
  EXPECT_EQ(reading.cameras[0].name, "seen from above") << "the node has no name";
  expect_near(reading.cameras[0].eye, {0, 0, 12});
  expect_near((reading.cameras[0].target - reading.cameras[0].eye).normalized(), {0, 1, 0});
  expect_near(reading.cameras[0].up, {0, 0, 1});
}

TEST(GltfCameras, HaveDifferentNamesThatOpFilesCanHave) {
  GltfMaker maker = GltfMaker::triangle();
  for (const char* name : {"a \"b\"\n", "a b", "none", ""}) {
    maker.add_root({{"camera", 0}, {"name", name}, {"translation", {0, 0, 5}}});
  }
  maker.json["cameras"] = json::array({perspective(1)});
  const Reading reading = maker.read();
  ASSERT_EQ(reading.cameras.size(), 4U) << reading.text();
  std::set<std::string> names;
  for (const options::NamedCamera& camera : reading.cameras) {
    EXPECT_EQ(camera.name.find_first_of("\"\n"), std::string::npos) << camera.name;
    EXPECT_NE(camera.name, "none");
    names.insert(camera.name);
  }
  EXPECT_EQ(names.size(), 4U);
}

TEST(GltfCameras, ThatGrfHasNotAreLosses) {
  for (const json& camera : {perspective(0), perspective(4), perspective(-1),
                             json{{"type", "orthographic"},
                                  {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 0}}}}}) {
    GltfMaker maker = GltfMaker::triangle();
    maker.add_root({{"camera", 0}});
    maker.json["cameras"] = json::array({camera});
    const Reading reading = maker.read();
    EXPECT_TRUE(reading.cameras.empty()) << camera;
    EXPECT_THAT(reading.text(), HasSubstr("1 camera was left out")) << camera;
    EXPECT_EQ(only_mesh(reading).face_count(), 1U);
  }
  GltfMaker maker = GltfMaker::triangle();
  maker.add_root({{"camera", 0}, {"scale", {1, 1, 0}}});
  maker.add_root({{"camera", 7}});
  maker.json["cameras"] = json::array({perspective(1)});
  const Reading reading = maker.read();
  EXPECT_TRUE(reading.cameras.empty());
  EXPECT_THAT(reading.text(), HasSubstr("2 cameras were left out"));
}

class WrittenCameras : public testing::TestWithParam<const char*> {
 protected:
  /// Writes a square with the cameras of OP text.
  std::string write(const std::string& op) const {
    const grf::Scene scene = scene_of_grf(
        "begin mesh begin vertexs (-1,-1,0) (1,-1,0) (1,1,0) (-1,1,0) end vertexs begin faces (0,1,2,3) end "
        "faces end "
        "mesh");
    const std::string path = folder_.path(std::string("out.") + GetParam());
    grf::Diagnostics diagnostics;
    EXPECT_TRUE(find_format(GetParam())->write_view(scene, path, {folder_.add("view.op", op)}, diagnostics))
        << diagnostics.to_text();
    return path;
  }

  const test::TemporaryFolder folder_;
};

TEST_P(WrittenCameras, AreReadAgain) {
  const std::string path = write(
      "BPT_Scene scene.grf\nBPT_Cameras \"left side\" -5 1 0 0 0 0 0 1 0 30 0 0\nBPT_Cameras \"top\" 0 8 0 0 "
      "0 0 0 0 -1 75.5 0.1 "
      "4\n"
      "BPT_Camera top\n");
  const Reading reading = read_path(path);
  ASSERT_EQ(reading.cameras.size(), 2U) << reading.text();
  EXPECT_EQ(reading.cameras[0].name, "top") << "the one that renders is the first";
  expect_near(reading.cameras[0].eye, {0, 8, 0});
  expect_near(reading.cameras[0].target, {0, 0, 0});
  expect_near(reading.cameras[0].up, {0, 0, -1});
  EXPECT_NEAR(reading.cameras[0].field_of_view, 75.5, 1e-4);
  EXPECT_EQ(reading.cameras[1].name, "left side");
  expect_near(reading.cameras[1].eye, {-5, 1, 0});
  const grf::Vec3f towards = (reading.cameras[1].target - reading.cameras[1].eye).normalized();
  expect_near(towards, grf::Vec3f(5, -1, 0).normalized());
  EXPECT_NEAR(reading.cameras[1].field_of_view, 30, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(All, WrittenCameras, testing::Values("gltf", "glb"));

// What other programs read: numbers by the specification.
TEST(GltfCameras, AreWrittenAsTheSpecificationHasThem) {
  const test::TemporaryFolder folder;
  const grf::Scene scene = scene_of_grf(
      "begin mesh begin vertexs (-1,-1,0) (1,-1,0) (1,1,0) end vertexs begin faces (0,1,2) end faces end "
      "mesh");
  const std::string op =
      folder.add("view.op",
                 "BPT_Scene scene.grf\nBPT_Viewer 0 0 5\nBPT_VLook 0 0 0\nBPT_FieldOfView 90\n"
                 "BPT_Image_Resolution 400 200\nBPT_EM_Background sky.exr\n");
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(find_format("gltf")->write_view(scene, folder.path("out.gltf"), {op}, diagnostics))
      << diagnostics.to_text();
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("the image around the scene was left out"));
  const json file = json::parse(test::bytes_of(folder.path("out.gltf")));
  ASSERT_EQ(file["cameras"].size(), 1U);
  EXPECT_EQ(file["cameras"][0]["type"], "perspective");
  const json& numbers = file["cameras"][0]["perspective"];
  EXPECT_NEAR(numbers["yfov"].get<double>(), std::numbers::pi / 2, 1e-6);
  EXPECT_EQ(numbers["aspectRatio"], 2);
  EXPECT_GT(numbers["znear"].get<double>(), 0);
  EXPECT_LT(numbers["znear"].get<double>(), 0.01);
  const int index = file["scenes"][0]["nodes"].back();
  const json& node = file["nodes"][static_cast<std::size_t>(index)];
  EXPECT_EQ(node["camera"], 0);
  const std::vector<double> expected = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1};
  const auto matrix = node["matrix"].get<std::vector<double>>();
  ASSERT_EQ(matrix.size(), 16U);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(matrix[i], expected[i], 1e-7) << i;
}

}  // namespace
}  // namespace convert
