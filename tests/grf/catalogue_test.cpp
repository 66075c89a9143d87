#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "grf/check.h"
#include "tests/grf/reading.h"
#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

ParameterInfo parameter(std::string_view name, ParameterKind kind, float maximum,
                        std::vector<std::string_view> aliases = {}) {
  ParameterInfo info;
  info.name = name;
  info.aliases = std::move(aliases);
  info.kind = kind;
  info.maximum = maximum;
  return info;
}

const Catalogue& catalogue() {
  static const Catalogue known = [] {
    ModelInfo glossy;
    glossy.keyword = "glossy";
    glossy.parameters = {
        parameter("Rough", ParameterKind::Number, std::numeric_limits<float>::max(), {"m", "sigma"}),
        parameter("kd", ParameterKind::Reflectance, 1), parameter("fast", ParameterKind::Boolean, 1)};
    ModelInfo flat;
    flat.keyword = "flat";
    ModelInfo cosine;
    cosine.keyword = "cosine";
    cosine.parameters = {parameter("n", ParameterKind::Number, 100)};
    return Catalogue{{glossy, flat}, {cosine}};
  }();
  return known;
}

/// The messages about a text that can be read, a line each, with the severity before those of warnings.
std::string said_of(const std::string& text) {
  const Scene scene = scene_of(text);
  Diagnostics diagnostics;
  const bool valid = check(scene, catalogue(), diagnostics);
  EXPECT_EQ(valid, !diagnostics.has_errors());
  std::string messages;
  for (const Diagnostic& entry : diagnostics.entries()) {
    messages += (entry.severity == Severity::Warning ? "warning: " : "") + entry.message + "\n";
  }
  return messages;
}

std::string said_of_brdf(const std::string& brdf) { return said_of(triangle("brdf " + brdf)); }

TEST(Check, AcceptsWhatTheCatalogueHas) {
  EXPECT_EQ(said_of_brdf("glossy rough=0.5 kd=(0, 0.5, 1) fast=true"), "");
  EXPECT_EQ(said_of_brdf("GLOSSY ROUGH=3e38 Kd=1 FAST=0"), "");
  EXPECT_EQ(said_of_brdf("glossy sigma=1"), "");
  EXPECT_EQ(said_of(triangle("brdf flat pdf cosine n=100")), "");
}

TEST(Check, ReportsUnknownModels) {
  EXPECT_EQ(said_of_brdf("glosy"), "unknown BRDF 'glosy': did you mean 'glossy'?\n");
  EXPECT_EQ(said_of_brdf("kajiya"), "unknown BRDF 'kajiya'\n");
  EXPECT_EQ(said_of(triangle("brdf flat pdf cosin")), "unknown PDF 'cosin': did you mean 'cosine'?\n");
  EXPECT_EQ(said_of(triangle("brdf flat pdf glossy")), "unknown PDF 'glossy'\n")
      << "each kind has its models";
}

TEST(Check, SuggestsDefinitionsOfThatKindToo) {
  EXPECT_EQ(said_of("def chrome = brdf flat chroma = rgb (1, 0, 0) begin " + triangle("brdf chrom") + "end"),
            "unknown BRDF 'chrom': did you mean 'chrome'?\n");
}

TEST(Check, ReportsUnknownParametersWithThoseThatThereAre) {
  EXPECT_EQ(said_of_brdf("glossy rouhg=1"),
            "'glossy' has no parameter 'rouhg', it has Rough, kd, fast: did you mean 'Rough'?\n");
  EXPECT_EQ(said_of_brdf("flat kd=1"), "'flat' has no parameter 'kd', it has none\n");
}

TEST(Check, ReportsParametersThatAreGivenTwice) {
  EXPECT_EQ(said_of_brdf("glossy rough=1 kd=1 Rough=1"), "the parameter 'Rough' is given twice\n");
  EXPECT_EQ(said_of_brdf("glossy m=1 sigma=1"), "the parameter 'Rough' is given twice\n");
}

TEST(Check, ReportsValuesOutOfRange) {
  EXPECT_EQ(said_of_brdf("glossy kd=1.5"),
            "'kd' of 'glossy': 1.5 is out of range, expected a number from 0 to 1\n");
  EXPECT_EQ(said_of_brdf("glossy kd=(0, 1, -0.5)"),
            "'kd' of 'glossy': -0.5 is out of range, expected numbers from 0 to 1\n");
  EXPECT_EQ(said_of_brdf("glossy m=-1"),
            "'Rough' of 'glossy': -1 is out of range, expected a number of 0 or more\n");
}

