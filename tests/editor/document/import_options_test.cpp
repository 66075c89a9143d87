#include "editor/document/import_options.h"

#include <QSettings>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/scene_loader.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using testing::HasSubstr;

/// Two triangles that share an edge, without sharing vertices, in a plane x z; and one with a BRDF.
const std::string Chair = R"(begin mesh "seat"
  begin vertexs
    normal (0, 1, 0) (0, 0, 0) normal (0, 1, 0) (1000, 0, 0) normal (0, 1, 0) (0, 0, 2000)
    normal (0, 1, 0) (1000, 0, 0) normal (0, 1, 0) (1000, 0, 2000) normal (0, 1, 0) (0, 0, 2000)
  end vertexs
  begin faces (0, 1, 2) (3, 4, 5) end faces
end mesh
begin mesh "back" brdf oren
  begin vertexs (0, 0, 0) (10, 0, 0) (0, 0, 10) end vertexs
  begin faces (0, 1, 2) end faces
end mesh)";

LoadedScene loaded_chair() {
  LoadedScene loaded;
  loaded.path = "/nowhere/chair.obj";
  loaded.model.scene = scene_of(Chair);
  loaded.model.path = "/nowhere/imports/chair.grf";
  loaded.objects = std::make_shared<const SceneObjects>(objects_of(loaded.model.scene, {}));
  return loaded;
}

TEST(ImportOptions, ChangeNothingByDefault) {
  EXPECT_TRUE(ImportOptions().are_default());
  const LoadedScene loaded = loaded_chair();
  EXPECT_TRUE(with_options(loaded, {})->model.scene == loaded.model.scene);
}

TEST(ImportOptions, TurnAndScaleTheModel) {
  ImportOptions options;
  options.is_z_up = true;
  options.unit = "mm";
  EXPECT_FALSE(options.are_default());
  const auto result = with_options(loaded_chair(), options);
  const grf::Vec3d size = result->objects->mesh_bounds.size();
  EXPECT_NEAR(size.x, 1, 1e-6);
  EXPECT_NEAR(size.y, 2, 1e-6) << "z of the file is up";
  EXPECT_NEAR(size.z, 0, 1e-6);
  EXPECT_NEAR(result->objects->mesh_bounds.max.y, 2, 1e-6) << "and not down";
}

TEST(ImportOptions, LeaveOutObjects) {
  ImportOptions options;
  options.left_out = {true, false};
  const auto result = with_options(loaded_chair(), options);
  ASSERT_EQ(result->objects->meshes.size(), 1U);
  EXPECT_EQ(result->objects->meshes[0].name, "back");
  const auto meshes = imported_meshes(loaded_chair());
  ASSERT_EQ(meshes.size(), 2U);
  EXPECT_EQ(meshes[0].name, "seat");
  EXPECT_EQ(meshes[0].faces, 2U);
}

TEST(ImportOptions, GiveABrdfToFacesWithoutOne) {
  ImportOptions options;
  options.brdf = "ward sx=0.3";
  const auto result = with_options(loaded_chair(), options);
  const auto keyword = [&result](std::size_t mesh) {
    return result->objects->meshes[mesh].flat_surfaces.front().brdf->keyword;
  };
  EXPECT_EQ(keyword(0), "ward");
  EXPECT_EQ(keyword(1), "oren") << "a BRDF of the file stays";
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(read_import_brdf("wrad", diagnostics).has_value());
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("did you mean 'ward'"));
}

TEST(ImportOptions, ChangeMeshes) {
  ImportOptions options;
  options.operations.weld = 0;
  options.operations.normals = convert::Normals::Flat;
  const grf::Mesh& welded = *with_options(loaded_chair(), options)->objects->meshes[0].mesh;
  EXPECT_EQ(welded.geometry->positions.size(), 4U);
  options.operations.weld = 5000;  // more than the model's size
  const auto collapsed = with_options(loaded_chair(), options);
  EXPECT_EQ(collapsed->objects->faces, 0U);
  EXPECT_THAT(collapsed->model.losses.join('\n').toStdString(), HasSubstr("3 faces were left out"));
}

TEST(ImportOptions, AreRememberedPerType) {
  QSettings().clear();
  ImportOptions options;
  options.is_z_up = true;
  options.unit = "inch";
  options.brdf = "ward sx=0.3";
  options.operations.weld = 0.25;
  options.operations.decimate = 0.5;
  options.operations.normals = convert::Normals::Smooth;
  options.operations.crease = std::numbers::pi / 4;
  remember_import_options("obj", options);
  EXPECT_EQ(import_type("/a/b/Chair.OBJ"), "obj");
  const ImportOptions again = remembered_import_options("obj");
  EXPECT_TRUE(again.is_z_up);
  EXPECT_EQ(again.unit, "inch");
  EXPECT_EQ(again.brdf, "ward sx=0.3");
  EXPECT_EQ(again.operations.weld, 0.25);
  EXPECT_EQ(again.operations.decimate, 0.5);
  EXPECT_EQ(again.operations.normals, convert::Normals::Smooth);
  EXPECT_DOUBLE_EQ(again.operations.crease, std::numbers::pi / 4);
  EXPECT_TRUE(remembered_import_options("ply").are_default());
  remember_import_options("obj", {});
  EXPECT_TRUE(remembered_import_options("obj").are_default());
  EXPECT_TRUE(asks_for_import_options("obj"));
  set_asks_for_import_options("obj", false);
  EXPECT_FALSE(asks_for_import_options("obj"));
  EXPECT_TRUE(asks_for_import_options("ply"));
  QSettings().clear();
}

}  // namespace
}  // namespace editor
