#include "converters/brdf_lobes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "converters/material_mapping.h"
#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/visit.h"
#include "grf/write.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/scheme.h"

namespace convert {
namespace {

grf::BrdfModel model(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto brdf = grf::read_brdf(text, "test", diagnostics);
  EXPECT_TRUE(brdf.has_value()) << diagnostics.to_text();
  return brdf.value_or(grf::BrdfModel());
}

BrdfLobes lobes_of(const std::string& text) { return brdf_lobes(model(text)); }
PhongMaterial phong_of(const std::string& text) { return phong_material(lobes_of(text)); }

TEST(PhongMaterials, InvertTheMapping) {
  for (const std::string text :
       {"diffuse kd=(0.1, 0.2, 0.3)", "diffuse kd=0.7", "lewis n=40 ks=0.5 kd=(0.2, 0.3, 0.4)",
        "lewis n=0.5 ks=(0.9, 0.7, 0.1) kd=(0.1, 0.3, 0.4)", "specular ks=(0.9, 0.8, 0.7)"}) {
    EXPECT_EQ(grf::to_text(std::get<grf::BrdfModel>(map_material(phong_of(text)).definition.body)), text);
  }
}

TEST(PhongMaterials, HaveALobeAboutTheMirrorDirection) {
  EXPECT_EQ(phong_of("lewis n=100").exponent, 100);
  EXPECT_EQ(phong_of("phong n=100").exponent, 100);
  EXPECT_EQ(phong_of("blinn n=100").exponent, 25) << "the half vector turns half as fast";
  EXPECT_NEAR(phong_of("ward sx=0.1").exponent.value_or(0), 49.5, 1e-4);
  EXPECT_EQ(phong_of("specular").reflection, Reflection::Mirror);
  EXPECT_EQ(phong_of("ward ks=0").reflection, Reflection::None);
}

TEST(BrdfLobes, AreAsWideAsTheLobe) {
  for (const auto& [sharp, dull] :
       std::vector<std::pair<std::string, std::string>>{{"ward sx=0.05", "ward sx=0.3"},
                                                        {"blinn n=500", "blinn n=50"},
                                                        {"torrance rough=0.1", "torrance m=0.4"},
                                                        {"ashikhmin nu=1000 nv=1000", "ashikhmin ex=10"},
                                                        {"neumann r=0.05", "neumann r=0.5"},
                                                        {"schlick Sr=0.01", "schlick Sr=0.5"},
                                                        {"strauss s=0.95", "strauss s=0.5"},
                                                        {"he sigma=0.1 tau=5", "he sigma=0.4 tau=2"}}) {
    EXPECT_GT(lobes_of(sharp).exponent, lobes_of(dull).exponent) << sharp;
  }
}

/// Returns the lobes of the last definition, a BRDF called `sum`.
BrdfLobes lobes_of_sum(const std::string& definitions) {
  grf::Diagnostics diagnostics;
  const auto scene =
      grf::read_text(definitions + " begin begin mesh brdf sum begin vertexs end begin faces end end end",
                     "scene.grf", diagnostics);
  EXPECT_TRUE(scene) << diagnostics.to_text();
  BrdfLobes lobes;
  grf::SceneVisitor visitor;
  visitor.mesh = [&lobes](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    const grf::ResolvedSurface surface = grf::resolve(mesh.surfaces[0], placement.scope);
    lobes = brdf_lobes(*surface.brdf, surface.brdf_scope);
  };
  if (scene) grf::visit(*scene, visitor);
  return lobes;
}

TEST(BrdfLobes, OfASumAddUp) {
  const BrdfLobes lobes = lobes_of_sum(
      "def matte = brdf diffuse kd=0.8 shiny = brdf lewis n=50 ks=0.5 kd=0.25 "
      "sum = brdf combine 0.5 matte, 0.5 shiny");
  EXPECT_NEAR(lobes.diffuse.x, 0.525, 1e-6);
  EXPECT_NEAR(lobes.glossy.x, 0.25, 1e-6);
  EXPECT_EQ(lobes.exponent, 200);
}

TEST(BrdfLobes, OfSumsOfSumsAddUpHoweverLongTheirChainIs) {
  std::string definitions = "def c0 = brdf lewis n=50 ks=0.5 kd=0.25";
  for (int i = 1; i <= 20'000; ++i) {
    definitions += " c" + std::to_string(i) + " = brdf combine 1 c" + std::to_string(i - 1);
  }
  const BrdfLobes lobes = lobes_of_sum(definitions + " sum = brdf combine 0.5 c20000");
  EXPECT_NEAR(lobes.diffuse.x, 0.125, 1e-6);
  EXPECT_NEAR(lobes.glossy.x, 0.25, 1e-6);
  EXPECT_EQ(lobes.exponent, 200);
}

TEST(BrdfLobes, OfNamesThatMeanNothingAreNone) {
  grf::BrdfModel sum;
  sum.keyword = "combine";
  sum.terms = {{1.0F, {"unknown", {}}}};
  EXPECT_EQ(brdf_lobes(sum, {}).diffuse, grf::Vec3d(0));
}

TEST(BrdfLobes, OfAnUnknownModelAreMatteGrey) {
  EXPECT_EQ(lobes_of("nosuchmodel").diffuse, grf::Vec3d(0.5));
  EXPECT_EQ(lobes_of("measured \"a.binary\"").glossy, grf::Vec3d(0));
}

/// The lobes match the albedo of the models at normal incidence, except for masking-shadowing losses of wide
/// lobes and grooves.
TEST(BrdfLobes, ReflectTogetherWhatTheModelDoes) {
  std::vector<std::string> texts = {"schlick Sr=0.01",
                                    "schlick Sr=0.01 Ly=true Dr=0.01",
                                    "strauss m=1 s=0.8 kd=(0.9, 0.5, 0.1)",
                                    "coupled R0=0.3",
                                    "ward sx=0.05 sy=0.2",
                                    "torrance nreal=0.617 nimag=2.63",
                                    "granier m=500 ks=0",
                                    "granier m=500 d=1000000",
                                    "granier kt=0",
                                    "hanrahan depth=1 g=-0.2",
                                    "poulin d=0",
                                    "ashikhmin ex=400"};
  for (const BrdfRule& rule : brdf_rules()) {
    const bool is_wide = rule.keyword == "ashikhmin" || rule.keyword == "schlick" ||
                         rule.keyword == "granier" || rule.keyword == "poulin";
    const bool is_layered = !grf::layer_names(rule.keyword).empty();  // it has no meaning without its base
    if (!is_wide && !is_layered) texts.emplace_back(rule.keyword);
  }
  for (const std::string& text : texts) {
    const grf::BrdfModel brdf = model(text);
    const auto made = reflectance::make_brdf(brdf);
    ASSERT_TRUE(made.has_value()) << text;
    const reflectance::Reflector reflector(*made, reflectance::OwnScheme());
    const reflectance::Rgb albedo = reflectance::albedo(reflector, {0, 0, 1});
    const BrdfLobes lobes = brdf_lobes(brdf);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(lobes.diffuse[i] + lobes.glossy[i], static_cast<double>(albedo[i]), 0.06) << text;
    }
  }
}

std::string text_of(const grf::ModelInfo& model, const grf::ParameterInfo& parameter) {
  if (parameter.kind == grf::ParameterKind::Boolean) return parameter.default_value != 0 ? "true" : "false";
  if (parameter.kind == grf::ParameterKind::Word) {
    return std::string(parameter.choices[static_cast<std::size_t>(parameter.default_value)]);
  }
  if (parameter.default_rgb) {
    const grf::Colour& c = *parameter.default_rgb;
    return fmt::format("({}, {}, {})", c.x, c.y, c.z);
  }
  if (parameter.default_from.empty()) return fmt::format("{}", parameter.default_value);
  return text_of(model, *model.find(parameter.default_from));
}

/// Defaults are written down a second time here, since converters know no catalogue.
TEST(BrdfLobes, KnowTheDefaultsOfEachModel) {
  std::size_t models = 0;
  for (const grf::ModelInfo& model : reflectance::catalogue().brdfs) {
    if (model.argument_kind != grf::ModelInfo::ArgumentKind::Parameters) continue;
    ++models;
    std::string written(model.keyword);
    for (const grf::ParameterInfo& parameter : model.parameters) {
      written += fmt::format(" {}={}", parameter.name, text_of(model, parameter));
    }
    const BrdfLobes by_default = lobes_of(std::string(model.keyword));
    const BrdfLobes by_value = lobes_of(written);
    EXPECT_LT((by_default.diffuse - by_value.diffuse).length(), 5e-3) << written;
    EXPECT_LT((by_default.glossy - by_value.glossy).length(), 5e-3) << written;
    EXPECT_TRUE(by_default.exponent == by_value.exponent ||
                std::abs(by_default.exponent - by_value.exponent) < 1e-3 * by_value.exponent)
        << written;
    const bool is_known = std::any_of(brdf_rules().begin(), brdf_rules().end(), [&](const BrdfRule& rule) {
      return grf::same_keyword(rule.keyword, model.keyword);
    });
    EXPECT_TRUE(is_known) << model.keyword;
  }
  EXPECT_GE(models, 20U);
}

}  // namespace
}  // namespace convert
