#include "grf/check.h"

#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/grf/check_helpers.h"
#include "tests/grf/reading.h"
#include "tests/grf/small_catalogue.h"
#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

std::string said_of_brdf(const std::string& brdf) { return said_of(triangle("brdf " + brdf)); }

TEST(Check, AcceptsWhatTheCatalogueHas) {
  EXPECT_EQ(said_of_brdf("glossy rough=0.5 kd=(0, 0.5, 1) fast=true"), "");
  EXPECT_EQ(said_of_brdf("GLOSSY ROUGH=3e38 Kd=1 FAST=0"), "");
  EXPECT_EQ(said_of_brdf("glossy sigma=1"), "");
  EXPECT_EQ(said_of(triangle("brdf flat pdf cosine n=100")), "");
}

TEST(Check, KnowsWhichParametersAnImageVaries) {
  const test::TemporaryFolder folder;
  const std::string image = "texture \"" + folder.add("a.png", "") + "\" ";
  const auto said_of_map = [](const std::string& brdf) {
    return said_of("begin mesh brdf " + brdf +
                   " begin vertexs uv (0, 0) (0, 0, 0) uv (1, 0) (1, 0, 0) uv (0, 1) (0, 1, 0) end vertexs "
                   "begin faces (0, 1, 2) end faces end mesh");
  };
  EXPECT_EQ(said_of_map("glossy rough=" + image + "r * 2 kd=" + image + "rgb * (0, 0.5, 1)"), "");
  EXPECT_EQ(said_of_map("glossy kd=" + image + "A"), "");
  EXPECT_EQ(said_of_map("glossy rough=" + image + "rgb"),
            "'Rough' of 'glossy': one number, expected the channel r, g, b or a of the image\n");
  EXPECT_EQ(said_of_map("glossy fast=" + image + "r"),
            "'fast' of 'glossy': an image varies only numbers that need not be whole, and colours\n");
  EXPECT_EQ(said_of_map("glossy kd=texture \"\" r"), "'kd' of 'glossy': expected the name of an image\n");
  EXPECT_EQ(said_of_map("glossy kd=" + image + "r * 1.5"),
            "'kd' of 'glossy': 1.5 is out of range, expected a number from 0 to 1\n");
  EXPECT_EQ(said_of_map("glossy pdf cosine n=" + image + "r"),
            "'n' of 'cosine': no image can vary it over faces\n");
  EXPECT_EQ(said_of_map("glossy kd=texture \"none.png\" r"), "warning: there is no image 'none.png'\n");
  EXPECT_EQ(said_of(triangle("brdf glossy kd=" + image + "r")),
            "warning: face 0 has a texture and corners without uv: it is (0, 0) there\n");
  EXPECT_EQ(said_of("def a = brdf glossy kd=" + image + "r begin " + triangle("brdf a") + "end"),
            "warning: face 0 has a texture and corners without uv: it is (0, 0) there\n");
}

