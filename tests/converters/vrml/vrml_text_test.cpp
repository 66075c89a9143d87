// Tests of the syntax of VRML: words, values, nodes, skipped nodes, and the location of errors.
#include <cmath>

#include <gmock/gmock.h>
#include <zlib.h>

#include "tests/converters/vrml/vrml_reading.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The errors of a text that has some.
std::string error_of(const Reading& reading) {
  EXPECT_FALSE(reading.scene.has_value());
  EXPECT_EQ(reading.diagnostics.error_count(), 1U) << reading.text();
  return reading.text();
}

std::string compressed(std::string_view text) {
  z_stream stream = {};
  constexpr int GzipAlone = 16;
  EXPECT_EQ(deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, MAX_WBITS + GzipAlone, 9, Z_DEFAULT_STRATEGY),
            Z_OK);
  std::string bytes(deflateBound(&stream, text.size()), '\0');
  std::string input(text);
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

const std::string Header = "#VRML V2.0 utf8\n";

TEST(VrmlText, IsToldByItsFirstLineAlsoCompressed) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  const auto format_of = [&](std::string_view name, std::string_view bytes) -> std::string {
    const Format* format = recognise(folder.add(name, bytes), diagnostics);
    return format == nullptr ? "" : std::string(format->name);
  };
  EXPECT_EQ(format_of("a.obj", Header), "vrml");
  EXPECT_EQ(format_of("a.dat", "\xEF\xBB\xBF#VRML V1.0 ascii\r\nSeparator {}"), "vrml");
  EXPECT_EQ(format_of("b.dat", compressed(Header + "Group {}")), "vrml");
  EXPECT_EQ(format_of("a.wrz", "what is this"), "vrml");
  EXPECT_EQ(format_of("c.dat", compressed("Group {}")), "");
}

TEST(VrmlText, ThatWasCompressedHasNothingBehindItsEnd) {
  const std::string bytes = compressed(Header + shape("Box {}"));
  EXPECT_EQ(read_bytes("a.wrz", bytes).text(), "");
  EXPECT_EQ(read_bytes("a.wrz", bytes + std::string(512, '\0')).text(), "") << "archives are filled up so";
  const std::string half = compressed(Header + "Shape { geometry ");
  EXPECT_EQ(read_bytes("a.wrz", half + compressed("Box {} }")).text(), "");
  EXPECT_THAT(error_of(read_bytes("a.wrz", bytes + "rest")),
              HasSubstr("error: 4 bytes follow the end of the compressed file"));
  for (std::size_t size = 2; size < bytes.size(); ++size) {
    EXPECT_THAT(error_of(read_bytes("a.wrz", bytes.substr(0, size))),
                HasSubstr("the compressed file is truncated"));
  }
}

TEST(VrmlText, OfAnotherKindIsAnError) {
  const test::TemporaryFolder folder;
  const auto error = [&](std::string_view bytes) { return error_of(read_path(folder.add("a.wrl", bytes))); };
  EXPECT_THAT(error("#X3D V3.0 utf8\n"),
              HasSubstr("a.wrl: error: this is not VRML: expected '#VRML V2.0 utf8'"));
  EXPECT_THAT(error(""), HasSubstr("the file is empty"));
  EXPECT_THAT(error(std::string_view("#VRML V2.0 utf8\n\0", 17)), HasSubstr("zero bytes"));
}

TEST(VrmlText, MayBeCompressed) {
  const test::TemporaryFolder folder;
  const std::string bytes = compressed(Header + shape(square()));
  const Reading whole = read_path(folder.add("a.wrl", bytes));
  ASSERT_TRUE(whole.scene.has_value()) << whole.text();
  EXPECT_EQ(meshes_of(*whole.scene)[0].face_count(), 2U);
  const Reading two = read_path(folder.add("b.wrz", compressed(Header) + compressed(shape(square()))));
  EXPECT_TRUE(two.scene.has_value()) << two.text();
  EXPECT_THAT(error_of(read_path(folder.add("c.wrz", bytes.substr(0, bytes.size() - 9)))),
              HasSubstr("c.wrz: error: the compressed file is truncated"));
  std::string damaged = bytes;
  damaged[damaged.size() - 6] ^= 1;
  EXPECT_THAT(error_of(read_path(folder.add("d.wrz", damaged))), HasSubstr("the compressed file is damaged"));
  EXPECT_THAT(error_of(read_path(folder.add("e.wrz", compressed(Header + "Shape {\n ,, ]")))),
              HasSubstr("e.wrz:3:5: error: found ']'"));
}

