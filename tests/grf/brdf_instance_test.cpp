#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/visit.h"
#include "tests/grf/reading.h"
#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

using testing::ElementsAre;

BrdfModel first_definition(const std::string& text) {
  const Scene scene = scene_of(text);
  return std::get<BrdfModel>(block<DefinitionScope>(scene.contents).definitions.back().body);
}

std::vector<std::pair<float, std::string>> terms_of(const BrdfModel& brdf) {
  std::vector<std::pair<float, std::string>> terms;
  for (const CombineTerm& term : brdf.terms) terms.emplace_back(term.weight, term.brdf.name);
  return terms;
}

TEST(Combine, KeepsItsTermsWhetherOrNotCommasAreThere) {
  for (const char* terms : {"0.25 a, 0.75 b, 0 a", "0.25 a 0.75 b 0 a", "0.25 a, 0.75 b 0 a"}) {
    const BrdfModel brdf = first_definition(
        std::string("def a = brdf ward b = brdf phong c = brdf combine ") + terms + " begin end");
    EXPECT_THAT(terms_of(brdf),
                ElementsAre(std::pair(0.25F, "a"), std::pair(0.75F, "b"), std::pair(0.0F, "a")))
        << terms;
  }
}

TEST(Combine, LeavesTheNumberOfAFaceBehindIt) {
  const Scene scene =
      scene_of("def a = brdf ward begin " +
               triangle("brdf ward", "brdf combine 0.5 a 0.5 a 3 0 1 2 brdf combine 1 a 3") + "end");
  const Mesh& mesh = *block<Shared<Mesh>>(block<DefinitionScope>(scene.contents).body);
  ASSERT_EQ(mesh.face_count(), 2U);
  EXPECT_EQ(std::get<BrdfModel>(*mesh.surface(0).brdf).terms.size(), 2U);
  EXPECT_EQ(std::get<BrdfModel>(*mesh.surface(1).brdf).terms.size(), 1U);
}

TEST(Combine, SeesNamesOfBeforeItsDefinition) {
  const Scene scene =
      scene_of("def a = brdf ward begin def a = brdf combine 1 a begin " + triangle("brdf a") + "end end");
  SceneVisitor visitor;
  visitor.mesh = [](const Mesh& mesh, const Placement& placement, const Block&) {
    const ResolvedSurface surface = resolve(mesh.surface(0), placement.scope);
    ASSERT_NE(surface.brdf, nullptr);
    EXPECT_EQ(surface.brdf->keyword, "combine");
    const auto* term = surface.brdf_scope.find<BrdfModel>(surface.brdf->terms.at(0).brdf.name);
    ASSERT_NE(term, nullptr);
    EXPECT_EQ(term->keyword, "ward") << "the outer one and not itself";
  };
  visit(scene, visitor);
}

TEST(Combine, WithoutTermsIsAWordAsAnyOther) {
  EXPECT_TRUE(first_definition("def a = brdf combine begin end").terms.empty());
  const Scene scene = scene_of("def combine = brdf ward begin " + triangle("brdf combine") + "end");
  const Mesh& mesh = *block<Shared<Mesh>>(block<DefinitionScope>(scene.contents).body);
  EXPECT_EQ(mesh.surfaces[0].brdf, BrdfAttribute(Reference{"combine", {}}));
}

TEST(DataFile, StandsBehindAnyKeywordBeforeItsParameters) {
  const BrdfModel brdf = first_definition("def a = brdf measured \"b c.binary\" linear=false begin end");
  EXPECT_EQ(brdf.keyword, "measured");
  EXPECT_EQ(brdf.data_file, "b c.binary");
  ASSERT_EQ(brdf.arguments.size(), 1U);
  EXPECT_EQ(brdf.arguments[0].value, Value(false));
  EXPECT_EQ(first_definition("def a = brdf other \"x.dat\" begin end").data_file, "x.dat");
  EXPECT_EQ(first_definition("def a = brdf ward begin end").data_file, "");
}

class BrdfFileTest : public testing::Test {
 protected:
  Scene read_scene(const std::string& text) {
    Diagnostics diagnostics;
    const auto scene = read(folder.add("scene.grf", text), diagnostics);
    EXPECT_EQ(diagnostics.to_text(), "");
    return scene ? *scene : Scene();
  }

  test::TemporaryFolder folder;
};

TEST_F(BrdfFileTest, IsTheInstanceThatItHoldsAndKeepsItsName) {
  folder.add("brdfs/gold.brdf", "// bright\r\nBRDF ward sx=0.1 // along\r\n");
  folder.add("brdfs/dull.brdf",
             "\xEF\xBB\xBF"
             "diffuse");
  folder.add("brdfs/measured.brdf", "measured \"gold.binary\" linear=true");
  const Scene scene = read_scene(
      "def gold = brdf \"brdfs\\gold.brdf\" dull = brdf \"brdfs/dull.brdf\" data = brdf "
      "\"brdfs/measured.brdf\" begin end");
  const auto& definitions = block<DefinitionScope>(scene.contents).definitions;
  ASSERT_EQ(definitions.size(), 3U);
  const auto& gold = std::get<BrdfModel>(definitions[0].body);
  EXPECT_EQ(gold.keyword, "ward");
  EXPECT_EQ(gold.arguments.size(), 1U);
  EXPECT_EQ(gold.instance_file, "brdfs\\gold.brdf");
  EXPECT_EQ(std::get<BrdfModel>(definitions[1].body).keyword, "diffuse");
  EXPECT_EQ(std::get<BrdfModel>(definitions[2].body).data_file, "gold.binary");
}

TEST_F(BrdfFileTest, HasALocationInItsFile) {
  folder.add("gold.brdf", "// bright\nbrdf ward\n  sx=0.1");
  const Scene scene = read_scene("def gold = brdf \"gold.brdf\" begin end");
  const auto& gold = std::get<BrdfModel>(block<DefinitionScope>(scene.contents).definitions[0].body);
  EXPECT_EQ(gold.location.file->path, folder.path("gold.brdf"));
  EXPECT_EQ(gold.location.line, 2U);
  EXPECT_EQ(gold.arguments[0].location.line, 3U);
  EXPECT_EQ(gold.location.file->included_at.line, 1U);
}

TEST_F(BrdfFileTest, IsNoReferenceWhateverWordItHolds) {
  folder.add("word.brdf", "gold");
  const Scene scene = read_scene("def gold = brdf ward begin " + triangle("brdf \"word.brdf\"") + "end");
  const Mesh& mesh = *block<Shared<Mesh>>(block<DefinitionScope>(scene.contents).body);
  ASSERT_TRUE(std::holds_alternative<BrdfModel>(*mesh.surfaces[0].brdf));
  EXPECT_EQ(std::get<BrdfModel>(*mesh.surfaces[0].brdf).keyword, "gold");
}

TEST_F(BrdfFileTest, IsFoundBesideTheFileThatNamesIt) {
  folder.add("parts/gold.brdf", "ward");
  folder.add("parts/part.grf", triangle("brdf \"gold.brdf\""));
  const Scene scene = read_scene("include \"parts/part.grf\" " + triangle("brdf \"parts/gold.brdf\""));
  const Mesh& part = *block<Shared<Mesh>>(*block<Include>(scene.contents).contents);
  EXPECT_EQ(std::get<BrdfModel>(*part.surfaces[0].brdf).keyword, "ward");
}

}  // namespace
}  // namespace grf
