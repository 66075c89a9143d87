#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/converters/assimp/three_ds_file.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;

std::string facet(const std::vector<float>& corners, unsigned attribute = 0) {
  return floats({0, 0, 1}) + floats(corners) + word(attribute);
}

std::string binary_stl(std::uint32_t count, const std::string& facets, const std::string& header = "") {
  std::string bytes = header;
  bytes.resize(80, ' ');
  return bytes + little_endian(count, 4) + facets;
}

const std::string Square = facet({0, 0, 0, 1, 0, 0, 1, 1, 0}) + facet({0, 0, 0, 1, 1, 0, 0, 1, 0});

TEST(Stl, BinaryFilesHaveSharedVerticesAndNoMaterial) {
  const Reading reading = read_bytes("a.stl", binary_stl(2, Square));
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const auto meshes = meshes_of(*reading.scene);
  ASSERT_EQ(meshes.size(), 1U);
  EXPECT_EQ(meshes[0].face_count(), 2U);
  EXPECT_EQ(meshes[0].geometry->positions.size(), 4U);
  EXPECT_TRUE(meshes[0].geometry->normals.empty());
  EXPECT_FALSE(meshes[0].surface(0).brdf.has_value());
  EXPECT_TRUE(definitions_of(*reading.scene).empty());
  EXPECT_EQ(reading.diagnostics.warning_count(), 0U) << reading.text();
}

TEST(Stl, ABinaryFileMayBeginAsTextDoes) {
  const Reading reading = read_bytes("a.stl", binary_stl(2, Square, "solid of facets"));
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_EQ(meshes_of(*reading.scene).at(0).face_count(), 2U);
}

TEST(Stl, FacetsWithoutAColourGetNone) {
  const unsigned red = 0x8000U | (31U << 10U);
  const std::string facets = facet({0, 0, 0, 1, 0, 0, 1, 1, 0}, red) + facet({5, 0, 0, 6, 1, 0, 5, 1, 0});
  const Reading reading = read_bytes("a.stl", binary_stl(2, facets));
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const grf::Mesh mesh = meshes_of(*reading.scene).at(0);
  ASSERT_TRUE(mesh.geometry->colours.has(mesh.face(0)[0]));
  EXPECT_EQ(mesh.geometry->colours[mesh.face(0)[0]], grf::Colour(1, 0, 0));
  EXPECT_FALSE(mesh.geometry->colours.has(mesh.face(1)[0]));
}

TEST(Stl, FilesThatWereCutOffAreErrors) {
  const std::string whole = binary_stl(2, Square);
  EXPECT_THAT(read_bytes("a.stl", std::string_view(whole).substr(0, 150)).text(),
              HasSubstr("error: the file ends after 1 of 2 facets"));
  EXPECT_THAT(read_bytes("a.stl", "nothing").text(), HasSubstr("error: the file is not an STL model"));
  EXPECT_THAT(read_bytes("a.stl", "").text(), HasSubstr("error: the file is empty"));
  // 50 times this count is 4 modulo 2^32, which is what is there.
  EXPECT_THAT(read_bytes("a.stl", binary_stl(85899346, "1234")).text(),
              HasSubstr("error: the file ends after 0 of 85899346 facets"));
}

TEST(Stl, EveryCutIsAnError) {
  const std::string whole = binary_stl(2, Square);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Reading reading = read_bytes("a.stl", std::string_view(whole).substr(0, size));
    EXPECT_FALSE(reading.scene.has_value()) << size;
    EXPECT_TRUE(reading.diagnostics.has_errors()) << size;
  }
}

// One byte too many in the middle moves all behind it: the size is all that shows it.
TEST(Stl, BytesBehindTheLastFacetAreErrors) {
  std::string moved = binary_stl(2, Square);
  moved.insert(100, 1, '\r');
  for (const std::string& bytes : {moved, binary_stl(2, Square) + "end", binary_stl(1, Square)}) {
    const Reading reading = read_bytes("a.stl", bytes);
    EXPECT_FALSE(reading.scene.has_value());
    EXPECT_THAT(reading.text(), HasSubstr(" the last of "));
  }
  EXPECT_EQ(read_bytes("a.stl", binary_stl(2, Square) + "\r\n\x1A").text(), "") << "which says nothing";
}

constexpr std::string_view TextFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

TEST(Stl, SolidsBecomeMeshes) {
  const std::string text = "solid first\n" + std::string(TextFacet) + "endsolid first\nsolid second\n" +
                           std::string(TextFacet) + std::string(TextFacet) + "endsolid second\n";
  const Reading reading = read_bytes("a.dat", text);
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const auto meshes = meshes_of(*reading.scene);
  ASSERT_EQ(meshes.size(), 2U);
  EXPECT_EQ(meshes[0].name, "first");
  EXPECT_EQ(meshes[0].face_count(), 1U);
  EXPECT_EQ(meshes[1].name, "second");
  EXPECT_EQ(meshes[1].face_count(), 2U);
}

TEST(Stl, OddFacetsInTextAreErrors) {
  const std::string four =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 1 1 0\n"
      "endloop\nendfacet\nendsolid a\n";
  const Reading reading = read_bytes("a.stl", four);
  EXPECT_FALSE(reading.scene.has_value());
  EXPECT_THAT(reading.text(), HasSubstr("error: Assimp says: STL: a facet with more than 3 vertices"));
  EXPECT_FALSE(
      read_bytes("a.stl", "solid a\nfacet normal 0 0 1\nvertex 1 2 3\nendfacet\nendsolid a\n").scene);
  EXPECT_FALSE(
      read_bytes("a.stl", "solid a\nfacet normal 0 0 1\nvertex 1 2 x\nendfacet\nendsolid a\n").scene);
  EXPECT_THAT(read_bytes("a.stl", "solid a\nendsolid a\n").text(), HasSubstr("error: "));
}

}  // namespace
}  // namespace convert
