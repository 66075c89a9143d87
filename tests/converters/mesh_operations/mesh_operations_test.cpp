#include "converters/mesh_operations/mesh_operations.h"

#include <algorithm>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/mesh_operations/triangulate.h"
#include "grf/read.h"
#include "tests/converters/mesh_operations/meshes.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

grf::Scene scene_of_text(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(text, "scene.grf", diagnostics);
  EXPECT_TRUE(scene.has_value()) << diagnostics.to_text();
  return scene.value_or(grf::Scene());
}

const std::string Square =
    "begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end vertexs begin faces (0,1,2,3) end faces ";

TEST(MeshOperations, ReachAllMeshes) {
  grf::Scene scene =
      scene_of_text("def a = begin mesh " + Square + "end mesh begin use a mesh light begin " + Square +
                    "end transform scale (1, 2, 1) begin begin mesh " + Square + "end mesh end end");
  MeshOperations operations;
  operations.triangulate = true;
  grf::Diagnostics diagnostics;
  apply(operations, scene, {}, diagnostics);
  std::size_t faces = 0;
  for (const grf::Mesh& mesh : meshes_of(scene)) faces += mesh.face_count();
  EXPECT_EQ(faces, 4U) << "of the mesh that is used and of that under the transform";
  const auto& scope = std::get<grf::DefinitionScope>(scene.contents.blocks[0].content);
  EXPECT_EQ(std::get<grf::MeshLight>(scope.body.blocks[1].content).mesh->face_count(), 2U);
  EXPECT_THAT(diagnostics.entries(), IsEmpty());
}

TEST(MeshOperations, AreDoneInTheirOrder) {
  grf::Scene scene;
  scene.contents.blocks.emplace_back();
  scene.contents.blocks[0].content = grf::Shared<grf::Mesh>(torn(sheet(8)));
  MeshOperations operations;
  operations.weld = 0;
  operations.decimate = 0.1;
  operations.normals = Normals::Smooth;
  operations.crease = std::numbers::pi;
  grf::Diagnostics diagnostics;
  apply(operations, scene, {}, diagnostics);
  const grf::Mesh mesh = meshes_of(scene).front();
  EXPECT_LT(mesh.face_count(), 20U) << "what was torn could not be decimated";
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i)
    EXPECT_EQ(mesh.geometry->normals[i], grf::Vec3f(0, 0, 1));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("303 vertices were welded\n"));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr(" of 128 triangles are left"));
}

TEST(MeshOperations, SayWhatIsLost) {
  grf::Scene scene = scene_of_text(
      "begin mesh begin vertexs (0,0,0) (1,0,0) (0.5,0.01,0) (9,9,9) end vertexs begin faces (0,1,2) (0,2,1) "
      "end "
      "faces end mesh begin mesh begin vertexs (0,0,0) (1,0,0) (1,0.01,0) end vertexs begin faces (0,1,2) "
      "end "
      "faces end mesh");
  MeshOperations operations;
  operations.weld = 0.1;
  grf::Diagnostics diagnostics;
  apply(operations, scene, {}, diagnostics);
  EXPECT_THAT(diagnostics.losses(),
              ElementsAre("1 vertex was left out: no face uses it",
                          "1 face was left out: fewer than three distinct corners remain after welding"));
  EXPECT_EQ(diagnostics.warning_count(), 2U);
  EXPECT_EQ(meshes_of(scene)[1].face_count(), 0U);
}

TEST(MeshOperations, SayWhatCannotBeDecimated) {
  grf::Scene scene = scene_of_text("begin mesh " + Square + "end mesh");
  MeshOperations operations;
  operations.decimate = 0.1;
  grf::Diagnostics diagnostics;
  apply(operations, scene, {}, diagnostics);
  EXPECT_THAT(
      diagnostics.to_text(),
      HasSubstr("1 mesh has more triangles than asked by 2: holes, borders, seams and shape are preserved"));
}

