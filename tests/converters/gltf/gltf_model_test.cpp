// The glTF models of Debian's package assimp-testmodels, against what Assimp makes of them.
#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/keywords.h"
#include "tests/converters/gltf/assimp_count.h"
#include "tests/converters/model_files.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;

/// The models that give an error, and a part of its text.
const std::map<std::string, std::string> Errors = {
    {"glTF/BoxTextured-glTF-Binary/BoxTextured.glb", "the file is glTF 1, and only glTF 2 can be read"},
    {"glTF/BoxTextured-glTF-Embedded/BoxTextured.gltf", "the file is glTF 1.0, and only glTF 2 can be read"},
    {"glTF/BoxTextured-glTF-MaterialsCommon/BoxTextured.gltf",
     "the file is glTF 1.0, and only glTF 2 can be read"},
    {"glTF/BoxTextured-glTF/BoxTextured.gltf", "the file is glTF 1.0, and only glTF 2 can be read"},
    {"glTF/IncorrectVertexArrays/Cube_v1.gltf", "the file is glTF 1.0, and only glTF 2 can be read"},
    {"glTF/TwoBoxes/TwoBoxes.gltf", "the file is glTF 1.0, and only glTF 2 can be read"},
    {"glTF/CesiumMilkTruck/CesiumMilkTruck.gltf", "\"asset\" object not found"},
    {"glTF2/BoxTextured-glTF-techniqueWebGL/BoxTextured.gltf",
     "requires what is not supported: 'KHR_technique_webgl'"},
    {"glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb",
     "accessor 2: element 0 is infinite or not a number"},
    {"glTF2/IndexOutOfRange/AllIndicesOutOfRange.gltf", "accessor 0: index 0 is vertex 65535 of 24"},
    {"glTF2/IndexOutOfRange/IndexOutOfRange.gltf", "accessor 0: index 0 is vertex 255 of 24"},
    {"glTF2/MissingBin/BoxTextured.gltf", "File not found : BoxTextured0.bin"},
    {"glTF2/RecursiveNodes/RecursiveNodes.gltf", "node 0 is its own ancestor"},
    {"glTF2/SchemaFailures/sceneWrongType.gltf", "File not found : BoxTextured0.bin"},
    {"glTF2/TestNoRootNode/NoScene.gltf", "the file has no faces"},
    {"glTF2/TestNoRootNode/SceneWithoutNodes.gltf", "the file has no faces"},
    {"glTF2/wrongTypes/badArray.gltf", "the file has no faces"},
    {"glTF2/wrongTypes/badNumber.gltf", "'index' property is missing in NormalTextureInfo"},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_00.gltf", "the file has no faces"},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_01.gltf", "the file has no faces"},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_02.gltf", "the file has no faces"},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_03.gltf", "the file has no faces"},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_07.gltf", "the file has no faces"},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_08.gltf", "the file has no faces"},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_09.gltf", "the file has no faces"},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_10.gltf", "the file has no faces"}};

/// Assimp leaves skins and morph targets where they are: what it counts is the same, and no place is.
const std::set<std::string> Posed = {"glTF2/simple_skin/simple_skin.gltf"};

/// What Assimp itself cannot read, and files that hold the same shape.
const std::map<std::string, std::string> Equals = {
    {"glTF2/wrongTypes/badExtension.gltf", "glTF2/BoxTextured-glTF/BoxTextured.gltf"},
    {"glTF2/wrongTypes/badObject.gltf", "glTF2/BoxTextured-glTF/BoxTextured.gltf"},
    {"glTF2/wrongTypes/badString.gltf", "glTF2/BoxTextured-glTF/BoxTextured.gltf"},
    {"glTF2/wrongTypes/badUint.gltf", "glTF2/BoxTextured-glTF/BoxTextured.gltf"}};

/// What Assimp counts of a file, or of one that holds the same shape. Nothing is like the shape of one file:
/// by the bounds of its accessors, it is a square of side 2 behind four of side 1.
std::optional<ModelCount> expected_count(const std::string& name) {
  if (name == "glTF2/issue_3269/texcoord_crash.gltf") {
    return ModelCount{10, 20, 8, {{-1.2, -1.2, -0.05259115}, {1.2, 1.2, 5e-7}}};
  }
  const auto equal = Equals.find(name);
  return assimp_count(AssimpModels + (equal == Equals.end() ? name : equal->second));
}

void expect_same(const ModelCount& found, const ModelCount& expected, bool is_posed) {
  EXPECT_EQ(found.faces, expected.faces);
  EXPECT_EQ(found.positions, expected.positions);
  if (is_posed) return;
  EXPECT_NEAR(found.area, expected.area, 1e-5 * expected.area);
  const double size = expected.bounds.size().length();
  EXPECT_LE((found.bounds.min - expected.bounds.min).length(), 1e-5 * size);
  EXPECT_LE((found.bounds.max - expected.bounds.max).length(), 1e-5 * size);
}

class GltfModel : public testing::TestWithParam<std::string> {};

TEST_P(GltfModel, IsReadAsAssimpReadsItOrNotAtAll) {
  const std::string name = short_name(GetParam());
  const Reading reading = read_path(GetParam());
  if (const auto error = Errors.find(name); error != Errors.end()) {
    EXPECT_FALSE(reading.scene.has_value());
    EXPECT_THAT(reading.text(), HasSubstr(error->second));
    return;
  }
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_FALSE(reading.diagnostics.has_errors());
  const auto expected = expected_count(name);
  ASSERT_TRUE(expected.has_value());
  expect_same(count_of(*reading.scene), *expected, Posed.contains(name));
}

std::string name_of(const testing::TestParamInfo<std::string>& info) { return test_name(info.param); }

INSTANTIATE_TEST_SUITE_P(OfDebian, GltfModel, testing::ValuesIn(model_files(formats_of_gltf_models())),
                         name_of);

TEST(GltfModels, AreAllThere) { EXPECT_GE(model_files(formats_of_gltf_models()).size(), 53U); }

// GRF -> glTF -> GRF, with real models: the same scene, and for Assimp the same shapes.
TEST_P(GltfModel, GoesThroughGltfAndBack) {
  if (Errors.contains(short_name(GetParam()))) return;
  const Reading reading = read_path(GetParam());
  ASSERT_TRUE(reading.scene.has_value());
  const test::TemporaryFolder folder;
  for (const char* name : {"out.gltf", "out.glb"}) {
    grf::Diagnostics diagnostics;
    ASSERT_TRUE(format_of_name(name)->write(*reading.scene, folder.path(name), diagnostics))
        << diagnostics.to_text();
    const Reading again = read_path(folder.path(name));
    ASSERT_TRUE(again.scene.has_value()) << again.text();
    EXPECT_EQ(*again.scene, *reading.scene);
    const auto counted = assimp_count(folder.path(name));
    ASSERT_TRUE(counted.has_value());
    expect_same(*counted, count_of(*reading.scene), false);
  }
}

}  // namespace
}  // namespace convert
