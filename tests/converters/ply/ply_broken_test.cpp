// Tests of corrupt PLY files: one error, with the line, or the byte offset of a binary file.
#include <bit>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/converters/ply/ply_bytes.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;

const std::string Begin = "ply\nformat ascii 1.0\n";
const std::string Vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string Face = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string Header = Begin + Vertices + Face + "end_header\n";
const std::string Triangle = "0 0 0\n1 0 0\n0 1 0\n";

/// The one error of a file.
std::string error_of_ply(std::string_view bytes) {
  const test::TemporaryFolder folder;
  const Reading reading = read_path(folder.add("model.ply", bytes));
  EXPECT_FALSE(reading.scene.has_value());
  EXPECT_EQ(reading.diagnostics.error_count(), 1U) << reading.text();
  return reading.text();
}

TEST(BrokenPly, TextSaysTheLine) {
  EXPECT_THAT(
      error_of_ply(Header + "0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n"),
      HasSubstr("model.ply:11:3: error: vertex 2 of 3: found 'zero', expected a number of the type float"));
  EXPECT_THAT(error_of_ply(Header + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
              HasSubstr("model.ply:11:3: error: vertex 2 of 3: y is nan, expected a finite number"));
  EXPECT_THAT(error_of_ply(Header + "0 0 0\n1 1e39 0\n0 1 0\n3 0 1 2\n"),
              HasSubstr("11:3: error: vertex 2 of 3: found '1e39'"));
  EXPECT_THAT(error_of_ply(Header + Triangle + "3 0 1 3\n"),
              HasSubstr("model.ply:13:7: error: face 1 of 1: there is no vertex 3: the file has 3"));
  EXPECT_THAT(error_of_ply(Header + Triangle + "3 0 -1 2\n"),
              HasSubstr("13:5: error: face 1 of 1: there is no vertex -1"));
  EXPECT_THAT(error_of_ply(Header + Triangle + "3 0 1  \n"), HasSubstr("face 1 of 1: the file ends here"));
  EXPECT_THAT(error_of_ply(Header + Triangle + "3 0 1.5 2\n"),
              HasSubstr("13:5: error: face 1 of 1: found '1.5'"));
  EXPECT_THAT(error_of_ply(Header + Triangle + "300 0 1 2\n"),
              HasSubstr("found '300', expected a number of the type uchar"));
  EXPECT_THAT(error_of_ply(Header + Triangle + "200 0 1 2\n"),
              HasSubstr("a list of 200 values, for which the file is too short"));
  EXPECT_THAT(error_of_ply(Header + Triangle + "2 0 1\n"),
              HasSubstr("no face of the file has three corners"));
}

TEST(BrokenPly, BinarySaysTheByte) {
  PlyBytes file("binary_little_endian");
  for (const auto* line : {"element vertex 3", "property float x", "property float y", "property float z",
                           "element face 2", "property list uchar int vertex_indices", "end_header"}) {
    file.line(line);
  }
  const std::size_t body = file.bytes().size();
  for (int i = 0; i < 9; ++i) file.put(static_cast<float>(i));
  PlyBytes wrong = file;
  for (int face = 0; face < 2; ++face) {
    file.put(std::uint8_t{3}).put(std::int32_t{0}).put(std::int32_t{1}).put(std::int32_t{2});
    wrong.put(std::uint8_t{3}).put(std::int32_t{0}).put(std::int32_t{1}).put(std::int32_t{2 + face});
  }
  const test::TemporaryFolder folder;
  EXPECT_EQ(read_path(folder.add("sound.ply", file.bytes())).text(), "");
  EXPECT_THAT(error_of_ply(wrong.bytes()),
              HasSubstr(fmt::format("face 2 of 2, at byte {}: there is no vertex 3", body + 36 + 13 + 9)));
  for (std::size_t size = 0; size < file.bytes().size(); ++size) error_of_ply(file.bytes().substr(0, size));
  EXPECT_THAT(
      error_of_ply(file.bytes().substr(0, file.bytes().size() - 5)),
      HasSubstr(fmt::format("face 2 of 2, at byte {}: a list of 3 values, for which the file is too short",
                            body + 36 + 13)));
  EXPECT_THAT(error_of_ply(file.bytes() + "ab"), HasSubstr("error: 2 bytes follow the last element"));
  EXPECT_THAT(error_of_ply(file.bytes() + '\0'), HasSubstr("error: 1 byte follows the last element"));
  EXPECT_EQ(read_path(folder.add("ended.ply", file.bytes() + "\r\n")).text(), "") << "a line end is no value";
}

/// A triangle in binary, with these line ends in the header and behind it.
std::string triangle_of(const std::string& line_end, const std::string& last_end, float first_value) {
  std::string bytes;
  for (const auto* line :
       {"ply", "format binary_little_endian 1.0", "element vertex 3", "property float x", "property float y",
        "property float z", "element face 1", "property list uchar int vertex_indices"}) {
    bytes += line + line_end;
  }
  PlyBytes values("binary_little_endian");
  const std::size_t header = values.bytes().size();
  for (const float value : {first_value, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F}) values.put(value);
  values.put(std::uint8_t{3}).put(std::int32_t{0}).put(std::int32_t{1}).put(std::int32_t{2});
  return bytes + "end_header" + last_end + values.bytes().substr(header);
}

// A body that is read from one byte off is rubbish in which nothing need be wrong.
TEST(BrokenPly, TheHeaderMayEndInAnotherLineEndThanItsOtherLines) {
  const float line_feed_first = std::bit_cast<float>(0x3F80000AU);
  const float return_first = std::bit_cast<float>(0x3F80000DU);
  for (const std::string line_end : {"\n", "\r\n", "\r"}) {
    for (const std::string last_end : {"\n", "\r\n", "\r", " \n"}) {
      if (line_end == "\r" && last_end.ends_with("\n") && last_end != "\r\n") continue;  // is no header
      for (const float first_value : {1.0F, line_feed_first, return_first}) {
        const Reading reading = read_bytes("model.ply", triangle_of(line_end, last_end, first_value));
        ASSERT_TRUE(reading.scene.has_value()) << reading.text();
        EXPECT_EQ(reading.text(), "");
        const auto meshes = meshes_of(*reading.scene);
        ASSERT_EQ(meshes.size(), 1U);
        EXPECT_THAT(
            meshes[0].geometry->positions,
            testing::ElementsAre(grf::Vec3f(first_value, 0, 0), grf::Vec3f(1, 0, 0), grf::Vec3f(0, 1, 0)));
        EXPECT_THAT(meshes[0].geometry->corners, testing::ElementsAre(0, 1, 2));
      }
    }
  }
  EXPECT_THAT(error_of_ply(triangle_of("\n", " x\n", 1)),
              HasSubstr("9:12: error: the line 'end_header' goes on"));
}

// The header says less than a line has: each vertex after the first would begin in the one before it.
TEST(BrokenPly, TextWithMoreNumbersThanTheHeaderNamesIsNoModel) {
  EXPECT_THAT(error_of_ply(Header + "0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n"), HasSubstr("error: "));
  EXPECT_THAT(error_of_ply(Header + Triangle + "3 0 1 2\n3 0 2 1\n"),
              HasSubstr("error: 9 bytes follow the last element: the header has a wrong count"));
}

TEST(BrokenPly, TextThatWasCutOffIsNoModel) {
  const std::string text = Header + Triangle + "3 0 1 2";
  for (std::size_t size = 0; size < text.size(); ++size) error_of_ply(text.substr(0, size));
}

TEST(BrokenPly, HeadersSayTheLineAndColumn) {
  EXPECT_THAT(error_of_ply("ply\n"), HasSubstr("the file ends inside its header"));
  EXPECT_THAT(error_of_ply("ply\nformat text 1.0\n"),
              HasSubstr("model.ply:2:8: error: expected 'format' and one of"));
  EXPECT_THAT(error_of_ply("ply\nformat ascii 2.0\n"),
              HasSubstr("model.ply:2:14: error: expected the version 1.0"));
  EXPECT_THAT(error_of_ply("ply\nend_header\n"), HasSubstr("the header does not say its format"));
  EXPECT_THAT(error_of_ply(Begin + "element vertex many\n"),
              HasSubstr("model.ply:3:16: error: found 'many', expected a count"));
  EXPECT_THAT(error_of_ply(Begin + "element vertex\n"),
              HasSubstr("3:1: error: expected 'element', its name and its count"));
  EXPECT_THAT(error_of_ply(Begin + "property float x\n"),
              HasSubstr("3:1: error: this property belongs to no element"));
  EXPECT_THAT(error_of_ply(Begin + "element vertex 3\nproperty int64 x\n"),
              HasSubstr("4:10: error: 'int64' is not a type of PLY"));
  EXPECT_THAT(error_of_ply(Begin + "element face 3\nproperty list float int a\n"),
              HasSubstr("4:15: error: a list is counted by an integer"));
  EXPECT_THAT(
      error_of_ply(Begin + "element vertex 3\npropety float x\n"),
      HasSubstr("4:1: error: found 'propety', expected a keyword of PLY headers: did you mean 'property'"));
  EXPECT_THAT(error_of_ply(Begin + Vertices + "property float x\n" + Face + "end_header\n"),
              HasSubstr("3:1: error: elements 'vertex' have two properties 'x'"));
  EXPECT_THAT(error_of_ply(Begin + Vertices + Vertices),
              HasSubstr("7:9: error: there are elements 'vertex' already"));
}

TEST(BrokenPly, HeadersMustNameVerticesAndFaces) {
  EXPECT_THAT(error_of_ply(Begin + Vertices + "end_header\n" + Triangle),
              HasSubstr("the file is a cloud of 3 points: it has no faces"));
  EXPECT_THAT(error_of_ply(Begin + Face + "end_header\n3 0 0 0\n"),
              HasSubstr("the header names no element 'vertex'"));
  EXPECT_THAT(error_of_ply(Begin + "element vertex 1\nproperty float x\nproperty float z\n" + Face +
                           "end_header\n0 0\n3 0 0 0\n"),
              HasSubstr("model.ply:3:1: error: elements 'vertex' have no property 'y'"));
  EXPECT_THAT(error_of_ply(Begin + Vertices + "element face 1\nproperty int corners\nend_header\n" +
                           Triangle + "0\n"),
              HasSubstr("elements 'face' have no list 'vertex_indices'"));
}

// What a count says is not believed before there are so many bytes.
TEST(BrokenPly, CountsThatTheSizeDoesNotBearOut) {
  for (const auto* count : {"1000", "4294967295", "4294967296", "18446744073709551615"}) {
    const std::string face = fmt::format("element face {}\nproperty list uchar int vertex_indices\n", count);
    EXPECT_THAT(error_of_ply(Begin + Vertices + face + "end_header\n" + Triangle + "3 0 1 2\n"),
                HasSubstr(fmt::format("7:1: error: the file is too short for {} elements 'face'", count)));
  }
  EXPECT_THAT(error_of_ply(Begin + "element vertex 18446744073709551616\n"), HasSubstr("expected a count"));
  PlyBytes list("binary_big_endian");
  for (const auto* line : {"element vertex 1", "property float x", "property float y", "property float z",
                           "element face 1", "property list uint uint vertex_indices", "end_header"}) {
    list.line(line);
  }
  list.put(0.0F).put(0.0F).put(0.0F).put(std::uint32_t{0xFFFFFFFF}).put(std::uint32_t{0});
  EXPECT_THAT(error_of_ply(list.bytes()),
              HasSubstr("a list of 4294967295 values, for which the file is too short"));
}

TEST(BrokenPly, ElementsWithoutPropertiesCostNothing) {
  const test::TemporaryFolder folder;
  const std::string text =
      Begin + Vertices + Face + "element nothing 18446744073709551615\nend_header\n" + Triangle;
  EXPECT_TRUE(read_path(folder.add("a.ply", text + "3 0 1 2\n")).scene.has_value());
}

}  // namespace
}  // namespace convert