TEST(MeshOperations, SmoothSubdivideAndCutInThisOrder) {
  grf::Scene scene;
  scene.contents.blocks.emplace_back();
  grf::MeshDraft bent(sheet(2));
  bent.positions[4].z = 1;  // in the middle
  bent.irradiance.set(0, grf::Colour(1));
  scene.contents.blocks[0].content = grf::Shared<grf::Mesh>(grf::MeshDraft(bent));
  MeshOperations operations;
  operations.smooth = 1;
  operations.subdivide = Subdivision{SubdivisionScheme::CatmullClark, 1};
  operations.triangulate = true;
  grf::Diagnostics diagnostics;
  apply(operations, scene, {}, diagnostics);
  const grf::Mesh mesh = meshes_of(scene).front();
  EXPECT_EQ(mesh.face_count(), 8U * 3U * 2U);
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("note: 8 faces were subdivided into 24\n"));
  EXPECT_THAT(diagnostics.losses(), ElementsAre("1 vertex lost its irradiance: the mesh was subdivided"));
  // One step of Taubin's leaves (1 - 0.5) (1 + 1/1.9) of the height. Of the six faces around it a third of
  // that is the height of each middle: (F + N + 4 P)/6, where N = 0.
  const float height = 0.5F * (1 + 1 / 1.9F);
  float highest = 0;
  for (const grf::Vec3f& p : mesh.geometry->positions) highest = std::max(highest, p.z);
  EXPECT_NEAR(highest, height * (1 / 3.0F + 4) / 6, 1e-6F);
}

TEST(MeshOperations, SayWhichEdgesHaveMoreThanTwoFaces) {
  const std::string book =
      "begin mesh begin vertexs (0,0,0) (1,0,0) (0,1,0) (0,-1,0) (0,0,1) end vertexs begin faces (0,1,2) "
      "(0,1,3) "
      "(0,1,4) end faces end mesh";
  for (const bool is_subdivided : {true, false}) {
    grf::Scene scene = scene_of_text(book);
    MeshOperations operations;
    operations.smooth = 2;
    if (is_subdivided) operations.subdivide = Subdivision{SubdivisionScheme::Loop, 2};
    grf::Diagnostics diagnostics;
    apply(operations, scene, {}, diagnostics);
    EXPECT_THAT(diagnostics.to_text(),
                HasSubstr("warning: 1 edge was kept sharp: more than two faces share each\n"));
  }
}

TEST(MeshOperations, RefuseTooManyFaces) {
  grf::Scene scene = scene_of_text("begin mesh " + Square + "end mesh");
  const grf::Scene before = scene;
  MeshOperations operations;
  operations.subdivide = Subdivision{SubdivisionScheme::CatmullClark, 15};
  grf::Diagnostics diagnostics;
  apply(operations, scene, {}, diagnostics);
  EXPECT_THAT(
      diagnostics.to_text(),
      HasSubstr("error: a mesh would have 1.07e+09 faces after subdivision, over the limit of 1e+09: use "
                "fewer levels"));
  EXPECT_EQ(scene, before);
}

TEST(MeshOperations, LeaveASceneAsItIsWhereThereAreNone) {
  grf::Scene scene = scene_of_text("begin mesh " + Square + "end mesh");
  const grf::Scene before = scene;
  grf::Diagnostics diagnostics;
  apply({}, scene, {}, diagnostics);
  EXPECT_EQ(scene, before);
}

TEST(Triangulated, KeepsSurfacesWithTheirFaces) {
  grf::MeshDraft mesh(cube());
  mesh.surfaces.emplace_back();
  mesh.surface_of_face[1] = 1;
  const grf::Mesh triangles = triangulated(grf::MeshDraft(mesh));
  EXPECT_EQ(triangles.geometry->positions, mesh.positions);
  EXPECT_THAT(*triangles.surface_of_face, ElementsAre(0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0));
}

}  // namespace
}  // namespace convert
