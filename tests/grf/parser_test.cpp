// Blocks, transforms and what holds for a text as a whole. Messages are in the corpus.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "grf/visit.h"
#include "grf/write.h"
#include "tests/grf/reading.h"

namespace grf {
namespace {

const std::string Light = "light begin (0, 2, 0) (1, 0, 0) (0, 0, 3) end ";

TEST(Light, HasACornerTwoEdgesAndARadiance) {
  AreaLight light{Vec3f(0, 2, 0), Vec3f(1, 0, 0), Vec3f(0, 0, 3), {}};
  EXPECT_EQ(block<AreaLight>(scene_of(Light).contents), light);
  light.radiance = Colour(4, 5, 6);
  const std::string region = " (0, 2, 0) (1, 0, 0) (0, 0, 3) ";
  EXPECT_EQ(block<AreaLight>(scene_of("light begin rgb (4, 5, 6)" + region + "end").contents), light);
  EXPECT_EQ(block<AreaLight>(scene_of("light begin" + region + "color (4, 5, 6) end").contents), light);
}

TEST(Transform, KeepsItsStepsInOrder) {
  const Scene scene =
      scene_of("transform rotation (1, 2, 3) scale (4, 5, 6) translation (7, 8, 9) begin end");
  using Kind = TransformStep::Kind;
  EXPECT_EQ(block<Transform>(scene.contents).steps,
            (std::vector<TransformStep>{{Kind::Rotation, Vec3f(1, 2, 3)},
                                        {Kind::Scale, Vec3f(4, 5, 6)},
                                        {Kind::Translation, Vec3f(7, 8, 9)}}));
}

TEST(Block, IsEndedByEndWhateverComesNext) {
  const std::string transform = "transform scale (2, 2, 2) begin " + Light + "end ";
  const Scene scene =
      scene_of(transform + transform + Light + "def a = rgb (0, 0, 0) begin end " + triangle());
  ASSERT_EQ(scene.contents.blocks.size(), 5U);
  EXPECT_EQ(block<Transform>(scene.contents, 1).body.blocks.size(), 1U);
  EXPECT_EQ(block<AreaLight>(scene.contents, 2).corner, Vec3f(0, 2, 0));
}

/// Where the first light's corner is in the world.
Vec3d placed(const std::string& text) {
  Vec3d place(0);
  SceneVisitor visitor;
  visitor.light = [&](const AreaLight& light, const Placement& placement, const Block&) {
    place = Vec3d(light.corner) * placement.to_world;
  };
  visit(scene_of(text), visitor);
  return place;
}

void expect_near(const Vec3d& a, const Vec3d& b) { EXPECT_LT((a - b).length(), 1e-6) << a << b; }

const std::string QuarterTurn = "1.5707963";

TEST(Transform, ActsInTheOrderWritten) {
  const std::string light = " begin light begin (1, 2, 3) (1, 0, 0) (0, 1, 0) end end";
  expect_near(placed("transform scale (2, 2, 2) translation (0, 1, 0)" + light), Vec3d(2, 5, 6));
  expect_near(placed("transform translation (0, 1, 0) scale (2, 2, 2)" + light), Vec3d(2, 6, 6));
  expect_near(placed("transform scale (-1, 1, 3)" + light), Vec3d(-1, 2, 9));
}

TEST(Transform, TurnsCounterClockwiseAboutXThenYThenZ) {
  const std::string light = " begin light begin (1, 2, 3) (1, 0, 0) (0, 1, 0) end end";
  expect_near(placed("transform rotation (" + QuarterTurn + ", 0, 0)" + light), Vec3d(1, -3, 2));
  expect_near(placed("transform rotation (0, " + QuarterTurn + ", 0)" + light), Vec3d(3, 2, -1));
  expect_near(placed("transform rotation (0, 0, " + QuarterTurn + ")" + light), Vec3d(-2, 1, 3));
  const std::string at_once = "rotation (0.3, -0.7, 2)";
  const std::string one_by_one = "rotation (0.3, 0, 0) rotation (0, -0.7, 0) rotation (0, 0, 2)";
  expect_near(placed("transform " + at_once + light), placed("transform " + one_by_one + light));
}

TEST(Transform, InsideActsFirst) {
  EXPECT_EQ(
      placed("transform scale (2, 2, 2) begin transform translation (1, 0, 0) begin " + Light + "end end"),
      placed("transform translation (1, 0, 0) scale (2, 2, 2) begin " + Light + "end"));
}

TEST(MatrixOf, NothingIsTheIdentity) { EXPECT_EQ(matrix_of({}), Matrix44d()); }

TEST(Locations, AreWhereThingsWereWritten) {
  const Scene scene = scene_of(
      "\n  light begin (0, 0, 0) (1, 0, 0) (0, 1, 0) end\n"
      "def red = rgb (1, 0, 0)\n"
      "    shiny = brdf ward\n"
      "      sx=0.1\n"
      "begin\n"
      "  begin mesh brdf shiny begin vertexs end begin faces end end\n"
      "end\n");
  const auto expect_at = [](const SourceLocation& location, unsigned line, unsigned column) {
    EXPECT_EQ(location.line, line);
    EXPECT_EQ(location.column, column);
    EXPECT_EQ(location.file->path, "scene.grf");
  };
  expect_at(scene.contents.blocks[0].location, 2, 3);
  const auto& definitions = block<DefinitionScope>(scene.contents, 1);
  expect_at(definitions.definitions[0].location, 3, 5);
  expect_at(definitions.definitions[1].location, 4, 5);
  const auto& model = std::get<BrdfModel>(definitions.definitions[1].body);
  expect_at(model.location, 4, 18);
  expect_at(model.arguments[0].location, 5, 7);
  const Mesh& mesh = *block<Shared<Mesh>>(definitions.body);
  expect_at(std::get<Reference>(*mesh.surfaces[0].brdf).location, 7, 19);
}

std::string nested_transforms(int depth) {
  std::string text;
  for (int i = 0; i < depth; ++i) text += "transform scale (2, 2, 2) begin\n";
  for (int i = 0; i < depth; ++i) text += "end\n";
  return text;
}

TEST(Nesting, IsLimitedToAThousandBlocks) {
  EXPECT_EQ(said_about(nested_transforms(1000)), "read\n");
  EXPECT_EQ(said_about(nested_transforms(1001)),
            "scene.grf:1001:1: error: blocks are nested deeper than 1000\n"
            "  transform scale (2, 2, 2) begin\n"
            "  ^\n"
            "not read\n");
}

TEST(Reading, OfAFileThatIsNotThereIsExplained) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read("nowhere.grf", diagnostics));
  EXPECT_EQ(diagnostics.to_text(), "nowhere.grf: error: cannot read the file: No such file or directory\n");
}

