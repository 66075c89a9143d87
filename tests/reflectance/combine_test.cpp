// Weighted sums of BRDFs, and BrdfMaker.
#include <string>

#include <gtest/gtest.h>

#include "grf/check.h"
#include "grf/read.h"
#include "grf/visit.h"
#include "renderer/reflectance/brdf_maker.h"
#include "tests/reflectance/brdf_cases.h"

namespace {

using reflectance::Brdf;
using reflectance::Combine;
using reflectance::Rgb;
using reflectance::Vec3f;

/// Returns the BRDF of a mesh in a scene with those definitions.
std::optional<Brdf> brdf_in(const std::string& definitions, const std::string& attribute,
                            grf::Diagnostics& diagnostics) {
  const auto scene = test::scene_with(definitions, attribute, diagnostics);
  return scene ? test::brdf_in(*scene, diagnostics) : std::nullopt;
}

Brdf brdf_in(const std::string& definitions, const std::string& attribute) {
  grf::Diagnostics diagnostics;
  const auto brdf = brdf_in(definitions, attribute, diagnostics);
  if (!brdf) throw std::runtime_error(diagnostics.to_text());
  return *brdf;
}

TEST(Combine, IsTheWeightedSum) {
  const Brdf sum =
      brdf_in("def a = brdf diffuse kd=0.6 b = brdf phong n=10 ks=0.3 kd=0", "combine 0.25 a, 2 b");
  const Brdf a = test::brdf_of("diffuse kd=0.6");
  const Brdf b = test::brdf_of("phong n=10 ks=0.3 kd=0");
  for (const test::Pair& pair : test::direction_pairs(1000, 1)) {
    const Rgb expected = evaluate(a, pair.u, pair.v) * 0.25F + evaluate(b, pair.u, pair.v) * 2.0F;
    ASSERT_NEAR(evaluate(sum, pair.u, pair.v).x, expected.x, 1e-6F * expected.x);
  }
}

TEST(Combine, AddsMirrorParts) {
  const Brdf sum = brdf_in("def m = brdf specular ks=0.5 c = brdf coupled", "combine 0.5 m 0.5 c");
  const Vec3f u = test::direction(40, 0);
  EXPECT_TRUE(has_specular_part(sum));
  EXPECT_FLOAT_EQ(specular_weight(sum, u).x, 0.25F + 0.5F * specular_weight(test::brdf_of("coupled"), u).x);
}

TEST(Combine, KnowsItsParts) {
  const std::string definitions = "def d = brdf diffuse m = brdf specular w = brdf ward sx=0.1 sy=0.3 kd=0";
  const Brdf mirror_alone = brdf_in(definitions, "combine 1 m, 0 d");
  EXPECT_TRUE(has_specular_part(mirror_alone));
  EXPECT_FALSE(has_nonspecular_part(mirror_alone));
  const Brdf all = brdf_in(definitions, "combine 0.1 d, 0.2 m, 0.3 w");
  EXPECT_TRUE(has_diffuse_part(all) && has_glossy_part(all) && is_anisotropic(all));
  EXPECT_FALSE(is_anisotropic(brdf_in(definitions, "combine 1 d")));
}

TEST(Combine, OfSumsIsOneSum) {
  const Brdf sum = brdf_in(
      "def a = brdf diffuse kd=1 b = brdf combine 0.5 a, 0.25 a c = brdf combine 2 b, 1 a", "combine 1 c");
  const auto& parts = *std::get<Combine>(sum).parts;
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_FLOAT_EQ(parts[0].weight, 2.5F);
}

TEST(Combine, CanBeNestedWhereItWouldHaveMoreTermsThanThereIsMemory) {
  std::string definitions = "def c0 = brdf diffuse";
  for (int i = 1; i <= 60; ++i) {
    const std::string inner = "c" + std::to_string(i - 1);
    definitions += " c" + std::to_string(i) + " = brdf combine 0.5 " + inner + ", 0.5 " + inner;
  }
  const Brdf sum = brdf_in(definitions, "c60");
  const Vec3f up(0, 0, 1);
  EXPECT_FLOAT_EQ(evaluate(sum, up, up).x, evaluate(test::brdf_of("diffuse"), up, up).x);
}

TEST(Combine, RefusesWeightsThatAreTooLarge) {
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(
      brdf_in("def a = brdf diffuse b = brdf combine 1e30 a c = brdf combine 1e30 b", "c", diagnostics));
  EXPECT_EQ(diagnostics.entries().at(0).message, "the product of the BRDFs' weights overflows a float");
}

TEST(Combine, TakesNamesAsTheyAreMeantWhereItStands) {
  const std::string text = "def a = brdf diffuse kd=1 b = brdf combine 1 a begin def a = brdf diffuse kd=0";
  grf::Diagnostics diagnostics;
  const auto scene =
      grf::read_text(text +
                         " begin begin mesh brdf b begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end "
                         "begin faces (0, 1, 2) end end end end",
                     "scene.grf", diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  grf::SceneVisitor visitor;
  bool visited = false;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    const grf::ResolvedSurface surface = resolve(mesh.surface(0), placement.scope);
    const auto brdf = reflectance::BrdfMaker(diagnostics).make(*surface.brdf, surface.brdf_scope);
    EXPECT_GT(evaluate(*brdf, Vec3f(0, 0, 1), Vec3f(0, 0, 1)).x, 0);
    visited = true;
  };
  visit(*scene, visitor);
  EXPECT_TRUE(visited);
}

TEST(Identity, TellsSumsOfOtherThingsApart) {
  const std::string text =
      "def a = brdf diffuse begin begin mesh brdf combine 1 a begin vertexs end begin faces end end end "
      "def a = brdf phong begin begin mesh brdf combine 1 a begin vertexs end begin faces end end end";
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(text, "scene.grf", diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  reflectance::BrdfMaker maker(diagnostics);
  std::vector<std::string> identities;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    const grf::ResolvedSurface surface = resolve(mesh.surfaces[0], placement.scope);
    identities.push_back(maker.identity(*surface.brdf, surface.brdf_scope));
  };
  visit(*scene, visitor);
  ASSERT_EQ(identities.size(), 2U);
  EXPECT_NE(identities[0], identities[1]);
}

TEST(BrdfMaker, WarnsOfGlassThatLetsNothingThrough) {
  for (const char* whole : {"combine 0.5 a, 0.5 b", "coat base=a", "layer base=b top=a"}) {
    grf::Diagnostics diagnostics;
    EXPECT_TRUE(
        brdf_in(std::string("def a = brdf glass b = brdf diffuse c = brdf ") + whole, "c", diagnostics));
    ASSERT_GE(diagnostics.entries().size(), 1U) << whole;
    EXPECT_EQ(diagnostics.entries()[0].message,
              "glass lets nothing through in a sum or layer: it only reflects there");
  }
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(brdf_in("def a = brdf glass", "a", diagnostics));
  EXPECT_TRUE(diagnostics.entries().empty());
}

TEST(BrdfMaker, SaysWhatCannotBeMade) {
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(brdf_in("def a = brdf unheard", "a", diagnostics));
  EXPECT_FALSE(brdf_in("def a = brdf measured", "a", diagnostics));
  EXPECT_FALSE(brdf_in("def a = brdf ward \"ward.binary\"", "a", diagnostics));
  ASSERT_EQ(diagnostics.entries().size(), 3U);
  EXPECT_EQ(diagnostics.entries()[0].message, "'unheard' cannot be rendered");
  EXPECT_EQ(diagnostics.entries()[1].message, "'measured' needs the name of a data file");
  EXPECT_EQ(diagnostics.entries()[2].message, "'ward' takes no data file");
}

}  // namespace
