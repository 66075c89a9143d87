// Scenes of blocks that are nested as deep as they can be, and trees of nodes that are nested deeper than
// that, in threads of small stacks.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/mesh_operations/scene_placement.h"
#include "grf/summary.h"
#include "tests/converters/assimp/collada_file.h"
#include "tests/converters/reading.h"
#include "tests/support/small_stack.h"

namespace convert {
namespace {

using testing::HasSubstr;

/// A triangle in so many transforms, each of which moves it by 1.
std::string nested_triangle(std::size_t depth) {
  std::string text;
  for (std::size_t i = 0; i < depth; ++i) text += "transform translation (1, 0, 0) begin\n";
  text +=
      "begin mesh begin vertexs normal (0,0,1) (0,0,0) normal (0,0,1) (1,0,0) normal (0,0,1) (0,1,0) end "
      "begin faces (0,1,2) end end\n";
  for (std::size_t i = 0; i < depth; ++i) text += "end\n";
  return text;
}

TEST(DeepScenes, AreWrittenInEachFormatAndReadAgain) {
  const test::TemporaryFolder folder;
  test::run_on_small_stack([&folder] {
    const grf::Scene scene = scene_of_grf(nested_triangle(grf::DeepestNesting));
    for (const Format& format : formats()) {
      if (format.write == nullptr) continue;
      const std::string path = folder.path("deep." + std::string(format.extensions.front()));
      grf::Diagnostics diagnostics;
      ASSERT_TRUE(format.write(scene, path, diagnostics)) << format.name << diagnostics.to_text();
      if (format.read == nullptr && format.write_view != nullptr) continue;
      const Reading again = read_path(path);
      ASSERT_TRUE(again.scene) << format.name << again.text();
      EXPECT_FLOAT_EQ(grf::summarize(*again.scene).bounds.max.x, 1001) << format.name;
    }
  });
}

TEST(DeepScenes, ThatAreTurnedAreNoDeeperThanCanBeRead) {
  const test::TemporaryFolder folder;
  grf::Scene scene = scene_of_grf(nested_triangle(grf::DeepestNesting));
  place(scene, {z_up_to_y_up()}, {});
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(find_format("grf")->write(scene, folder.path("deep.grf"), diagnostics));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("its blocks are nested deeper than 1000"));
}

/// A chain of nodes, the last of which has the mesh.
std::string gltf_chain(int nodes) {
  std::string text = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)";
  for (int i = 0; i + 1 < nodes; ++i) {
    text += "{\"translation\":[1,0,0],\"children\":[" + std::to_string(i + 1) + "]},";
  }
  // Three corners at (0,0,0), (1,0,0) and (0,1,0), as little-endian floats in base 64.
  return text +
         R"({"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[)"
         R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":)"
         R"("data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}

TEST(DeepNodes, OfGltfAreReadUpToTheLimit) {
  test::run_on_small_stack([] {
    const Reading deepest = read_bytes("a.gltf", gltf_chain(900));
    ASSERT_TRUE(deepest.scene) << deepest.text();
    EXPECT_FLOAT_EQ(grf::summarize(*deepest.scene).bounds.max.x, 900);
    for (const int nodes : {901, 60'000}) {
      EXPECT_THAT(read_bytes("a.gltf", gltf_chain(nodes)).text(), HasSubstr("or is nested deeper than 900"));
    }
  });
}

TEST(DeepNodes, OfVrmlAreReadUpToTheLimit) {
  const auto chain = [](int nodes) {
    std::string text = "#VRML V2.0 utf8\n";
    for (int i = 0; i < nodes; ++i) text += "Transform{translation 1 0 0 children ";
    text += "Shape{geometry IndexedFaceSet{coord Coordinate{point[0 0 0,1 0 0,0 1 0]}coordIndex[0 1 2]}}";
    return text + std::string(static_cast<std::size_t>(nodes), '}');
  };
  test::run_on_small_stack([&chain] {
    // The shape, its geometry and the coordinates are three more levels.
    const Reading deepest = read_bytes("a.wrl", chain(497));
    ASSERT_TRUE(deepest.scene) << deepest.text();
    EXPECT_FLOAT_EQ(grf::summarize(*deepest.scene).bounds.max.x, 498);
    for (const int nodes : {498, 60'000}) {
      EXPECT_THAT(read_bytes("a.wrl", chain(nodes)).text(), HasSubstr("nested more than 500 deep"));
    }
  });
}

TEST(DeepNodes, OfColladaAreReadUpToTheLimit) {
  const auto chain = [](int nodes) {
    ColladaParts parts;
    for (int i = 0; i < nodes; ++i) parts.nodes += "<node><translate>1 0 0</translate>";
    parts.nodes += "{}";
    for (int i = 0; i < nodes; ++i) parts.nodes += "</node>";
    return collada_file(parts);
  };
  const Reading deepest = read_bytes("a.dae", chain(500));
  ASSERT_TRUE(deepest.scene) << deepest.text();
  EXPECT_FLOAT_EQ(grf::summarize(*deepest.scene).bounds.max.x, 501);
  EXPECT_THAT(read_bytes("a.dae", chain(501)).text(), HasSubstr("objects are nested deeper than 500"));
}

}  // namespace
}  // namespace convert
