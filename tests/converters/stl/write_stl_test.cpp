#include "converters/stl/write_stl.h"

#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/summary.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;

struct Triangle {
  grf::Vec3f normal, a, b, c;

  grf::Vec3d area() const {
    return (grf::Vec3d(b) - grf::Vec3d(a)).cross(grf::Vec3d(c) - grf::Vec3d(a)) * 0.5;
  }
};

/// The triangles of a scene as a binary STL file has them.
std::vector<Triangle> triangles_of(const grf::Scene& scene, grf::Diagnostics& diagnostics) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("a.stl");
  if (!write_stl(scene, path, diagnostics)) throw std::runtime_error(diagnostics.to_text());
  const std::string bytes = test::bytes_of(path);
  EXPECT_FALSE(bytes.starts_with("solid"));
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  EXPECT_EQ(bytes.size(), 84 + 50 * count);
  std::vector<Triangle> triangles(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<float, 12> numbers = {};
    std::memcpy(numbers.data(), bytes.data() + 84 + 50 * i, sizeof numbers);
    for (int k = 0; k < 3; ++k) {
      const auto place = static_cast<std::size_t>(k);
      triangles[i].normal[k] = numbers[place];
      triangles[i].a[k] = numbers[place + 3];
      triangles[i].b[k] = numbers[place + 6];
      triangles[i].c[k] = numbers[place + 9];
    }
  }
  Assimp::Importer importer;
  const aiScene* read = importer.ReadFile(path, 0);
  if (read == nullptr) throw std::runtime_error(importer.GetErrorString());
  EXPECT_EQ(read->mMeshes[0]->mNumFaces, count);
  return triangles;
}

// An L, which is concave, and a triangle that a mirror turns round.
TEST(WriteStl, CutsPolygonsAndKeepsFronts) {
  const grf::Scene scene = scene_of_grf(
      "begin mesh begin vertexs (0,0,0) (2,0,0) (2,1,0) (1,1,0) (1,2,0) (0,2,0) end vertexs\n"
      "begin faces (0,1,2,3,4,5) end faces end mesh\n"
      "transform scale (-1,1,1) begin begin mesh begin vertexs (0,0,3) (1,0,3) (0,1,3) end vertexs\n"
      "begin faces (0,1,2) end faces end mesh end");
  grf::Diagnostics diagnostics;
  const std::vector<Triangle> triangles = triangles_of(scene, diagnostics);
  ASSERT_EQ(triangles.size(), 5U);
  double area = 0;
  for (const Triangle& triangle : triangles) {
    EXPECT_EQ(triangle.normal, grf::Vec3f(0, 0, 1));
    EXPECT_GT(triangle.area().z, 0) << "also of the one in the mirror: its front stays where it was";
    area += triangle.area().length();
  }
  EXPECT_NEAR(area, 3.5, 1e-6);
  EXPECT_EQ(triangles[4].a, grf::Vec3f(0, 0, 3));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("1 polygon was cut into triangles"));
}

TEST(WriteStl, AFaceWithoutAreaHasNoNormal) {
  grf::Diagnostics diagnostics;
  const auto triangles = triangles_of(
      scene_of_grf(
          "begin mesh begin vertexs (0,0,0) (1,0,0) end vertexs begin faces (0,1,1) end faces end mesh"),
      diagnostics);
  EXPECT_EQ(triangles.front().normal, grf::Vec3f(0));
}

TEST(WriteStl, SaysWhatIsLost) {
  grf::Diagnostics diagnostics;
  triangles_of(
      scene_of_grf(
          "light begin (0,0,0) (1,0,0) (0,1,0) end\n"
          "begin mesh \"name\" rgb (1,0,0) brdf phong n=3 begin vertexs normal (0,0,1) (0,0,0) (1,0,0) "
          "(0,1,0) (5,5,5) end vertexs begin faces (0,1,2) end faces end mesh"),
      diagnostics);
  for (const auto* line : {"1 light was left out: STL has none", "1 face lost its BRDF: STL has none",
                           "1 face lost its colour: STL has none", "1 vertex lost its normal: STL has none",
                           "1 vertex without a face was left out", "1 mesh lost its name"}) {
    EXPECT_THAT(diagnostics.to_text(), HasSubstr(line));
  }
}

TEST(WriteStl, LeavesTheOldFileWhereItCannotWrite) {
  const test::TemporaryFolder folder;
  const std::string path = folder.add("a.stl", "old");
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(write_stl(scene_of_grf("params begin end"), path, diagnostics));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("cannot write the file: the scene has no faces"));
  EXPECT_EQ(test::bytes_of(path), "old");
}

// Real models: the area is that of the scene.
TEST(WriteStl, RealModelsKeepTheirArea) {
  for (const auto* path :
       {"/usr/share/assimp/models/PLY/Wuson.ply", "/usr/share/assimp/models/OBJ/spider.obj",
        "/usr/share/assimp/models/PLY/cube.ply"}) {
    const Reading reading = read_path(path);
    ASSERT_TRUE(reading.scene.has_value()) << reading.text();
    const grf::Summary summary = grf::summarize(*reading.scene);
    grf::Diagnostics diagnostics;
    const std::vector<Triangle> triangles = triangles_of(*reading.scene, diagnostics);
    EXPECT_EQ(triangles.size(), summary.triangles);
    double area = 0;
    for (const Triangle& triangle : triangles) area += triangle.area().length();
    EXPECT_NEAR(area, summary.area, 1e-4 * summary.area) << path;
  }
}

}  // namespace
}  // namespace convert