TEST(VrmlText, ThatStandsForFarMoreIsAnError) {
  const test::TemporaryFolder folder;
  const std::string bomb = compressed(Header + std::string(std::size_t{257} << 20U, ' '));
  EXPECT_LT(bomb.size(), 2'000'000U);
  EXPECT_THAT(error_of(read_path(folder.add("a.wrz", bomb))), HasSubstr("more than 256 MB"));
}

TEST(VrmlText, SeparatesWordsByCommasAndCommentsToo) {
  const grf::Mesh mesh = mesh97(
      "Shape{geometry IndexedFaceSet{coord Coordinate{point[+0,.0,-0.# first\r\n1e0 0 0\r\n 0,,1e-400 0x1]}"
      "coordIndex[0,1,2]}}");
  EXPECT_THAT(corners_of(mesh, 0),
              ElementsAre(grf::Vec3f(0, 0, 0), grf::Vec3f(1, 0, 0), grf::Vec3f(0, 0, 1)));
  EXPECT_FALSE(std::signbit(mesh.geometry->positions[0].z));
}

TEST(VrmlText, TakesNamesAsExportersWriteThem) {
  EXPECT_EQ(mesh97("DEF O'Neill-1.2 " + shape(square())).name, "O'Neill-1.2");
  EXPECT_EQ(mesh97("DEF 01-box " + shape(square())).name, "01-box");
  EXPECT_EQ(mesh97("DEF \u00E6 " + shape(square())).name, "\u00E6");
  EXPECT_EQ(mesh97("DEF \xE6 " + shape(square())).name, "\u00E6") << "Latin-1";
}

TEST(VrmlText, SaysWhereItIsWrong) {
  const auto error = [](std::string_view text) { return error_of(read_vrml97(text)); };
  EXPECT_THAT(error("Shape { geometry Box { size 1 2 } }"),
              HasSubstr("model.wrl:2:24: error: the field 'size' has 2 numbers, expected 3"));
  EXPECT_THAT(error("Shape {\n  geometry Box {"), HasSubstr("model.wrl:3:17: error: the file ends here"));
  EXPECT_THAT(error("Group { children [ 1.2.3 ] }"), HasSubstr(":2:20: error: '1.2.3' is not a number"));
  EXPECT_THAT(error("Shape { geometry Box { size 1 -1.#IND 1 } }"), HasSubstr("is not a finite number"));
  EXPECT_THAT(error("Shape { geometry Box { size 1 1e39 1 } }"), HasSubstr("is too large for a float"));
  EXPECT_THAT(error("Group { \u00E6 }"), HasSubstr(":2:11: error: found '}', expected a value"));
  EXPECT_THAT(error("Shape { Box { } }"), HasSubstr("found '{', expected a value"));
  EXPECT_THAT(error("Anchor { url \"a } "), HasSubstr("begins a string that has no end"));
  EXPECT_THAT(error("}"), HasSubstr("found '}', expected a node"));
  EXPECT_THAT(error("Group ["), HasSubstr("found '[', expected '{' after the node type 'Group'"));
  EXPECT_THAT(error("Shape { geometry Sphere { radius TRUE } }"), HasSubstr("'radius' is a number"));
  EXPECT_THAT(error("Shape { geometry Sphere { radius -1 } }"), HasSubstr("is -1, expected more than 0"));
  EXPECT_THAT(error("Shape { geometry Cone { side 2 side 1 2 } }"), HasSubstr("has 2 numbers, expected 1"));
  EXPECT_THAT(error("Shape { geometry [ Box {} Box {} ] }"), HasSubstr("has one node at most"));
  EXPECT_THAT(error("Shape { appearance Material {} geometry Box {} }"),
              HasSubstr("found the node Material in the field 'appearance', expected Appearance"));
  EXPECT_THAT(error(""), HasSubstr("the file has no faces"));
}

TEST(VrmlText, UseMeansTheLastNodeOfTheName) {
  const grf::Mesh mesh = mesh97(
      "Switch { choice [ DEF a Coordinate { point [ 9 9 9 ] } DEF a Coordinate { point [ 0 0 0 1 0 0 0 1 0 ] "
      "} ] }"
      "Shape { geometry IndexedFaceSet { coord USE a coordIndex [ 0 1 2 ] } } Group { children DEF a Group "
      "{} }");
  EXPECT_EQ(mesh.geometry->positions.size(), 3U);
  EXPECT_THAT(error_of(read_vrml97("USE a\nDEF a Group {}")),
              HasSubstr("model.wrl:2:5: error: 'a' is used, but not defined before"));
  EXPECT_THAT(error_of(read_vrml97("DEF a Group { children USE a }")),
              HasSubstr("'a' is used inside itself"));
}

