// The same text in two scopes, which define its names differently: a file that is included twice is read
// once, so whatever is cached by its address or its text has two meanings.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "renderer/plan/table_bytes.h"
#include "renderer/reflectance/brdf_maker.h"
#include "tests/plan/plan_helpers.h"
#include "tests/support/temporary_folder.h"

namespace {

using image::Image;
using test::Effect;
using test::PlannedRender;
using test::PlannedScene;
using transport::Rgb;
using transport::Vec3f;

/// Placed twice in the scenes below: at x from -7 to -1, and, translated, from 1 to 7.
std::string left_quad(const std::string& attributes) {
  return test::quad(attributes, "uv (0,0) (-7,-4,0) uv (0,0) (-1,-4,0) uv (0,0) (-1,4,0) uv (0,0) (-7,4,0)");
}

std::string moved(const std::string& blocks) {
  return "transform translation (8,0,0) begin " + blocks + " end\n";
}

std::string twice(const std::string& first, const std::string& second, const std::string& blocks) {
  return first + " begin " + blocks + " end\n" + second + " begin " + moved(blocks) + " end\n";
}

PlannedRender look_at_both() {
  PlannedRender setup;
  setup.eye = Vec3f(0, 0, 10);
  setup.width = 32;
  setup.height = 8;
  setup.samples = 16;
  setup.depth = 1;
  setup.background = 1;
  return setup;
}

/// The radiance from the centre of each of the two placements. Under a background of 1 a diffuse surface
/// sends its kd to the eye, and a specular one its ks.
std::pair<Rgb, Rgb> left_and_right(const Image& image) {
  const auto at = [&image](int x) { return image.at(x, image.height / 2); };
  // The field of view of 45 degrees makes 8 rows 8.28 high at that distance, and each column 1.04 wide.
  return {at(12), at(19)};
}

class ScopeTest : public testing::Test {
 protected:
  PlannedScene planned(const std::string& text, const PlannedRender& setup = look_at_both()) const {
    return PlannedScene(text, setup, folder.path("scene.grf"));
  }

  /// Renders with the kernel and the tables that the plan needs, and with all.
  void expect_seen(const std::string& text, const Rgb& left, const Rgb& right) const {
    for (const bool full : {false, true}) {
      PlannedRender setup = look_at_both();
      setup.full = full;
      const auto [a, b] = left_and_right(planned(text, setup).image());
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(a[i], left[i], 0.02F) << "left, " << (full ? "full" : "planned");
        EXPECT_NEAR(b[i], right[i], 0.02F) << "right, " << (full ? "full" : "planned");
      }
    }
  }

  /// Adds an image of one colour, as uncompressed TGA.
  void add_texture(const std::string& name, const char* bgr) const {
    const unsigned char header[18] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 24, 0};
    folder.add(name, std::string(reinterpret_cast<const char*>(header), sizeof header) + std::string(bgr, 3));
  }

  test::TemporaryFolder folder;
};

TEST_F(ScopeTest, TermsOfASumAreThoseOfThePlace) {
  folder.add("part.grf", left_quad("brdf combine 1 a"));
  expect_seen(twice("def a = brdf diffuse kd=0.1", "def a = brdf diffuse kd=0.9", "include \"part.grf\""),
              Rgb(0.1F), Rgb(0.9F));
}

TEST_F(ScopeTest, TermsOfASumInAnIncludedDefinitionAreThoseOfThePlace) {
  folder.add("part.grf",
             "def s = brdf combine 0.5 a def t = brdf combine 1 s begin " + left_quad("brdf t") + " end");
  expect_seen(twice("def a = brdf diffuse kd=0.2", "def a = brdf diffuse kd=0.8", "include \"part.grf\""),
              Rgb(0.1F), Rgb(0.4F));
}

// A BRDF that the plan considered diffuse in both scopes would be a specular one that is left out.
TEST_F(ScopeTest, PlansKnowWhatASumIsMadeOfAtEachPlace) {
  folder.add("part.grf", left_quad("brdf combine 1 a"));
  const std::string text =
      twice("def a = brdf diffuse kd=0.25", "def a = brdf specular ks=0.5", "include \"part.grf\"");
  expect_seen(text, Rgb(0.25F), Rgb(0.5F));
  const PlannedScene scene = planned(text);
  EXPECT_TRUE(scene.plan()[Effect::MirrorReflection].is_needed);
  EXPECT_EQ(scene.plan().tables.size(), 2U) << "one text, two BRDFs";
}

