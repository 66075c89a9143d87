// Tests of the conversion of glTF materials to GRF BRDFs, and back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/gltf/gltf_brdf.h"
#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/write.h"
#include "renderer/reflectance/scheme.h"
#include "tests/converters/gltf/gltf_maker.h"

namespace convert {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string brdf_of(const json& material) {
  const Reading reading = GltfMaker::with_material(material).read();
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  return reading.scene ? brdf_text(definitions_of(*reading.scene).at(0)) : "";
}

json pbr(const json& colour, double metallic, double roughness) {
  return {{"pbrMetallicRoughness",
           {{"baseColorFactor", colour}, {"metallicFactor", metallic}, {"roughnessFactor", roughness}}}};
}

TEST(GltfMaterial, BecomesTheBrdfOfItsValues) {
  EXPECT_EQ(brdf_of(pbr({1, 0.5, 0.25, 1}, 1, 0.25)),
            "gltf baseColor=(1, 0.5, 0.25) metallic=1 roughness=0.25");
  EXPECT_EQ(brdf_of(pbr({1, 0.5, 0.25, 1}, 1, 0)), "gltf baseColor=(1, 0.5, 0.25) metallic=1 roughness=0");
  EXPECT_EQ(brdf_of(pbr({1, 0.5, 0.25, 1}, 0, 0.5)), "gltf baseColor=(1, 0.5, 0.25)")
      << "values that are defaults of the BRDF are left out";
  EXPECT_EQ(brdf_of(pbr({0.5, 0.5, 0.5, 1}, 0.5, 1)), "gltf baseColor=0.5 metallic=0.5 roughness=1");
}

// glTF 2.0, 5.22: white, metallic and rough are the defaults of the file.
TEST(GltfMaterial, OfNoValuesHasTheDefaultsOfTheFile) {
  EXPECT_EQ(brdf_of(json::object()), "gltf metallic=1 roughness=1");
  EXPECT_EQ(brdf_of({{"pbrMetallicRoughness", json::object()}}), "gltf metallic=1 roughness=1");
}

TEST(GltfMaterial, ExtensionsThatSayItsReflectanceAreRead) {
  json unlit = pbr({0.5, 0.25, 0.5, 1}, 1, 1);
  unlit["extensions"]["KHR_materials_unlit"] = json::object();
  EXPECT_EQ(brdf_of(unlit), "diffuse kd=(0.5, 0.25, 0.5)") << "whatever its metallic factor";
  const json glossy = {{"extensions",
                        {{"KHR_materials_pbrSpecularGlossiness",
                          {{"diffuseFactor", {0.5, 0.25, 0, 1}},
                           {"specularFactor", {0.25, 0.5, 1}},
                           {"glossinessFactor", 0.75}}}}}};
  // F0 is specularColor times 0.04.
  EXPECT_EQ(brdf_of(glossy), "gltf baseColor=(0.5, 0.25, 0) roughness=0.25 specularColor=(6.25, 12.5, 25)");
}

TEST(GltfMaterial, KeepsItsNameAndItsValuesInAComment) {
  json material = pbr({0.5, 0.5, 0.5, 1}, 0, 1);
  material["name"] = "red clay";
  const Reading reading = GltfMaker::with_material(material).read();
  ASSERT_TRUE(reading.scene);
  const grf::Definition definition = definitions_of(*reading.scene).at(0);
  EXPECT_EQ(grf::from_identifier(definition.name), "red clay");
  ASSERT_EQ(definition.comments.before.size(), 2U);
  EXPECT_EQ(definition.comments.before[0], " \"red clay\"");
  EXPECT_EQ(definition.comments.before[1],
            " glTF: baseColorFactor 0.5 0.5 0.5 1; metallicFactor 0; roughnessFactor 1");
}

TEST(GltfMaterial, CommentsHaveAllValuesThatAreRead) {
  const auto values = [](const json& material) {
    const Reading reading = GltfMaker::with_material(material).read();
    if (!reading.scene) throw std::runtime_error(reading.text());
    const grf::Definition definition = definitions_of(*reading.scene).at(0);
    std::string joined;
    for (const std::string& line : definition.comments.before) {
      joined += " " + line.substr(line.find_first_not_of(' '));
    }
    return joined;
  };
  json all = pbr({0.5, 0.25, 0, 0.75}, 0.5, 0.25);
  all["extensions"]["KHR_materials_ior"] = {{"ior", 3}};
  all["extensions"]["KHR_materials_specular"] = {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0, 1}}};
  all["extensions"]["KHR_materials_anisotropy"] = {{"anisotropyStrength", 0.5}, {"anisotropyRotation", 7}};
  all["extensions"]["KHR_materials_clearcoat"] = {{"clearcoatFactor", 0.25}};
  all["extensions"]["KHR_materials_sheen"] = {{"sheenColorFactor", {0, 0.5, 1}}};
  all["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 8}};
  all["emissiveFactor"] = {1, 0.5, 0};
  all["alphaMode"] = "BLEND";
  all["doubleSided"] = true;
  EXPECT_EQ(
      values(all),
      " glTF: baseColorFactor 0.5 0.25 0 0.75; metallicFactor 0.5; roughnessFactor 0.25; ior 3; "
      "specularFactor 0.5; specularColorFactor 1 0 1; anisotropyStrength 0.5; anisotropyRotation 7; "
      "clearcoatFactor 0.25; clearcoatRoughnessFactor 0; sheenColorFactor 0 0.5 1; "
      "sheenRoughnessFactor 0; emissiveFactor 1 0.5 0; emissiveStrength 8; alphaMode BLEND; doubleSided");
  json unlit = pbr({1, 1, 1, 1}, 0, 1);
  unlit["extensions"]["KHR_materials_unlit"] = json::object();
  EXPECT_THAT(values(unlit), HasSubstr("unlit"));
  const json glossy = {{"extensions",
                        {{"KHR_materials_pbrSpecularGlossiness",
                          {{"diffuseFactor", {0.5, 0.25, 0, 1}},
                           {"specularFactor", {0.25, 0.75, 1}},
                           {"glossinessFactor", 0.5}}}}}};
  EXPECT_EQ(values(glossy),
            " glTF: diffuseFactor 0.5 0.25 0 1; specularFactor 0.25 0.75 1; glossinessFactor 0.5");
}