TEST(VrmlText, PrototypesAndScriptsArePassedOver) {
  const Reading reading = read_vrml97(
      "PROTO Lamp [ field SFColor c 1 1 1 exposedField MFNode n [ Group { } ] eventIn SFBool \"]\" ]\n"
      "{ DEF inner Shape { geometry Box { size IS c } } ROUTE a.b TO c.d }\n"
      "EXTERNPROTO Far [ field SFBool b ] [ \"far.wrl#Far\" \"x\" ]\n"
      "Lamp { c 0 1 0 n [ DEF deep Shape { } ] } Lamp { } Far { b IS what ( }\n"
      "DEF s Script { eventIn SFBool set eventOut SFTime t field SFNode n USE s url \"javascript: function "
      "}{\" }\n"
      "DEF t TimeSensor { loop TRUE } ROUTE t.fraction TO s.set ROUTE t . time TO s .set\n"
      "Group { ROUTE t.a TO t.b children [ USE deep ] }\n" +
      shape(square()));
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const std::string text = reading.text();
  EXPECT_THAT(text, HasSubstr("1 prototype 'Lamp' was skipped: prototypes are not supported"));
  EXPECT_THAT(text, HasSubstr("1 prototype 'Far' was skipped"));
  EXPECT_THAT(text, HasSubstr("3 Lamp nodes were skipped: the standard has no node of that name"));
  EXPECT_THAT(text, HasSubstr("1 Far node was skipped"));
  EXPECT_THAT(text, HasSubstr("1 Script node was skipped: GRF scenes are static"));
  EXPECT_THAT(text, HasSubstr("1 TimeSensor node was skipped: GRF scenes are static"));
  EXPECT_THAT(text, HasSubstr("3 ROUTEs were skipped"));
  EXPECT_EQ(meshes_of(*reading.scene).size(), 1U);
  EXPECT_THAT(error_of(read_vrml97("PROTO a [ ] { [ } ]")), HasSubstr("found '}', expected ']'"));
  EXPECT_THAT(error_of(read_vrml97("a { b { [ ]")), HasSubstr("the file ends here, expected '}'"));
  EXPECT_THAT(error_of(read_vrml97("USE inner")), HasSubstr("not defined"));
}

TEST(VrmlText, WhatIsInNoFaceIsCounted) {
  const Reading reading = read_vrml97(
      "Viewpoint {} Viewpoint {} PointLight {} Fog {} WorldInfo { title \"a \\\" b\" info [ \"c\" ] }\n"
      "Sound {} DEF i PositionInterpolator { key [ 0 1 ] keyValue [ 0 0 0 1 1 1 ] } Anchor { url \"a.html\" "
      "}\n"
      "Billboard {} Shape { geometry IndexedLineSet {} } Shape { geometry Text { string \"a\" } } Shape {}\n"
      "Shape { geometry IndexedFaceSet {} }\n" +
      shape(square()));
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  for (const std::string_view line :
       {"2 cameras were left out", "1 light was left out", "1 Fog node was skipped",
        "1 WorldInfo node was skipped", "1 Sound node was skipped: GRF has no sound",
        "1 PositionInterpolator node was skipped", "1 link of an Anchor was lost", "1 Billboard is static",
        "1 IndexedLineSet node was skipped: GRF has only faces", "1 Text node was skipped",
        "1 shape was left out: it has no faces"}) {
    EXPECT_THAT(reading.text(), HasSubstr(line));
  }
}

TEST(VrmlText, DeepNestingAndBombsAreErrors) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "Group{children ";
  EXPECT_THAT(error_of(read_vrml97(deep)), HasSubstr("nested more than 500 deep"));
  EXPECT_THAT(error_of(read_vrml97("x {" + std::string(200'000, '['))), HasSubstr("expected ']'"));
  std::string chain = "DEF a0 " + shape("Box {}");
  std::string bomb = chain;
  for (int i = 1; i < 1000; ++i) {
    const std::string before = "USE a" + std::to_string(i - 1) + " ";
    const std::string group = "DEF a" + std::to_string(i) + " Group { children [ ";
    chain += group + before + "] }\n";
    if (i < 60) bomb += group + before + before + "] }\n";
  }
  EXPECT_THAT(error_of(read_vrml97(chain)), HasSubstr("nested more than 500 deep"));
  EXPECT_THAT(error_of(read_vrml97(bomb)),
              HasSubstr("with all that USE repeats, there are more than 1000000"));
}

TEST(VrmlText, OneLongLineIsReadInLinearTime) {
  std::string text;
  for (int i = 0; i < 20'000; ++i)
    text += "Shape{geometry DEF a Box{}appearance Appearance{material Material{}}}";
  const Reading reading = read_vrml97(text);
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_EQ(meshes_of(*reading.scene).size(), 20'000U);
}

}  // namespace
}  // namespace convert