TEST(Check, RefusesImagesInPartsOfABrdf) {
  const test::TemporaryFolder folder;
  const std::string image = folder.add("a.png", "");
  EXPECT_EQ(said_of("def a = brdf glossy kd=texture \"" + image + "\" r b = brdf combine 1 a begin " +
                    triangle("brdf b") + "end"),
            "images vary parameters of 'a', which 'combine' cannot have as a part\n");
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

TEST(Check, KnowsTheWordsOfAParameter) {
  const auto said = [](const std::string& pdf) { return said_of(triangle("brdf flat pdf " + pdf)); };
  EXPECT_EQ(said("cosine mode=reject"), "");
  EXPECT_EQ(said("cosine Mode=WARP n=3"), "");
  EXPECT_EQ(said("cosine mode=rejct"),
            "'mode' of 'cosine': 'rejct' is unknown, expected one of reject, warp: did you mean 'reject'?\n");
  EXPECT_EQ(said("cosine mode=other"),
            "'mode' of 'cosine': 'other' is unknown, expected one of reject, warp\n");
  EXPECT_EQ(said("cosine mode=1"), "'mode' of 'cosine': expected one of reject, warp\n");
  EXPECT_EQ(said("cosine mode=true"), "'mode' of 'cosine': expected one of reject, warp\n");
  EXPECT_EQ(said("cosine n=warp"), "'n' of 'cosine': expected a number from 0 to 100\n");
  EXPECT_EQ(said_of_brdf("glossy kd=warp"),
            "'kd' of 'glossy': expected a number, or three in parentheses, from 0 to 1\n");
  EXPECT_EQ(said_of_brdf("glossy fast=yes"), "'fast' of 'glossy': expected true, false, 1 or 0\n");
}

// The model's keyword reads as the value of a parameter.
TEST(Check, SaysWhatADefinitionLacksThatReadsAsAParameter) {
  const auto said = [](const std::string& definitions) {
    return said_of("def a = " + definitions + " begin " + triangle("brdf flat") + "end");
  };
  EXPECT_EQ(said("brdf glossy m=1 b = flat kd=3"),
            "'glossy' has no parameter 'b', it has Rough, kd, fast: a definition called 'b' needs 'brdf' or "
            "'pdf' before 'flat'\n")
      << "once, and nothing of the parameters of 'flat'";
  EXPECT_EQ(said("pdf cosine b = flt kd=3"),
            "'cosine' has no parameter 'b', it has n, mode: a definition called 'b' needs 'brdf' or 'pdf' "
            "before 'flt'\n"
            "'cosine' has no parameter 'kd', it has n, mode\n");
  EXPECT_EQ(
      said("brdf flat c = brdf combine 1 a b = flat"),
      "'combine' has no parameter 'b', it has none: a definition called 'b' needs 'brdf' or 'pdf' before "
      "'flat'\n");
  EXPECT_EQ(said("pdf cosine moed = warp"),
            "'cosine' has no parameter 'moed', it has n, mode: did you mean 'mode'?\n");
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
  EXPECT_EQ(said_of_reference("def god = brdf flat", {{}, gold, {}, {}, {}, {}, {}}),
            "no BRDF called 'gold' is defined here: did you mean 'god'?");
  EXPECT_EQ(said_of_reference("def gold = rgb (1, 1, 0)", {{}, gold, {}, {}, {}, {}, {}}),
            "no BRDF called 'gold' is defined here");
  EXPECT_EQ(said_of_reference("def gold = brdf flat", {{}, BrdfAttribute(gold), gold, {}, {}, {}, {}}),
            "no PDF called 'gold' is defined here");
  EXPECT_EQ(said_of_reference("def gold = brdf flat", {gold, BrdfAttribute(gold), {}, {}, {}, {}, {}}),
            "no colour called 'gold' is defined here");
  EXPECT_EQ(said_of_reference("def gold = brdf flat", {{}, BrdfAttribute(gold), {}, gold, {}, {}, {}}),
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
            "2 faces, the first is 1, have a texture and corners without uv: it is (0, 0) there");
  Diagnostics unmissed;
  EXPECT_TRUE(check(*scene, catalogue(), unmissed, {folder.path("gone.png")}));
  EXPECT_EQ(unmissed.entries().size(), 1U) << "the image is to come";
}

TEST(CheckOfTermsOfCombine, ReportsWhatNoTextCanHave) {
  const std::string text = "def a = brdf flat b = brdf combine 1 a begin " + triangle("brdf b") + "end";
  EXPECT_EQ(said_of(text), "");
  Scene scene = scene_of(text);
  auto& brdf =
      std::get<BrdfModel>(std::get<DefinitionScope>(scene.contents.blocks[0].content).definitions[1].body);
  brdf.terms = {{-1, {"a", {}}}, {1, {"c", {}}}, {1, {"b", {}}}};
  Diagnostics diagnostics;
  EXPECT_FALSE(check(scene, catalogue(), diagnostics));
  ASSERT_EQ(diagnostics.entries().size(), 3U) << diagnostics.to_text();
  EXPECT_EQ(diagnostics.entries()[0].message, "the weight -1 of a BRDF, expected 0 or more");
  EXPECT_EQ(diagnostics.entries()[1].message, "no BRDF called 'c' is defined here");
  EXPECT_EQ(diagnostics.entries()[2].message, "no BRDF called 'b' is defined here");
}

TEST(CheckOfTermsOfCombine, WantsSomeAndNothingElse) {
  EXPECT_EQ(said_of_brdf("combine"), "'combine' without terms, expected weights and names\n");
  EXPECT_EQ(said_of("def a = brdf flat begin " + triangle("brdf combine 1 a kd=1") + "end"),
            "'combine' has no parameter 'kd', it has none\n");
  EXPECT_EQ(said_of("def chrome = brdf flat begin " + triangle("brdf chrome", "brdf combin") + "end"),
            "unknown BRDF 'combin': did you mean 'combine'?\n");
}

TEST(Check, WantsAnOpacityFromNothingToAll) {
  for (const char* given : {"0", "1", "0.5", "-0"}) {
    EXPECT_EQ(said_of(triangle(std::string("brdf flat opacity ") + given)), "") << given;
  }
  for (const char* given : {"opacity -0.5", "opacity 1.5", "opacity mask 2", "opacity blend -1"}) {
    const std::string message = fmt::format("'{}', expected a number from 0 to 1\n", given);
    EXPECT_EQ(said_of(triangle(std::string("brdf flat ") + given)), message);
    EXPECT_EQ(said_of(triangle("brdf flat", given)), message);
  }
}

TEST(Check, WarnsOfAnOpacityThatReadsTheAlphaOfNoTexture) {
  EXPECT_EQ(said_of(triangle("brdf flat opacity mask 0.5")),
            "warning: 'opacity mask 0.5' without a texture, whose alpha it uses: alpha is 1\n");
  EXPECT_EQ(said_of(triangle("brdf flat", "opacity blend 1")),
            "warning: 'opacity blend 1' without a texture, whose alpha it uses: alpha is 1\n");
}

TEST(CheckOfModels, LetsThoseThatReadNoFileHaveNone) {
  EXPECT_EQ(said_of_brdf("flat \"a.dat\""), "'flat' takes no data file\n");
  EXPECT_EQ(said_of_brdf("unknown \"a.dat\""), "unknown BRDF 'unknown'\n");
}

TEST(CheckOfModels, DoesNotTakeANameForAModelInADefinition) {
  EXPECT_EQ(said_of("def a = brdf flat b = brdf a begin " + triangle("brdf b") + "end"),
            "'a' is the name of a BRDF, expected a model\n");
  EXPECT_EQ(said_of("def a = brdf flat begin " + triangle("brdf a kd=1") + "end"),
            "'a' is the name of a BRDF, expected a model\n");
  EXPECT_EQ(said_of("def a = pdf cosine b = pdf a begin " + triangle("brdf flat pdf b") + "end"),
            "'a' is the name of a PDF, expected a model\n");
  EXPECT_EQ(said_of("def flat = brdf flat begin " + triangle("brdf flat") + "end"), "")
      << "a definition may be called like its model";
}

TEST(CheckOfDefinitions, WarnsOfThoseThatNothingUses) {
  EXPECT_EQ(said_of("def a = brdf flat b = pdf cosine c = rgb (1, 0, 0) d = begin mesh brdf flat " + Square +
                    faces("") + "end begin end"),
            "warning: the BRDF 'a' is defined and never used\n"
            "warning: the PDF 'b' is defined and never used\n"
            "warning: the colour 'c' is defined and never used\n"
            "warning: the mesh 'd' is defined and never used\n");
  EXPECT_EQ(said_of("def a = brdf flat begin def a = brdf flat begin " + triangle("brdf a") + "end end"),
            "warning: the BRDF 'a' is defined and never used\n")
      << "the inner one hides it";
}

TEST(CheckOfDefinitions, KnowsEveryUse) {
  EXPECT_EQ(said_of("def a = brdf flat b = pdf cosine c = rgb (1, 0, 0) begin " +
                    triangle("brdf flat", "brdf a pdf b rgb c") + "end"),
            "");
  EXPECT_EQ(said_of("def a = brdf flat b = brdf combine 1 a begin " + triangle("brdf b") + "end"), "");
  EXPECT_EQ(said_of("def c = rgb (1, 0, 0) begin mesh light begin rgb c " + Square + faces("(0, 1, 2)") +
                    "end " + mesh("(0, 0, 1) (1, 0, 1) (0, 1, 1)", "(0, 1, 2)") + "end"),
            "");
  EXPECT_EQ(said_of("def a = brdf flat m = " + triangle("brdf a") + " begin use m end"), "");
  const test::TemporaryFolder folder;
  folder.add("part.grf", triangle("brdf a"));
  const std::string path = folder.add("scene.grf", "def a = brdf flat begin include \"part.grf\" end");
  Diagnostics diagnostics;
  const auto scene = read(path, diagnostics);
  EXPECT_TRUE(scene && check(*scene, catalogue(), diagnostics));
  EXPECT_EQ(diagnostics.to_text(), "") << "in an included file";
}

TEST(CheckOfDefinitions, SaysNothingOfUnusedOnesAfterAnError) {
  EXPECT_EQ(said_of("def a = brdf flat begin " + triangle("brdf unknown") + "end"),
            "unknown BRDF 'unknown'\n");
}

TEST(CheckOfDefinedMeshes, SaysOnceWhatIsWrongHoweverOftenTheyArePlaced) {
  EXPECT_EQ(said_of("def m = " + triangle("brdf glosy") + " begin use m use m end"),
            "unknown BRDF 'glosy': did you mean 'glossy'?\n");
  EXPECT_EQ(said_of("def m = " + triangle("brdf flat", "rgb (2, 0, 0)") + " begin use m use m end"),
            "warning: a colour over 1: such a surface can reflect more light than it receives\n");
}

TEST(CheckOfDefinedMeshes, LooksNamesUpWhereTheyAreDefined) {
  EXPECT_EQ(said_of("def a = brdf flat m = " + triangle("brdf a") +
                    " begin def a = rgb (0, 0, 0) begin use m " + triangle("brdf flat rgb a") + "end end"),
            "");
}

TEST(CheckOfUses, ReportsMeshesThatAreNotThere) {
  Scene scene = scene_of("def ball = " + triangle("brdf flat") + " begin use ball end");
  auto& scope = std::get<DefinitionScope>(scene.contents.blocks[0].content);
  std::get<Use>(scope.body.blocks[0].content).mesh.name = "bal";
  Diagnostics diagnostics;
  EXPECT_FALSE(check(scene, catalogue(), diagnostics));
  EXPECT_EQ(diagnostics.entries().at(0).message,
            "no mesh called 'bal' is defined here: did you mean 'ball'?");
}

int asked_for_albedo = 0;

/// A catalogue with a model whose albedo is its parameter.
Catalogue catalogue_with_lamp() {
  ModelInfo lamp;
  lamp.keyword = "lamp";
  lamp.parameters = {parameter("albedo", ParameterKind::Number, 10)};
  lamp.largest_albedo = [](const Model& model) {
    ++asked_for_albedo;
    return LargestAlbedo{std::get<float>(model.arguments.at(0).value), 80};
  };
  Catalogue known = catalogue();
  known.brdfs.push_back(lamp);
  return known;
}

std::string said_of_lamps(const std::string& text) {
  Diagnostics diagnostics;
  const bool valid = check(scene_of(text), catalogue_with_lamp(), diagnostics);
  EXPECT_EQ(valid, !diagnostics.has_errors());
  std::string messages;
  for (const Diagnostic& entry : diagnostics.entries()) {
    messages += fmt::format("{}:{} {}\n", entry.location.line, entry.location.column, entry.message);
  }
  return messages;
}

TEST(CheckOfEnergy, WarnsOfBrdfsThatReflectMoreThanTheyReceive) {
  EXPECT_EQ(said_of_lamps(triangle("brdf lamp albedo=1")), "");
  EXPECT_EQ(said_of_lamps(triangle("brdf lamp albedo=1.01")), "") << "not clearly";
  EXPECT_EQ(said_of_lamps(triangle("\nbrdf lamp albedo=1.577")),
            "2:6 'lamp' reflects up to 1.58 times the light it receives (at 80 degrees)\n");
  EXPECT_EQ(said_of_lamps("def a = brdf lamp albedo=3 begin " + triangle("brdf a") + "end"),
            "1:14 'lamp' reflects up to 3 times the light it receives (at 80 degrees)\n");
  EXPECT_EQ(said_of_lamps(triangle("rgb (0.1, 0.1, 0.1) brdf lamp albedo=2")).empty(), false)
      << "whatever the faces' colour";
}

TEST(CheckOfEnergy, AsksOnceForEachInstanceThatIsRight) {
  asked_for_albedo = 0;
  const std::string twice = triangle("brdf lamp albedo=2") + triangle("brdf LAMP Albedo=2.0");
  EXPECT_EQ(said_of_lamps(twice),
            "1:17 'lamp' reflects up to 2 times the light it receives (at 80 degrees)\n"
            "2:17 'lamp' reflects up to 2 times the light it receives (at 80 degrees)\n");
  EXPECT_LE(asked_for_albedo, 2);
  asked_for_albedo = 0;
  said_of_lamps(triangle("brdf lamp albedo=2") + triangle("brdf lamp albedo=2") +
                triangle("brdf lamp albedo=2"));
  EXPECT_EQ(asked_for_albedo, 1);
  EXPECT_EQ(said_of_lamps(triangle("brdf lamp albedo=20")),
            "1:22 'albedo' of 'lamp': 20 is out of range, expected a number from 0 to 10\n");
  EXPECT_EQ(asked_for_albedo, 1) << "not of what is wrong";
}

}  // namespace
}  // namespace grf