TEST_F(ScopeTest, TablesArePlannedForEachMeaningOfAText) {
  folder.add("part.grf", left_quad("brdf combine 1 a pdf hemisphere"));
  const PlannedScene scene =
      planned(twice("def a = brdf diffuse", "def a = brdf ward sx=0.1 sy=0.3", "include \"part.grf\""));
  grf::Diagnostics diagnostics;
  const auto bytes = plan::table_bytes(scene.scene(), scene.compile_settings(), diagnostics);
  ASSERT_EQ(diagnostics.error_count(), 0U) << diagnostics.to_text();
  ASSERT_EQ(scene.plan().tables.size(), 2U);
  EXPECT_EQ(bytes.size(), 2U);
  for (const plan::PlannedTable& table : scene.plan().tables) {
    EXPECT_EQ(table.brdf, "combine 1 a");
    EXPECT_TRUE(bytes.contains({table.identity, table.scheme}));
  }
}

TEST_F(ScopeTest, NamesOfAttributesMeanWhatTheyMeanAtThePlace) {
  folder.add("brdf.grf", left_quad("brdf a"));
  expect_seen(twice("def a = brdf diffuse kd=0.1", "def a = brdf diffuse kd=0.9", "include \"brdf.grf\""),
              Rgb(0.1F), Rgb(0.9F));
  folder.add("rgb.grf", left_quad("rgb c brdf diffuse kd=1"));
  expect_seen(twice("def c = rgb (0.1, 0.2, 0.3)", "def c = rgb (0.7, 0.8, 0.9)", "include \"rgb.grf\""),
              Rgb(0.1F, 0.2F, 0.3F), Rgb(0.7F, 0.8F, 0.9F));
  add_texture("blue.tga", "\xFF\0\0");
  add_texture("red.tga", "\0\0\xFF");
  folder.add("texture.grf", left_quad("texture t brdf diffuse kd=0.5"));
  expect_seen(twice("def t = texture \"blue.tga\"", "def t = texture \"red.tga\"", "include \"texture.grf\""),
              Rgb(0, 0, 0.5F), Rgb(0.5F, 0, 0));
  folder.add("use.grf", "use m");
  expect_seen(twice("def m = " + left_quad("brdf diffuse kd=0.1"),
                    "def m = " + left_quad("brdf diffuse kd=0.9"), "include \"use.grf\""),
              Rgb(0.1F), Rgb(0.9F));
}

TEST_F(ScopeTest, DefinedMeshesHaveTheNamesOfTheirOwnPlace) {
  folder.add("part.grf", "def m = " + left_quad("brdf combine 1 a") + " begin use m end");
  expect_seen(twice("def a = brdf diffuse kd=0.1", "def a = brdf diffuse kd=0.9", "include \"part.grf\""),
              Rgb(0.1F), Rgb(0.9F));
}

TEST_F(ScopeTest, SchemesAreThoseOfThePlace) {
  folder.add("part.grf", left_quad("brdf ward pdf p"));
  const auto tables = planned(twice("def p = pdf diffuse", "def p = pdf hemisphere", "include \"part.grf\""))
                          .compiled()
                          .tables();
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].scheme, "diffuse");
  EXPECT_EQ(tables[1].scheme, "hemisphere");
}

TEST_F(ScopeTest, FilesAreThoseBesideTheFileThatNamesThem) {
  add_texture("a/t.tga", "\xFF\0\0");
  add_texture("b/t.tga", "\0\0\xFF");
  const std::string part = left_quad("texture \"t.tga\" brdf diffuse kd=0.5");
  folder.add("a/part.grf", part);
  folder.add("b/part.grf", part);
  const std::string scene = "include \"a/part.grf\" " + moved("include \"b/part.grf\"");
  expect_seen(scene, Rgb(0, 0, 0.5F), Rgb(0.5F, 0, 0));
  folder.add("a/m.brdf", "diffuse kd=0.1");
  folder.add("b/m.brdf", "diffuse kd=0.9");
  folder.add("a/part.grf", left_quad("brdf \"m.brdf\""));
  folder.add("b/part.grf", left_quad("brdf \"m.brdf\""));
  expect_seen(scene, Rgb(0.1F), Rgb(0.9F));
}

