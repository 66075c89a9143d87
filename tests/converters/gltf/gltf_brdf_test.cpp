// Tests of the BRDF `gltf` in glTF files: what is read of each extension, written, and read back.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/write.h"
#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/scheme.h"
#include "tests/converters/gltf/gltf_brdf_files.h"

namespace convert {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(GltfBrdf, HasTheIndexOfRefraction) {
  EXPECT_EQ(clean_brdf_of(dielectric({{"ior", {{"ior", 1.33}}}})), "gltf ior=1.33");
  EXPECT_EQ(clean_brdf_of(dielectric({{"ior", {{"ior", 1}}}})), "gltf ior=1");
  EXPECT_EQ(clean_brdf_of(dielectric({{"ior", {{"ior", 1.5}}}})), "gltf");
  EXPECT_EQ(clean_brdf_of(dielectric({{"ior", json::object()}})), "gltf");
}

// KHR_materials_specular: F0 = min(((ior - 1)/(ior + 1))^2 specularColor, 1) specular, where an ior of 0
// makes the square 1. At the BRDF's default of 1.5 the square is 1/25.
TEST(GltfBrdf, HasIndicesThatAreOutOfItsRangeInItsColour) {
  const auto brdf = [](const json& ior, const json& colour) {
    return clean_brdf_of(
        dielectric({{"ior", {{"ior", ior}}}, {"specular", {{"specularColorFactor", colour}}}}));
  };
  EXPECT_EQ(brdf(0, {1, 1, 1}), "gltf specularColor=25");
  EXPECT_EQ(brdf(0, {0.5, 0.25, 4}), "gltf specularColor=(12.5, 6.25, 25)");
  EXPECT_EQ(brdf(19, {0.5, 0.5, 0.5}), "gltf specularColor=10.125") << "25/2 (18/20)^2";
  EXPECT_EQ(brdf(1e300, {1, 1, 1}), "gltf specularColor=25");
  EXPECT_EQ(brdf(1.25, {81, 40.5, 0}), "gltf specularColor=(25, 12.5, 0)") << "the square is 1/81";
}

TEST(GltfBrdf, HasTheSpecularFactorAndColour) {
  EXPECT_EQ(clean_brdf_of(dielectric({{"specular", {{"specularFactor", 0.25}}}})), "gltf specular=0.25");
  EXPECT_EQ(clean_brdf_of(dielectric({{"specular", {{"specularColorFactor", {0, 0.5, 2}}}}})),
            "gltf specularColor=(0, 0.5, 2)");
  EXPECT_EQ(clean_brdf_of(dielectric({{"specular", json::object()}})), "gltf");
}

TEST(GltfBrdf, WithoutSpecularReflectionIsDiffuse) {
  const json none = {{"specularFactor", 0}};
  EXPECT_EQ(clean_brdf_of(dielectric({{"specular", none}})), "diffuse kd=1");
  EXPECT_EQ(clean_brdf_of(dielectric({{"specular", none}, {"clearcoat", {{"clearcoatFactor", 1}}}})),
            "gltf specular=0 clearcoat=1");
  EXPECT_EQ(clean_brdf_of(dielectric({{"specular", none}, {"sheen", {{"sheenColorFactor", {1, 1, 1}}}}})),
            "gltf specular=0 sheenColor=1 sheenRoughness=0.01");
  json metal = dielectric({{"specular", none}});
  metal["pbrMetallicRoughness"]["metallicFactor"] = 0.5;
  EXPECT_EQ(clean_brdf_of(metal), "gltf metallic=0.5 specular=0");
  EXPECT_EQ(clean_brdf_of(dielectric({{"specular", {{"specularColorFactor", {0, 0, 0}}}}})),
            "gltf specularColor=0")
      << "it reflects at grazing";
}

TEST(GltfBrdf, HasTheAnisotropyAndItsDirection) {
  const auto brdf = [](double strength, double rotation) {
    return clean_brdf_of(
        dielectric({{"anisotropy", {{"anisotropyStrength", strength}, {"anisotropyRotation", rotation}}}}));
  };
  EXPECT_EQ(brdf(0.5, 0.25), "gltf anisotropy=0.5 rotation=0.25");
  EXPECT_EQ(brdf(1, -0.75), "gltf anisotropy=1 rotation=-0.75");
  EXPECT_EQ(brdf(0.5, 1.5 + 4 * std::numbers::pi), "gltf anisotropy=0.5 rotation=1.5") << "whole turns";
  EXPECT_EQ(brdf(0, 0.25), "gltf") << "a direction without anisotropy means nothing";
  EXPECT_EQ(clean_brdf_of(dielectric({{"anisotropy", json::object()}})), "gltf");
}

TEST(GltfBrdf, HasTheClearCoat) {
  EXPECT_EQ(clean_brdf_of(
                dielectric({{"clearcoat", {{"clearcoatFactor", 0.75}, {"clearcoatRoughnessFactor", 0.25}}}})),
            "gltf clearcoat=0.75 coatRoughness=0.25");
  EXPECT_EQ(clean_brdf_of(dielectric({{"clearcoat", {{"clearcoatFactor", 1}}}})), "gltf clearcoat=1");
  EXPECT_EQ(clean_brdf_of(dielectric({{"clearcoat", {{"clearcoatRoughnessFactor", 0.25}}}})), "gltf");
}

TEST(GltfBrdf, HasTheSheen) {
  EXPECT_EQ(clean_brdf_of(
                dielectric({{"sheen", {{"sheenColorFactor", {0.5, 0, 1}}, {"sheenRoughnessFactor", 0.75}}}})),
            "gltf sheenColor=(0.5, 0, 1) sheenRoughness=0.75");
  EXPECT_EQ(clean_brdf_of(
                dielectric({{"sheen", {{"sheenColorFactor", {1, 1, 1}}, {"sheenRoughnessFactor", 0.3}}}})),
            "gltf sheenColor=1");
  EXPECT_EQ(clean_brdf_of(dielectric({{"sheen", {{"sheenColorFactor", {1, 1, 1}}}}})),
            "gltf sheenColor=1 sheenRoughness=0.01")
      << "the file's default is 0";
  EXPECT_EQ(clean_brdf_of(dielectric({{"sheen", {{"sheenRoughnessFactor", 0.75}}}})), "gltf");
}

TEST(GltfBrdf, HasTheFilm) {
  EXPECT_EQ(clean_brdf_of(dielectric({{"iridescence",
                                       {{"iridescenceFactor", 0.5},
                                        {"iridescenceIor", 1.5},
                                        {"iridescenceThicknessMinimum", 50},
                                        {"iridescenceThicknessMaximum", 250}}}})),
            "gltf iridescence=0.5 iridescenceIor=1.5 filmThickness=250");
  EXPECT_EQ(clean_brdf_of(dielectric({{"iridescence", {{"iridescenceFactor", 1}}}})), "gltf iridescence=1")
      << "with the defaults of the file";
  EXPECT_EQ(clean_brdf_of(dielectric({{"iridescence", {{"iridescenceIor", 2}}}})), "gltf");
}

// glTF 2.0 and its extensions have these ranges.
TEST(GltfBrdf, HasValuesOutOfRangeClamped) {
  json wild = dielectric({{"ior", {{"ior", 0.5}}},
                          {"specular", {{"specularFactor", -1}, {"specularColorFactor", {-1, 1, 2}}}},
                          {"anisotropy", {{"anisotropyStrength", 2}}},
                          {"clearcoat", {{"clearcoatFactor", 1e300}, {"clearcoatRoughnessFactor", -3}}},
                          {"sheen", {{"sheenColorFactor", {2, -1, 0.5}}, {"sheenRoughnessFactor", 4}}}});
  wild["pbrMetallicRoughness"] = {
      {"baseColorFactor", {-1, 0.5, 3, 1}}, {"metallicFactor", 7}, {"roughnessFactor", -0.5}};
  const Reading reading = read_material(wild);
  EXPECT_EQ(grf::to_text(model_of(reading)),
            "gltf baseColor=(0, 0.5, 1) metallic=1 roughness=0 ior=1 specular=0 specularColor=(0, 1, 2) "
            "anisotropy=1 clearcoat=1 sheenColor=(1, 0, 0.5) sheenRoughness=1");
  EXPECT_THAT(reading.text(), HasSubstr("values of materials are out of range, and were clamped"));
  const json coarse =
      dielectric({{"sheen", {{"sheenColorFactor", {1, 1, 1}}, {"sheenRoughnessFactor", -1}}}});
  EXPECT_THAT(read_material(coarse).text(), HasSubstr("out of range"));
}

TEST(GltfBrdf, HasDefaultsForWhatIsNoNumber) {
  json wrong = dielectric({{"ior", {{"ior", "glass"}}},
                           {"specular", {{"specularFactor", "NaN"}, {"specularColorFactor", {1, 1}}}},
                           {"anisotropy", {{"anisotropyStrength", nullptr}}},
                           {"clearcoat", {{"clearcoatFactor", true}}},
                           {"sheen", {{"sheenColorFactor", {"red", "NaN", "Infinity"}}}}});
  EXPECT_EQ(clean_brdf_of(wrong), "gltf");
  wrong["pbrMetallicRoughness"] = {
      {"baseColorFactor", {"NaN", 1, 1}}, {"metallicFactor", "NaN"}, {"roughnessFactor", nullptr}};
  EXPECT_EQ(clean_brdf_of(wrong), "gltf metallic=1 roughness=1");
}

const std::vector<std::string>& brdfs() {
  static const std::vector<std::string> texts = {
      "gltf",
      "gltf baseColor=(0.8, 0.25, 0.1) metallic=0.25 roughness=0.35",
      "gltf metallic=1 roughness=0",
      "gltf ior=1.33",
      "gltf ior=10",
      "gltf specular=0.4",
      "gltf specularColor=(0, 0.3, 25)",
      "gltf specular=0 clearcoat=1",
      "gltf anisotropy=0.7",
      "gltf anisotropy=0.7 rotation=0.3",
      "gltf anisotropy=0.7 rotation=-1.2",
      "gltf anisotropy=1 rotation=3.1415927",
      "gltf clearcoat=0.6",
      "gltf clearcoat=0.6 coatRoughness=0.2",
      "gltf sheenColor=(0.1, 0.2, 0.3)",
      "gltf sheenColor=(0.1, 0.2, 0.3) sheenRoughness=0.01",
      "gltf iridescence=0.7",
      "gltf metallic=1 iridescence=1 iridescenceIor=1.77 filmThickness=312.5",
      "gltf baseColor=0.5 metallic=0.3 roughness=0.7 ior=1.8 specular=0.9 specularColor=(0.7, 0.8, 0.9) "
      "anisotropy=0.4 rotation=1.1 clearcoat=0.2 coatRoughness=0.1 sheenColor=0.3 sheenRoughness=0.6",
  };
  return texts;
}

TEST(GltfBrdf, IsReadBackWithoutExtras) {
  for (const std::string& text : brdfs()) {
    const Reading reading = read_bare(written("brdf " + text));
    EXPECT_EQ(grf::to_text(model_of(reading)), text);
    EXPECT_THAT(reading.text(), IsEmpty()) << text;
  }
}

TEST(GltfBrdf, IsReadBackByItsOtherNames) {
  EXPECT_EQ(grf::to_text(model_of(read_bare(written("brdf GLTF clearcoat=0.5 ClearcoatRoughness=0.25")))),
            "gltf clearcoat=0.5 coatRoughness=0.25");
}

TEST(GltfBrdf, UsesTheExtensionsOfItsValuesAlone) {
  EXPECT_FALSE(written("brdf gltf metallic=1 roughness=0.25").contains("extensionsUsed"));
  const std::vector<std::pair<std::string, std::string>> expected = {{"ior=2", "ior"},
                                                                     {"specular=0.5", "specular"},
                                                                     {"specularColor=0.5", "specular"},
                                                                     {"anisotropy=0.5", "anisotropy"},
                                                                     {"clearcoat=0.5", "clearcoat"},
                                                                     {"sheenColor=0.5", "sheen"},
                                                                     {"iridescence=0.5", "iridescence"}};
  for (const auto& [argument, extension] : expected) {
    const json file = written("brdf gltf " + argument);
    EXPECT_EQ(file["extensionsUsed"], json::array({"KHR_materials_" + extension})) << argument;
    EXPECT_EQ(file["materials"][0]["extensions"].size(), 1U) << argument;
  }
  EXPECT_FALSE(written("brdf gltf rotation=1 coatRoughness=0.5 sheenRoughness=0.5 filmThickness=90")
                   .contains("extensionsUsed"))
      << "values without an effect";
}

TEST(GltfBrdf, HasTheColourOfTheFaceInItsBase) {
  const Reading reading = read_bare(written("rgb (0.5, 1, 4) brdf gltf baseColor=(0.5, 0.25, 0.5) ior=2"));
  EXPECT_EQ(grf::to_text(model_of(reading)), "gltf baseColor=(0.25, 0.25, 1) ior=2");
}

// The BRDF in the extras of a material is used as it is written there, as long as all values are its own.
TEST(GltfBrdf, InExtrasIsUsedUnlessAValueOfItsMaterialChanged) {
  const std::string text =
      "gltf rotation=0.5 coatRoughness=0.5 roughness=0.3 ior=1.8 specular=0.9 specularColor=0.7 "
      "anisotropy=0.4 clearcoat=0.2 sheenColor=0.3 sheenRoughness=0.6 iridescence=0.5 filmThickness=123.4567";
  const json file = written("brdf " + text);
  const Reading same = read_bare(file, true);
  EXPECT_EQ(grf::to_text(model_of(same)), text) << "in its order of arguments";
  EXPECT_THAT(same.text(), IsEmpty());
  const std::vector<std::pair<std::string, std::string>> values = {
      {"ior", "ior"},
      {"specular", "specularFactor"},
      {"anisotropy", "anisotropyStrength"},
      {"anisotropy", "anisotropyRotation"},
      {"clearcoat", "clearcoatFactor"},
      {"clearcoat", "clearcoatRoughnessFactor"},
      {"sheen", "sheenRoughnessFactor"},
      {"iridescence", "iridescenceFactor"},
      {"iridescence", "iridescenceIor"},
      {"iridescence", "iridescenceThicknessMaximum"}};
  for (const auto& [extension, value] : values) {
    json changed = file;
    json& number = changed["materials"][0]["extensions"]["KHR_materials_" + extension][value];
    number = number.get<double>() * 0.99;
    const Reading reading = read_bare(changed, true);
    EXPECT_THAT(reading.text(), HasSubstr("1 material was changed")) << value;
    EXPECT_NE(grf::to_text(model_of(reading)), text) << value;
  }
  for (const std::string extension : {"ior", "specular", "anisotropy", "clearcoat", "sheen", "iridescence"}) {
    json without = file;
    without["materials"][0]["extensions"].erase("KHR_materials_" + extension);
    EXPECT_THAT(read_bare(without, true).text(), HasSubstr("1 material was changed")) << extension;
  }
  json unlit = file;
  unlit["materials"][0]["extensions"]["KHR_materials_unlit"] = json::object();
  EXPECT_EQ(grf::to_text(model_of(read_bare(unlit, true))), "diffuse kd=1");
}

// What the renderer makes of materials that are read.

using reflectance::Vec3f;

Vec3f direction(double theta, double phi) {
  return {static_cast<float>(std::sin(theta) * std::cos(phi)),
          static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta))};
}

