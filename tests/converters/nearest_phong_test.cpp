#include "converters/nearest_phong.h"

#include <cmath>
#include <string>
#include <variant>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/write.h"
#include "renderer/reflectance/scheme.h"

namespace convert {
namespace {

PhongMaterial nearest(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto brdf = grf::read_brdf(text, "test", diagnostics);
  EXPECT_TRUE(brdf.has_value()) << diagnostics.to_text();
  return nearest_phong(*brdf, [](const grf::CombineTerm&) { return nullptr; });
}

/// What the mapping makes of what it gave, as text.
std::string there_and_back(const std::string& text) {
  return grf::to_text(std::get<grf::BrdfModel>(map_material(nearest(text)).definition.body));
}

TEST(NearestPhong, InvertsTheMapping) {
  for (const std::string text :
       {"diffuse kd=(0.1, 0.2, 0.3)", "diffuse kd=0.7", "lewis n=40 ks=0.5 kd=(0.2, 0.3, 0.4)",
        "lewis n=0.5 ks=(0.9, 0.7, 0.1) kd=(0.1, 0.3, 0.4)", "specular ks=(0.9, 0.8, 0.7)"}) {
    EXPECT_EQ(there_and_back(text), text);
  }
}

TEST(NearestPhong, NormalisesThePhongLobe) {
  const PhongMaterial material = nearest("phong n=100 ks=0.4 kd=0.6");
  EXPECT_EQ(*material.exponent, 100);
  EXPECT_NEAR(material.specular.x, 0.4 * 2 * std::acos(-1.0) / 102, 1e-7);
  EXPECT_EQ(material.diffuse, grf::Vec3d(0.6F));
}

TEST(NearestPhong, SharperLobesHaveHigherExponents) {
  for (const auto& [sharp, dull] :
       std::vector<std::pair<std::string, std::string>>{{"ward sx=0.05", "ward sx=0.3"},
                                                        {"blinn n=500", "blinn n=50"},
                                                        {"torrance rough=0.1", "torrance m=0.4"},
                                                        {"ashikhmin nu=1000 nv=1000", "ashikhmin ex=10"},
                                                        {"neumann r=0.05", "neumann r=0.5"},
                                                        {"schlick Sr=0.01", "schlick Sr=0.5"},
                                                        {"strauss s=0.95", "strauss s=0.5"},
                                                        {"he sigma=0.1 tau=5", "he sigma=0.4 tau=2"}}) {
    EXPECT_GT(*nearest(sharp).exponent, *nearest(dull).exponent) << sharp;
  }
}

TEST(NearestPhong, AddsUpASum) {
  grf::BrdfModel diffuse;
  diffuse.keyword = "diffuse";
  diffuse.arguments = {{"kd", 0.8F, {}}};
  grf::BrdfModel shiny;
  shiny.keyword = "lewis";
  shiny.arguments = {{"n", 50.0F, {}}, {"ks", 0.5F, {}}, {"kd", 0.25F, {}}};
  grf::BrdfModel sum;
  sum.keyword = "combine";
  sum.terms = {{0.5F, {"diffuse", {}}}, {0.5F, {"shiny", {}}}, {1.0F, {"unknown", {}}}};
  const PhongMaterial material = nearest_phong(sum, [&](const grf::CombineTerm& term) {
    return term.brdf.name == "diffuse" ? &diffuse : term.brdf.name == "shiny" ? &shiny : nullptr;
  });
  EXPECT_NEAR(material.diffuse.x, 0.525, 1e-6);
  EXPECT_NEAR(material.specular.x, 0.25, 1e-6);
  EXPECT_EQ(*material.exponent, 50);
}

TEST(NearestPhong, StopsAtASumOfItself) {
  grf::BrdfModel sum;
  sum.keyword = "combine";
  sum.terms = {{1.0F, {"itself", {}}}, {1.0F, {"itself", {}}}};
  const PhongMaterial material = nearest_phong(sum, [&](const grf::CombineTerm&) { return &sum; });
  EXPECT_LE(material.diffuse.x, 1);
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
TEST(NearestPhong, KnowsTheDefaultsOfEachModel) {
  std::size_t models = 0;
  for (const grf::ModelInfo& model : reflectance::catalogue().brdfs) {
    if (model.takes != grf::ModelInfo::Takes::Parameters) continue;
    ++models;
    std::string written(model.keyword);
    for (const grf::ParameterInfo& parameter : model.parameters) {
      written += fmt::format(" {}={}", parameter.name, text_of(model, parameter));
    }
    const PhongMaterial by_default = nearest(std::string(model.keyword));
    const PhongMaterial by_value = nearest(written);
    EXPECT_LT((by_default.diffuse - by_value.diffuse).length(), 5e-3) << written;
    EXPECT_LT((by_default.specular - by_value.specular).length(), 5e-3) << written;
    EXPECT_NEAR(by_default.exponent.value_or(0), by_value.exponent.value_or(0),
                1e-3 * by_value.exponent.value_or(0))
        << written;
    EXPECT_EQ(by_default.reflection, by_value.reflection) << written;
    EXPECT_GT((by_default.diffuse + by_default.specular).length(), 0.1) << written;
  }
  EXPECT_GE(models, 20U);
}

}  // namespace
}  // namespace convert
