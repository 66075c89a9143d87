// The tree of nodes of VRML97: transforms, groups, instances, inlined files.
#include <cmath>

#include <gmock/gmock.h>

#include "grf/read.h"
#include "grf/summary.h"
#include "grf/visit.h"
#include "grf/write.h"
#include "tests/converters/vrml/vrml_reading.h"

namespace convert {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// Where the origin and the ends of the axes of the only mesh come to lie.
std::vector<grf::Vec3d> frame_of(const Reading& reading) {
  std::vector<grf::Vec3d> frame;
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  if (!reading.scene) return {4, grf::Vec3d(0)};
  grf::SceneVisitor visitor;
  visitor.mesh = [&frame](const grf::Mesh&, const grf::Placement& placement, const grf::Block&) {
    for (const grf::Vec3d& p :
         {grf::Vec3d(0), grf::Vec3d(1, 0, 0), grf::Vec3d(0, 1, 0), grf::Vec3d(0, 0, 1)}) {
      frame.push_back(p * placement.to_world);
    }
  };
  grf::visit(*reading.scene, visitor);
  EXPECT_EQ(frame.size(), 4U);
  return frame;
}

void expect_frame(const Reading& reading, const std::vector<grf::Vec3d>& expected) {
  const auto frame = frame_of(reading);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT((frame[i] - expected[i]).length(), 1e-5) << i << ": " << frame[i];
  }
}

Reading in_transform(const std::string& fields) {
  return read_vrml97("Transform { " + fields + " children " + shape(square()) + "}");
}

