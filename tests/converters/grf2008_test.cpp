#include "converters/grf2008.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "grf/visit.h"
#include "grf/write.h"
#include "tests/grf/reading.h"
#include "tests/grf/scene_generator.h"
#include "tests/support/grammar_of_2008.h"
#include "tests/support/paths.h"
#include "tests/support/small_stack.h"
#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

using convert::to_grf2008;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string Radiance =
    "warning: mesh lights have the radiance 1 in the grammar of 2008: another one is lost\n";
const std::string LostBrdf = "warning: faces that emit lose their BRDF: they become a mesh light\n";

std::string cut_into(int parts) {
  return "warning: the grammar of 2008 has no 'none' in faces: the mesh becomes " + std::to_string(parts) +
         "\n";
}

struct Converted {
  std::string text;
  std::string said;  ///< a line for each message
};

Converted converted(const Scene& scene, const std::string& path = "scene.grf") {
  Diagnostics diagnostics;
  const auto result = to_grf2008(scene, path, diagnostics);
  EXPECT_EQ(result.has_value(), !diagnostics.has_errors());
  Converted outcome;
  for (const Diagnostic& entry : diagnostics.entries()) {
    outcome.said += (entry.severity == Severity::Warning ? "warning: " : "error: ") + entry.message + "\n";
  }
  if (result) outcome.text = to_text(*result);
  return outcome;
}

Converted converted(const std::string& text) { return converted(scene_of(text)); }

/// The scene that a text becomes, as text again, which must be read as that scene.
std::string in_2008(const std::string& text, const std::string& said = "") {
  const Converted outcome = converted(text);
  EXPECT_EQ(outcome.said, said);
  EXPECT_EQ(to_text(scene_of(outcome.text)), outcome.text);
  return outcome.text;
}

void expect_same(const std::string& text, const std::string& expected, const std::string& said = "") {
  EXPECT_EQ(in_2008(text, said), to_text(scene_of(expected)));
}

TEST(Grf2008, LeavesScenesWithoutExtensionsAsTheyAre) {
  for (const char* name :
       {"thesis_first_example", "mesh_defined_in_an_outer_scope", "transforms_nested", "combine"}) {
    Diagnostics diagnostics;
    const std::string path = std::string(GRANADA_SOURCE_DIR "/tests/grf/corpus/valid/") + name + ".grf";
    const auto scene = read(path, diagnostics);
    ASSERT_TRUE(scene) << name;
    EXPECT_EQ(to_grf2008(*scene, path, diagnostics), scene) << name;
    EXPECT_EQ(diagnostics.to_text(), "");
  }
}

TEST(Grf2008, HasNamesOfMeshesInComments) {
  EXPECT_EQ(in_2008("// first\nbegin mesh \"ball\" begin vertexs end begin faces end end mesh // behind\n"),
            "// first\n// ball\nbegin mesh\n  begin vertexs\n  end vertexs\n  begin faces\n  end faces\n"
            "end mesh  // behind\n");
  EXPECT_THAT(in_2008("def m = " + triangle("\"ball\"") + " begin use m end"),
              HasSubstr("def\n  // ball\n  m = begin mesh\n"));
}

TEST(Grf2008, MakesMeshLightsOfFacesThatEmit) {
  const std::string vertices =
      "begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) normal (0, 0, 1) (1, 1, 0) end vertexs ";
  expect_same(
      "begin mesh brdf ward " + vertices +
          "begin faces (0, 1, 2) brdf none light rgb (1, 1, 1) (1, 3, 2) end end",
      "begin mesh brdf ward begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end begin faces (0, 1, 2) end end "
      "mesh "
      "mesh light begin begin vertexs (1, 0, 0) normal (0, 0, 1) (1, 1, 0) (0, 1, 0) end begin faces (0, 1, "
      "2) end end");
}

TEST(Grf2008, SaysWhatEmittingFacesLose) {
  const std::string light =
      "mesh light begin begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end begin faces (0, 1, 2) end end";
  expect_same(triangle("light rgb (1, 1, 1)"), light);
  expect_same(triangle("light rgb (5, 5, 5)"), light, Radiance);
  expect_same(triangle("light rgb (1, 1, 1) brdf ward"), light, LostBrdf);
}

