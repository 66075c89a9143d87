#include "editor/document/geometry_edits.h"

#include <numbers>

#include <gtest/gtest.h>

#include "converters/mesh_operations/subdivide.h"
#include "editor/document/document.h"
#include "grf/write.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

/// Two quads that meet at a right angle, and a mesh that is used twice.
const std::string SceneOfSquares = R"(def tile = begin mesh
  begin vertexs
    (0, 0, 0) (1, 0, 0) (0, 1, 0)
  end vertexs
  begin faces
    (0, 1, 2)
  end faces
end mesh
begin
  use tile
  transform translation (2, 0, 0) begin
    use tile
  end
  begin mesh "corner"
    begin vertexs
      (0, 0, 0) (1, 0, 0) (1, 1, 0) (0, 1, 0) (0, 0, 1) (1, 0, 1)
    end vertexs
    begin faces
      (0, 1, 2, 3)
      brdf diffuse kd=0.1
      (1, 0, 4, 5)
    end faces
  end mesh
end
)";

class GeometryEdits : public testing::Test {
 protected:
  GeometryEdits() { document_.take(scene_of(SceneOfSquares), {}, {}); }

  void select(std::initializer_list<FaceId> faces) {
    FaceSelection selection(document_.objects());
    for (const FaceId& face : faces) selection.set(face);
    document_.select(selection);
  }
  SelectedFaces selected() const { return {document_.scene(), document_.objects(), document_.selection()}; }
  void take(std::optional<grf::Scene> scene) {
    ASSERT_TRUE(scene) << diagnostics_.to_text();
    EXPECT_EQ(scene_of(grf::to_text(*scene)), *scene);
    document_.replace("Edit", std::move(*scene));
  }
  const grf::Mesh& corner() const { return *document_.objects().meshes[1].mesh; }
  const grf::Vec3f& position(std::size_t face, std::size_t corner_number) const {
    return corner().geometry->positions[corner().face(face)[corner_number]];
  }

  Document document_;
  grf::Diagnostics diagnostics_;
};

TEST_F(GeometryEdits, FlipSomeFacesAndLeaveTheOthers) {
  select({{1, 1}});
  take(flipped(selected()));
  EXPECT_EQ(position(0, 1), grf::Vec3f(1, 0, 0));
  EXPECT_EQ(position(1, 0), grf::Vec3f(1, 0, 0));
  EXPECT_EQ(position(1, 1), grf::Vec3f(1, 0, 1));
  EXPECT_EQ(corner().geometry->positions.size(), 6U);
  EXPECT_TRUE(document_.selection().has({1, 1}));
  EXPECT_EQ(document_.selection().count(), 1U);
  EXPECT_EQ(std::get<grf::BrdfModel>(*corner().surface(1).brdf).keyword, "diffuse");
}

TEST_F(GeometryEdits, SmoothNormalsAreOfTheFacesThatAreMeant) {
  select({{1, 0}});
  take(with_smooth_normals(selected(), 0.1));
  for (const std::uint32_t vertex : corner().face(0))
    EXPECT_EQ(corner().geometry->normals[vertex], grf::Vec3f(0, 0, 1));
  for (const std::uint32_t vertex : corner().face(1)) EXPECT_FALSE(corner().geometry->normals.has(vertex));
  take(flipped(selected()));
  EXPECT_EQ(corner().geometry->normals[corner().face(0)[0]], grf::Vec3f(0, 0, -1));
  take(with_flat_faces(selected()));
  EXPECT_TRUE(corner().geometry->normals.empty());
  EXPECT_EQ(corner().geometry->positions.size(), 6U);
}

TEST_F(GeometryEdits, SmoothNormalsGoOverSmallAngles) {
  select({{1, 0}, {1, 1}});
  take(with_smooth_normals(selected(), std::numbers::pi));
  EXPECT_EQ(corner().geometry->positions.size(), 6U);
  EXPECT_GT(corner().geometry->normals[corner().face(0)[0]].y, 0.5F);
  EXPECT_TRUE(common_vertices(document_.objects(), document_.selection()).have_normals);
}

