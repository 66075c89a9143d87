#include "editor/document/reimport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/scene_objects.h"
#include "grf/read.h"
#include "grf/write.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using grf::Vec3f;
using testing::ElementsAre;
using testing::HasSubstr;

const QString Model = "/models/chair.obj";

/// Two triangles beside each other at this height; the second one may be missing.
std::string seat(double height, const std::string& faces, const std::string& name = "seat") {
  const std::string y = std::to_string(height);
  return "begin mesh \"" + name + "\" begin vertexs (0," + y + ",0) (1," + y + ",0) (1," + y + ",1) (0," + y +
         ",1) end vertexs begin faces " + faces + " end faces end mesh\n";
}

const std::string Both = "(0,1,2) (0,2,3)";

/// The scene after an import, in which the author has moved the chair and given its second face a BRDF.
grf::Scene assigned() {
  grf::Scene scene = scene_of(seat(0, "(0,1,2) brdf mirror (0,2,3)") + seat(2, Both, "back"));
  mark_imported(scene, Model);
  // As an author does: the comment goes with the mesh.
  grf::Scene moved = scene_of("transform translation (5,0,0) begin end");
  auto& transform = std::get<grf::Transform>(moved.contents.blocks[0].content);
  transform.body.blocks = scene.contents.blocks;
  return moved;
}

const grf::Mesh& mesh_called(const grf::Scene& scene, const std::string& name) {
  const SceneObjects objects = objects_of(scene, "scene.grf");
  for (const MeshObject& object : objects.meshes) {
    if (object.mesh->name == name) {
      static grf::Mesh found;
      found = *object.mesh;
      return found;
    }
  }
  throw std::runtime_error("no mesh is called " + name);
}

TEST(Reimport, KnowsTheFileAfterSavingAndMoving) {
  grf::Diagnostics diagnostics;
  const auto read = grf::read_text(grf::to_text(assigned()), "scene.grf", diagnostics);
  ASSERT_TRUE(read) << diagnostics.to_text();
  EXPECT_EQ(import_source(*read, grf::ScenePath{0}), Model);
  EXPECT_EQ(import_source(scene_of(seat(0, Both)), grf::ScenePath{0}), "");
  EXPECT_EQ(reimported(*read, Model, scene_of(seat(1, Both) + seat(2, Both, "back"))).meshes, 1U);
}

TEST(Reimport, KeepsWhatWasAssigned) {
  const Reimported now = reimported(assigned(), Model, scene_of(seat(1, Both) + seat(2, Both, "back")));
  EXPECT_EQ(now.meshes, 1U) << "the back is the same";
  EXPECT_TRUE(now.problems.isEmpty());
  const grf::Mesh& mesh = mesh_called(now.scene, "seat");
  EXPECT_EQ(mesh.geometry->positions[0], Vec3f(0, 1, 0));
  EXPECT_FALSE(mesh.surface(0).brdf);
  EXPECT_TRUE(mesh.surface(1).brdf);
  EXPECT_THAT(grf::to_text(now.scene), HasSubstr("translation (5, 0, 0)"));
}

TEST(Reimport, SaysWhatNoLongerFits) {
  const Reimported more =
      reimported(assigned(), Model, scene_of(seat(0, Both + " (0,1,3)") + seat(0, Both, "arm")));
  EXPECT_EQ(more.meshes, 1U);
  EXPECT_THAT(more.problems, ElementsAre("seat has 1 more face, with the surface of the mesh",
                                         "back is no longer in the file: it stays as it was",
                                         "arm is new in the file: append the file to get it"));
  const grf::Mesh& mesh = mesh_called(more.scene, "seat");
  ASSERT_EQ(mesh.face_count(), 3U);
  EXPECT_TRUE(mesh.surface(1).brdf);
  EXPECT_FALSE(mesh.surface(2).brdf);
  const Reimported fewer =
      reimported(assigned(), Model, scene_of(seat(0, "(0,1,2)") + seat(2, Both, "back")));
  EXPECT_THAT(fewer.problems, ElementsAre("seat has 1 face less"));
  EXPECT_EQ(mesh_called(fewer.scene, "seat").face_count(), 1U);
}

TEST(Reimport, LeavesMeshesOfOtherFiles) {
  const Reimported now = reimported(assigned(), "/models/table.obj", scene_of(seat(1, Both)));
  EXPECT_EQ(now.meshes, 0U);
  EXPECT_EQ(now.scene, assigned());
}

}  // namespace
}  // namespace editor