TEST(Check, ReportsValuesOfAnotherKind) {
  EXPECT_EQ(said_of_brdf("glossy rough=true"), "'Rough' of 'glossy': expected a number of 0 or more\n");
  EXPECT_EQ(said_of_brdf("glossy rough=(1, 1, 1)"), "'Rough' of 'glossy': expected a number of 0 or more\n");
  EXPECT_EQ(said_of_brdf("glossy kd=true"),
            "'kd' of 'glossy': expected a number, or three in parentheses, from 0 to 1\n");
  EXPECT_EQ(said_of_brdf("glossy fast=2"), "'fast' of 'glossy': expected true, false, 1 or 0\n");
  EXPECT_EQ(said_of_brdf("glossy fast=(1, 1, 1)"), "'fast' of 'glossy': expected true, false, 1 or 0\n");
}

TEST(Check, ReportsEveryMistakeAtItsPlace) {
  const Scene scene = scene_of("def a = brdf glossy\n  kd=2 rough=-1\n  b = pdf cosin\nbegin end");
  Diagnostics diagnostics;
  check(scene, catalogue(), diagnostics);
  ASSERT_EQ(diagnostics.entries().size(), 3U);
  EXPECT_EQ(diagnostics.entries()[0].location.line, 2U);
  EXPECT_EQ(diagnostics.entries()[0].location.column, 3U);
  EXPECT_EQ(diagnostics.entries()[1].location.column, 8U);
  EXPECT_EQ(diagnostics.entries()[2].location.line, 3U);
  EXPECT_EQ(diagnostics.entries()[2].location.column, 11U);
}

TEST(Check, ReportsOneMistakeOnceForAllFacesThatHaveIt) {
  EXPECT_EQ(said_of(triangle("brdf glosy", "rgb (1, 0, 0) (0, 1, 2) rgb (0, 1, 0)")),
            "unknown BRDF 'glosy': did you mean 'glossy'?\n");
}

TEST(Check, ReportsNegativeColoursAndWarnsOfLargeOnes) {
  const std::string warning =
      "warning: a colour over 1: such a surface can reflect more light than it receives\n";
  EXPECT_EQ(said_of(triangle("brdf flat rgb (1.5, 0, 0)")), warning);
  EXPECT_EQ(said_of(triangle("brdf flat rgb (0, -1, 0)")),
            "a colour of (0, -1, 0), expected components of 0 or more\n");
  EXPECT_EQ(
      said_of("def red = rgb (2, 0, 0) dark = rgb (0, 0, -2) begin " + triangle("brdf flat rgb red") + "end"),
      "a colour of (0, 0, -2), expected components of 0 or more\n" + warning);
  const std::string vertices = "(0, 0, 0) rgb (0, 0, 2) (1, 0, 0) rgb (0, 0, -2) (0, 1, 0)";
  EXPECT_EQ(said_of("begin mesh brdf flat begin vertexs " + vertices + " end begin faces end end"),
            warning + "a vertex colour of (0, 0, -2), expected components of 0 or more\n");
}

TEST(Check, LetsRadianceBeLargeButNotNegative) {
  EXPECT_EQ(said_of(triangle("light rgb (100, 0, 0)")), "");
  EXPECT_EQ(said_of(triangle("light rgb (-1, 0, 0)")),
            "a radiance of (-1, 0, 0), expected components of 0 or more\n");
  EXPECT_EQ(said_of("light begin rgb (9, 9, -1) (0, 0, 0) (1, 0, 0) (0, 1, 0) end"),
            "a radiance of (9, 9, -1), expected components of 0 or more\n");
}