TEST_F(ScopeTest, FilesAreThoseBesideTheLinkByWhichAFileIsIncluded) {
  add_texture("a/t.tga", "\xFF\0\0");
  add_texture("b/t.tga", "\0\0\xFF");
  folder.add("a/m.brdf", "diffuse kd=0.1");
  folder.add("b/m.brdf", "diffuse kd=0.9");
  folder.add("textured.grf", left_quad("texture \"t.tga\" brdf diffuse kd=0.5"));
  folder.add("shiny.grf", left_quad("brdf \"m.brdf\""));
  for (const std::string name : {"textured.grf", "shiny.grf"}) {
    for (const std::string in : {"a/", "b/"}) {
      std::filesystem::create_symlink("../" + name, folder.path(in + name));
    }
  }
  expect_seen("include \"a/textured.grf\" " + moved("include \"b/textured.grf\""), Rgb(0, 0, 0.5F),
              Rgb(0.5F, 0, 0));
  expect_seen("include \"a/shiny.grf\" " + moved("include \"b/shiny.grf\""), Rgb(0.1F), Rgb(0.9F));
}

TEST_F(ScopeTest, DataFilesBesideTwoFilesAreTwo) {
  folder.add("a/part.grf", left_quad("brdf measured \"m.binary\""));
  folder.add("b/part.grf", left_quad("brdf measured \"m.binary\""));
  grf::Diagnostics diagnostics;
  const auto scene =
      grf::read_text("include \"a/part.grf\" include \"b/part.grf\"", folder.path("scene.grf"), diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  reflectance::BrdfMaker maker(diagnostics);
  std::vector<std::string> files;
  std::vector<std::string> identities;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    const grf::ResolvedSurface surface = resolve(mesh.surface(0), placement.scope);
    for (const std::string& file : maker.data_files_of(*surface.brdf, surface.brdf_scope))
      files.push_back(file);
    identities.push_back(maker.identity(*surface.brdf, surface.brdf_scope));
  };
  visit(*scene, visitor);
  EXPECT_EQ(files, (std::vector{folder.path("a/m.binary"), folder.path("b/m.binary")}));
  ASSERT_EQ(identities.size(), 2U);
  EXPECT_NE(identities[0], identities[1]);
}

/// A mesh light of twelve triangles, so that it may be an instance: a strip above the left placement.
std::string lamp(const std::string& colour) {
  std::string vertices;
  std::string faces;
  for (int i = 0; i <= 6; ++i) {
    const double x = -3 + i / 3.0;
    vertices += fmt::format("({},2,1)({},2,-1)", x, x);
    if (i < 6) faces += fmt::format("({},{},{},{})", 2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2);
  }
  return "mesh light begin " + colour + " begin vertexs " + vertices + " end begin faces " + faces +
         " end end ";
}

// An instance that emits nothing must not affect another one, nor vice versa.
TEST_F(ScopeTest, InstancesOfALampShineAsTheirPlaceSays) {
  folder.add("lamp.grf", lamp("rgb c"));
  const std::string floor = test::quad("brdf diffuse kd=0.5", "(-4,0,2) (8,0,2) (8,0,-2) (-4,0,-2)");
  PlannedRender setup;
  setup.eye = Vec3f(2, 3, 14);
  setup.target = Vec3f(2, 0, 0);
  setup.depth = 1;
  setup.samples = 32;
  setup.most_copied_triangles = 0;
  const std::array<std::string, 2> colours = {"rgb (0,0,0)", "rgb (50,40,30)"};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string& first = colours[i];
    const std::string& second = colours[1 - i];
    PlannedScene scene =
        planned(floor + twice("def c = " + first, "def c = " + second, "include \"lamp.grf\""), setup);
    EXPECT_EQ(scene.compiled().instance_count(), 2U);
    PlannedScene inline_scene = planned(floor + lamp(first) + moved(lamp(second)), setup);
    EXPECT_EQ(inline_scene.compiled().instance_count(), 0U);
    const test::Estimate a = test::mean_radiance(scene.film());
    const test::Estimate b = test::mean_radiance(inline_scene.film());
    EXPECT_GT(b.mean, 0.05);
    EXPECT_NEAR(a.mean, b.mean, 4 * (a.deviation + b.deviation));
    EXPECT_NEAR(a.mean, b.mean, 0.01 * b.mean);
  }
}

// Regression: 1.8 MB of text overflowed the stack.
TEST_F(ScopeTest, AChainOfSumsOfAnyLengthIsRendered) {
  std::string text = "def c0 = brdf diffuse kd=0.4\n";
  for (int i = 1; i < 60'000; ++i) text += fmt::format("c{} = brdf combine 1 c{}\n", i, i - 1);
  text += "begin " + left_quad("brdf c59999") + moved(left_quad("brdf c1")) + " end";
  PlannedRender setup = look_at_both();
  const auto [left, right] = left_and_right(planned(text, setup).image());
  EXPECT_NEAR(left.x, 0.4F, 0.02F);
  EXPECT_NEAR(right.x, 0.4F, 0.02F);
}

}  // namespace
