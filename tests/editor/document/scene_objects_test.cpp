// Flattens a scene whose files are included where names have different meanings, and one with the maximum
// nesting depth.
#include "editor/document/scene_objects.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/definitions.h"
#include "editor/document/object_edits.h"
#include "editor/document/scene_places.h"
#include "grf/read.h"
#include "grf/text_file.h"
#include "tests/editor/moved_object.h"
#include "tests/editor/scene_of.h"
#include "tests/support/small_stack.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using testing::ElementsAre;

std::string triangle_mesh(const std::string& attributes) {
  return "begin mesh " + attributes +
         " begin vertexs uv (0, 0) (0, 0, 0) uv (1, 0) (1, 0, 0) uv (0, 1) (0, 1, 0) end begin faces (0, 1, "
         "2) "
         "end end\n";
}

class SceneObjectsTest : public testing::Test {
 protected:
  SceneObjects objects(const std::string& text) const {
    const std::string path = folder_.add("scenes/main.grf", text);
    grf::Diagnostics diagnostics;
    const auto scene = grf::read(path, diagnostics);
    if (!scene) throw std::runtime_error(diagnostics.to_text());
    return objects_of(*scene, path);
  }

  /// The surface of each mesh instance, in the order of the scene.
  static std::vector<FlatSurface> flat_surfaces_of(const SceneObjects& objects) {
    std::vector<FlatSurface> flat_surfaces;
    for (const MeshInstance& instance : *objects.instances) {
      flat_surfaces.push_back(objects.meshes[instance.mesh].flat_surfaces.front());
    }
    return flat_surfaces;
  }

  /// Texture paths relative to the folder of the test.
  std::vector<std::string> textures(const std::string& text) const {
    std::vector<std::string> paths;
    for (const FlatSurface& flat_surface : flat_surfaces_of(objects(text))) {
      const std::string path = grf::canonical_path(flat_surface.texture);
      paths.push_back(path.substr(grf::canonical_path(folder_.path()).size() + 1));
    }
    return paths;
  }

  test::TemporaryFolder folder_;
};

TEST_F(SceneObjectsTest, DefinedMeshesLookAsNamesAreMeantAtEachPlaceOfTheirFile) {
  folder_.add("scenes/part.grf", "def m = " + triangle_mesh("rgb c brdf combine 1 a") + " begin use m end");
  const SceneObjects found = objects(
      "def c = rgb (1, 0, 0) a = brdf diffuse kd=0.1 begin include \"part.grf\" end "
      "def c = rgb (0, 1, 0) a = brdf phong begin include \"part.grf\" include \"part.grf\" end");
  const std::vector<FlatSurface> flat_surfaces = flat_surfaces_of(found);
  ASSERT_EQ(flat_surfaces.size(), 3U);
  EXPECT_EQ(flat_surfaces[0].colour, grf::Colour(1, 0, 0));
  EXPECT_EQ(flat_surfaces[1].colour, grf::Colour(0, 1, 0));
  EXPECT_EQ(flat_surfaces[2].colour, grf::Colour(0, 1, 0));
  ASSERT_TRUE(flat_surfaces[0].terms.size() == 1 && flat_surfaces[1].terms.size() == 1);
  EXPECT_EQ(flat_surfaces[0].terms[0].brdf.keyword, "diffuse");
  EXPECT_EQ(flat_surfaces[1].terms[0].brdf.keyword, "phong");
  EXPECT_TRUE(found.mesh_at(grf::ScenePath{0, 2, 0, 0})) << "each definition is found where it stands";
  EXPECT_TRUE(found.mesh_at(grf::ScenePath{1, 3, 0, 0}));
}

TEST_F(SceneObjectsTest, SumsOfSumsLookAsWhatTheyAddUp) {
  std::string definitions = "def a = brdf diffuse b = brdf ward s0 = brdf combine 0.5 a, 2 b\n";
  for (int i = 1; i < 20'000; ++i) {
    definitions += "s" + std::to_string(i) + " = brdf combine 1 s" + std::to_string(i - 1) + "\n";
  }
  std::vector<FlatSurface> flat_surfaces;
  test::run_on_small_stack([&] {
    flat_surfaces = flat_surfaces_of(
        objects(definitions + "t = brdf combine 0.5 s19999, 3 a begin " + triangle_mesh("brdf t") + "end"));
  });
  ASSERT_EQ(flat_surfaces.size(), 1U);
  ASSERT_EQ(flat_surfaces[0].terms.size(), 2U);
  EXPECT_EQ(flat_surfaces[0].terms[0].brdf.keyword, "diffuse");
  EXPECT_EQ(flat_surfaces[0].terms[0].weight, 3.25F);
  EXPECT_EQ(flat_surfaces[0].terms[1].brdf.keyword, "ward");
  EXPECT_EQ(flat_surfaces[0].terms[1].weight, 1);
}

TEST_F(SceneObjectsTest, TexturesAreBesideTheFileThatNamesThem) {
  folder_.add("a/part.grf", triangle_mesh("texture \"t.png\""));
  folder_.add("b/part.grf", "include \"inner/part.grf\"");
  folder_.add("b/inner/part.grf", triangle_mesh("texture \"t.png\""));
  EXPECT_THAT(
      textures("include \"../a/part.grf\" include \"../b/part.grf\" " + triangle_mesh("texture \"t.png\"")),
      ElementsAre("a/t.png", "b/inner/t.png", "scenes/t.png"));
}

