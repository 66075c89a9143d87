#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;

grf::Mesh mesh_of(const Reading& reading) {
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  return reading.scene ? meshes_of(*reading.scene).at(0) : grf::Mesh();
}

TEST(Off, KeepsPolygonsAndSharedVertices) {
  const Reading reading =
      read_bytes("a",
                 "# made by hand\nOFF 5 3 0\n0 0 0\n1 0 0 # a comment\n\n1 1 0\n0 1 0\n# apex\n0.5 0.5 1\n"
                 "4 3 2 1 0\n3 0 1 4\n3 1 2 4\n");
  const grf::Mesh mesh = mesh_of(reading);
  EXPECT_EQ(mesh.face_count(), 3U);
  EXPECT_EQ(mesh.face(0).size(), 4U);
  EXPECT_EQ(mesh.geometry->positions.size(), 5U);
  EXPECT_EQ(mesh.geometry->positions[mesh.face(1)[2]], grf::Vec3f(0.5F, 0.5F, 1));
  EXPECT_FALSE(mesh.surface(0).brdf.has_value());
  EXPECT_EQ(reading.diagnostics.warning_count(), 0U) << reading.text();
}

TEST(Off, FacesOfManyCornersAreWhole) {
  std::string text = "OFF\n12 1 0\n";
  std::string face = "12";
  for (int i = 0; i < 12; ++i) {
    text += std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
    face += " " + std::to_string(i);
  }
  const grf::Mesh mesh = mesh_of(read_bytes("a.off", text + face + "\n"));
  ASSERT_EQ(mesh.face_count(), 1U);
  EXPECT_EQ(mesh.face(0).size(), 12U);
}

TEST(Off, VerticesHaveWhatTheNameAnnounces) {
  const grf::Mesh mesh = mesh_of(read_bytes("a.off",
                                            "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 255 0.5 0\n"
                                            "1 0 0 0 0 1 0 255 0 255 1 0\n0 1 0 0 0 1 0 0 255 255 0 1\n"
                                            "3 0 1 2\n"));
  ASSERT_EQ(mesh.geometry->positions.size(), 3U);
  EXPECT_EQ(mesh.geometry->normals[0], grf::Vec3f(0, 0, 1));
  EXPECT_EQ(mesh.geometry->colours[1], grf::Colour(0, 1, 0)) << "of 255 parts";
  EXPECT_EQ(mesh.geometry->uvs[0], grf::Vec2f(0.5F, 0));
}

TEST(Off, HomogeneousVerticesAreDivided) {
  const grf::Mesh mesh = mesh_of(read_bytes("a.off", "4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 4 0 4\n3 0 1 2\n"));
  EXPECT_EQ(mesh.geometry->positions[1], grf::Vec3f(1, 0, 0));
  EXPECT_EQ(mesh.geometry->positions[2], grf::Vec3f(0, 1, 0));
  EXPECT_THAT(read_bytes("a.off", "4OFF\n3 1 0\n0 0 0 0\n").text(), HasSubstr(":3:1: error: the vertex is"));
}

TEST(Off, FacesHaveTheirColours) {
  const Reading reading = read_bytes(
      "a.off", "OFF\n3 4 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 0.5 0\n3 0 1 2\n3 0 1 2 7\n3 0 1 2 0 0 1 0.5\n");
  const grf::Mesh mesh = mesh_of(reading);
  EXPECT_EQ(mesh.surface(0).colour, grf::ColourAttribute(grf::Colour(1, 0.5F, 0)));
  EXPECT_FALSE(mesh.surface(1).colour.has_value());
  EXPECT_FALSE(mesh.surface(2).colour.has_value());
  EXPECT_EQ(mesh.surface(3).colour, grf::ColourAttribute(grf::Colour(0, 0, 1)));
  EXPECT_THAT(reading.text(), HasSubstr("warning: 1 face lost its colour"));
}

TEST(Off, WhatIsNoFaceIsCounted) {
  const Reading reading =
      read_bytes("a.off", "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0 9\n2 0 1\n1 0\n3 0 1 2\n3 0 2 1\n");
  EXPECT_EQ(mesh_of(reading).face_count(), 1U);
  EXPECT_THAT(reading.text(), HasSubstr("1 line was left out"));
  EXPECT_THAT(reading.text(), HasSubstr("1 point was left out"));
  EXPECT_THAT(reading.text(), HasSubstr("1 vertex has numbers that the format's name does not announce"));
  EXPECT_THAT(reading.text(), HasSubstr("1 line is not read after the last face"));
}

TEST(Off, BrokenFilesAreErrors) {
  const auto error_of = [](const std::string& text) {
    const Reading reading = read_bytes("a.off", text);
    EXPECT_FALSE(reading.scene.has_value()) << text;
    return reading.text();
  };
  EXPECT_THAT(error_of(""), HasSubstr("the file is empty, expected an OFF model"));
  EXPECT_THAT(error_of("8 6 0\n"), HasSubstr("a.off:1:1: error: expected OFF"));
  EXPECT_THAT(error_of("nOFF 4\n1 1 1\n"), HasSubstr("error: vertices of any dimension are not read"));
  EXPECT_THAT(error_of("OFF BINARY\n"), HasSubstr("a.off:1:5: error: binary OFF files are not read"));
  EXPECT_THAT(error_of("OFF\n"), HasSubstr("error: the counts are missing"));
  EXPECT_THAT(error_of("OFF\n-3 1 0\n"), HasSubstr("a.off:2:1: error: found '-3', expected the count"));
  EXPECT_THAT(error_of("OFF\n353535235358 6 0\n"), HasSubstr("error: found '353535235358'"));
  EXPECT_THAT(error_of("OFF\n4000000000 4000000000 0\n0 0 0\n"),
              HasSubstr("error: the file ends after 1 of 4000000000 vertices"));
  EXPECT_THAT(error_of("OFF\n1 1 0\n0 0\n"), HasSubstr("a.off:3:3: error: the vertex has 2 of at least 3"));
  EXPECT_THAT(error_of("OFF\n1 1 0\n0 0 nan\n"), HasSubstr("a.off:3:5: error: found 'nan'"));
  EXPECT_THAT(error_of("OFF\n1 1 0\n0 0 0\n3 0 0 1\n"), HasSubstr("a.off:4:7: error: vertex 1 of 1"));
  EXPECT_THAT(error_of("OFF\n1 1 0\n0 0 0\n3 0 0\n"),
              HasSubstr("error: the line ends here, expected the index"));
  EXPECT_THAT(error_of("OFF\n1 2 0\n0 0 0\n3 0 0 0\n"), HasSubstr("error: the file ends after 1 of 2 faces"));
  EXPECT_THAT(error_of("OFF\n2 1 0\n0 0 0\n1 0 0\n2 0 1\n"), HasSubstr("error: the file has no faces"));
}

}  // namespace
}  // namespace convert