/// A file with three materials by variants: paper, which is the default, wood and, by both others, brass.
GltfMaker with_variants() {
  GltfMaker maker = GltfMaker::triangle();
  maker.json["materials"] = {{{"name", "paper"}}, {{"name", "wood"}}, {{"name", "brass"}}};
  maker.json["extensionsUsed"] = {"KHR_materials_variants"};
  maker.json["extensions"]["KHR_materials_variants"]["variants"] = {
      {{"name", "forest"}}, {{"name", "museum"}}, {{"name", "office"}}};
  maker.primitive()["material"] = 0;
  maker.primitive()["extensions"]["KHR_materials_variants"]["mappings"] = {
      {{"material", 1}, {"variants", {0}}}, {{"material", 2}, {"variants", {1, 2}}}};
  return maker;
}

TEST(GltfVariants, ChooseMaterials) {
  const test::TemporaryFolder folder;
  const std::string path = folder.add("model.gltf", with_variants().gltf());
  const auto material = [&](const std::string& variant) {
    const Reading reading = read_path(path, {{}, variant});
    return reading.scene ? material_of(only_mesh(reading), 0) : reading.text();
  };
  EXPECT_EQ(material(""), "paper");
  EXPECT_EQ(material("forest"), "wood");
  EXPECT_EQ(material("museum"), "brass");
  EXPECT_EQ(material("office"), "brass");
  EXPECT_THAT(material("sea"), HasSubstr("the file has no variant 'sea', only 'forest', 'museum', 'office'"));
  EXPECT_THAT(read_path(path).text(),
              HasSubstr("the file has 3 variants of its materials, 'forest', 'museum', 'office'"));
}

TEST(GltfVariants, AreOfFilesThatHaveThem) {
  const test::TemporaryFolder folder;
  const std::string plain = folder.add("plain.gltf", GltfMaker::triangle().gltf());
  EXPECT_THAT(read_path(plain, {{}, "forest"}).text(),
              HasSubstr("the file has no variants, expected 'forest'"));
  const std::string obj = folder.add("square.obj", SquareVertices + "f 1 2 3 4\n");
  EXPECT_THAT(read_path(obj, {{}, "forest"}).text(),
              HasSubstr("obj files have no variants, expected 'forest'"));
}