reflectance::Rgb reflectance_of(const json& material, const Vec3f& u, const Vec3f& v) {
  const auto brdf = reflectance::make_brdf(model_of(read_material(material)));
  if (!brdf) throw std::runtime_error("no BRDF");
  return evaluate(*brdf, u, v);
}

TEST(GltfBrdf, OfADielectricWithoutSpecularReflectionIsLambertian) {
  json material = dielectric({{"specular", {{"specularFactor", 0}}}});
  material["pbrMetallicRoughness"]["baseColorFactor"] = {0.8, 0.4, 0.2, 1};
  const reflectance::Rgb f = reflectance_of(material, direction(0.3, 0.4), direction(1.1, 2));
  EXPECT_NEAR(f.x, 0.8 / std::numbers::pi, 1e-6);
  EXPECT_NEAR(f.y, 0.4 / std::numbers::pi, 1e-6);
  EXPECT_NEAR(f.z, 0.2 / std::numbers::pi, 1e-6);
}

/// KHR_materials_anisotropy, for u = v in the direction h, where Fresnel's factor is that of normal
/// incidence: F0 D G/(4 cos^2) with D of GGX, and G of Smith with correlated heights.
double aligned_facets(double f0, double along, double across, double theta, double phi) {
  const double x = std::sin(theta) * std::cos(phi);
  const double y = std::sin(theta) * std::sin(phi);
  const double z = std::cos(theta);
  const double stretched = (x / along) * (x / along) + (y / across) * (y / across) + z * z;
  const double distribution = 1 / (std::numbers::pi * along * across * stretched * stretched);
  const double slope = (along * x * along * x + across * y * across * y) / (z * z);
  const double masking = 1 / std::sqrt(1 + slope);
  return f0 * distribution * masking / (4 * z * z);
}