TEST_F(SceneObjectsTest, TexturesByNameAreBesideTheFileThatDefinesThem) {
  folder_.add("a/part.grf", triangle_mesh("texture t"));
  folder_.add("b/part.grf",
              "def t = texture \"own.png\" m = " + triangle_mesh("texture t") + " begin use m end");
  EXPECT_THAT(
      textures("def t = texture \"t.png\" begin include \"../a/part.grf\" include \"../b/part.grf\" end"),
      ElementsAre("scenes/t.png", "b/own.png"));
}

// The 3D view shows it as a texture.
TEST_F(SceneObjectsTest, HaveTheImageOfTheColourOfTheirBrdf) {
  folder_.add("scenes/brdfs/oak.brdf", "gltf baseColor=texture \"oak.png\" rgb");
  EXPECT_THAT(textures(triangle_mesh("brdf diffuse kd=texture \"t.png\" rgb") +
                       triangle_mesh("brdf \"brdfs/oak.brdf\"") +
                       triangle_mesh("texture \"own.png\" brdf diffuse kd=texture \"t.png\" rgb")),
              ElementsAre("scenes/t.png", "scenes/brdfs/oak.png", "scenes/own.png"));
  folder_.add("a/part.grf", "def oak = brdf gltf baseColor=texture \"oak.png\" rgb begin " +
                                triangle_mesh("brdf oak") + " end");
  EXPECT_THAT(textures("include \"../a/part.grf\""), ElementsAre("a/oak.png"));
  const SceneObjects other =
      objects(triangle_mesh("brdf ward sx=texture \"t.png\" r kd=texture \"t.png\" r"));
  EXPECT_EQ(flat_surfaces_of(other).at(0).texture, "") << "no colours";
}

TEST(DeepScenes, CanBeLookedAtAndEditedOnASmallStack) {
  std::string text;
  for (std::size_t i = 0; i < grf::DeepestNesting; ++i) {
    text += i % 2 == 0 ? "transform translation (1, 0, 0) begin\n" : "def a = rgb (1, 1, 1) begin\n";
  }
  text += triangle_mesh("rgb a");
  for (std::size_t i = 0; i < grf::DeepestNesting; ++i) text += "end\n";
  test::run_on_small_stack([&text] {
    const grf::Scene scene = scene_of(text);
    const SceneObjects objects = objects_of(scene, "scene.grf");
    ASSERT_EQ(objects.instances->size(), 1U);
    EXPECT_EQ(objects.bounds.min.x, 500);
    const grf::ScenePath path = objects.instances->front().path;
    EXPECT_EQ(path.size(), grf::DeepestNesting + 1);
    EXPECT_EQ(definitions_at(scene, path).size(), 1U) << "the innermost hides the others";
    EXPECT_EQ(count_uses(scene).size(), 1U);
    grf::Diagnostics diagnostics;
    grf::Scene same = scene;
    EXPECT_EQ(edit_all_places(scene, same, diagnostics), 0U);
    const auto moved = moved_object(scene, path, grf::Vec3d(0, 1, 0), diagnostics);
    ASSERT_TRUE(moved) << diagnostics.to_text();
    EXPECT_EQ(objects_of(*moved, "scene.grf").bounds.min.y, 1);
    const auto two = duplicate_object(scene, path, grf::Vec3d(0, 1, 0), diagnostics);
    ASSERT_TRUE(two) << diagnostics.to_text();
    EXPECT_EQ(objects_of(*two, "scene.grf").instances->size(), 2U);
    const auto used_alone = remove_unused_definitions(scene);
    EXPECT_EQ(grf::nesting_of(used_alone.contents), grf::DeepestNesting / 2 + 1);
    EXPECT_TRUE(remove_objects(scene, {path}, {}, diagnostics)) << diagnostics.to_text();
  });
}

TEST(LongChains, OfUnusedDefinitionsAreRemovedAtOnce) {
  std::string text = "def c0 = brdf diffuse\n";
  for (int i = 1; i < 20'000; ++i) {
    text += "c" + std::to_string(i) + " = brdf combine 1 c" + std::to_string(i - 1) + "\n";
  }
  const grf::Scene unused = scene_of(text + "begin " + triangle_mesh("") + "end");
  const grf::Scene used = scene_of(text + "begin " + triangle_mesh("brdf c19999") + "end");
  EXPECT_EQ(remove_unused_definitions(unused), scene_of(triangle_mesh("")));
  EXPECT_EQ(remove_unused_definitions(used), used);
}

TEST(Definitions, AreUsedWhereAnyPlaceOfTheirFileUsesThem) {
  const test::TemporaryFolder folder;
  folder.add("part.grf", "def s = brdf combine 1 a begin include \"use.grf\" end");
  folder.add("use.grf", triangle_mesh("brdf s"));
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(
      "def a = brdf diffuse begin include \"part.grf\" end def a = brdf phong begin include \"part.grf\" end",
      folder.path("scene.grf"), diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  EXPECT_EQ(remove_unused_definitions(*scene), *scene);
}

}  // namespace
}  // namespace editor
