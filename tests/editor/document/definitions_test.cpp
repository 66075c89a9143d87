#include "editor/document/definitions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/write.h"
#include "tests/editor/scene_of.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string Triangle = R"(
    begin vertexs
      (0, 0, 0) (1, 0, 0) (0, 1, 0)
    end vertexs
    begin faces
      (0, 1, 2)
    end faces
  end mesh
)";

const std::string Scopes = R"(def gold = brdf ward sx=0.2
def dull = brdf diffuse
def both = brdf combine 0.5 gold, 0.5 dull
begin
  begin mesh "outer"
    brdf gold)" + Triangle +
                           R"(
  def gold = brdf phong n=20
  begin
    begin mesh "inner"
      brdf gold)" + Triangle +
                           R"(
    begin mesh "mixed"
      brdf both)" + Triangle +
                           R"(
  end
end
)";

std::vector<std::string> names(const std::vector<PlacedDefinition>& definitions) {
  std::vector<std::string> result;
  for (const PlacedDefinition& each : definitions) result.push_back(each.definition->name);
  return result;
}

TEST(Definitions, ThatMeanSomethingAtAPlace) {
  const grf::Scene scene = scene_of(Scopes);
  EXPECT_THAT(names(definitions_at(scene, grf::ScenePath{0, 3})), ElementsAre("gold", "dull", "both"));
  const auto inside = definitions_at(scene, grf::ScenePath{0, 4, 1});
  EXPECT_THAT(names(inside), ElementsAre("dull", "both", "gold"));
  EXPECT_EQ(inside.back().path, (grf::ScenePath{0, 4, 0}));
  // Definitions are in scope of later ones.
  EXPECT_THAT(names(definitions_at(scene, grf::ScenePath{0, 1})), ElementsAre("gold"));
  EXPECT_THAT(names(common_definitions(scene, {{0, 3}, {0, 4, 1}, {0, 4, 2}})), ElementsAre("dull", "both"));
}

TEST(Definitions, AreCounted) {
  const grf::Scene scene = scene_of(Scopes);
  const auto uses = count_uses(scene);
  EXPECT_EQ(uses.at(definition_at(scene, grf::ScenePath{0, 0})), 2U);  // a mesh and a term
  EXPECT_EQ(uses.at(definition_at(scene, grf::ScenePath{0, 4, 0})), 1U);
  EXPECT_EQ(count_uses(scene, {{0, 4}}).count(definition_at(scene, grf::ScenePath{0, 4, 0})), 0U);
}

TEST(Definitions, AreAddedToTheOutermostScope) {
  grf::Diagnostics diagnostics;
  grf::BrdfModel red;
  red.keyword = "phong";
  const auto defined = define(scene_of(Scopes), "red", red, diagnostics);
  ASSERT_TRUE(defined) << diagnostics.to_text();
  EXPECT_EQ(defined->name, "red");
  EXPECT_EQ(definition_at(defined->scene, defined->path)->name, "red");
  EXPECT_THAT(grf::to_text(defined->scene), HasSubstr("dull\ndef red = brdf phong\nbegin"));
}

TEST(Definitions, MakeAScopeWhereThereIsNone) {
  grf::Diagnostics diagnostics;
  const grf::Scene scene = scene_of("begin mesh\n" + Triangle + "light begin (0,0,0) (1,0,0) (0,1,0) end");
  const auto defined = define(scene, "red wine", grf::Colour(1, 0, 0), diagnostics);
  ASSERT_TRUE(defined);
  EXPECT_EQ(defined->name, "red$20$wine");
  EXPECT_EQ(defined->path, (grf::ScenePath{0, 0}));
  EXPECT_EQ(scene_of(grf::to_text(defined->scene)), defined->scene);
}

TEST(Definitions, GetAFreshNameWhereTheWantedOneIsTaken) {
  const grf::Scene scene = scene_of(Scopes);
  EXPECT_EQ(fresh_name(scene, "gold"), "gold_2");
  EXPECT_EQ(fresh_name(scene, "phong"), "phong_2");
  EXPECT_NE(fresh_name(scene, "begin"), "begin");
}

TEST(Definitions, AreRenamedWithAllThatRefersToThem) {
  grf::Diagnostics diagnostics;
  const auto renamed = rename_definition(scene_of(Scopes), grf::ScenePath{0, 0}, "brass", diagnostics);
  ASSERT_TRUE(renamed) << diagnostics.to_text();
  const std::string text = grf::to_text(*renamed);
  EXPECT_THAT(text, HasSubstr("def brass = brdf ward"));
  EXPECT_THAT(text, HasSubstr("combine 0.5 brass, 0.5 dull"));
  EXPECT_THAT(text, HasSubstr("\"outer\"\n    brdf brass"));
  EXPECT_THAT(text, HasSubstr("\"inner\"\n      brdf gold"));
  EXPECT_EQ(scene_of(text), *renamed);
}