TEST(Vrml97Transform, ScalesThenTurnsThenMoves) {
  expect_frame(in_transform(""), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  expect_frame(in_transform("translation 1 2 3"), {{1, 2, 3}, {2, 2, 3}, {1, 3, 3}, {1, 2, 4}});
  expect_frame(in_transform("rotation 0 0 2 1.57079633"), {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}});
  expect_frame(in_transform("rotation 0 0 0 1"), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  expect_frame(in_transform("translation 1 0 0 scale 2 3 4 rotation 0 0 1 1.57079633"),
               {{1, 0, 0}, {1, 2, 0}, {-2, 0, 0}, {1, 0, 4}});
}

TEST(Vrml97Transform, TurnsAndScalesAboutItsCenter) {
  expect_frame(in_transform("center 1 0 0 scale 2 2 2"), {{-1, 0, 0}, {1, 0, 0}, {-1, 2, 0}, {-1, 0, 2}});
  expect_frame(in_transform("center 1 0 0 rotation 0 0 1 3.14159265"),
               {{2, 0, 0}, {1, 0, 0}, {2, -1, 0}, {2, 0, 1}});
}

TEST(Vrml97Transform, ScalesAlongOtherAxes) {
  // Twice as long along the line x = y.
  expect_frame(in_transform("scale 2 1 1 scaleOrientation 0 0 1 0.78539816"),
               {{0, 0, 0}, {1.5, 0.5, 0}, {0.5, 1.5, 0}, {0, 0, 1}});
}

TEST(Vrml97Transform, ActsOnThoseInsideIt) {
  const Reading reading = read_vrml97(
      "Transform { translation 1 0 0 children [ Group { children Transform { scale 2 2 2 children [" +
      shape(square()) + "] } } ] }");
  expect_frame(reading, {{1, 0, 0}, {3, 0, 0}, {1, 2, 0}, {1, 0, 2}});
}

TEST(Vrml97Transform, MayBeNestedDeep) {
  std::string text = shape(square());
  for (int i = 0; i < 490; ++i) text = "Transform { translation 0 0 1 children " + text + "}";
  const Reading reading = read_vrml97(text);
  EXPECT_LT((frame_of(reading)[0] - grf::Vec3d(0, 0, 490)).length(), 1e-3);
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(grf::read_text(grf::to_text(*reading.scene), "again.grf", diagnostics).has_value());
}

TEST(Vrml97Transform, WithoutHeightLeavesMeshesOut) {
  const Reading reading =
      read_vrml97("Transform { scale 1 0 1 children " + shape(square()) + "}" + shape("Box {}"));
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_EQ(meshes_of(*reading.scene).size(), 1U);
  EXPECT_THAT(reading.text(), HasSubstr("1 mesh was left out"));
  const Reading large =
      read_vrml97("Transform { scale 1e30 1 1 children Transform { scale 1e30 1 1 center 1e30 0 0 children " +
                  shape(square()) + "} }");
  EXPECT_THAT(large.text(), HasSubstr("error: the transform is too large for floats"));
}

TEST(Vrml97, GroupingNodesKeepTheirChildren) {
  for (const std::string type : {"Group", "Anchor", "Billboard", "Collision"}) {
    EXPECT_EQ(mesh97(type + " { children [ " + shape(square()) + " ] }").face_count(), 2U) << type;
  }
  EXPECT_EQ(
      mesh97("Collision { proxy " + shape("Box {}") + " children " + shape(square()) + "}").face_count(), 2U);
  const Reading other = read_vrml97("Shape { geometry Box {} } Group { children Box {} }");
  EXPECT_THAT(other.text(), HasSubstr("1 Box node was skipped: it is not allowed there"));
}

TEST(Vrml97, ASwitchShowsItsChoice) {
  const std::string choices = "choice [ " + shape("Box {}") + shape(square()) + "] }";
  const Reading reading = read_vrml97("Switch { whichChoice 1 " + choices);
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_EQ(meshes_of(*reading.scene)[0].face_count(), 2U);
  EXPECT_THAT(reading.text(), HasSubstr("1 choice of a Switch was left out"));
  for (const std::string which : {"", "whichChoice -1 ", "whichChoice 2 "}) {
    EXPECT_THAT(read_vrml97("Switch { " + which + choices).text(),
                HasSubstr("2 choices of Switches were left out"));
  }
}

TEST(Vrml97, AnLodShowsItsFirstLevel) {
  const Reading reading =
      read_vrml97("LOD { range [ 5 9 ] level [ " + shape(square()) + shape("Box {}") + "Group {} ] } LOD {}");
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_EQ(meshes_of(*reading.scene)[0].face_count(), 2U);
  EXPECT_THAT(reading.text(), HasSubstr("2 levels of LODs were left out: the first one is kept"));
}

TEST(Vrml97, NamesMeshesByTheNearestName) {
  EXPECT_EQ(mesh97("DEF a Transform { children DEF b Group { children " + shape(square()) + "} }").name, "b");
  EXPECT_EQ(mesh97("DEF a Group { children " + shape("DEF c " + square()) + "}").name, "c");
  EXPECT_EQ(mesh97("DEF a Group { children DEF d " + shape("DEF c " + square()) + "}").name, "d");
  EXPECT_EQ(mesh97(shape(square())).name, "");
}

TEST(Vrml97, ShapesThatAreUsedAgainAreDefinedOnce) {
  const Reading reading =
      read_vrml97("DEF part Transform { translation 5 0 0 children DEF it " + shape(square()) +
                  "} Transform { scale 2 2 2 children [ USE part USE it ] } " + shape("Box {}") +
                  "Shape { geometry DEF g Box {} } Shape { geometry USE g }");
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_THAT(reading.text(), IsEmpty());
  const auto definitions = definitions_of(*reading.scene);
  ASSERT_EQ(definitions.size(), 2U);
  EXPECT_EQ(definitions[0].name, "it");
  EXPECT_EQ(definitions[1].name, "g");
  const grf::Summary summary = grf::summarize(*reading.scene);
  EXPECT_EQ(summary.meshes, 6U);
  EXPECT_EQ(summary.instances, 5U);
  EXPECT_NEAR(summary.area, 1 + 4 + 4 + 3 * 24, 1e-4);
  grf::Diagnostics diagnostics;
  const auto again = grf::read_text(grf::to_text(*reading.scene), "again.grf", diagnostics);
  ASSERT_TRUE(again.has_value()) << diagnostics.to_text();
  EXPECT_EQ(*again, *reading.scene);
}

TEST(Vrml97, GeometryWithAnotherAppearanceIsAnotherMesh) {
  const Reading reading = read_vrml97(
      "Shape { geometry DEF g Box {} appearance DEF a Appearance { material DEF m Material { diffuseColor 1 "
      "0 0 } } }"
      "Shape { geometry USE g } Shape { geometry USE g appearance Appearance { material USE m } }"
      "Shape { appearance USE a geometry USE g }");
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const auto definitions = definitions_of(*reading.scene);
  ASSERT_EQ(definitions.size(), 2U) << "the material, and the mesh that is placed twice";
  EXPECT_EQ(definitions[0].name, "m");
  const auto meshes = meshes_of(*reading.scene);
  ASSERT_EQ(meshes.size(), 4U);
  EXPECT_EQ(material_of(meshes[0], 0), "m");
  EXPECT_EQ(material_of(meshes[1], 0), "");
  EXPECT_EQ(material_of(meshes[2], 0), "m");
}

class Vrml97Inline : public testing::Test {
 protected:
  Reading read(const std::string& name) { return read_path(folder_.path(name)); }
  void add(const std::string& name, const std::string& text) {
    folder_.add(name, "#VRML V2.0 utf8\n" + text);
  }
  test::TemporaryFolder folder_;
};

TEST_F(Vrml97Inline, StandsForAnotherFile) {
  add("a.wrl",
      "DEF b Transform { translation 0 0 1 children DEF i Inline { url [ \"http://x/y.wrl\" \"sub/b.wrl\" ] "
      "} } USE i");
  add("sub/b.wrl", "Inline { url \"file:c.wrl\" } " +
                       shape(square(), "material Material {} texture ImageTexture { url \"t.png\" }"));
  folder_.add("sub/c.wrl", "#VRML V1.0 ascii\nTranslation { translation 0 0 1 } Cube {}");
  const Reading reading = read("a.wrl");
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const auto meshes = meshes_of(*reading.scene);
  ASSERT_EQ(meshes.size(), 4U);
  EXPECT_EQ(meshes[0].face_count(), 6U);
  EXPECT_EQ(std::get<grf::Texture>(*meshes[1].surface(0).texture).file, "sub/t.png");
  EXPECT_EQ(grf::summarize(*reading.scene).bounds.max.z, 3);
  EXPECT_EQ(reading.diagnostics.files().size(), 3U);
}

TEST_F(Vrml97Inline, ThatIsMissingIsLeftOutWithAWarning) {
  add("a.wrl", "Inline { url \"b.wrl\" }\nInline { url \"http://x/y.wrl\" } Inline {} " + shape(square()));
  const Reading reading = read("a.wrl");
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_THAT(reading.text(), HasSubstr("a.wrl:2:1: warning: cannot read '"));
  EXPECT_THAT(reading.text(), HasSubstr("a.wrl:3:1: warning: what is inlined here is no file: left out"));
}

TEST_F(Vrml97Inline, ThatIsBrokenIsAnErrorAtItsPlace) {
  add("a.wrl", shape(square()) + "Inline { url \"b.wrl\" }");
  add("b.wrl", "Shape {\n geometry ]");
  const Reading reading = read("a.wrl");
  EXPECT_FALSE(reading.scene.has_value());
  EXPECT_THAT(reading.text(), HasSubstr("b.wrl:3:11: error: found ']'"));
  EXPECT_THAT(reading.text(), HasSubstr("a.wrl:3"));
}

TEST_F(Vrml97Inline, OfItselfIsAnError) {
  add("a.wrl", "Inline { url \"b.wrl\" }");
  add("b.wrl", "Inline { url \"./sub/../a.wrl\" }");
  folder_.add("sub/empty", "");
  const Reading reading = read("a.wrl");
  EXPECT_FALSE(reading.scene.has_value());
  EXPECT_THAT(reading.text(), HasSubstr("b.wrl:2:1: error: the file inlines itself: "));
}

TEST_F(Vrml97Inline, InChainsAndAsABombIsAnError) {
  for (int i = 0; i < 100; ++i) {
    add("c" + std::to_string(i) + ".wrl", "Inline { url \"c" + std::to_string(i + 1) + ".wrl\" }");
    const std::string next = "Inline { url \"d" + std::to_string(i + 1) + ".wrl\" }";
    add("d" + std::to_string(i) + ".wrl", i < 50 ? next + next : shape("Box {}"));
  }
  EXPECT_THAT(read("c0.wrl").text(), HasSubstr("error: files inline each other more than 64 deep"));
  EXPECT_THAT(read("d0.wrl").text(), HasSubstr("there are more than 1000000 nodes"));
}

}  // namespace
}  // namespace convert