TEST(Reading, StopsAfterTwentyErrors) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += "light begin end\n";
  Diagnostics diagnostics;
  EXPECT_FALSE(read_text(text, "scene.grf", diagnostics));
  EXPECT_EQ(diagnostics.entries().size(), Diagnostics::MaximumErrors);
}

TEST(Reading, DependsNotOnEarlierErrors) {
  Diagnostics diagnostics;
  for (unsigned i = 0; i < 2 * Diagnostics::MaximumErrors; ++i) {
    EXPECT_TRUE(read_text(Light, "right.grf", diagnostics));
    EXPECT_FALSE(read_text("light", "wrong.grf", diagnostics));
    EXPECT_FALSE(read_text(Light + "end", "end_too_many.grf", diagnostics));
    EXPECT_FALSE(read_text("transform scale (2, 2, 2) begin", "unclosed.grf", diagnostics));
    EXPECT_FALSE(read_brdf("ward sx=", "wrong.brdf", diagnostics));
  }
}

TEST(ReadBrdf, TakesAKeywordAndValues) {
  Diagnostics diagnostics;
  const auto brdf = read_brdf("ward sx=0.2 // rough\n kd=(0, 0.5, 1) fast=true", "argument", diagnostics);
  ASSERT_TRUE(brdf) << diagnostics.to_text();
  EXPECT_EQ(brdf->keyword, "ward");
  ASSERT_EQ(brdf->arguments.size(), 3U);
  EXPECT_EQ(brdf->arguments[0].value, Value(0.2F));
  EXPECT_EQ(brdf->arguments[1].value, Value(Colour(0, 0.5F, 1)));
  EXPECT_EQ(brdf->arguments[2].value, Value(true));
}

TEST(ReadPdf, TakesAKeywordAndValues) {
  for (const char* text : {"adaptive nQT=90 mode=reject", "PDF Adaptive nqt = 90 // trees\n MODE=Reject"}) {
    Diagnostics diagnostics;
    const auto pdf = read_pdf(text, "argument", diagnostics);
    ASSERT_TRUE(pdf) << diagnostics.to_text();
    PdfModel expected;
    expected.keyword = "adaptive";
    expected.arguments = {{"nQT", 90.0F, {}}, {"mode", Word{"reject"}, {}}};
    EXPECT_EQ(*pdf, expected);
    EXPECT_EQ(*read_pdf(to_text(*pdf), "argument", diagnostics), expected);
  }
}

TEST(ReadPdf, TakesNothingElse) {
  const auto error = [](const std::string& text) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_pdf(text, "argument", diagnostics));
    EXPECT_EQ(diagnostics.entries().size(), 1U);
    return diagnostics.entries()[0].message;
  };
  EXPECT_EQ(error(""), "found the end of the file, expected a model's keyword or the name of a definition");
  EXPECT_EQ(error("adaptive \"a.file\""), "found the string \"a.file\", expected the end of the PDF");
  EXPECT_EQ(error("adaptive diffuse"), "found 'diffuse', expected the end of the PDF");
  for (const char* word : {"begin", "none", "def", "rgb", "Colour", "brdf", "pdf", "texture"}) {
    EXPECT_EQ(error(std::string("adaptive mode=") + word),
              std::string("found '") + word +
                  "', expected a number, 'true', 'false', a word, three numbers in parentheses or 'texture' "
                  "for 'mode'");
  }
}

TEST(ReadBrdf, TakesNothingElse) {
  const auto error = [](const std::string& text) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_brdf(text, "argument", diagnostics));
    EXPECT_EQ(diagnostics.entries().size(), 1U);
    return diagnostics.entries()[0].message;
  };
  EXPECT_EQ(error(""), "found the end of the file, expected a model's keyword or the name of a definition");
  EXPECT_EQ(error("ward sx=0.2)"), "found ')', expected the end of the BRDF");
  EXPECT_EQ(error("ward phong"), "found 'phong', expected the end of the BRDF");
  EXPECT_EQ(error("ward sx=1e99"),
            "the number 1e99 is out of range: numbers reach from -3.4028235e38 to 3.4028235e38");
}

}  // namespace
}  // namespace grf