// A black dielectric has facets alone; at alpha = 0.01 what they scatter to each other is under 1e-4 of
// F0/pi.
TEST(GltfBrdf, OfAnAnisotropicDielectricIsItsClosedForm) {
  const double rotation = 0.6;
  const double strength = 0.1;
  json material =
      dielectric({{"ior", {{"ior", 1.8}}},
                  {"specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 2, 0.5}}}},
                  {"anisotropy", {{"anisotropyStrength", strength}, {"anisotropyRotation", rotation}}}});
  material["pbrMetallicRoughness"] = {
      {"baseColorFactor", {0, 0, 0, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 0.1}};
  const double across = 0.1 * 0.1;
  const double along = across + (1 - across) * strength * strength;
  const double f0 = 0.5 * (0.8 / 2.8) * (0.8 / 2.8);
  for (const double phi : {rotation, rotation + 1.57, 0.1, -0.6}) {
    const Vec3f u = direction(0.02, phi);
    const reflectance::Rgb f = reflectance_of(material, u, u);
    const double expected = aligned_facets(f0, along, across, 0.02, phi - rotation);
    EXPECT_NEAR(f.x / expected, 1, 2e-3) << phi;
    EXPECT_NEAR(f.y / expected, 2, 4e-3) << phi;
    EXPECT_NEAR(f.z / expected, 0.5, 1e-3) << phi;
  }
}

// The coat on a black dielectric without specular reflection reflects 0.04 at normal incidence, alone.
TEST(GltfBrdf, OfAClearCoatIsItsClosedForm) {
  json material = dielectric({{"specular", {{"specularFactor", 0}}},
                              {"clearcoat", {{"clearcoatFactor", 0.75}, {"clearcoatRoughnessFactor", 0.4}}}});
  material["pbrMetallicRoughness"]["baseColorFactor"] = {0, 0, 0, 1};
  for (const double theta : {0.0, 0.1, 0.4}) {
    const Vec3f u = direction(theta, 0);
    const double expected = 0.75 * aligned_facets(0.04, 0.16, 0.16, theta, 0);
    EXPECT_NEAR(reflectance_of(material, u, u).x / expected, 1, 1e-4) << theta;
  }
}

// glTF 2.0, appendix B: a metal's reflectance is its base colour, and Schlick's approximation leads to white.
TEST(GltfBrdf, OfASmoothMetalReflectsItsColour) {
  const json material = {
      {"pbrMetallicRoughness", {{"baseColorFactor", {0.9, 0.6, 0.3, 1}}, {"roughnessFactor", 0.1}}}};
  const Vec3f u = direction(0.5, 0.3);
  const reflectance::Rgb f = reflectance_of(material, u, direction(0.5, 0.3 + std::numbers::pi));
  const double schlick = std::pow(1 - std::cos(0.5), 5);
  EXPECT_NEAR(f.y / f.x, (0.6 + 0.4 * schlick) / (0.9 + 0.1 * schlick), 1e-4);
  EXPECT_NEAR(f.z / f.x, (0.3 + 0.7 * schlick) / (0.9 + 0.1 * schlick), 1e-4);
}

// KHR_materials_iridescence: the film is between air and a dielectric of the same reflectance. Where it is a
// quarter of a wavelength thick, both reflections differ by half a wave (Born and Wolf, "Principles of
// Optics", 1.6).
TEST(GltfBrdf, OfAFilmReflectsLessWhereWavesCancel) {
  json material = {
      {"pbrMetallicRoughness", {{"baseColorFactor", {0.16, 0.16, 0.16, 1}}, {"roughnessFactor", 0.1}}}};
  const Vec3f u = direction(0.02, 0);
  const double bare = reflectance_of(material, u, u).y;
  const double film = 1.5;
  const double base = (1 + 0.4) / (1 - 0.4);  // the index of refraction whose reflectance is 0.16
  material["extensions"]["KHR_materials_iridescence"] = {
      {"iridescenceFactor", 1}, {"iridescenceIor", film}, {"iridescenceThicknessMaximum", 545 / film / 4}};
  const double cancelled = std::pow((film * film - base) / (film * film + base), 2);
  // Green has other wavelengths, too, which cancel less.
  EXPECT_NEAR(reflectance_of(material, u, u).y / bare * 0.16, cancelled, 0.004);
}

// Converters know no catalogue, so that they have names, defaults and ranges a second time.
TEST(GltfBrdf, HasTheParametersOfTheModel) {
  const grf::Catalogue catalogue = reflectance::catalogue();
  const grf::ModelInfo* info = grf::find_model(catalogue.brdfs, "gltf");
  ASSERT_NE(info, nullptr);
  EXPECT_EQ(info->parameters.size(), 15U);
  std::string defaults = "gltf";
  for (const grf::ParameterInfo& parameter : info->parameters) {
    defaults += fmt::format(" {}={}", parameter.name, parameter.default_value);
  }
  EXPECT_EQ(grf::to_text(model_of(read_bare(written("brdf " + defaults)))), "gltf");
  for (const grf::ParameterInfo& parameter : info->parameters) {
    for (const float limit : {parameter.minimum, parameter.maximum}) {
      // With all layers, each value has an effect.
      std::string expected = "gltf";
      for (const grf::ParameterInfo& other : info->parameters) {
        const bool is_needed = other.name == "anisotropy" || other.name == "clearcoat" ||
                               other.name == "sheenColor" || other.name == "iridescence";
        if (other.name == parameter.name) {
          if (limit != parameter.default_value) expected += fmt::format(" {}={}", other.name, limit);
        } else if (is_needed) {
          expected += fmt::format(" {}=0.5", other.name);
        }
      }
      std::vector<std::string> names(parameter.aliases.begin(), parameter.aliases.end());
      names.emplace_back(parameter.name);
      for (const std::string& name : names) {
        std::string asked = expected;
        const std::size_t at = asked.find(fmt::format(" {}=", parameter.name));
        if (at != std::string::npos) asked.replace(at + 1, parameter.name.size(), name);
        EXPECT_EQ(grf::to_text(model_of(read_bare(written("brdf " + asked)))), expected) << asked;
      }
    }
  }
}

}  // namespace
}  // namespace convert