TEST(Check, WarnsOnceAFileOfFacesWithoutBrdf) {
  const std::string warning = "warning: faces without a BRDF: they are diffuse with kd=0.5\n";
  EXPECT_EQ(said_of(triangle() + triangle()), warning);
  EXPECT_EQ(said_of(triangle("brdf flat", "(0, 1, 2) brdf none")), warning);
  EXPECT_EQ(said_of(triangle("", "brdf flat")), "") << "every face has one";
  EXPECT_EQ(said_of(triangle("light rgb (1, 1, 1)")), "") << "such emitters are black";

  const test::TemporaryFolder folder;
  folder.add("part.grf", triangle() + triangle());
  folder.add("scene.grf", triangle() + "include \"part.grf\" include \"part.grf\"");
  Diagnostics diagnostics;
  const auto scene = read(folder.path("scene.grf"), diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  EXPECT_TRUE(check(*scene, catalogue(), diagnostics));
  EXPECT_EQ(diagnostics.warning_count(), 2U);
}

/// A scene that no text gives: its reference does not mean what it should.
std::string said_of_reference(const std::string& definitions, const Surface& surface) {
  Scene scene = scene_of(definitions + " begin " + triangle("brdf flat") + " end");
  auto& scope = std::get<DefinitionScope>(scene.contents.blocks[0].content);
  std::get<Shared<Mesh>>(scope.body.blocks[0].content).edit().surfaces[0] = surface;
  Diagnostics diagnostics;
  EXPECT_FALSE(check(scene, catalogue(), diagnostics));
  return diagnostics.entries().at(0).message;
}

TEST(Check, ReportsReferencesToDefinitionsThatAreNotThere) {
  const Reference gold{"gold", {}};
  EXPECT_EQ(said_of_reference("def god = brdf flat", {{}, gold, {}, {}, {}, {}}),
            "no BRDF called 'gold' is defined here: did you mean 'god'?");
  EXPECT_EQ(said_of_reference("def gold = rgb (1, 1, 0)", {{}, gold, {}, {}, {}, {}}),
            "no BRDF called 'gold' is defined here");
  EXPECT_EQ(said_of_reference("def gold = brdf flat", {{}, BrdfAttribute(gold), gold, {}, {}, {}}),
            "no PDF called 'gold' is defined here");
  EXPECT_EQ(said_of_reference("def gold = brdf flat", {gold, BrdfAttribute(gold), {}, {}, {}, {}}),
            "no colour called 'gold' is defined here");
  EXPECT_EQ(said_of_reference("def gold = brdf flat", {{}, BrdfAttribute(gold), {}, gold, {}, {}}),
            "no texture called 'gold' is defined here");
}

TEST(Check, WarnsOfImagesThatAreMissingAndOfCornersWithoutUv) {
  const test::TemporaryFolder folder;
  folder.add("there.png", "an image");
  const std::string vertices =
      "begin vertexs uv (0, 0) (0, 0, 0) uv (1, 0) (1, 0, 0) uv (1, 1) (1, 1, 0) (0, 1, 0) end vertexs ";
  const std::string path = folder.add(
      "scene.grf",
      "def stone = texture \"gone.png\" begin begin mesh brdf flat texture \"there.png\" " + vertices +
          "begin faces (0, 1, 2) texture stone (0, 2, 3) texture \"gone.png\" (0, 1, 3) end faces "
          "end mesh end");
  Diagnostics diagnostics;
  const auto scene = read(path, diagnostics);
  ASSERT_TRUE(scene && check(*scene, catalogue(), diagnostics)) << diagnostics.to_text();
  ASSERT_EQ(diagnostics.entries().size(), 2U) << diagnostics.to_text();
  EXPECT_EQ(diagnostics.entries()[0].message, "there is no image '" + folder.path("gone.png") + "'");
  EXPECT_EQ(diagnostics.entries()[1].message,
            "2 faces with a texture have corners without uv: it is (0, 0) there");
}

TEST(CheckOfAModel, NeedsNoScene) {
  Diagnostics diagnostics;
  EXPECT_TRUE(
      check(*read_brdf("glossy m=1", "argument", diagnostics), catalogue().brdfs, "BRDF", diagnostics));
  EXPECT_FALSE(check(*read_brdf("glosy", "argument", diagnostics), catalogue().brdfs, "BRDF", diagnostics));
  EXPECT_EQ(diagnostics.entries().at(0).message, "unknown BRDF 'glosy': did you mean 'glossy'?");
}

TEST(FindArgument, KnowsAliases) {
  Diagnostics diagnostics;
  const auto model = read_brdf("glossy kd=1 SIGMA=2", "argument", diagnostics);
  const ModelInfo* info = find_model(catalogue().brdfs, "Glossy");
  ASSERT_TRUE(model && info != nullptr);
  EXPECT_EQ(find_argument(*model, *info->find("m"))->value, Value(2.0F));
  EXPECT_EQ(find_argument(*model, *info->find("fast")), nullptr);
  EXPECT_EQ(find_model(catalogue().brdfs, "cosine"), nullptr);
}

}  // namespace
}  // namespace grf
