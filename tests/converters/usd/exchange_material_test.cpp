// The materials of USD and MaterialX files.
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/converters/usd/exchanged_scene.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* Nearest = "the nearest material in place of";

ExchangedScene scene_with(const std::string& surface) {
  const test::TemporaryFolder files;
  files.add("wood.png", "");
  return ExchangedScene(exchange_cube(surface, {}), {}, files);
}

TEST(ExchangeMaterials, AreExactWhereMaterialxHasTheModel) {
  for (const char* surface :
       {"brdf diffuse kd=0.5", "rgb (0.5, 1, 1) brdf diffuse kd=0.5 texture \"wood.png\"",
        "brdf eon rough=0.25", "brdf sheen", "brdf specular",
        "brdf ggx alpha=0.25 nreal=2 nimag=3 scattering=scaled", "brdf openpbr baseColor=0.25 coatWeight=1",
        "brdf gltf metallic=1 anisotropy=0.5 rotation=1"}) {
    EXPECT_THAT(scene_with(surface).mtlx_warnings(), Not(HasSubstr(Nearest))) << surface;
    EXPECT_THAT(scene_with(surface).usd_warnings(), Not(HasSubstr(Nearest))) << surface;
  }
  for (const char* surface :
       {"brdf oren s=0.25", "brdf ggx", "brdf ggx scattering=scaled anisotropy=0.5", "brdf ward",
        "brdf lewis", "rgb (0.5, 1, 1) brdf openpbr", "brdf openpbr rotation=1",
        "brdf gltf texture \"wood.png\"", "brdf gltf sheenColor=0.5"}) {
    EXPECT_THAT(scene_with(surface).mtlx_warnings(), HasSubstr("6 faces have " + std::string(Nearest)))
        << surface;
    EXPECT_THAT(scene_with(surface).usd_warnings(), HasSubstr("6 faces have " + std::string(Nearest)))
        << surface;
  }
}

TEST(ExchangeMaterials, OfOpenPbrHaveItsValues) {
  const ExchangedScene scene = scene_with(
      "brdf openpbr baseWeight=0.5 baseColor=(0.25, 0.5, 0.75) metalness=0.125 diffuseRough=0.375 ior=1.75 "
      "fuzzWeight=0.625 filmThickness=0.25 light rgb (4, 2, 1)");
  const auto& inputs = scene.mtlx().only("open_pbr_surface").inputs;
  const std::map<std::string, std::string> expected = {
      {"base_weight", "0.5"},      {"base_color", "0.25, 0.5, 0.75"},   {"base_metalness", "0.125"},
      {"specular_ior", "1.75"},    {"base_diffuse_roughness", "0.375"}, {"fuzz_weight", "0.625"},
      {"coat_ior", "1.6"},         {"thin_film_thickness", "0.25"},     {"specular_roughness", "0.3"},
      {"emission_luminance", "4"}, {"emission_color", "1, 0.5, 0.25"}};
  for (const auto& [name, value] : expected) EXPECT_EQ(inputs.at(name).value, value) << name;
  const test::UsdaPrim& node = *scene.usd().find("/World/Looks/openpbr/Node_1");
  EXPECT_EQ(node.string("info:id"), "ND_open_pbr_surface_surfaceshader");
  EXPECT_THAT(node.attribute("inputs:base_color").numbers, ElementsAre(0.25, 0.5, 0.75));
}

TEST(ExchangeMaterials, OfGlassTransmit) {
  const ExchangedScene solid = scene_with("brdf glass ior=1.75 colour=(0.25, 0.5, 1) distance=2");
  const auto& inputs = solid.mtlx().only("open_pbr_surface").inputs;
  const std::map<std::string, std::string> expected = {{"transmission_weight", "1"},
                                                       {"transmission_color", "0.25, 0.5, 1"},
                                                       {"transmission_depth", "2"},
                                                       {"specular_ior", "1.75"},
                                                       {"specular_roughness", "0"}};
  for (const auto& [name, value] : expected) EXPECT_EQ(inputs.at(name).value, value) << name;
  EXPECT_FALSE(inputs.contains("geometry_thin_walled"));
  const test::UsdaPrim& preview = *solid.usd().find("/World/Looks/glass/PreviewSurface");
  EXPECT_EQ(preview.number("inputs:opacity"), 0);
  EXPECT_EQ(preview.string("inputs:opacityMode"), "transparent");
  EXPECT_EQ(preview.number("inputs:ior"), 1.75);
  const ExchangedScene pane = scene_with("brdf glass colour=0.5 thin=true");
  EXPECT_EQ(pane.mtlx().only("open_pbr_surface").inputs.at("geometry_thin_walled").value, "true");
  EXPECT_EQ(pane.mtlx().only("open_pbr_surface").inputs.at("transmission_color").value, "0.5, 0.5, 0.5");
  EXPECT_FALSE(pane.mtlx().only("open_pbr_surface").inputs.contains("transmission_depth"));
}

TEST(ExchangeMaterials, OfFacetsHaveTheirAlphas) {
  const ExchangedScene scene = scene_with("brdf ggx alpha=0.25 ay=0.5 nreal=2 nimag=(3, 4, 5)");
  const auto& inputs = scene.mtlx().only("conductor_bsdf").inputs;
  EXPECT_EQ(inputs.at("roughness").value, "0.25, 0.5");
  EXPECT_EQ(inputs.at("ior").value, "2, 2, 2");
  EXPECT_EQ(inputs.at("extinction").value, "3, 4, 5");
  const test::UsdaPrim& node = *scene.usd().find("/World/Looks/ggx/Node_1");
  EXPECT_EQ(node.attribute("inputs:roughness").type, "float2");
}