TEST(Grf2008, KeepsTheCommentsOfMeshesThatBecomeLights) {
  EXPECT_EQ(in_2008("// above\n" + triangle("\"lamp\" // name\n light rgb (1, 1, 1) // one\n") + "// end\n"),
            "// above\n// lamp\nmesh light begin\n  // name\n  // one\n  begin vertexs\n    (0, 0, 0)\n    "
            "(1, 0, 0)\n"
            "    (0, 1, 0)\n  end vertexs\n  begin faces\n    (0, 1, 2)\n  end faces\nend\n// end\n");
}

TEST(Grf2008, MakesFacesBlackThatWereSaidToEmitNothing) {
  expect_same(triangle("light rgb (0, 0, 0)"), triangle("brdf diffuse kd=0"));
  expect_same(triangle("light rgb (0, 0, 0) brdf ward"), triangle("brdf ward"));
}

TEST(Grf2008, TakesTheRadianceFromMeshLights) {
  const auto light = [](const std::string& attributes, const std::string& faces) {
    return "mesh light begin " + attributes +
           " begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end begin faces " + faces + " end end ";
  };
  const std::string plain = light("", "(0, 1, 2) (0, 2, 1)");
  expect_same(plain, plain);
  expect_same(light("rgb (1, 1, 1)", "(0, 1, 2) (0, 2, 1)"), plain);
  expect_same(light("rgb (4, 4, 4)", "(0, 1, 2) (0, 2, 1)"), plain, Radiance);
  expect_same(light("", "(0, 1, 2) rgb (4, 4, 4) (0, 2, 1)"), plain, Radiance);
  const std::string def = "def c = rgb (2, 2, 2) begin ";
  expect_same(def + light("rgb c", "(0, 1, 2) (0, 2, 1)") + "end", def + plain + "end", Radiance);
}

TEST(Grf2008, CutsMeshesWhereAnAttributeReturnsToNothing) {
  expect_same(
      triangle("brdf ward", "rgb (1, 0, 0) (0, 1, 2) rgb none (0, 2, 1) rgb (0, 1, 0) (0, 1, 2) brdf none"),
      "begin mesh brdf ward rgb (1, 0, 0) begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end begin faces (0, 1, "
      "2) end end "
      "begin mesh brdf ward begin vertexs (0, 0, 0) (0, 1, 0) (1, 0, 0) end begin faces (0, 1, 2) rgb (0, 1, "
      "0) "
      "(0, 2, 1) end end "
      "begin mesh rgb (0, 1, 0) begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end begin faces (0, 1, 2) end "
      "end",
      cut_into(3));
}

TEST(Grf2008, NeedsNoCutBeforeTheFirstFace) {
  expect_same(triangle("brdf ward rgb (1, 0, 0)", "rgb none (0, 1, 2) brdf phong"),
              triangle("brdf ward", "(0, 1, 2) brdf phong"));
  expect_same(
      triangle("brdf ward", "(0, 1, 2) rgb (1, 0, 0) (0, 1, 2) rgb none light rgb (1, 1, 1)"),
      in_2008(triangle("brdf ward", "(0, 1, 2) rgb (1, 0, 0) (0, 1, 2) light rgb (1, 1, 1)"), LostBrdf),
      LostBrdf);
}

std::vector<std::string> used_in(const Scene& scene) {
  std::vector<std::string> names;
  SceneVisitor visitor;
  visitor.use = [&](const Use& use, const Placement&, const Block&) { names.push_back(use.mesh.name); };
  visit(scene, visitor);
  return names;
}

TEST(Grf2008, UsesAllThatADefinedMeshBecomes) {
  const std::string text = in_2008("def m = " + triangle("brdf ward", "(0, 1, 2) brdf none") +
                                       " m_2 = rgb (1, 0, 0) begin // here\nuse m // there\n" +
                                       "def m_3 = rgb (0, 0, 0) begin use m end end",
                                   cut_into(2));
  EXPECT_THAT(used_in(scene_of(text)), ElementsAre("m", "m_4", "m", "m_4"));
  EXPECT_THAT(text, HasSubstr("  // here\n  use m  // there\n  use m_4\n"));
}

TEST(Grf2008, PlacesTheLightOfADefinedMeshWhereItIsUsed) {
  const Scene scene = scene_of(in_2008("def m = " + triangle("brdf ward", "(0, 1, 2) light rgb (1, 1, 1)") +
                                           " begin use m transform translation (0, 0, 5) begin use m end end",
                                       LostBrdf));
  std::vector<double> heights;
  SceneVisitor visitor;
  visitor.mesh_light = [&](const MeshLight& light, const Placement& placement, const Block&) {
    heights.push_back((Vec3d(light.mesh->geometry->positions[0]) * placement.to_world).z);
  };
  visit(scene, visitor);
  EXPECT_THAT(heights, ElementsAre(0, 5));
  EXPECT_THAT(used_in(scene), ElementsAre("m", "m"));
}