// Of the images that extensions name, WebP can be read, and KTX2 cannot.
TEST(GltfMaterial, TexturesOfExtensionsAreTheImagesThatCanBeRead) {
  json material = pbr({1, 1, 1, 1}, 0, 1);
  material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  const auto reading_of = [&](const json& texture) {
    GltfMaker maker = GltfMaker::with_material(material);
    maker.json["textures"][0] = texture;
    maker.json["images"].push_back({{"uri", "wood.webp"}});
    maker.json["images"].push_back({{"uri", "wood.ktx2"}});
    return maker.read();
  };
  const json webp = {{"EXT_texture_webp", {{"source", 1}}}};
  const json basisu = {{"KHR_texture_basisu", {{"source", 2}}}};
  const auto file_of = [](const Reading& reading) {
    return std::get<grf::Texture>(meshes_of(*reading.scene).at(0).surface(0).texture.value()).file;
  };
  EXPECT_EQ(file_of(reading_of({{"extensions", webp}})), "wood.webp");
  EXPECT_EQ(file_of(reading_of({{"source", 0}, {"extensions", basisu}})), "wood a.png");
  const Reading lost = reading_of({{"extensions", basisu}});
  ASSERT_TRUE(lost.scene);
  EXPECT_FALSE(meshes_of(*lost.scene).at(0).surface(0).texture.has_value());
  EXPECT_NE(lost.text().find("1 face lost its texture"), std::string::npos) << lost.text();
}

TEST(GltfMaterial, TheBaseColoursTextureMultiplies) {
  json material = pbr({1, 1, 1, 1}, 0, 1);
  material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 1}};
  const Reading reading = GltfMaker::with_material(material).read();
  ASSERT_TRUE(reading.scene);
  const grf::Mesh mesh = meshes_of(*reading.scene).at(0);
  EXPECT_EQ(std::get<grf::Texture>(mesh.surface(0).texture.value()).file, "wood a.png");
  EXPECT_THAT(reading.text(), HasSubstr("1 face lost the wrap mode of its texture"));
}

TEST(GltfMaterial, EmissionIsRadiance) {
  json material = {{"emissiveFactor", {1, 0.5, 0}},
                   {"doubleSided", true},
                   {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}}};
  Reading reading = GltfMaker::with_material(material).read();
  ASSERT_TRUE(reading.scene);
  EXPECT_EQ(meshes_of(*reading.scene).at(0).surface(0).emission, grf::Colour(8, 4, 0));
  EXPECT_THAT(reading.text(), HasSubstr("1 face lost the emission of its back"));
  material["emissiveTexture"] = {{"index", 0}};
  reading = GltfMaker::with_material(material).read();
  EXPECT_FALSE(meshes_of(*reading.scene).at(0).surface(0).emission.has_value());
  EXPECT_THAT(reading.text(), HasSubstr("1 face lost its map of emission"));
}

TEST(GltfMaterial, WhatIsLostIsSaid) {
  json material = pbr({1, 1, 1, 1}, 0, 1);
  for (const char* map : {"normalTexture", "occlusionTexture"}) material[map] = {{"index", 0}};
  for (const char* extension : {"dispersion", "diffuse_transmission"}) {
    material["extensions"][std::string("KHR_materials_") + extension] = {{"a", 1}};
  }
  const Reading reading = GltfMaker::with_material(material).read();
  EXPECT_TRUE(reading.scene);
  for (const char* said : {"its normal map", "its occlusion map",
                           "1 face lost what KHR_materials_diffuse_transmission says of their material",
                           "what KHR_materials_dispersion says"}) {
    EXPECT_THAT(reading.text(), HasSubstr(said));
  }
}

/// The opacity of a face whose base colour has an alpha of 0.5, and its texture if there is one.
std::string opacity_of(const json& alpha, bool has_texture) {
  json material = pbr({1, 1, 1, 0.5}, 0, 1);
  if (has_texture) material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  material.update(alpha);
  GltfMaker maker = GltfMaker::with_material(material);
  maker.json["images"] = {{{"uri", "leaf.png"}}};
  maker.json["textures"] = {{{"source", 0}}};
  const Reading reading = maker.read();
  const std::vector<grf::Mesh> meshes = meshes_of(reading.scene.value());
  const auto& opacity = meshes.at(0).surface(0).opacity;
  return opacity ? grf::to_text(*opacity) : "none";
}

