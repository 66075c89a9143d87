// Tests of the geometry of OBJ files, and of the reports of losses.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/write.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Returns the meshes of a valid text.
std::vector<grf::Mesh> meshes_of_text(const std::string& obj) {
  const Reading reading = read_obj_text(obj);
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  return reading.scene ? meshes_of(*reading.scene) : std::vector<grf::Mesh>();
}

/// Returns the only mesh of a valid text.
grf::Mesh mesh_of_text(const std::string& obj) { return only_mesh(read_obj_text(obj)); }

std::vector<std::uint32_t> corners_of(const grf::Mesh& mesh, std::size_t face) {
  return {mesh.face(face).begin(), mesh.face(face).end()};
}

/// Returns the diagnostics of an invalid text.
std::string error_of(const std::string& obj) {
  const Reading reading = read_obj_text(obj);
  EXPECT_FALSE(reading.scene.has_value());
  EXPECT_TRUE(reading.diagnostics.has_errors());
  return reading.text();
}

/// Returns the diagnostics of a valid text.
std::string warnings_of(const std::string& obj) {
  const Reading reading = read_obj_text(obj);
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  return reading.text();
}

TEST(Obj, KeepsPolygonsAndTheOrderOfFaces) {
  const grf::Mesh mesh = mesh_of_text(SquareVertices + "v 2 2 0\nf 4 3 2 1\nf 1 2 5\nf 1 2 3 5 4\n");
  ASSERT_EQ(mesh.face_count(), 3U);
  EXPECT_THAT(corners_of(mesh, 0), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(corners_of(mesh, 1), ElementsAre(3, 2, 4));
  EXPECT_THAT(corners_of(mesh, 2), ElementsAre(3, 2, 1, 4, 0));
  EXPECT_EQ(mesh.geometry->positions[0], grf::Vec3f(0, 1, 0));
}

TEST(Obj, KeepsFacesThatAreDegenerate) {
  const grf::Mesh mesh = mesh_of_text(SquareVertices + "f 1 1 2\nf 3 3 3\n");
  ASSERT_EQ(mesh.face_count(), 2U);
  EXPECT_THAT(corners_of(mesh, 0), ElementsAre(0, 0, 1));
}

TEST(Obj, SharesVerticesWhoseNormalsAreEqual) {
  const std::string normals = "vn 0 0 1\nvn 0 1 0\n";
  EXPECT_EQ(mesh_of_text(SquareVertices + normals + "f 1//1 2//1 3//1\nf 1//1 3//1 4//1\n")
                .geometry->positions.size(),
            4U);
  EXPECT_EQ(mesh_of_text(SquareVertices + normals + "f 1//1 2//1 3//1\nf 1//2 3//2 4//2\n")
                .geometry->positions.size(),
            6U);
}

TEST(Obj, SharesNoVerticesThatAreOnlyNear) {
  const grf::Mesh mesh = mesh_of_text("v 0 0 0\nv 1e-9 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 4\nf 2 3 4\n");
  EXPECT_EQ(mesh.geometry->positions.size(), 4U);
}

TEST(Obj, KeepsNormalsWhereThereAreSome) {
  const grf::Mesh mesh = mesh_of_text(SquareVertices + "vn 0 0 2\nf 1//1 2//1 3//1\nf 1 3 4\n");
  ASSERT_EQ(mesh.geometry->positions.size(), 6U);
  EXPECT_EQ(mesh.geometry->normals[0], grf::Vec3f(0, 0, 2));
  EXPECT_FALSE(mesh.geometry->normals.has(3));
}

TEST(Obj, KeepsVertexColours) {
  const grf::Mesh mesh = mesh_of_text("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0.5\nf 1 2 3\n");
  ASSERT_EQ(mesh.geometry->positions.size(), 3U);
  EXPECT_EQ(mesh.geometry->colours[2], grf::Colour(0, 0, 0.5F));
}

TEST(Obj, KeepsColoursThatOnlySomeVerticesHave) {
  const std::string obj = "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0 0 0 1\nf 1 2 3\n";
  EXPECT_THAT(warnings_of(obj), IsEmpty());
  const grf::Mesh mesh = mesh_of_text(obj);
  ASSERT_EQ(mesh.geometry->positions.size(), 3U);
  EXPECT_EQ(mesh.geometry->colours[0], grf::Colour(1, 0, 0));
  EXPECT_FALSE(mesh.geometry->colours.has(1));
  EXPECT_EQ(mesh.geometry->colours[2], grf::Colour(0, 0, 1));
}

TEST(Obj, KeepsTextureCoordinates) {
  const grf::Mesh mesh = mesh_of_text(SquareVertices + "vt 0.25 -3\nvt 0.5\nvt 0.75 1 0\nvn 0 0 1\n" +
                                      "f 1/1 2/2 3/3\nf 1/1/1 3/3/1 4/2/1\nf 1 2 3\n");
  ASSERT_EQ(mesh.geometry->positions.size(), 9U);
  EXPECT_EQ(mesh.geometry->uvs[0], grf::Vec2f(0.25F, -3));
  EXPECT_EQ(mesh.geometry->uvs[1], grf::Vec2f(0.5F, 0));
  EXPECT_EQ(mesh.geometry->uvs[4], grf::Vec2f(0.75F, 1));
  EXPECT_EQ(mesh.geometry->normals[4], grf::Vec3f(0, 0, 1));
  EXPECT_FALSE(mesh.geometry->uvs.has(6));
}

TEST(Obj, SplitsVerticesWhoseTextureCoordinatesDiffer) {
  const std::string uvs = "vt 0 0\nvt 1 0\nvt 0 0\n";
  EXPECT_EQ(mesh_of_text(SquareVertices + uvs + "f 1/1 2/1 3/1\nf 1/2 3/2 4/2\n").geometry->positions.size(),
            6U);
  EXPECT_EQ(mesh_of_text(SquareVertices + uvs + "f 1/1 2/1 3/1\nf 1/3 3/3 4/3\n").geometry->positions.size(),
            4U);
}

TEST(Obj, MixedCornersBeforeTheirElementsAreKept) {
  const grf::Mesh mesh = mesh_of_text("f 1/2 2/1 3/2\nvn 0 0 1\n" + SquareVertices + "vt 0.5 0.5\nvt 1 1\n");
  EXPECT_TRUE(mesh.geometry->normals.empty());
  EXPECT_EQ(mesh.geometry->uvs[0], grf::Vec2f(1, 1));
  EXPECT_EQ(mesh.geometry->uvs[1], grf::Vec2f(0.5F, 0.5F));
}

TEST(Obj, ReadsTheNearestFloat) {
  // Each lies a little beside the middle between two floats, or is one that takes many digits.
  for (const char* digits :
       {"0.1", "16777217.000001", "16777216.999999", "1.00000005960464477540", "1.00000017881393432616",
        "3.4028234663852886e38", "1e-45", "7.0064923216240854e-46",
        "0.000000000000000000000000000000000000011754943508222875", "-123456.789e-3"}) {
    const grf::Mesh mesh = mesh_of_text(fmt::format("v {0} 0 0\nv 0 {0} 1\nv 0 0 {0}\nf 1 2 3\n", digits));
    EXPECT_EQ(mesh.geometry->positions[0].x, std::strtof(digits, nullptr)) << digits;
    EXPECT_EQ(mesh.geometry->positions[1].y, std::strtof(digits, nullptr)) << digits;
  }
}

TEST(Obj, KeepsTheSignOfAZeroAndSharesItsVertexAllTheSame) {
  const grf::Mesh mesh = mesh_of_text("v -0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nf 1 2 3\nf 4 3 2\n");
  EXPECT_EQ(mesh.geometry->positions.size(), 3U);
  EXPECT_TRUE(std::signbit(mesh.geometry->positions[0].x));
}

TEST(Obj, DividesByTheWeightOfAVertex) {
  EXPECT_EQ(mesh_of_text("v 2 4 6 2\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").geometry->positions[0],
            grf::Vec3f(1, 2, 3));
}

TEST(Obj, CountsNegativeIndicesFromTheLastVertex) {
  const grf::Mesh mesh = mesh_of_text(SquareVertices + "f -4 -3 -2\nv 5 5 5\nf -1 -2 1\n");
  EXPECT_EQ(mesh.geometry->positions[mesh.face(0)[0]], grf::Vec3f(0, 0, 0));
  EXPECT_EQ(mesh.geometry->positions[mesh.face(1)[0]], grf::Vec3f(5, 5, 5));
}

TEST(Obj, FacesMayStandBeforeTheirVertices) {
  EXPECT_EQ(mesh_of_text("f 1 2 3\n" + SquareVertices).face_count(), 1U);
}

TEST(Obj, ObjectsAndGroupsBecomeMeshesWithTheirNames) {
  const std::vector<grf::Mesh> meshes =
      meshes_of_text(SquareVertices +
                     "f 1 2 3\no First \"object\"\nf 1 2 4\ng group a b\nf 2 3 4\nf 1 3 4\no empty\n"
                     "o First \"object\"\nf 1 2 3\n");
  ASSERT_EQ(meshes.size(), 4U);
  EXPECT_EQ(meshes[0].name, "");
  EXPECT_EQ(meshes[1].name, "First \"object\"");
  EXPECT_EQ(meshes[2].name, "group a b");
  EXPECT_EQ(meshes[2].face_count(), 2U);
  EXPECT_EQ(meshes[3].name, "First \"object\"");
  EXPECT_EQ(meshes[3].geometry->positions.size(), 3U);
}

TEST(Obj, NamesOfMeshesComeBackFromGrfText) {
  const Reading reading = read_obj_text(SquareVertices + "o a \"b\" \\ c // d \u00E6 (1,2)\nf 1 2 3\n");
  ASSERT_TRUE(reading.scene.has_value());
  grf::Diagnostics diagnostics;
  const auto again = grf::read_text(grf::to_text(*reading.scene), "again.grf", diagnostics);
  ASSERT_TRUE(again.has_value()) << diagnostics.to_text();
  EXPECT_EQ(*again, *reading.scene);
  EXPECT_EQ(meshes_of(*again)[0].name, "a \"b\" \\ c // d \u00E6 (1,2)");
}

TEST(Obj, NamesOfMeshesHaveQuotesOfOneKind) {
  const Reading reading =
      read_obj_text(SquareVertices + "g b\" 1 \u201C2\u201D\nf 1 2 3\no \u201C3\u201D\nf 1 2 4\n");
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_EQ(meshes_of(*reading.scene)[0].name, "b\" 1 \"2\"");
  EXPECT_EQ(meshes_of(*reading.scene)[1].name, "\u201C3\u201D");
}

TEST(Obj, UnderstandsTheWaysToWriteAStatement) {
  const std::string obj =
      "\xEF\xBB\xBF  v 0 0 0\r\n\tv 1 0 0 # a corner\r\nv 1 1 0\r\nf 1 \\\r\n  2 \\\n3 # all\r\nf 1// 2// "
      "3//\n";
  const grf::Mesh mesh = mesh_of_text(obj);
  EXPECT_EQ(mesh.face_count(), 2U);
  EXPECT_EQ(mesh.geometry->positions.size(), 3U);
  std::string old_macintosh = SquareVertices + "f 1 2 3 4\n";
  std::replace(old_macintosh.begin(), old_macintosh.end(), '\n', '\r');
  EXPECT_EQ(mesh_of_text(old_macintosh).face_count(), 1U);
}

TEST(Obj, SaysInOneLineAKindWhatIsLost) {
  const std::string text = warnings_of("vt 0 0 1\n" + SquareVertices +
                                       "v 7 7 7\nf 1/1 2/1 3/1\nf 1 3 4\nl 1 2 3\nl 3 4\np 1 2 3\nf 1 2\n"
                                       "curv 0 1 1 2\ncurv 0 1 2 3\nlod 3\n");
  EXPECT_THAT(text, HasSubstr("1 texture coordinate lost its third number: "));
  EXPECT_THAT(text, HasSubstr("1 vertex without a face was left out: "));
  EXPECT_THAT(text, HasSubstr("1 face was left out: fewer than three corners"));
  EXPECT_THAT(text, HasSubstr("2 lines were left out: "));
  EXPECT_THAT(text, HasSubstr("3 points were left out: "));
  EXPECT_THAT(text, HasSubstr("3 statements were not read: 'curv', 'lod'"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 6);
}

TEST(Obj, SaysNothingOfAPlainModel) { EXPECT_THAT(warnings_of(SquareVertices + "f 1 2 3 4\n"), IsEmpty()); }

TEST(Obj, VerticesThatAreNoneAreErrors) {
  EXPECT_THAT(
      error_of("v 0 0\n" + SquareVertices + "f 1 2 3\n"),
      HasSubstr("model.obj:1:1: error: found 2 numbers for a vertex, expected 3 or 4 or 6\n  v 0 0\n  ^\n"));
  EXPECT_THAT(error_of("v 0 0 0 0 0\n" + SquareVertices + "f 1 2 3\n"),
              HasSubstr("error: found 5 numbers for a vertex"));
  EXPECT_THAT(error_of("v 0 0 x\n" + SquareVertices + "f 1 2 3\n"),
              HasSubstr(":1:7: error: found 'x', expected a finite number"));
  EXPECT_THAT(error_of("v 0 nan 0\n" + SquareVertices + "f 1 2 3\n"), HasSubstr("error: found 'nan'"));
  EXPECT_THAT(error_of("v 0 1e39 0\n" + SquareVertices + "f 1 2 3\n"), HasSubstr("error: found '1e39'"));
  EXPECT_THAT(error_of("v 0,5 1 0\n" + SquareVertices + "f 1 2 3\n"), HasSubstr("error: found '0,5'"));
  EXPECT_THAT(error_of("v 0 1 0 0\n" + SquareVertices + "f 1 2 3\n"), HasSubstr("infinitely far"));
  EXPECT_THAT(error_of("v 1e30 1 0 1e-30\n" + SquareVertices + "f 1 2 3\n"),
              HasSubstr("too large for a float"));
  EXPECT_THAT(error_of("v 0 1 0 1 -1 0\n" + SquareVertices + "f 1 2 3\n"), HasSubstr("0 or more"));
  EXPECT_THAT(error_of("vn 0 1\n" + SquareVertices + "f 1 2 3\n"),
              HasSubstr("found 2 numbers for a normal, expected 3"));
}

TEST(Obj, CornersThatAreNoneAreErrors) {
  for (const char* corner :
       {"x", "0", "1.5", "1/x", "1/1/1/1", "1,", "01", "+1", "99999999999999999999", "/1"}) {
    EXPECT_THAT(error_of(fmt::format("{}vt 0 0\nvn 0 0 1\nf 1 2 {}\n", SquareVertices, corner)),
                HasSubstr(fmt::format("model.obj:7:7: error: found '{}', expected a corner", corner)));
  }
  EXPECT_THAT(error_of(SquareVertices + "vn 0 0 1\nf 1//1 2 3//1\n"),
              HasSubstr(":6:8: error: '2': the corners of a face"));
  EXPECT_THAT(error_of(SquareVertices + "f\n"), HasSubstr(":5:1: error: a face without corners"));
}

TEST(Obj, IndicesOfWhatDoesNotExistAreErrors) {
  EXPECT_THAT(error_of(SquareVertices + "f 1 2 3\nf 1 2 5\n"),
              HasSubstr("model.obj:6:7: error: no vertex with the index 5 exists: the file has 4"));
  EXPECT_THAT(
      error_of(SquareVertices + "f 1 2 -5\n"),
      HasSubstr("model.obj:5:7: error: '-5': no vertex with the index -5 exists: there are 4 before"));
  EXPECT_THAT(error_of(SquareVertices + "vn 0 0 1\nf 1//1 2//2 3//1\n"),
              HasSubstr("no normal with the index 2 exists"));
  EXPECT_THAT(error_of(SquareVertices + "f 1/1 2/1 3/1\n"),
              HasSubstr("no texture coordinate with the index 1 exists"));
}

TEST(Obj, AllErrorsAreFoundInOneGo) {
  const std::string text = error_of(SquareVertices + "v 1\nf 1 2 x\nf\nv 0 0 z\n");
  for (const char* place : {":5:1: error", ":6:7: error", ":7:1: error", ":8:7: error"}) {
    EXPECT_THAT(text, HasSubstr(place));
  }
}

TEST(Obj, FilesThatHoldNoModelAreErrors) {
  const auto error_of_bytes = [](std::string_view bytes) {
    const test::TemporaryFolder folder;
    const Reading reading = read_path(folder.add("model.obj", bytes));
    EXPECT_FALSE(reading.scene.has_value());
    EXPECT_EQ(reading.diagnostics.error_count(), 1U);
    return reading.text();
  };
  EXPECT_THAT(error_of_bytes(""), HasSubstr("model.obj: error: the file is empty, expected an OBJ model"));
  EXPECT_THAT(error_of_bytes(std::string_view("v\0\0\0\1", 5)), HasSubstr("error: this is a binary file"));
  EXPECT_THAT(error_of_bytes("# nothing\n"), HasSubstr("error: the file has no faces"));
  EXPECT_THAT(error_of_bytes(SquareVertices), HasSubstr("error: the file has no faces"));
  const test::TemporaryFolder folder;
  EXPECT_THAT(read_path(folder.path("missing.obj")).text(),
              HasSubstr("missing.obj: error: cannot read the file: No such"));
  EXPECT_THAT(read_path(folder.path()).text(), HasSubstr("it is a directory"));
}

TEST(Obj, AVeryLongLineCostsNoMoreThanItsLength) {
  std::string obj = SquareVertices;
  for (int i = 0; i < 100'000; ++i) obj += "v 1 2 3\n";
  obj += "f";
  for (int i = 1; i <= 100'000; ++i) obj += fmt::format(" {}", i);
  EXPECT_EQ(mesh_of_text(obj + "\n").face(0).size(), 100'000U);
}

TEST(Obj, HasMoreThanAMillionCorners) {
  constexpr std::size_t Faces = 340'000;
  std::string obj;
  for (std::size_t i = 0; i < 3 * Faces; ++i) obj += fmt::format("v {} {} {}\n", i % 1000, i / 1000, i % 2);
  for (std::size_t i = 0; i < Faces; ++i) obj += fmt::format("f {} {} {}\n", 3 * i + 1, 3 * i + 2, 3 * i + 3);
  const grf::Mesh mesh = mesh_of_text(obj);
  ASSERT_EQ(mesh.face_count(), Faces);
  for (const std::size_t face : {std::size_t(0), Faces / 2, Faces - 5'000, Faces - 1}) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = 3 * face + k;
      EXPECT_EQ(mesh.geometry->positions[mesh.face(face)[k]],
                grf::Vec3f(static_cast<float>(i % 1000), static_cast<float>(i / 1000), i % 2 == 0 ? 0 : 1))
          << face << " " << k;
    }
  }
}

}  // namespace
}  // namespace convert