TEST(ExchangeMaterials, OfSumsAreWeighted) {
  const ExchangedScene scene(
      "def clay = brdf diffuse kd=0.75 shine = brdf specular ks=1 "
      "both = brdf combine 0.5 clay, 0.25 shine begin " +
      exchange_cube("brdf both", {}) + " end");
  const auto& nodes = scene.mtlx().nodes;
  const auto& sum = scene.mtlx().only("add").inputs;
  const auto& clay = nodes.at(sum.at("in1").node).inputs;
  const auto& shine = nodes.at(sum.at("in2").node).inputs;
  EXPECT_EQ(clay.at("in2").value, "0.5");
  EXPECT_EQ(nodes.at(clay.at("in1").node).inputs.at("color").value, "0.75, 0.75, 0.75");
  EXPECT_EQ(shine.at("in2").value, "0.25");
  EXPECT_EQ(nodes.at(shine.at("in1").node).category, "generalized_schlick_bsdf");
  EXPECT_THAT(nodes.at("both").doc, HasSubstr("combine 0.5 clay, 0.25 shine\nclay = brdf diffuse kd=0.75"));
}

TEST(ExchangeMaterials, HaveTheOpacityOfTheTexture) {
  const ExchangedScene mask = scene_with("brdf diffuse texture \"wood.png\" opacity mask 0.75");
  const auto& choice = mask.mtlx().only("ifgreatereq").inputs;
  EXPECT_EQ(choice.at("value2").value, "0.75");
  EXPECT_EQ(choice.at("in1").value, "1");
  EXPECT_EQ(choice.at("in2").value, "0");
  EXPECT_EQ(mask.mtlx().only("surface").inputs.at("opacity").node, mask.mtlx().only("ifgreatereq").name);
  const test::UsdaPrim& preview = *mask.usd().find("/World/Looks/diffuse/PreviewSurface");
  EXPECT_EQ(preview.number("inputs:opacityThreshold"), 0.75);
  EXPECT_EQ(preview.attribute("inputs:opacity").connection, "/World/Looks/diffuse/PreviewTexture.outputs:a");
  const test::UsdaPrim& texture = *mask.usd().find("/World/Looks/diffuse/PreviewTexture");
  EXPECT_THAT(texture.attribute("inputs:scale").numbers, ElementsAre(0.5, 0.5, 0.5, 1));
  EXPECT_EQ(texture.string("inputs:sourceColorSpace"), "sRGB");
  EXPECT_EQ(texture.string("inputs:wrapS"), "repeat");
  EXPECT_EQ(texture.string("inputs:file"), "./wood.png");
}

TEST(ExchangeMaterials, HaveTheFactorsOfTheTexture) {
  const ExchangedScene scene =
      scene_with("brdf diffuse kd=(0.25, 0.5, 0.75) texture \"wood.png\" opacity blend 0.5");
  const test::UsdaPrim& texture = *scene.usd().find("/World/Looks/diffuse/PreviewTexture");
  EXPECT_THAT(texture.attribute("inputs:scale").numbers, ElementsAre(0.25, 0.5, 0.75, 0.5));
  EXPECT_EQ(texture.string("inputs:wrapT"), "repeat");
  EXPECT_THAT(scene.usd_text(), HasSubstr("@./wood.png@ ( colorSpace = \"srgb_texture\" )"));
  EXPECT_THAT(scene.usd_text(), testing::Not(HasSubstr("lin_rec709")));
}

// The reflectance at normal incidence of an index of 1.5 is 0.04.
TEST(ExchangeMaterials, OfPreviewsHaveTheReflectanceOfTheirIndex) {
  const ExchangedScene plastic = scene_with("brdf gltf baseColor=0.5 specular=0.5 ior=1.5 roughness=0.3");
  const test::UsdaPrim& dielectric = *plastic.usd().find("/World/Looks/gltf/PreviewSurface");
  EXPECT_EQ(dielectric.number("inputs:useSpecularWorkflow"), 1);
  EXPECT_NEAR(dielectric.number("inputs:specularColor"), 0.02, 1e-6);
  EXPECT_NEAR(dielectric.number("inputs:roughness"), 0.3, 1e-6);
  const ExchangedScene alloy = scene_with("brdf gltf baseColor=0.5 metallic=0.75 roughness=0.25");
  const test::UsdaPrim& metal = *alloy.usd().find("/World/Looks/gltf/PreviewSurface");
  EXPECT_EQ(metal.number("inputs:metallic"), 0.75);
  EXPECT_EQ(metal.number("inputs:roughness"), 0.25);
}

TEST(ExchangeMaterials, OfPreviewsOfCoatsHaveTheirStrength) {
  const ExchangedScene scene = scene_with("brdf gltf baseColor=0.5 clearcoat=0.5 coatRoughness=0.25 ior=2");
  const test::UsdaPrim& preview = *scene.usd().find("/World/Looks/gltf/PreviewSurface");
  EXPECT_EQ(preview.number("inputs:clearcoat"), 0.5);
  EXPECT_EQ(preview.number("inputs:clearcoatRoughness"), 0.25);
  EXPECT_EQ(preview.number("inputs:ior"), 2);
  EXPECT_EQ(preview.number("inputs:useSpecularWorkflow"), 0);
}

TEST(ExchangeMaterials, LoseWhatIsNoMaterialInMaterialx) {
  EXPECT_THAT(ExchangedScene(exchange_cube({}, {})).mtlx_warnings(), HasSubstr("1 mesh lost its geometry"));
}

}  // namespace
}  // namespace convert
