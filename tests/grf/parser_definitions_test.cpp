#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/visit.h"
#include "tests/grf/reading.h"

namespace grf {
namespace {

using testing::ElementsAre;

std::vector<std::string> names_in(const std::string& definitions) {
  const Scene scene = scene_of(definitions + " begin end");
  std::vector<std::string> names;
  for (const Definition& definition : block<DefinitionScope>(scene.contents).definitions) {
    names.push_back(definition.name);
  }
  return names;
}

TEST(Definitions, NeedOneDefForAll) {
  EXPECT_THAT(names_in("def a = rgb (1, 0, 0) def b = brdf ward def c = pdf diffuse"),
              ElementsAre("a", "b", "c"));
  EXPECT_THAT(names_in("def a = rgb (1, 0, 0) b = brdf ward c = pdf diffuse"), ElementsAre("a", "b", "c"));
  EXPECT_THAT(names_in("def a = brdf ward sx=1 b = rgb (1, 0, 0) c = brdf ward d = brdf phong n=2"),
              ElementsAre("a", "b", "c", "d"));
}

TEST(Definitions, AreToldFromParametersByWhatFollows) {
  const Scene scene =
      scene_of("def a = brdf ward b=1 c=true d=(1, 2, 3) e=-1 f = colour (0, 0, 0) begin end");
  const auto& definitions = block<DefinitionScope>(scene.contents).definitions;
  ASSERT_EQ(definitions.size(), 2U);
  EXPECT_EQ(std::get<BrdfModel>(definitions[0].body).arguments.size(), 4U);
  EXPECT_EQ(definitions[1].body, decltype(definitions[1].body)(Colour(0, 0, 0)));
}

// The channel tells the image of a parameter from a texture that is defined.
TEST(Definitions, AreToldFromImagesOfParameters) {
  const Scene scene = scene_of(
      "def a = brdf ward b=texture \"1.png\" g c=texture \"2.png\" RGB * (1, 2, 3) d = texture \"3.png\" "
      "e = brdf ward f = texture \"4.png\" r = brdf ward g=texture \"5.png\" a * 0.5 begin "
      "begin mesh brdf ward b=texture \"6.png\" rgb rgb (1, 0, 0) texture \"7.png\" begin vertexs end "
      "begin faces end end end");
  const auto& scope = block<DefinitionScope>(scene.contents);
  std::vector<std::string> names;
  for (const Definition& definition : scope.definitions) names.push_back(definition.name);
  ASSERT_THAT(names, ElementsAre("a", "d", "e", "f", "r"));
  const auto& a = std::get<BrdfModel>(scope.definitions[0].body).arguments;
  ASSERT_EQ(a.size(), 2U);
  EXPECT_EQ(a[0].map, (ParameterMap{"1.png", ImageChannel::Green}));
  EXPECT_EQ(a[0].value, Value(1.0F));
  EXPECT_EQ(a[1].map, (ParameterMap{"2.png", ImageChannel::Rgb}));
  EXPECT_EQ(a[1].value, Value(Colour(1, 2, 3)));
  EXPECT_EQ(std::get<Texture>(scope.definitions[3].body).file, "4.png");
  const auto& r = std::get<BrdfModel>(scope.definitions[4].body).arguments;
  ASSERT_EQ(r.size(), 1U);
  EXPECT_EQ(r[0].map, (ParameterMap{"5.png", ImageChannel::Alpha}));
  EXPECT_EQ(r[0].value, Value(0.5F));
  const Surface& surface = block<Shared<Mesh>>(scope.body)->surfaces.at(0);
  EXPECT_EQ(std::get<BrdfModel>(*surface.brdf).arguments[0].map, (ParameterMap{"6.png", ImageChannel::Rgb}));
  EXPECT_EQ(std::get<Colour>(*surface.colour), Colour(1, 0, 0));
  EXPECT_EQ(std::get<Texture>(*surface.texture).file, "7.png");
}

TEST(Definitions, SayWhatAnImageOfAParameterLacks) {
  EXPECT_EQ(error_in(triangle("brdf ward a=texture \"b.png\"")),
            "found 'begin', expected the channel of the image for 'a': r, g, b, a or rgb");
  EXPECT_EQ(error_in(triangle("brdf ward a=texture \"b.png\" r * c")),
            "found 'c', expected a number or three numbers in parentheses, a factor of 'a'");
}

TEST(Definitions, NameBothReadingsOfWhatIsNoValue) {
  EXPECT_EQ(error_in("def a = brdf ward b = none begin end"),
            "found 'none', expected a value for the parameter 'b' of 'ward', or 'rgb', 'brdf', 'pdf', "
            "'texture' or 'begin mesh' for a definition called 'b'");
  EXPECT_EQ(error_in("def a = brdf ward b = begin end"), "found 'end', expected 'mesh' after this 'begin'");
}

TEST(Definitions, TakeOtherWordsForValues) {
  const Scene scene = scene_of(
      "def a = pdf few mode=reject n=1 b = rgb (0, 0, 0) c = pdf few mode=begin mesh "
      "begin vertexs end begin faces end end begin end");
  const auto& definitions = block<DefinitionScope>(scene.contents).definitions;
  ASSERT_EQ(definitions.size(), 4U);
  const auto& arguments = std::get<PdfModel>(definitions[0].body).arguments;
  ASSERT_EQ(arguments.size(), 2U);
  EXPECT_EQ(arguments[0].value, Value(Word{"REJECT"}));
  EXPECT_EQ(definitions[3].name, "mode");
}

std::vector<std::string> layers_of(const Definition& definition) {
  std::vector<std::string> names;
  for (const CombineTerm& term : std::get<BrdfModel>(definition.body).terms) names.push_back(term.brdf.name);
  return names;
}

// Any name can be a layer's, also one that is a keyword elsewhere; what follows tells it from a definition.
TEST(Definitions, NameLayersThatAreCalledAsKeywords) {
  const Scene scene = scene_of(
      "def rgb = brdf diffuse texture = brdf diffuse brdf = brdf diffuse pdf = brdf diffuse "
      "a = brdf layer base=rgb top=brdf b = brdf layer base=texture top=pdf c = brdf coat base=brdf ior=1.4 "
      "d = brdf layer top=pdf base=rgb base = rgb (1, 0, 0) top = texture \"a.png\" "
      "e = brdf coat base=pdf begin "
      "begin mesh brdf layer base=rgb top=texture texture \"b.png\" begin vertexs end begin faces end end "
      "end");
  const auto& scope = block<DefinitionScope>(scene.contents);
  std::vector<std::string> names;
  for (const Definition& definition : scope.definitions) names.push_back(definition.name);
  ASSERT_THAT(names, ElementsAre("rgb", "texture", "brdf", "pdf", "a", "b", "c", "d", "base", "top", "e"));
  EXPECT_THAT(layers_of(scope.definitions[4]), ElementsAre("rgb", "brdf"));
  EXPECT_THAT(layers_of(scope.definitions[5]), ElementsAre("texture", "pdf"));
  EXPECT_THAT(layers_of(scope.definitions[6]), ElementsAre("brdf"));
  EXPECT_THAT(layers_of(scope.definitions[7]), ElementsAre("rgb", "pdf"));
  EXPECT_THAT(layers_of(scope.definitions[10]), ElementsAre("pdf"));
  const Surface& surface = block<Shared<Mesh>>(scope.body)->surfaces.front();
  EXPECT_EQ(std::get<BrdfModel>(*surface.brdf).terms.size(), 2U);
  EXPECT_TRUE(surface.texture.has_value());
  EXPECT_THAT(names_in("def a = brdf diffuse b = brdf coat base=a base = brdf ward sx=1 top = pdf diffuse"),
              ElementsAre("a", "b", "base", "top"));
}

// Reading ends before `check` could explain the parameter.
TEST(Definitions, SayWhatWasTakenForAParameter) {
  EXPECT_EQ(
      error_in("def a = brdf ward b = phong c = brdf combine 1 b begin end"),
      "no BRDF called 'b' is defined here: 'b = phong' is a parameter, because 'brdf' or 'pdf' is missing");
}

TEST(Definitions, AreCaseSensitiveAndMayHaveTheNamesOfKeywords) {
  EXPECT_THAT(names_in("def red = rgb (1, 0, 0) Red = rgb (0.9, 0, 0)"), ElementsAre("red", "Red"));
  EXPECT_THAT(names_in("def ward = brdf phong light = brdf ward transform = rgb (0, 0, 0) include = pdf a "
                       "mesh = pdf b rgb = rgb (0, 0, 0) brdf = brdf ward"),
              ElementsAre("ward", "light", "transform", "include", "mesh", "rgb", "brdf"));
}

TEST(Definitions, CannotHaveReservedNames) {
  for (const std::string name : {"begin", "end", "none", "use", "true", "false", "USE"}) {
    EXPECT_EQ(error_in("def " + name + " = rgb (1, 0, 0) begin end"),
              "'" + name + "' is a reserved word, expected another name");
    EXPECT_EQ(error_in("def a = brdf ward " + name + " = rgb (1, 0, 0) begin end"),
              "'" + name + "' is a reserved word, expected another name");
  }
  EXPECT_EQ(error_in("def def = rgb (1, 0, 0) begin end"), "found '=', expected the name of a definition");
}

/// What the attribute `brdf` of the mesh in the definitions means: its keyword.
std::string meaning_of(const std::string& definitions, const std::string& brdf,
                       const std::string& end = "end") {
  std::string meaning = "nothing";
  SceneVisitor visitor;
  visitor.mesh = [&](const Mesh& mesh, const Placement& placement, const Block&) {
    const ResolvedSurface surface = resolve(mesh.surface(0), placement.scope);
    if (surface.brdf != nullptr) meaning = surface.brdf->keyword;
  };
  visit(scene_of(definitions + " begin " + triangle("brdf " + brdf) + end), visitor);
  return meaning;
}

TEST(BareWord, IsAReferenceWhereADefinitionOfThatKindAndSpellingIsInScope) {
  EXPECT_EQ(meaning_of("def ward = brdf phong", "ward"), "phong");
  EXPECT_EQ(meaning_of("def ward = brdf phong", "Ward"), "Ward") << "another spelling";
  EXPECT_EQ(meaning_of("def ward = brdf phong", "ward sx=1"), "ward") << "a reference takes no parameters";
  EXPECT_EQ(meaning_of("def ward = pdf diffuse", "ward"), "ward") << "another kind";
  EXPECT_EQ(meaning_of("def ward = rgb (1, 0, 0)", "ward"), "ward");
  EXPECT_EQ(meaning_of("def light = brdf ward", "light"), "ward");
}

TEST(Scope, EndsWithTheBody) {
  EXPECT_EQ(error_in("def red = rgb (1, 0, 0) begin end " + triangle("rgb red")),
            "no colour called 'red' is defined here");
}

TEST(Scope, InnerNamesHideOuterOnes) {
  const std::string outer = "def a = brdf ward begin ";
  EXPECT_EQ(meaning_of(outer + "def a = brdf phong", "a", "end end"), "phong");
  EXPECT_EQ(meaning_of(outer + "def b = brdf phong", "a", "end end"), "ward");
  EXPECT_EQ(meaning_of(outer + "def a = rgb (1, 0, 0)", "a", "end end"), "a")
      << "all kinds share one name space";
  EXPECT_EQ(error_in("def a = rgb (1, 0, 0) begin def a = brdf ward begin " + triangle("rgb a") + " end end"),
            "'a' is a BRDF, expected a colour");
}

TEST(Scope, KnowsWhatCanBeSeen) {
  const Definition outer{"a", Colour(1, 0, 0), {}, {}};
  const Definition other{"b", PdfModel(), {}, {}};
  const Definition inner{"a", BrdfModel(), {}, {}};
  ScopeStack stack;
  for (const Definition* definition : {&outer, &other, &inner}) stack.enter(*definition);
  const Scope scope = stack.scope();
  EXPECT_EQ(scope.find("a"), &inner);
  EXPECT_EQ(scope.find<Colour>("a"), nullptr);
  EXPECT_EQ(scope.find("c"), nullptr);
  EXPECT_THAT(scope.names(), testing::UnorderedElementsAre("a", "b"));
  EXPECT_THAT(scope.names_of<BrdfModel>(), ElementsAre("a"));
  EXPECT_THAT(scope.names_of<Colour>(), ElementsAre());
  stack.leave(1);
  EXPECT_EQ(stack.scope().find("a"), &outer);
  stack.leave(2);
  EXPECT_EQ(stack.scope().find("a"), nullptr);
  EXPECT_THAT(stack.scope().names(), ElementsAre());
}

TEST(Scope, OfNothingIsEmpty) {
  EXPECT_TRUE(Scope().names().empty());
  EXPECT_EQ(Scope().find("a"), nullptr);
}

TEST(Scope, OfADefinitionIsWhatStandsBeforeIt) {
  const Definition outer{"a", Colour(1, 0, 0), {}, {}};
  const Definition mesh{"m", Shared<Mesh>(), {}, {}};
  const Definition inner{"a", BrdfModel(), {}, {}};
  ScopeStack stack;
  for (const Definition* definition : {&outer, &mesh, &inner}) stack.enter(*definition);
  const Scope around = stack.scope().around("m");
  EXPECT_EQ(around.find("a"), &outer);
  EXPECT_EQ(around.find("m"), nullptr);
  EXPECT_THAT(around.names(), ElementsAre("a"));
  EXPECT_EQ(stack.scope().around("nothing").find("a"), nullptr);
}

TEST(UnknownColour, IsReportedOnceWithTheNearestNames) {
  const std::string definitions = "def red = rgb (1, 0, 0) rot = rgb (0.9, 0, 0) rad = brdf ward begin ";
  EXPECT_EQ(error_in(definitions + triangle("rgb rde", "rgb rde") + triangle("rgb rde") + "end"),
            "no colour called 'rde' is defined here: did you mean 'red'?");
}

}  // namespace
}  // namespace grf
