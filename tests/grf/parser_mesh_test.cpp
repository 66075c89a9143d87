#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/visit.h"
#include "tests/grf/reading.h"
#include "tests/support/paths.h"

namespace grf {
namespace {

using testing::ElementsAre;

const std::string Square = "begin vertexs (0, 0, 0) (1, 0, 0) (1, 1, 0) (0, 1, 0) end vertexs ";

Scene square(const std::string& faces, const std::string& attributes = {}) {
  return scene_of("begin mesh " + attributes + " " + Square + "begin faces " + faces + " end faces end mesh");
}

TEST(Mesh, MayHaveAName) {
  EXPECT_EQ(mesh_of(scene_of("begin mesh \"a b\" " + Square + "begin faces end faces end mesh")).name, "a b");
  EXPECT_EQ(mesh_of(square("")).name, "");
}

TEST(Vertices, KeepAbsentWhatIsAbsent) {
  const Mesh mesh =
      mesh_of(scene_of("begin mesh begin vertices (0, 0, 0) normal (0, 0, 2) (1, 0, 0) rgb (1, 0, 0) normal "
                       "(0, 1, 0) (2, 0, 0) (3, 0, 0) end vertices begin faces end faces end mesh"));
  EXPECT_THAT(mesh.geometry->positions,
              ElementsAre(Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(2, 0, 0), Vec3f(3, 0, 0)));
  EXPECT_FALSE(mesh.geometry->normals.has(0));
  EXPECT_EQ(mesh.geometry->normals[1], Vec3f(0, 0, 2)) << "normals stay as they were written";
  EXPECT_EQ(mesh.geometry->normals[2], Vec3f(0, 1, 0));
  EXPECT_FALSE(mesh.geometry->normals.has(3));
  EXPECT_FALSE(mesh.geometry->colours.has(1));
  EXPECT_EQ(mesh.geometry->colours[2], Colour(1, 0, 0));
}

TEST(Vertices, MayHaveTextureCoordinates) {
  const Mesh mesh =
      mesh_of(scene_of("begin mesh begin vertexs uv (0.5, -1) (0, 0, 0) rgb (1, 0, 0) uv (0, 2) "
                       "(1, 0, 0) (2, 0, 0) end vertexs begin faces end faces end mesh"));
  EXPECT_EQ(mesh.geometry->uvs[0], Vec2f(0.5F, -1));
  EXPECT_EQ(mesh.geometry->uvs[1], Vec2f(0, 2));
  EXPECT_FALSE(mesh.geometry->uvs.has(2));
}

TEST(Faces, MayHaveATextureFromAFileOrADefinition) {
  const Scene scene =
      scene_of("def wood = texture \"wood.png\" begin begin mesh texture wood " + Square +
               "begin faces (0, 1, 2) texture \"a b\\c.exr\" (0, 1, 2) texture none (0, 1, 2) "
               "end faces end mesh end");
  std::vector<std::string> files;
  SceneVisitor visitor;
  visitor.mesh = [&](const Mesh& mesh, const Placement& placement, const Block&) {
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      const Texture* texture = resolve(mesh.surface(i), placement.scope).texture;
      files.push_back(texture == nullptr ? "none" : texture->file);
    }
  };
  visit(scene, visitor);
  EXPECT_THAT(files, ElementsAre("wood.png", "a b\\c.exr", "none"));
}

TEST(Faces, ArePolygonsWrittenInThreeWays) {
  const Scene scene = square("(0, 1, 2) 4 (0, 1, 2, 3) 3 3 2 1 (0, 2, 3)");
  const Mesh& mesh = mesh_of(scene);
  ASSERT_EQ(mesh.face_count(), 4U);
  EXPECT_THAT(mesh.face(0), ElementsAre(0U, 1U, 2U));
  EXPECT_THAT(mesh.face(1), ElementsAre(0U, 1U, 2U, 3U));
  EXPECT_THAT(mesh.face(2), ElementsAre(3U, 2U, 1U));
  EXPECT_THAT(mesh.face(3), ElementsAre(0U, 2U, 3U));
}

TEST(Faces, HaveTheAttributesOfTheMeshUntilTheyAreGivenOthers) {
  const Scene scene = square(
      "(0, 1, 2) rgb (0, 1, 0) (0, 1, 2) pdf diffuse light rgb (5, 5, 5) (0, 1, 2) rgb none brdf none (0, 1, "
      "2) light none pdf none (0, 1, 2)",
      "rgb (1, 0, 0) brdf ward");
  const Mesh& mesh = mesh_of(scene);
  EXPECT_EQ(mesh.surface(0), mesh.surfaces[0]);
  EXPECT_EQ(mesh.surface(0).colour, ColourAttribute(Colour(1, 0, 0)));
  EXPECT_EQ(mesh.surface(1).colour, ColourAttribute(Colour(0, 1, 0)));
  EXPECT_EQ(mesh.surface(1).brdf, mesh.surface(0).brdf);
  EXPECT_EQ(std::get<PdfModel>(*mesh.surface(2).pdf).keyword, "diffuse");
  EXPECT_EQ(mesh.surface(2).emission, Colour(5, 5, 5));
  EXPECT_FALSE(mesh.surface(3).colour) << "not the mesh's, but none";
  EXPECT_FALSE(mesh.surface(3).brdf);
  EXPECT_TRUE(mesh.surface(3).emission);
  EXPECT_EQ(mesh.surface(4), Surface());
}

TEST(Faces, ShareEqualSurfaces) {
  const Scene scene =
      square("rgb (0, 1, 0) (0, 1, 2) rgb none (0, 1, 2) rgb (0, 1, 0) (0, 1, 2) rgb (0, 0, 1) (0, 1, 2)");
  EXPECT_THAT(*mesh_of(scene).surface_of_face, ElementsAre(1U, 0U, 1U, 2U));
}

TEST(Faces, MayLetLightPass) {
  const auto opacity = [](Opacity::Kind kind, float value) { return std::optional(Opacity{kind, value}); };
  const Scene scene =
      square("(0, 1, 2) opacity mask 0.25 3 (0, 1, 2) OPACITY BLEND 0.5f (0, 1, 2) opacity none (0, 1, 2)",
             "opacity 0.75");
  const Mesh& mesh = mesh_of(scene);
  EXPECT_EQ(mesh.surface(0).opacity, opacity(Opacity::Kind::Number, 0.75F));
  EXPECT_EQ(mesh.surface(1).opacity, opacity(Opacity::Kind::Mask, 0.25F));
  EXPECT_EQ(mesh.surface(2).opacity, opacity(Opacity::Kind::Blend, 0.5F));
  EXPECT_EQ(mesh.surface(3).opacity, std::nullopt);
}

TEST(Faces, MayAllBeEmitters) {
  const Scene scene = square("(0, 1, 2)", "light rgb (1, 2, 3)");
  EXPECT_EQ(mesh_of(scene).surface(0).emission, Colour(1, 2, 3));
}

TEST(MissingWords, AreSuppliedWithAWarning) {
  const std::string mesh = "begin mesh " + Square + "begin faces (0, 1, 2) ";
  const std::string light = "light begin (0, 2, 0) (1, 0, 0) (0, 0, 1) end";
  const auto blocks = [](const std::string& text) {
    Diagnostics diagnostics;
    const auto scene = read_text(text, "scene.grf", diagnostics);
    EXPECT_TRUE(scene) << diagnostics.to_text();
    EXPECT_EQ(diagnostics.warning_count(), 1U);
    return scene ? scene->contents.blocks.size() : 0;
  };
  EXPECT_EQ(blocks(mesh + "end mesh"), 1U);
  EXPECT_EQ(blocks(mesh + "end mesh include \"" GRANADA_SOURCE_DIR "/tests/grf/corpus/valid/light.grf\""),
            2U);
  EXPECT_EQ(blocks(mesh + "end faces " + light), 2U);
  EXPECT_EQ(blocks(mesh + "end " + light), 2U);
}

TEST(MissingWords, AreAnErrorWhereTwoReadingsArePossible) {
  const std::string mesh = "begin mesh " + Square + "begin faces (0, 1, 2) ";
  EXPECT_EQ(error_in(mesh + "end mesh light begin (0, 2, 0) (1, 0, 0) (0, 0, 1) end"),
            "'end faces' is missing, and this can be 'end faces end mesh' before a light, or 'end faces end' "
            "before a mesh light");
}

}  // namespace
}  // namespace grf