TEST(Grf2008, MayDefineAMeshOfEmittingFacesAlone) {
  in_2008("def m = " + triangle("light rgb (1, 1, 1)") + " begin use m end");
}

TEST(Grf2008, HasNoOpacityAndNamesTheFirstFace) {
  const auto error = [](int face, const std::string& opacity) {
    return fmt::format("error: face {} has 'opacity {}', which the grammar of 2008 lacks\n", face, opacity);
  };
  EXPECT_EQ(converted(triangle("opacity 0.5")).said, error(0, "0.5"));
  EXPECT_EQ(converted(triangle("", "opacity mask 0.25")).said, error(0, "mask 0.25"));
  EXPECT_EQ(converted(triangle("light rgb (1, 1, 1) opacity 0")).said, error(0, "0"));
  EXPECT_EQ(converted("def m = " + triangle("opacity blend 1") + " begin use m end").said,
            error(0, "blend 1"));
  EXPECT_EQ(
      converted("begin mesh begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs begin faces (0,1,2) (0,2,1) "
                "opacity 0.5 (0,1,2) opacity 0.75 (0,1,2) end faces end mesh")
          .said,
      error(2, "0.5"));
  EXPECT_THAT(converted(triangle("opacity 1")).text, Not(HasSubstr("opacity"))) << "it is the default";
}

TEST(Grf2008, HasNoThreeNumbersForAParameter) {
  const std::string error = "error: 'kd' has three numbers, and parameters have one in the grammar of 2008\n";
  EXPECT_EQ(converted(triangle("brdf diffuse kd=(1, 0, 0)")).said, error);
  EXPECT_EQ(converted(triangle("", "brdf diffuse kd=(1, 0, 0)")).said, error);
  EXPECT_EQ(converted("def a = brdf diffuse kd=(1, 0, 0) begin end").said, error);
  EXPECT_EQ(converted("def a = pdf diffuse kd=(1, 0, 0) begin end").said, error);
  EXPECT_EQ(converted("def m = " + triangle("brdf diffuse kd=(1, 0, 0)") + " begin end").said, error);
}

// A scheme without it makes the same image, and a BRDF another one.
TEST(Grf2008, HasNoWordsAsValues) {
  expect_same(triangle("brdf ward pdf adaptive mode=reject nQT=90"),
              triangle("brdf ward pdf adaptive nQT=90"),
              "warning: 'mode' has a word as value, which the grammar of 2008 lacks: it is lost\n");
  EXPECT_EQ(converted(triangle("brdf ward kind=rough")).said,
            "error: 'kind' has a word as value, which the grammar of 2008 lacks\n");
}

TEST(Grf2008, HasNoParametersBehindAFileOfData) {
  expect_same(triangle("brdf measured \"a.binary\" linear=false"), triangle("brdf measured \"a.binary\""),
              "warning: 'measured' has no parameters in the grammar of 2008: they are lost\n");
}

class Grf2008Files : public testing::Test {
 protected:
  Converted convert_scene(const std::string& text) {
    const std::string path = folder.add("scene.grf", text);
    Diagnostics diagnostics;
    const auto scene = read(path, diagnostics);
    EXPECT_EQ(diagnostics.to_text(), "");
    return scene ? converted(*scene, path) : Converted();
  }
  static std::string as_one(const std::string& name) {
    return "warning: '" + name + "' needs what the grammar of 2008 lacks: all files are written as one\n";
  }

  test::TemporaryFolder folder;
};

TEST_F(Grf2008Files, StayApartWhereTheyNeedNotChange) {
  folder.add("part.grf", "def m = " + triangle("brdf ward") + " begin use m end");
  folder.add("gold.brdf", "ward");
  const Converted outcome =
      convert_scene("include \"part.grf\" include \"part.grf\" " + triangle("\"a\" brdf \"gold.brdf\""));
  EXPECT_EQ(outcome.said, "");
  EXPECT_THAT(outcome.text, HasSubstr("include \"part.grf\"\ninclude \"part.grf\"\n// a\n"));
  EXPECT_THAT(outcome.text, HasSubstr("  brdf \"gold.brdf\"\n"));
}