TEST(GltfMaterial, HasAnOpacityByItsAlphaMode) {
  const json blend = {{"alphaMode", "BLEND"}};
  const json mask = {{"alphaMode", "MASK"}};
  const auto cutoff = [&](double value) {
    json of_value = mask;
    of_value["alphaCutoff"] = value;
    return of_value;
  };
  for (const bool has_texture : {false, true}) {
    EXPECT_EQ(opacity_of(json::object(), has_texture), "none") << "alpha counts only with a mode";
    EXPECT_EQ(opacity_of({{"alphaMode", "OPAQUE"}}, has_texture), "none");
    EXPECT_EQ(opacity_of(cutoff(0.75), has_texture), "opacity 0") << "the factor is below";
    EXPECT_EQ(opacity_of(cutoff(0), has_texture), "none");
  }
  EXPECT_EQ(opacity_of(blend, false), "opacity 0.5");
  EXPECT_EQ(opacity_of(blend, true), "opacity blend 0.5");
  EXPECT_EQ(opacity_of(mask, false), "none") << "at the default cutoff of 0.5 it is there";
  EXPECT_EQ(opacity_of(mask, true), "opacity mask 1");
  EXPECT_EQ(opacity_of(cutoff(0.125), true), "opacity mask 0.25");
}

TEST(GltfMaterial, EmbeddedImagesBecomeFiles) {
  GltfMaker maker =
      GltfMaker::with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  const std::string png = "\x89PNG not decoded";
  const int bytes = maker.add(std::vector<char>(png.begin(), png.end()), "SCALAR", 5121);
  maker.json["images"] = {{{"bufferView", bytes}, {"mimeType", "image/jpeg"}, {"name", "../a.PNG"}},
                          {{"uri", "data:image/png;base64,/9j/"}, {"name", "a.png"}}};
  const Reading reading = maker.read();
  ASSERT_TRUE(reading.scene) << reading.text();
  ASSERT_EQ(reading.files.size(), 2U);
  EXPECT_EQ(reading.files[0].name, "_a.png");
  EXPECT_EQ(reading.files[0].bytes, png);
  EXPECT_EQ(reading.files[1].name, "a.png.jpg");
  EXPECT_EQ(std::get<grf::Texture>(*meshes_of(*reading.scene)[0].surface(0).texture).file, "_a.png");
}

grf::BrdfModel model(const std::string& text) {
  grf::Diagnostics diagnostics;
  return grf::read_brdf(text, "test", diagnostics).value();
}

// glTF 2.0, appendix B: a mixture by `metallic` of a metal of the base colour and of a dielectric, whose
// facets reflect 0.04, and let 0.96 through to a diffuse base of the base colour.
TEST(NearestGltf, HasTheReflectancesOfItsLobes) {
  for (const double metallic : {0.0, 0.3, 0.7, 1.0}) {
    for (const double grey : {0.2, 0.5, 0.9}) {
      BrdfLobes lobes;
      lobes.diffuse = grf::Vec3d(0.96 * grey * (1 - metallic));
      lobes.glossy = grf::Vec3d(0.04 * (1 - metallic) + grey * metallic);
      lobes.exponent = 30;
      const GltfBrdf values = nearest_gltf(lobes);
      EXPECT_NEAR(values.metallic, metallic, 1e-9);
      EXPECT_NEAR(values.base.x, grey, 1e-9);
      EXPECT_NEAR(values.roughness, 0.5, 1e-9) << "the root of the slope, which is the root of 2/(30 + 2)";
      EXPECT_EQ(values.specular, 1);
    }
  }
}

// The model's fit of what facets reflect is off by up to 1.5 %.
TEST(GltfMaterial, ConservesEnergy) {
  const grf::Catalogue catalogue = reflectance::catalogue();
  for (const double metallic : {0.0, 0.5, 1.0}) {
    for (const double roughness : {0.0, 0.1, 0.5, 1.0}) {
      const grf::BrdfModel brdf = model(brdf_of(pbr({1, 1, 1, 1}, metallic, roughness)));
      const grf::ModelInfo* info = grf::find_model(catalogue.brdfs, brdf.keyword);
      ASSERT_NE(info, nullptr);
      ASSERT_NE(info->largest_albedo, nullptr);
      EXPECT_LE(info->largest_albedo(brdf).albedo, 1.015F) << brdf.keyword << ' ' << roughness;
    }
  }
}

}  // namespace
}  // namespace convert
