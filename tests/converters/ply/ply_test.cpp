#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/ply/ply_header.h"
#include "grf/keywords.h"
#include "grf/read.h"
#include "tests/converters/ply/ply_bytes.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using grf::Colour;
using grf::Vec2f;
using grf::Vec3f;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string Begin = "ply\nformat ascii 1.0\n";
const std::string Vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string Face = "property list uchar int vertex_indices\n";
const std::string Square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

Reading read_ply_bytes(std::string_view bytes, const ReadOptions& options = {}) {
  const test::TemporaryFolder folder;
  return read_path(folder.add("model.ply", bytes), options);
}

/// The one mesh of a file that is sound.
grf::Mesh mesh_of(std::string_view bytes) {
  const Reading reading = read_ply_bytes(bytes);
  if (!reading.scene) throw std::runtime_error(reading.text());
  return meshes_of(*reading.scene).front();
}

std::vector<std::uint32_t> face_of(const grf::Mesh& mesh, std::size_t face) {
  const auto corners = mesh.face(face);
  return {corners.begin(), corners.end()};
}

TEST(Ply, ReadsASquare) {
  const grf::Mesh mesh = mesh_of(Begin + Vertices + "element face 2\n" + Face + "end_header\n" + Square +
                                 "4 0 1 2 3\n3 2 1 0\n");
  EXPECT_THAT(mesh.geometry->positions,
              ElementsAre(Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(1, 1, 0), Vec3f(0, 1, 0)));
  ASSERT_EQ(mesh.face_count(), 2U);
  EXPECT_THAT(face_of(mesh, 0), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(face_of(mesh, 1), ElementsAre(2, 1, 0));
  EXPECT_TRUE(mesh.geometry->normals.empty() && mesh.geometry->colours.empty() && mesh.geometry->uvs.empty());
}

TEST(Ply, KeepsFacesThatNoHalfEdgeMeshCouldHave) {
  const grf::Mesh mesh = mesh_of(Begin + Vertices + "element face 5\n" + Face + "end_header\n" + Square +
                                 "3 0 1 2\n3 0 1 3\n3 0 1 2\n3 1 1 2\n3 1 0 2\n");
  ASSERT_EQ(mesh.face_count(), 5U)
      << "an edge of three faces, a face twice, and one that uses a vertex twice";
  EXPECT_THAT(face_of(mesh, 3), ElementsAre(1, 1, 2));
}

/// A vertex with all that it can have, its properties in an odd order and of many types.
std::string odd_file(std::string_view encoding) {
  PlyBytes file(encoding);
  file.line("comment odd").line("obj_info too").line("element vertex 3");
  file.line("property uchar blue").line("property double z").line("property float nz");
  file.line("property list ushort short neighbours").line("property float ny").line("property int x");
  file.line("property float32 y").line("property float nx").line("property uchar red");
  file.line("property ushort alpha").line("property uint8 green").line("property float64 texture_v");
  file.line("property float texture_u").line("element marker 2").line("property list char double at");
  file.line("element face 1").line("property list int uchar flags");
  file.line("property list ushort ushort vertex_index")
      .line("property double red")
      .line("property float green");
  file.line("property ushort blue").line("end_header");
  for (int i = 0; i < 3; ++i) {
    file.put(std::uint8_t{255}).put(0.5 * i).put(1.0F).put(std::uint16_t{2});
    file.put(std::int16_t{-3}).put(std::int16_t{4}).put(0.25F).put(std::int32_t{-i}).put(0.125F).put(0.0F);
    file.put(static_cast<std::uint8_t>(51 * i))
        .put(static_cast<std::uint16_t>(i == 1 ? 1 : 65535))
        .put(std::uint8_t{0});
    file.put(0.75).put(0.25F).end();
  }
  file.put(std::int8_t{1}).put(1.5).end().put(std::int8_t{0}).end();
  file.put(std::int32_t{1}).put(std::uint8_t{7}).put(std::uint16_t{3}).put(std::uint16_t{2});
  file.put(std::uint16_t{1}).put(std::uint16_t{0}).put(0.1).put(2.5F).put(std::uint16_t{65535}).end();
  return file.bytes();
}

class PlyEncodings : public testing::TestWithParam<const char*> {};

TEST_P(PlyEncodings, ReadAnyOrderAndType) {
  const Reading reading = read_ply_bytes(odd_file(GetParam()));
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const grf::Mesh mesh = meshes_of(*reading.scene).front();
  EXPECT_THAT(mesh.geometry->positions,
              ElementsAre(Vec3f(0, 0.125F, 0), Vec3f(-1, 0.125F, 0.5F), Vec3f(-2, 0.125F, 1)));
  EXPECT_EQ(mesh.geometry->normals[1], Vec3f(0, 0.25F, 1));
  EXPECT_EQ(mesh.geometry->uvs[2], Vec2f(0.25F, 0.75F));
  EXPECT_EQ(mesh.geometry->colours[2], Colour(0.4F, 0, 1));
  EXPECT_THAT(face_of(mesh, 0), ElementsAre(2, 1, 0));
  EXPECT_EQ(std::get<Colour>(*mesh.surface(0).colour), Colour(0.1F, 2.5F, 1));
  EXPECT_THAT(reading.text(),
              HasSubstr("2 properties were not read: 'neighbours of vertex', 'flags of face'"));
  EXPECT_THAT(reading.text(), HasSubstr("2 elements were not read: 'marker'"));
  EXPECT_THAT(reading.text(), HasSubstr("1 vertex or face lost its alpha"));
}

TEST_P(PlyEncodings, ReadStrips) {
  PlyBytes file(GetParam());
  file.line("element vertex 5").line("property float x").line("property float y").line("property float z");
  file.line("element tristrips 1").line("property list int int vertex_indices").line("end_header");
  for (int i = 0; i < 5; ++i) file.put(static_cast<float>(i)).put(0.0F).put(0.0F).end();
  const std::vector<int> strip = {0, 1, 2, 3, 3, 4, 4, -1, 2, 1, 0, -1, -1, 3, 4};
  file.put(static_cast<std::int32_t>(strip.size()));
  for (const int vertex : strip) file.put(std::int32_t{vertex});
  const grf::Mesh mesh = mesh_of(file.end().bytes());
  ASSERT_EQ(mesh.face_count(), 3U);
  EXPECT_THAT(face_of(mesh, 0), ElementsAre(0, 1, 2));
  EXPECT_THAT(face_of(mesh, 1), ElementsAre(2, 1, 3)) << "every other one is turned round";
  EXPECT_THAT(face_of(mesh, 2), ElementsAre(2, 1, 0));
}

TEST_P(PlyEncodings, ReadFacesThatStandBeforeTheirVertices) {
  PlyBytes file(GetParam());
  file.line("element face 1").line("property list uchar int vertex_indices");
  file.line("property list uchar float texcoord").line("element vertex 3").line("property float x");
  file.line("property float y").line("property float z").line("end_header");
  file.put(std::uint8_t{3})
      .put(std::int32_t{0})
      .put(std::int32_t{2})
      .put(std::int32_t{1})
      .put(std::uint8_t{6});
  for (int i = 0; i < 6; ++i) file.put(static_cast<float>(i));
  file.end();
  for (int i = 0; i < 3; ++i) file.put(static_cast<float>(i)).put(0.0F).put(0.0F).end();
  const Reading reading = read_ply_bytes(file.bytes());
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_EQ(reading.text(), "");
  const grf::Mesh mesh = meshes_of(*reading.scene).front();
  EXPECT_THAT(face_of(mesh, 0), ElementsAre(0, 2, 1));
  EXPECT_EQ(mesh.geometry->uvs[2], Vec2f(2, 3));
}

INSTANTIATE_TEST_SUITE_P(All, PlyEncodings,
                         testing::Values("ascii", "binary_little_endian", "binary_big_endian"),
                         [](const auto& of) { return std::string(of.param); });

TEST(Ply, GivesFacesTheirOwnTextureCoordinates) {
  const grf::Mesh mesh = mesh_of(
      Begin + "comment TextureFile wood.png\ncomment TextureFile my stone.png\n" + Vertices +
      "element face 3\n" + Face + "property list uchar float texcoord\nproperty int texnumber\nend_header\n" +
      Square + "3 0 1 2 6 0 0 1 0 1 1 0\n3 0 2 3 6 .5 0 1 1 0 1 1\n3 0 2 3 6 .5 0 1 1 0 1 -1\n");
  ASSERT_EQ(mesh.geometry->positions.size(), 5U) << "vertex 0 has two uvs";
  EXPECT_EQ(mesh.geometry->positions[4], mesh.geometry->positions[0]);
  EXPECT_EQ(mesh.geometry->uvs[0], Vec2f(0, 0));
  EXPECT_EQ(mesh.geometry->uvs[4], Vec2f(0.5F, 0));
  EXPECT_THAT(face_of(mesh, 0), ElementsAre(0, 1, 2));
  EXPECT_THAT(face_of(mesh, 1), ElementsAre(4, 2, 3));
  EXPECT_THAT(face_of(mesh, 2), ElementsAre(4, 2, 3));
  EXPECT_EQ(std::get<grf::Texture>(*mesh.surface(0).texture).file, "wood.png");
  EXPECT_EQ(std::get<grf::Texture>(*mesh.surface(1).texture).file, "my stone.png");
  EXPECT_FALSE(mesh.surface(2).texture.has_value());
}

TEST(Ply, ATextureWithoutNumbersIsThatOfAllFaces) {
  const std::string header = Begin +
                             "comment TextureFile a.png\nelement vertex 3\nproperty float x\n"
                             "property float y\nproperty float z\n";
  const std::string face = "element face 1\n" + Face + "end_header\n";
  const grf::Mesh mesh = mesh_of(header + "property float s\nproperty float t\n" + face +
                                 "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n");
  EXPECT_EQ(std::get<grf::Texture>(*mesh.surface(0).texture).file, "a.png");
  const Reading without_uvs = read_ply_bytes(header + face + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_THAT(without_uvs.text(), HasSubstr("1 face lost its texture: the file has no texture coordinates"));
}

TEST(Ply, FacesOfOneColourShareASurface) {
  const grf::Mesh mesh =
      mesh_of(Begin + Vertices + "element face 4\n" + Face +
              "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n" + Square +
              "3 0 1 2 255 0 0\n3 0 1 3 0 0 255\n3 1 2 3 255 0 0\n3 3 2 1 255 0 0\n");
  EXPECT_EQ(mesh.surfaces.size(), 2U);
  EXPECT_EQ(std::get<Colour>(*mesh.surface(0).colour), Colour(1, 0, 0));
  EXPECT_EQ(std::get<Colour>(*mesh.surface(1).colour), Colour(0, 0, 1));
  EXPECT_EQ((*mesh.surface_of_face)[3], (*mesh.surface_of_face)[0]);
}

TEST(Ply, MaterialsAreNames) {
  ReadOptions options;
  const std::string text = Begin + "comment material 1 shiny gold\ncomment material 0 " +
                           grf::to_identifier(" odd\tname") + "\n" + Vertices + "element face 4\n" + Face +
                           "property int material_index\nend_header\n" + Square +
                           "3 0 1 2 1\n3 0 1 3 0\n3 1 2 3 -1\n3 1 2 3 7\n";
  const Reading reading = read_ply_bytes(text, options);
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const grf::Mesh mesh = meshes_of(*reading.scene).front();
  EXPECT_EQ(grf::from_identifier(material_of(mesh, 0)), "shiny gold");
  EXPECT_EQ(grf::from_identifier(material_of(mesh, 1)), " odd\tname");
  EXPECT_EQ(material_of(mesh, 2), "");
  EXPECT_EQ(grf::from_identifier(material_of(mesh, 3)), "material 7");
  EXPECT_EQ(definitions_of(*reading.scene).size(), 3U);
  EXPECT_EQ(brdf_text(definitions_of(*reading.scene).front()), "diffuse kd=0.5");
  EXPECT_THAT(reading.text(),
              HasSubstr("note: 3 faces are of materials of which the file has only the names"));
  grf::Diagnostics diagnostics;
  options.brdf = grf::read_brdf("ward sx=0.15", "option", diagnostics);
  EXPECT_EQ(brdf_text(definitions_of(*read_ply_bytes(text, options).scene).front()), "ward sx=0.15");
}

TEST(Ply, CountsWhatItRoundsOrLeavesOut) {
  const Reading reading = read_ply_bytes(
      Begin +
      "element vertex 4\nproperty double x\nproperty double y\nproperty double z\nproperty float nx\n" +
      "property float ny\nproperty float nz\nproperty float red\nproperty float green\nproperty float "
      "blue\n" +
      "element face 2\n" + Face + "element edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n" +
      "0.1 0 0 nan 0 0 1 1 1\n1 0 0 0 0 1 -1 0 0\n1 1 0 0 0 0 1 1 1\n0 1 0.2 0 0 1 0 0 0\n" +
      "3 0 1 2\n2 0 1\n0 1\n1 2\n");
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const grf::Mesh mesh = meshes_of(*reading.scene).front();
  EXPECT_EQ(mesh.face_count(), 1U);
  EXPECT_EQ(mesh.geometry->positions.size(), 4U) << "one without a face too";
  EXPECT_EQ(mesh.geometry->positions[0].x, 0.1F);
  EXPECT_FALSE(mesh.geometry->normals.has(0)) << "no number";
  EXPECT_FALSE(mesh.geometry->normals.has(2)) << "no length";
  EXPECT_EQ(mesh.geometry->colours[1], Colour(0, 0, 0));
  EXPECT_THAT(reading.text(), HasSubstr("note: 2 positions were rounded to the numbers of GRF"));
  EXPECT_THAT(reading.text(), HasSubstr("1 vertex lost its normal: it has no direction"));
  EXPECT_THAT(reading.text(), HasSubstr("1 face was left out: fewer than three corners"));
  EXPECT_THAT(reading.text(), HasSubstr("2 edges were left out"));
  EXPECT_THAT(reading.text(), HasSubstr("1 colour has components below 0"));
}

TEST(Ply, ReadsLineEndsOfAllSystems) {
  std::string text = Begin + Vertices + "element face 1\n" + Face + "end_header\n" + Square + "4 0 1 2 3\n";
  const grf::Mesh expected = mesh_of(text);
  std::string windows;
  for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(mesh_of(windows), expected);
  std::replace(text.begin(), text.end(), '\n', '\r');
  EXPECT_EQ(mesh_of(text), expected);
}

}  // namespace
}  // namespace convert