TEST_F(Grf2008Files, BecomeOneWhereOneWouldHaveToChange) {
  folder.add("plain.grf", triangle("brdf phong"));
  folder.add("a/named.grf", triangle("\"a\" texture \"wood.png\" brdf ward"));
  const Converted outcome = convert_scene("include \"plain.grf\" include \"a/named.grf\"");
  EXPECT_EQ(outcome.said, as_one("a/named.grf"));
  EXPECT_THAT(outcome.text, Not(HasSubstr("include")));
  EXPECT_THAT(outcome.text, HasSubstr("// a\nbegin mesh\n"));
  EXPECT_THAT(outcome.text, HasSubstr("texture \"a/wood.png\""));
}

TEST_F(Grf2008Files, BecomeOneWhereAMeshOfTheirsIsDefinedOutsideAndBecomesSeveral) {
  folder.add("use.grf", "use m");
  const Converted outcome = convert_scene("def m = " + triangle("brdf ward", "(0, 1, 2) brdf none") +
                                          " begin include \"use.grf\" end");
  EXPECT_EQ(outcome.said, as_one("use.grf") + cut_into(2));
  EXPECT_THAT(outcome.text, HasSubstr("  use m\n  use m_2\n"));
}

TEST_F(Grf2008Files, OfBrdfsAreWrittenOutWhereTheyWouldHaveToChange) {
  folder.add("a/gold.brdf", "measured \"gold.binary\" linear=false");
  const Converted outcome = convert_scene(triangle("brdf \"a/gold.brdf\""));
  EXPECT_EQ(outcome.said,
            as_one("a/gold.brdf") +
                "warning: 'measured' has no parameters in the grammar of 2008: they are lost\n");
  EXPECT_THAT(outcome.text, HasSubstr("brdf measured \"a/gold.binary\"\n"));
}

TEST(GrammarOf2008, HasTheThesisExamplesAndNoExtension) {
  using test::difference_from_grammar_of_2008;
  for (const char* name :
       {"thesis_first_example", "mesh_defined_in_an_outer_scope", "transforms_nested", "combine"}) {
    EXPECT_EQ(difference_from_grammar_of_2008(
                  test::bytes_of(std::string(GRANADA_SOURCE_DIR "/tests/grf/corpus/valid/") + name + ".grf")),
              "")
        << name;
  }
  EXPECT_EQ(difference_from_grammar_of_2008(
                "begin mesh rgb (1,0,0) begin vertexs normal (0,0,1) irad (1,1,1) uv (0,0) (0,0,0) (1,0,0) "
                "begin list ray (0,0,1) irad (1,1,1) end list (0,1,0) end vertexs begin faces brdf ward "
                "sx=.1f half=true pdf reject 3 (0,1,2) texture wood (0,1,2) end faces end mesh "
                "params begin dependent view (0,0,1) end"),
            "");
  for (const std::string& extension :
       {triangle("\"ball\""), triangle("light rgb (1, 1, 1)"), triangle("", "(0, 1, 2) brdf none (0, 1, 2)"),
        triangle("", "(0, 1, 2) texture none (0, 1, 2)"), triangle("brdf ward kd=(1, 1, 1)"),
        triangle("pdf adaptive mode=warp"), triangle("brdf measured \"a.binary\" linear=true"),
        std::string("mesh light begin rgb (1,1,1) begin vertexs end vertexs begin faces end faces end")}) {
    EXPECT_NE(difference_from_grammar_of_2008(extension), "") << extension;
  }
}

TEST(Grf2008, HasWhatTheEditorAuthored) {
  for (const char* name : {"blocks", "outdoors", "still_life"}) {
    const std::string path = std::string(GRANADA_SOURCE_DIR "/samples/authored/") + name + ".grf";
    Diagnostics diagnostics;
    const auto scene = read(path, diagnostics);
    ASSERT_TRUE(scene) << name;
    EXPECT_EQ(test::difference_from_grammar_of_2008(converted(*scene, path).text), "") << name;
  }
}

/// Finds what the grammar of 2008 does not have.
class Extensions {
 public:
  static bool in(const Scene& scene) {
    bool found = false;
    SceneVisitor visitor;
    visitor.mesh = [&](const Mesh& mesh, const Placement&, const Block&) { found = found || are_in(mesh); };
    visitor.mesh_light = [&](const MeshLight& light, const Placement&, const Block&) {
      found = found || light.mesh->surfaces.front().colour;
      for (std::size_t i = 0; i < light.mesh->face_count(); ++i)
        found = found || light.mesh->surface(i).colour;
    };
    visitor.definition = [&](const Definition& definition, const Placement&) {
      if (const auto* mesh = std::get_if<Shared<Mesh>>(&definition.body)) found = found || are_in(**mesh);
      if (const auto* brdf = std::get_if<BrdfModel>(&definition.body)) found = found || are_in(*brdf);
      if (const auto* pdf = std::get_if<PdfModel>(&definition.body)) found = found || have_extensions(*pdf);
    };
    visit(scene, visitor);
    return found;
  }

