#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/visit.h"
#include "tests/grf/reading.h"

namespace grf {
namespace {

using testing::ElementsAre;

const std::string Corners = "begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs ";

std::string light(const std::string& attributes, const std::string& faces = "(0, 1, 2)") {
  return "mesh light begin " + attributes + Corners + "begin faces " + faces + " end faces end ";
}

/// Returns the radiance of the faces of all mesh lights of a text.
std::vector<Colour> radiances(const std::string& text) {
  std::vector<Colour> colours;
  SceneVisitor visitor;
  visitor.mesh_light = [&](const MeshLight& found, const Placement& placement, const Block&) {
    for (std::size_t i = 0; i < found.mesh->face_count(); ++i) {
      colours.push_back(resolve(found.mesh->surface(i), placement.scope).colour);
    }
  };
  visit(scene_of(text), visitor);
  return colours;
}

TEST(MeshLight, EmitsOneUnlessItSaysOtherwise) {
  EXPECT_THAT(radiances(light("")), ElementsAre(Colour(1)));
  EXPECT_THAT(radiances(light("rgb (9, 8, 7) ")), ElementsAre(Colour(9, 8, 7)));
}

TEST(MeshLight, MayEmitAnotherRadianceFromEachFace) {
  EXPECT_THAT(radiances("def warm = rgb (9, 6, 3) begin " +
                        light("rgb warm ",
                              "(0, 1, 2) rgb (1, 2, 3) (0, 1, 2) (0, 2, 1) rgb none (0, 1, 2) rgb "
                              "warm (0, 1, 2)") +
                        "end"),
              ElementsAre(Colour(9, 6, 3), Colour(1, 2, 3), Colour(1, 2, 3), Colour(1), Colour(9, 6, 3)));
}

TEST(MeshLight, LooksItsNamesUpInItsScope) {
  EXPECT_THAT(radiances("def c = rgb (2, 2, 2) begin " + light("rgb c ") + "def c = rgb (3, 3, 3) begin " +
                        light("rgb c ") + "end end"),
              ElementsAre(Colour(2), Colour(3)));
}

TEST(MeshLight, IsNoMesh) {
  const Scene scene = scene_of(light(""));
  EXPECT_EQ(block<MeshLight>(scene.contents).mesh->surfaces[0], Surface());
  SceneVisitor visitor;
  visitor.mesh = [](const Mesh&, const Placement&, const Block&) { ADD_FAILURE(); };
  visit(scene, visitor);
  EXPECT_FALSE(scene == scene_of("begin mesh " + Corners + "begin faces (0, 1, 2) end faces end mesh"));
}

TEST(MeshLight, IsEndedByEndWhateverComesNext) {
  const Scene scene = scene_of(light("") + light("") + "light begin (0, 2, 0) (1, 0, 0) (0, 0, 1) end " +
                               light("") + triangle() + light(""));
  ASSERT_EQ(scene.contents.blocks.size(), 6U);
  block<MeshLight>(scene.contents, 1);
  block<AreaLight>(scene.contents, 2);
  block<Shared<Mesh>>(scene.contents, 4);
}

TEST(EndMeshLightBegin, IsReadByWhatIsInnermost) {
  const std::string mesh = "begin mesh " + Corners + "begin faces (0, 1, 2) end faces end mesh ";
  const Scene in_mesh = scene_of(mesh + "light begin (0, 2, 0) (1, 0, 0) (0, 0, 1) end");
  ASSERT_EQ(in_mesh.contents.blocks.size(), 2U);
  block<AreaLight>(in_mesh.contents, 1);
  const Scene in_transform = scene_of("transform scale (2, 2, 2) begin end " + light(""));
  ASSERT_EQ(in_transform.contents.blocks.size(), 2U);
  block<MeshLight>(in_transform.contents, 1);
}

}  // namespace
}  // namespace grf
