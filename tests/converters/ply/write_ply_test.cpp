#include "converters/ply/write_ply.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The text of a scene as a PLY file, and what was said of it.
struct Written {
  std::string text;
  std::string said;
};

Written written(const std::string& grf_text) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(write_ply_ascii(scene_of_grf(grf_text), folder.path("a.ply"), diagnostics));
  return {test::bytes_of(folder.path("a.ply")), diagnostics.to_text()};
}

const std::string TriangleVertices = "begin vertexs (0,0,0) (0.1,0,0) (0,1,0) end vertexs\n";

TEST(WritePly, IsOneMeshInTheWorld) {
  const Written file = written("begin mesh " + TriangleVertices + "begin faces (0,1,2) end faces end mesh\n" +
                               "transform scale (1,-2,1) begin begin mesh " + TriangleVertices +
                               "begin faces (0,1,2) end faces end mesh end");
  EXPECT_EQ(file.text,
            "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0\n0.1 0 0\n0 1 0\n0 0 0\n0.1 0 0\n0 -2 0\n3 0 1 2\n3 3 5 4\n");
  EXPECT_EQ(file.said, "");
}

TEST(WritePly, ColoursAreBytesOnlyWhereThoseHoldThem) {
  const auto colours = [](const std::string& vertex, const std::string& face) {
    return written("begin mesh begin vertexs rgb " + vertex + " (0,0,0) (1,0,0) (0,1,0) end vertexs\n" +
                   "begin faces rgb " + face + " (0,1,2) end faces end mesh")
        .text;
  };
  const std::string bytes = colours("(1,0,0.2)", "(0,0.4,1)");
  EXPECT_THAT(bytes, HasSubstr("property uchar red"));
  EXPECT_THAT(bytes, Not(HasSubstr("property float red")));
  EXPECT_THAT(bytes, HasSubstr("0 0 0 255 0 51\n1 0 0 255 255 255\n"));
  EXPECT_THAT(bytes, HasSubstr("3 0 1 2 0 102 255\n"));
  const std::string floats = colours("(1,0,0.3)", "(0,0.4,2)");
  EXPECT_THAT(floats, Not(HasSubstr("property uchar red")));
  EXPECT_THAT(floats, HasSubstr("0 0 0 1 0 0.3\n"));
  EXPECT_THAT(floats, HasSubstr("3 0 1 2 0 0.4 2\n"));
}

TEST(WritePly, NamesTexturesOfIncludedFilesFromItsOwnFolder) {
  const test::TemporaryFolder folder;
  const std::string part =
      "begin mesh texture \"t.png\" begin vertexs uv (0,0) (0,0,0) uv (1,0) (1,0,0) uv (0,1) (0,1,0) end "
      "vertexs "
      "begin faces (0,1,2) end faces end mesh";
  folder.add("a/part.grf", part);
  folder.add("b/part.grf", part);
  grf::Diagnostics diagnostics;
  const auto scene =
      grf::read_text("include \"a/part.grf\" include \"b/part.grf\"", folder.path("scene.grf"), diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  ASSERT_TRUE(write_ply_ascii(*scene, folder.path("out.ply"), diagnostics)) << diagnostics.to_text();
  const std::string text = test::bytes_of(folder.path("out.ply"));
  EXPECT_THAT(text, HasSubstr("comment TextureFile a/t.png\ncomment TextureFile b/t.png\n"));
  EXPECT_THAT(text, HasSubstr("3 0 1 2 0\n3 3 4 5 1\n"));
}

TEST(WritePly, KeepsNamesOfMaterialsAndTextures) {
  const std::string text =
      "def shiny$20$gold = brdf phong n=3 begin begin mesh begin vertexs uv (0,1) (0,0,0) (1,0,0) (0,1,0) "
      "end vertexs\n"
      "begin faces texture \"b.png\" brdf shiny$20$gold (0,1,2) texture \"a.png\" brdf none (0,1,2) texture "
      "none (0,1,2) "
      "end faces end mesh end";
  const Written file = written(text);
  EXPECT_THAT(
      file.text,
      HasSubstr("comment TextureFile a.png\ncomment TextureFile b.png\ncomment material 0 shiny gold\n"));
  EXPECT_THAT(file.text, HasSubstr("\n3 0 1 2 0 1\n3 0 1 2 -1 0\n3 0 1 2 -1 -1\n"));
  EXPECT_THAT(file.said, HasSubstr("1 face lost its BRDF: PLY has none"));
  const test::TemporaryFolder folder;
  const Reading reading = read_path(folder.add("a.ply", file.text));
  const grf::Mesh mesh = meshes_of(*reading.scene).front();
  EXPECT_EQ(material_of(mesh, 0), "shiny$20$gold");
  EXPECT_EQ(std::get<grf::Texture>(*mesh.surface(0).texture).file, "b.png");
  EXPECT_FALSE(mesh.surface(2).texture.has_value());
}

TEST(WritePly, SaysWhatIsLost) {
  const Written file = written(
      "light begin (0,0,0) (1,0,0) (0,1,0) end\n"
      "begin mesh \"name\" begin vertexs irad (1,1,1) (0,0,0) (1,0,0) (0,1,0) end vertexs\n"
      "begin faces pdf uniform light rgb (1,1,1) texture \"a.png\" (0,1,2) (0,1,2) end faces end mesh");
  for (const auto* line :
       {"1 light was left out: PLY has none", "1 mesh lost its name: PLY has none",
        "1 vertex lost its irradiance: PLY has none", "2 faces lost their sampling scheme: PLY has none",
        "2 faces lost their emission: PLY has none",
        "2 faces lost their texture: a PLY file without texture coordinates has none"}) {
    EXPECT_THAT(file.said, HasSubstr(line));
  }
}

TEST(WritePly, LeavesTheOldFileWhereItCannotWrite) {
  const test::TemporaryFolder folder;
  const std::string path = folder.add("a.ply", "old");
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(write_ply(scene_of_grf("light begin (0,0,0) (1,0,0) (0,1,0) end"), path, diagnostics));
  EXPECT_THAT(diagnostics.to_text(),
              HasSubstr("a.ply: error: cannot write the file: the scene has no faces"));
  EXPECT_EQ(test::bytes_of(path), "old");
  EXPECT_EQ(folder.names().size(), 1U);
  EXPECT_FALSE(
      write_ply(scene_of_grf("begin mesh " + TriangleVertices + "begin faces (0,1,2) end faces end mesh"),
                folder.path("missing/a.ply"), diagnostics));
}

TEST(WritePly, FacesOfManyCornersGetALargerCount) {
  std::string vertices;
  std::string face;
  for (int i = 0; i < 300; ++i) {
    vertices += "(" + std::to_string(i) + "," + std::to_string(i * i) + ",0) ";
    face += (i == 0 ? "" : ",") + std::to_string(i);
  }
  const std::string text =
      "begin mesh begin vertexs " + vertices + "end vertexs begin faces (" + face + ") end faces end mesh";
  EXPECT_THAT(written(text).text, HasSubstr("property list int int vertex_indices"));
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(write_ply(scene_of_grf(text), folder.path("a.ply"), diagnostics));
  EXPECT_EQ(meshes_of(*read_path(folder.path("a.ply")).scene).front().face(0).size(), 300U);
}

}  // namespace
}  // namespace convert
