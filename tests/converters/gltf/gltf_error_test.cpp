// Tests of invalid glTF files: each gives an error with its location, and no scene.
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/converters/gltf/gltf_maker.h"

namespace convert {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// The triangle with something changed.
template <class Change>
Reading changed(const Change& change) {
  GltfMaker maker = GltfMaker::triangle();
  change(maker);
  return maker.read();
}

TEST(GltfErrors, OfAccessors) {
  expect_error(changed([](auto& m) { m.json["accessors"][0]["count"] = 4; }),
               "accessor 0: 4 elements from byte 0 go beyond the 36 bytes of buffer view 0");
  expect_error(changed([](auto& m) { m.json["accessors"][0]["count"] = 18446744073709551615ULL; }),
               "elements from byte 0 go beyond");
  expect_error(changed([](auto& m) { m.json["accessors"][0]["byteOffset"] = 18446744073709551615ULL; }),
               "elements from byte 18446744073709551615 go beyond");
  expect_error(changed([](auto& m) { m.json["accessors"][0]["type"] = "VEC2"; }),
               "accessor 0: found 2 numbers per element, expected 3");
  expect_error(changed([](auto& m) { m.json["accessors"][0]["componentType"] = 5124; }),
               "accessor 0: components of type 5124");
  expect_error(changed([](auto& m) { m.json["accessors"][0].erase("bufferView"); }),
               "accessor 0 has no data");
  expect_error(changed([](auto& m) { m.attributes()["POSITION"] = 7; }), "error");
  expect_error(changed([](auto& m) {
                 m.attributes()["NORMAL"] = m.floats({0, 0, 1}, "VEC3");
               }),
               "NORMAL has 1 value for 3 vertices");
  expect_error(changed([](auto& m) { m.json["bufferViews"][0]["byteStride"] = 4; }),
               "elements of 12 bytes, 4 bytes from one to the next");
  expect_error(changed([](auto& m) {
                 const float infinity = std::numeric_limits<float>::infinity();
                 m.attributes()["POSITION"] = m.floats({0, 0, 0, 1, 0, 0, 0, infinity, 0}, "VEC3");
               }),
               "element 2 is infinite or not a number");
}

TEST(GltfErrors, OfViewsAndBuffers) {
  expect_error(changed([](auto& m) { m.json["accessors"][0]["bufferView"] = 9; }),
               "there is no buffer view 9");
  expect_error(changed([](auto& m) { m.json["bufferViews"][0]["buffer"] = 2; }), "there is no buffer 2");
  expect_error(changed([](auto& m) { m.json["bufferViews"][0]["byteLength"] = 37; }),
               "buffer view 0: 37 bytes from byte 0 of a buffer that has 36");
  expect_error(changed([](auto& m) { m.json["bufferViews"][0]["byteOffset"] = 18446744073709551615ULL; }),
               "buffer view 0");
  expect_error(changed([](auto& m) {
                 m.json["buffers"] = {{{"byteLength", 36}, {"uri", "gone.bin"}}};
               }),
               "gone.bin");
}

TEST(GltfErrors, OfIndicesAndSparseValues) {
  expect_error(changed([](auto& m) {
                 m.primitive()["indices"] = m.indices({0, 1, 3});
               }),
               "accessor 1: index 2 is vertex 3 of 3");
  expect_error(changed([](auto& m) {
                 const int places = m.indices({3});
                 m.json["accessors"][0]["sparse"] = {
                     {"count", 1},
                     {"indices", {{"bufferView", places}, {"componentType", 5123}}},
                     {"values", {{"bufferView", 0}}}};
               }),
               "accessor 0: a sparse value for element 3 of 3");
  expect_error(changed([](auto& m) {
                 m.json["accessors"][0]["sparse"] = {
                     {"count", -5},
                     {"indices", {{"bufferView", 0}, {"componentType", 5123}}},
                     {"values", {{"bufferView", 0}}}};
               }),
               "its sparse values have no places");
}

TEST(GltfErrors, OfNodesMeshesAndMaterials) {
  expect_error(changed([](auto& m) { m.json["nodes"][0]["mesh"] = 5; }), "there is no mesh 5");
  expect_error(changed([](auto& m) { m.json["nodes"][0]["children"] = {0}; }), "node 0 is its own ancestor");
  expect_error(changed([](auto& m) { m.json["nodes"][0]["children"] = {3}; }), "there is no node 3");
  expect_error(changed([](auto& m) { m.json["scenes"][0]["nodes"] = {0, 0}; }), "twice");
  expect_error(changed([](auto& m) { m.json["scene"] = 3; }), "there is no scene 3");
  expect_error(changed([](auto& m) { m.primitive()["material"] = 0; }), "there is no material 0");
  expect_error(changed([](auto& m) { m.primitive()["mode"] = 7; }), "mode 7");
  expect_error(changed([](auto& m) { m.primitive().erase("attributes"); }), "attributes");
  expect_error(changed([](auto& m) {
                 m.json["nodes"][0]["scale"] = {1, 2};
               }),
               "node 0 has an invalid transform");
  expect_error(changed([](auto& m) { m.json["nodes"][0]["skin"] = 0; }), "there is no skin 0");
  expect_error(changed([](auto& m) {
                 m.json.erase("nodes");
                 m.json["scenes"] = {{{"name", "a"}}};
               }),
               "the file has no faces");
}

TEST(GltfErrors, OfWhatTheFileIs) {
  expect_error(changed([](auto& m) { m.json["asset"]["version"] = "1.0"; }), "the file is glTF 1.0");
  expect_error(changed([](auto& m) { m.json["extensionsRequired"] = {"KHR_technique_webgl"}; }),
               "requires what is not supported: 'KHR_technique_webgl'");
  expect_error(changed([](auto& m) { m.json["extensionsRequired"] = {"KHR_texture_basisu"}; }),
               "its textures are KTX2 images, which cannot be read; save the model with PNG, JPEG or WebP");
  expect_error(GltfMaker::read_bytes("a.gltf", ""), "the file is empty");
  expect_error(GltfMaker::read_bytes("a.gltf", "{\"asset\""), "error");
  std::string glb = GltfMaker::triangle().glb();
  expect_error(GltfMaker::read_bytes("a.glb", glb.substr(0, 15)), "the file ends inside its header");
  expect_error(GltfMaker::read_bytes("a.glb", glb.substr(0, glb.size() - 4)), "and says that it has");
  glb[4] = 1;
  expect_error(GltfMaker::read_bytes("a.glb", glb), "the file is glTF 1");
  const std::string deep(100000, '[');
  expect_error(GltfMaker::read_bytes("a.gltf", "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + deep),
               "one in another");
}

TEST(GltfErrors, ABinaryPartThatEndsTooSoonIsNotReadBeyond) {
  GltfMaker maker = GltfMaker::triangle();
  std::string glb = maker.glb();
  const std::size_t length_of_binary = glb.size() - maker.buffer.size() - 8;
  glb[length_of_binary] = static_cast<char>(maker.buffer.size() + 8);
  expect_error(GltfMaker::read_bytes("a.glb", glb), "the binary part of the file is truncated");
}

TEST(GltfErrors, ASizeThatTheBytesDoNotBearOutIsAnError) {
  const std::string glb = GltfMaker::triangle().glb();
  for (std::size_t size = 0; size < glb.size(); ++size) {
    expect_error(GltfMaker::read_bytes("a.glb", glb.substr(0, size)), "error: ");
  }
  expect_error(GltfMaker::read_bytes("a.glb", glb + "rest"), "and says that it has");
  std::string with_another_part = glb + std::string("\x08\0\0\0PART", 8) + "1234";
  with_another_part[8] = static_cast<char>(with_another_part.size());
  expect_error(GltfMaker::read_bytes("a.glb", with_another_part), "the binary part of the file is truncated");
  std::string of_another_kind = glb;
  of_another_kind.replace(glb.find("BIN"), 3, "ABC");
  expect_error(GltfMaker::read_bytes("a.glb", of_another_kind), "error: ");
}

TEST(GltfErrors, AFewBytesCannotAskForEndlessWork) {
  GltfMaker maker;
  const int positions = maker.floats(std::vector<float>(3 * 3000), "VEC3");
  const json primitive = {{"attributes", {{"POSITION", positions}}}, {"mode", 5}};
  maker.add_mesh(primitive);
  for (int i = 0; i < 20000; ++i) maker.json["meshes"][0]["primitives"].push_back(primitive);
  expect_error(maker.read(), "vertices and corners, too many for its ");
}

/// Bytes of a file changed, cut off or made of large numbers.
std::string mutated(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  const std::size_t changes = 1 + below(8);
  for (std::size_t i = 0; i < changes; ++i) {
    const std::size_t place = below(bytes.size());
    switch (below(5)) {
      case 0:
        bytes[place] = static_cast<char>(below(256));
        break;
      case 1:
        bytes[place] ^= static_cast<char>(1U << below(8));
        break;
      case 2:  // another digit for one
        if (bytes[place] >= '0' && bytes[place] <= '9') bytes[place] = static_cast<char>('0' + below(10));
        break;
      case 3:
        if (bytes[place] >= '0' && bytes[place] <= '9') bytes.insert(place, "99999999");
        break;
      default:
        if (below(4) == 0) bytes.resize(place + 1);
    }
  }
  return bytes;
}

/// A file that has something of everything.
GltfMaker rich() {
  GltfMaker maker = GltfMaker::triangle({{"skin", 0}});
  maker.attributes()["JOINTS_0"] = maker.add<std::uint8_t>(std::vector<std::uint8_t>(12), "VEC4", 5121);
  maker.attributes()["WEIGHTS_0"] = maker.floats(std::vector<float>(12, 0.25F), "VEC4");
  maker.attributes()["TEXCOORD_0"] = maker.floats({0, 0, 1, 0, 0, 1}, "VEC2");
  maker.attributes()["COLOR_0"] = maker.floats(std::vector<float>(12, 0.5F), "VEC4");
  maker.primitive()["indices"] = maker.indices({0, 1, 2});
  maker.primitive()["material"] = 0;
  maker.primitive()["targets"] = {{{"POSITION", 0}}};
  maker.json["meshes"][0]["weights"] = {0.5};
  const int places = maker.indices({1});
  maker.json["accessors"][0]["sparse"] = {{"count", 1},
                                          {"indices", {{"bufferView", places}, {"componentType", 5123}}},
                                          {"values", {{"bufferView", 0}}}};
  maker.json["skins"] = {{{"joints", {1}}}};
  maker.add_root({{"translation", {1, 2, 3}}, {"mesh", 0}});
  maker.json["images"] = {{{"bufferView", 0}, {"mimeType", "image/png"}}};
  maker.json["textures"] = {{{"source", 0}}};
  maker.json["materials"] = {
      {{"name", "m"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  return maker;
}

TEST(GltfErrors, MutatedFilesGiveASceneOrAMessage) {
  std::mt19937 random(8);
  const GltfMaker maker = rich();
  const std::string gltf = maker.gltf();
  const std::string glb = maker.glb();
  ASSERT_TRUE(GltfMaker::read_bytes("a.gltf", gltf).scene) << GltfMaker::read_bytes("a.gltf", gltf).text();
  const test::TemporaryFolder folder;
  int errors = 0;
  for (int i = 0; i < 1000; ++i) {
    const bool binary = i % 2 == 0;
    const std::string name = binary ? "a.glb" : "a.gltf";
    grf::Diagnostics diagnostics;
    const auto import = read(*find_format(binary ? "glb" : "gltf"),
                             folder.add(name, mutated(binary ? glb : gltf, random)), {}, diagnostics);
    EXPECT_EQ(import.has_value(), !diagnostics.has_errors());
    if (!import) ++errors;
  }
  EXPECT_GT(errors, 100);
}

}  // namespace
}  // namespace convert