TEST_F(GeometryEdits, GiveVerticesColoursAndIrradiance) {
  select({{1, 0}});
  take(with_vertex_colours(selected(), grf::Colour(1, 0, 0)));
  take(with_irradiance(selected(), grf::Colour(3)));
  EXPECT_EQ(corner().geometry->positions.size(), 8U);  // the edge is split
  CommonVertices common = common_vertices(document_.objects(), document_.selection());
  EXPECT_EQ(common.colour.value, grf::Colour(1, 0, 0));
  EXPECT_EQ(common.irradiance.value, grf::Colour(3));
  select({{1, 0}, {1, 1}});
  common = common_vertices(document_.objects(), document_.selection());
  EXPECT_TRUE(common.colour.is_mixed);
  EXPECT_TRUE(common.irradiance.is_mixed);
  take(with_vertex_colours(selected(), std::nullopt));
  take(with_irradiance(selected(), std::nullopt));
  EXPECT_TRUE(corner().geometry->colours.empty());
  common = common_vertices(document_.objects(), document_.selection());
  EXPECT_FALSE(common.colour.value || common.colour.is_mixed || common.irradiance.value);
}

TEST_F(GeometryEdits, SubdivideWholeMeshesOfSomeFaces) {
  select({{1, 1}});
  EXPECT_EQ(faces_after(selected(), {convert::SubdivisionScheme::CatmullClark, 1}), 8);
  EXPECT_EQ(faces_after(selected(), {convert::SubdivisionScheme::Loop, 1}), 16);
  take(with_subdivided_meshes(selected(), {convert::SubdivisionScheme::CatmullClark, 1}));
  ASSERT_EQ(corner().face_count(), 8U);
  for (std::size_t face = 0; face < 4; ++face) EXPECT_FALSE(corner().surface(face).brdf);
  for (std::size_t face = 4; face < 8; ++face) {
    ASSERT_TRUE(corner().surface(face).brdf);
    EXPECT_EQ(std::get<grf::BrdfModel>(*corner().surface(face).brdf).keyword, "diffuse");
  }
  EXPECT_EQ(document_.objects().meshes[0].mesh->face_count(), 1U) << "of which no face is selected";
  EXPECT_EQ(document_.selection().mesh_count(), 2U);
  EXPECT_EQ(document_.selection().of_mesh(1).size(), 8U);
  document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), scene_of(SceneOfSquares));
  EXPECT_TRUE(document_.selection().has({1, 1}));
}

/// A pyramid on a square: its apex is the one vertex inside, and the others stay, since they are the
/// boundary. One step of Taubin's moves the apex by 0.5 of its height down and by mu = 1 / (0.1 - 2) of what
/// is left up again.
TEST_F(GeometryEdits, SmoothWholeMeshes) {
  document_.take(scene_of("begin mesh begin vertexs\n"
                          "(-1,-1,0) (1,-1,0) (1,1,0) (-1,1,0) (0,0,1)\n"
                          "end vertexs begin faces (0,1,4) (1,2,4) brdf diffuse (2,3,4) (3,0,4) end faces "
                          "end mesh"),
                 {}, {});
  select({{0, 2}});
  take(with_smooth_meshes(selected(), 1));
  const grf::Mesh& mesh = *document_.objects().meshes[0].mesh;
  EXPECT_NEAR(mesh.geometry->positions[4].z, 0.5 * (1 + 1 / 1.9), 1e-6);
  EXPECT_EQ(mesh.geometry->positions[0], grf::Vec3f(-1, -1, 0));
  EXPECT_FALSE(mesh.surface(1).brdf);
  EXPECT_TRUE(mesh.surface(2).brdf);
  EXPECT_TRUE(document_.selection().has({0, 2}));
}

TEST_F(GeometryEdits, DeleteFacesAndMeshesWithoutAny) {
  select({{0, 0}, {1, 1}});
  take(without_faces(selected()));
  ASSERT_EQ(document_.objects().meshes.size(), 1U);
  EXPECT_EQ(document_.objects().instances->size(), 1U);
  EXPECT_EQ(document_.objects().faces, 1U);
  EXPECT_EQ(document_.objects().meshes[0].mesh->geometry->positions.size(), 4U);
  EXPECT_TRUE(document_.selection().empty());
  document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), scene_of(SceneOfSquares));
  EXPECT_EQ(document_.selection().count(), 2U);
}

}  // namespace
}  // namespace editor