 private:
  static bool have_extensions(const Model& model) {
    return std::any_of(model.arguments.begin(), model.arguments.end(), [](const Argument& argument) {
      return std::holds_alternative<Colour>(argument.value) || std::holds_alternative<Word>(argument.value);
    });
  }
  static bool are_in(const BrdfModel& brdf) {
    return have_extensions(brdf) || (!brdf.data_file.empty() && !brdf.arguments.empty());
  }
  static bool are_in(const Surface& surface) {
    const auto* brdf = surface.brdf ? std::get_if<BrdfModel>(&*surface.brdf) : nullptr;
    const auto* pdf = surface.pdf ? std::get_if<PdfModel>(&*surface.pdf) : nullptr;
    return surface.emission || (brdf != nullptr && are_in(*brdf)) ||
           (pdf != nullptr && have_extensions(*pdf));
  }
  static bool are_in(const Mesh& mesh) {
    if (!mesh.name.empty() || are_in(mesh.surfaces.front())) return true;
    const Surface* before = &mesh.surfaces.front();
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      const Surface& surface = mesh.surface(i);
      const bool needs_none = (before->colour && !surface.colour) || (before->brdf && !surface.brdf) ||
                              (before->pdf && !surface.pdf) || (before->texture && !surface.texture);
      if (needs_none || are_in(surface)) return true;
      before = &surface;
    }
    return false;
  }
};

TEST(Grf2008, OfAThousandBlocksFitsASmallStack) {
  std::string text = "light begin (0, 0, 0) (1, 0, 0) (0, 1, 0) end";
  for (std::size_t i = 0; i < DeepestNesting; ++i) text = "transform scale (1, 1, 1) begin " + text + " end";
  test::run_on_small_stack([&] {
    const Scene scene = scene_of(text);
    Diagnostics diagnostics;
    EXPECT_EQ(to_grf2008(scene, "scene.grf", diagnostics), scene);
  });
}

TEST(Extensions, AreFound) {
  const auto found = [](const std::string& text) { return Extensions::in(scene_of(text)); };
  EXPECT_FALSE(found(triangle("brdf ward", "(0, 1, 2) rgb (1, 0, 0)")));
  EXPECT_TRUE(found(triangle("\"a\"")));
  EXPECT_TRUE(found(triangle("", "light rgb (1, 1, 1)")));
  EXPECT_TRUE(found(triangle("brdf ward", "(0, 1, 2) brdf none")));
  EXPECT_TRUE(found("def a = brdf ward kd=(1, 1, 1) begin end"));
  EXPECT_TRUE(found("def a = pdf adaptive mode=warp begin end"));
  EXPECT_TRUE(found("mesh light begin rgb (1, 1, 1) begin vertexs end begin faces end end"));
}

std::optional<Scene> in_2008(const Scene& scene) {
  Diagnostics diagnostics;
  auto result = to_grf2008(scene, "scene.igrf", diagnostics);
  if (result.has_value() == diagnostics.has_errors()) RC_FAIL("an error that is not said, or one that is");
  return result;
}

RC_GTEST_PROP(Grf2008OfAnyScene, HasNoExtensionsAndIsReadBack, ()) {
  const auto result = in_2008(SceneGenerator(false).scene());
  if (!result) return;
  const std::string text = to_text(*result);
  RC_LOG() << text;
  RC_ASSERT(!Extensions::in(*result));
  RC_ASSERT(test::difference_from_grammar_of_2008(text) == "");
  Diagnostics diagnostics;
  const auto again = read_text(text, "scene.igrf", diagnostics);
  RC_ASSERT(diagnostics.to_text() == "");
  RC_ASSERT(again == result);
}

RC_GTEST_PROP(Grf2008OfAnyScene, StaysAsItIs, ()) {
  const auto result = in_2008(SceneGenerator(false).scene());
  if (result) RC_ASSERT(in_2008(*result) == result);
}

RC_GTEST_PROP(Grf2008OfAnyScene, HasNoExtensionsInIncludedFiles, ()) {
  const auto result = in_2008(SceneGenerator(true).scene());
  if (result) RC_ASSERT(!Extensions::in(*result));
}

}  // namespace
}  // namespace grf