TEST(Definitions, AreNotRenamedToWhatMeansSomethingElse) {
  const grf::Scene scene = scene_of(Scopes);
  const auto is_refused = [&scene](const grf::ScenePath& path, const std::string& name) {
    grf::Diagnostics diagnostics;
    const bool is_renamed = rename_definition(scene, path, name, diagnostics).has_value();
    EXPECT_EQ(diagnostics.error_count(), is_renamed ? 0U : 1U);
    return !is_renamed;
  };
  EXPECT_TRUE(is_refused({0, 0}, "dull"));     // exists already
  EXPECT_TRUE(is_refused({0, 2}, "gold"));     // likewise
  EXPECT_TRUE(is_refused({0, 4, 0}, "both"));  // would be found by the last mesh
  EXPECT_TRUE(is_refused({0, 0}, "end"));
  EXPECT_TRUE(is_refused({0, 0}, "a b"));
  EXPECT_FALSE(is_refused({0, 4, 0}, "dull"));  // to which nothing refers there
}

TEST(Definitions, AreChangedIfTheirNamesMeanSomething) {
  grf::Diagnostics diagnostics;
  const grf::Scene scene = scene_of(Scopes);
  grf::BrdfModel sum;
  sum.keyword = "combine";
  sum.terms = {{1, {"gold", {}}}};
  const auto changed = change_definition(scene, grf::ScenePath{0, 1}, sum, diagnostics);
  ASSERT_TRUE(changed);
  EXPECT_THAT(grf::to_text(*changed), HasSubstr("dull = brdf combine 1 gold"));
  EXPECT_FALSE(change_definition(scene, grf::ScenePath{0, 0}, sum, diagnostics));  // refers to itself
  EXPECT_FALSE(change_definition(scene, grf::ScenePath{0, 0}, grf::Colour(1), diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 2U);
}

TEST(Definitions, ThatNothingUsesGo) {
  grf::Diagnostics diagnostics;
  const std::string text = R"(def a = brdf diffuse
def b = brdf combine 1 a
def c = rgb (1, 0, 0)
begin
  // the floor
  begin mesh)" + Triangle + R"(
end
)";
  const grf::Scene left = remove_unused_definitions(scene_of(text));
  EXPECT_THAT(grf::to_text(left), Not(HasSubstr("def")));
  EXPECT_THAT(grf::to_text(left), HasSubstr("// the floor\nbegin mesh"));
  EXPECT_EQ(remove_unused_definitions(scene_of(Scopes)), scene_of(Scopes));
}

TEST(Definitions, OfAFileThatIsIncludedTwiceStayOneText) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(grf::write(scene_of("begin mesh\n" + Triangle), folder.path("part.grf"), diagnostics));
  grf::Scene part = scene_of("begin mesh\nbrdf diffuse\n" + Triangle);
  ASSERT_TRUE(grf::write(part, folder.path("part.grf"), diagnostics));
  const auto text = std::string("include \"part.grf\"\ninclude \"part.grf\"\n");
  auto scene = grf::read_text(text, folder.path("scene.grf"), diagnostics);
  ASSERT_TRUE(scene);
  grf::Scene edited = *scene;
  grf::find_mesh(edited, grf::ScenePath{1, 0})->edit().name = "second";
  EXPECT_EQ(edit_all_places(*scene, edited, diagnostics), 1U);
  EXPECT_EQ((*grf::find_mesh(edited, grf::ScenePath{0, 0}))->name, "second");
  grf::Scene torn = edited;
  grf::find_mesh(torn, grf::ScenePath{0, 0})->edit().name = "first";
  grf::find_mesh(torn, grf::ScenePath{1, 0})->edit().name = "last";
  edit_all_places(edited, torn, diagnostics);
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("included at several places"));
}

TEST(Definitions, AreRenamedBesideAFileThatIsIncludedTwiceAndHasItsOwn) {
  const test::TemporaryFolder folder;
  folder.add("part.grf", "def tile = begin mesh brdf gold" + Triangle + "begin use tile end");
  grf::Diagnostics diagnostics;
  const auto scene =
      grf::read_text("def gold = brdf ward begin include \"part.grf\" include \"part.grf\" end",
                     folder.path("scene.grf"), diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  const auto renamed = rename_definition(*scene, grf::ScenePath{0, 0}, "brass", diagnostics);
  ASSERT_TRUE(renamed) << diagnostics.to_text();
  for (const grf::ScenePath& part : {grf::ScenePath{0, 1, 0, 0}, grf::ScenePath{0, 2, 0, 0}}) {
    EXPECT_EQ(std::get<grf::Reference>(*mesh_at(*renamed, part)->surfaces[0].brdf).name, "brass");
  }
  const auto of_part = rename_definition(*scene, grf::ScenePath{0, 2, 0, 0}, "slab", diagnostics);
  ASSERT_TRUE(of_part) << diagnostics.to_text();
  for (const grf::ScenePath& use : {grf::ScenePath{0, 1, 0, 1}, grf::ScenePath{0, 2, 0, 1}}) {
    EXPECT_EQ(std::get<grf::Use>(block_at(*of_part, use)->content).mesh.name, "slab");
  }
}

TEST(Places, AreFoundByWhereTheyWereWritten) {
  const grf::Scene scene = scene_of(Scopes);
  const auto& block = *block_at(scene, grf::ScenePath{0, 4, 1});
  grf::SourceLocation inside = block.location;
  inside.line += 3;
  EXPECT_EQ(written_at(scene, inside), (grf::ScenePath{0, 4, 1}));
  grf::SourceLocation of_definition = definition_at(scene, grf::ScenePath{0, 1})->location;
  EXPECT_EQ(written_at(scene, of_definition), (grf::ScenePath{0, 1}));
  EXPECT_FALSE(written_at(scene, grf::whole_file("other.grf")));
}

}  // namespace
}  // namespace editor
