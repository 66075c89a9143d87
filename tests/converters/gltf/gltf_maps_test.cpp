// Tests of images that vary parameters of the BRDF `gltf` in glTF files: read, written, and read back.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/write.h"
#include "tests/converters/gltf/gltf_brdf_files.h"

namespace convert {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

/// An image that varies one parameter in files of glTF 2.0: its channel by the specification.
struct Map {
  std::string extension;  ///< empty: pbrMetallicRoughness
  std::string texture;
  std::string factor;
  json value;
  std::string brdf;  ///< what it is with the factor, in GRF
};
const std::string Image = "texture \"wood a.png\" ";

std::vector<Map> maps() {
  return {{"", "metallicRoughnessTexture", "metallicFactor", 0.5,
           "gltf metallic=" + Image + "b * 0.5 roughness=" + Image + "g"},
          {"specular", "specularTexture", "specularFactor", 0.25, "gltf specular=" + Image + "a * 0.25"},
          {"specular",
           "specularColorTexture",
           "specularColorFactor",
           {1, 0.5, 2},
           "gltf specularColor=" + Image + "rgb * (1, 0.5, 2)"},
          {"clearcoat", "clearcoatTexture", "clearcoatFactor", 0.5, "gltf clearcoat=" + Image + "r * 0.5"},
          {"sheen",
           "sheenColorTexture",
           "sheenColorFactor",
           {1, 0.5, 0},
           "gltf sheenColor=" + Image + "rgb * (1, 0.5, 0) sheenRoughness=0.01"},
          {"iridescence", "iridescenceTexture", "iridescenceFactor", 1, "gltf iridescence=" + Image + "r"}};
}

json material_with(const Map& map) {
  const json values = {{map.texture, {{"index", 0}}}, {map.factor, map.value}};
  if (map.extension.empty()) return {{"pbrMetallicRoughness", values}};
  return dielectric({{map.extension, values}});
}

TEST(GltfMaps, VariesByTheImagesOfItsParameters) {
  for (const Map& map : maps()) EXPECT_EQ(clean_brdf_of(material_with(map)), map.brdf);
  const auto coat = [](double factor) {
    return clean_brdf_of(dielectric({{"clearcoat",
                                      {{"clearcoatFactor", factor},
                                       {"clearcoatRoughnessFactor", 0.5},
                                       {"clearcoatRoughnessTexture", {{"index", 0}}}}}}));
  };
  EXPECT_EQ(coat(1), "gltf clearcoat=1 coatRoughness=" + Image + "g * 0.5");
  EXPECT_EQ(coat(0), "gltf") << "an image without an effect";
  const json fibres = {{"sheenColorFactor", {1, 1, 1}},
                       {"sheenRoughnessFactor", 0.5},
                       {"sheenRoughnessTexture", {{"index", 0}}}};
  EXPECT_EQ(clean_brdf_of(dielectric({{"sheen", fibres}})),
            "gltf sheenColor=1 sheenRoughness=" + Image + "a * 0.5");
}

// mix(minimum, maximum, g) is a product if the minimum is 0; its default is 100.
TEST(GltfMaps, VariesByTheThicknessOfItsFilm) {
  json film = {{"iridescenceFactor", 1},
               {"iridescenceThicknessMaximum", 500},
               {"iridescenceThicknessTexture", {{"index", 0}}}};
  EXPECT_THAT(read_material(dielectric({{"iridescence", film}})).text(),
              HasSubstr("1 face lost its map of a parameter"));
  film["iridescenceThicknessMinimum"] = 0;
  EXPECT_EQ(clean_brdf_of(dielectric({{"iridescence", film}})),
            "gltf iridescence=1 filmThickness=" + Image + "g * 500");
}

TEST(GltfMaps, LosesMapsThatAreNoFactorsOfItsParameters) {
  const auto said_of = [](const json& material) { return read_material(material).text(); };
  const json turned = {{"anisotropyStrength", 1}, {"anisotropyTexture", {{"index", 0}}}};
  EXPECT_THAT(said_of(dielectric({{"anisotropy", turned}})), HasSubstr("1 face lost its map of a parameter"));
  // All images of a face have the same texture coordinates.
  json other = material_with(maps().front());
  other["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}, {"texCoord", 1}};
  EXPECT_THAT(said_of(other), HasSubstr("1 face lost its map of a parameter"));
  other["pbrMetallicRoughness"]["metallicRoughnessTexture"]["texCoord"] = 1;
  EXPECT_THAT(said_of(other), testing::Not(HasSubstr("map of a parameter")));
  other["pbrMetallicRoughness"]["metallicRoughnessTexture"]["extensions"]["KHR_texture_transform"] = {
      {"scale", {2, 2}}};
  EXPECT_THAT(said_of(other), HasSubstr("1 face lost its map of a parameter"));
  const json bumps = {{"clearcoatNormalTexture", {{"index", 0}}}};
  EXPECT_THAT(said_of(dielectric({{"clearcoat", bumps}})), HasSubstr("1 face lost its normal map"));
}

TEST(GltfMaps, WritesTheImagesOfItsParameters) {
  for (const Map& map : maps()) {
    const json file = written("brdf " + map.brdf);
    const json& material = file["materials"][0];
    const json& owner = map.extension.empty() ? material["pbrMetallicRoughness"]
                                              : material["extensions"]["KHR_materials_" + map.extension];
    ASSERT_TRUE(owner.contains(map.texture)) << material;
    EXPECT_EQ(file["images"][0]["uri"], "wood%20a.png");
    const Reading reading = read_bare(file);
    EXPECT_EQ(grf::to_text(model_of(reading)), map.brdf);
    EXPECT_THAT(reading.text(), IsEmpty());
  }
  const json base = written("brdf gltf baseColor=" + Image + "rgb * (1, 0.5, 0.25)");
  EXPECT_TRUE(base["materials"][0]["pbrMetallicRoughness"].contains("baseColorTexture"));
}

TEST(GltfMaps, SaysWhichImagesItCannotWrite) {
  const auto said_of = [](const std::string& brdf) {
    const test::TemporaryFolder folder;
    grf::Diagnostics diagnostics;
    const grf::Scene scene = scene_of_grf("begin mesh brdf " + brdf +
                                          " begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs begin "
                                          "faces (0, 1, 2) end faces end mesh");
    EXPECT_TRUE(find_format("gltf")->write(scene, folder.path("a.gltf"), diagnostics));
    return diagnostics.to_text();
  };
  const std::string lost = "1 material lost a parameter of an image that glTF has not";
  EXPECT_THAT(said_of("gltf roughness=" + Image + "r"), HasSubstr(lost)) << "glTF reads green";
  EXPECT_THAT(said_of("gltf metallic=0.5 roughness=" + Image + "g"), HasSubstr(lost))
      << "its blue would vary metallic";
  EXPECT_THAT(said_of("gltf metallic=" + Image + "b roughness=texture \"other.png\" g"),
              HasSubstr("2 materials lost a parameter"));
  EXPECT_THAT(said_of("ward sx=" + Image + "r"), HasSubstr(lost));
  EXPECT_THAT(said_of("gltf metallic=0 roughness=" + Image + "g"), testing::Not(HasSubstr(lost)));
}

}  // namespace
}  // namespace convert
