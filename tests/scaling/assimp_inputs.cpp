#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "tests/scaling/inputs.h"

namespace scaling {
namespace {

void append(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> 8 * i & 0xffU);
}

std::string chunk(std::uint32_t id, const std::string& contents) {
  std::string bytes;
  append(bytes, id, 2);
  append(bytes, static_cast<std::uint32_t>(contents.size() + 6), 4);
  return bytes + contents;
}

std::string counted(const std::string& items, std::size_t count) {
  std::string bytes;
  append(bytes, static_cast<std::uint32_t>(count), 2);
  return bytes + items;
}

std::string floats(std::initializer_list<float> values) {
  std::string bytes;
  for (const float value : values) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    append(bytes, bits, 4);
  }
  return bytes;
}

std::string three_ds_object(const std::string& name, std::size_t faces) {
  std::string face;
  for (const std::uint32_t value : {0U, 1U, 2U, 0U}) append(face, value, 2);
  const std::string vertices = chunk(0x4110, counted(floats({0, 0, 0, 1, 0, 0, 1, 1, 0}), 3));
  return chunk(
      0x4000, name + '\0' + chunk(0x4100, vertices + chunk(0x4120, counted(copies("", face)(faces), faces))));
}

std::string three_ds(const std::string& editor) { return chunk(0x4d4d, chunk(0x3d3d, editor)); }

std::vector<Input> three_ds_inputs() {
  return {
      {"objects", "3ds",
       [](std::size_t n) {
         return three_ds(
             pieces("", [](std::size_t i) { return three_ds_object("o" + std::to_string(i), 1); })(n));
       }},
      {"faces", "3ds", [](std::size_t n) { return three_ds(three_ds_object("o", n)); }},
      {"materials", "3ds",
       [](std::size_t n) {
         const Text materials = pieces(
             "", [](std::size_t i) { return chunk(0xafff, chunk(0xa000, "m" + std::to_string(i) + '\0')); });
         return three_ds(materials(n) + three_ds_object("o", 1));
       }},
  };
}

std::string binary_stl(std::size_t facets) {
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(facets), 4);
  for (std::size_t i = 0; i < facets; ++i) {
    const auto x = static_cast<float>(i);
    bytes += floats({0, 0, 1, x, 0, 0, x + 1, 0, 0, x, 1, 0});
    append(bytes, 0, 2);
  }
  return bytes;
}

std::vector<Input> soup_inputs() {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n";
  return {
      {"facets", "stl", copies("solid a\n", facet, "endsolid a\n")},
      {"solids", "stl",
       pieces("", [=](std::size_t i) { return fmt::format("solid s{0}\n{1}endsolid s{0}\n", i, facet); })},
      {"facets in binary", "stl", binary_stl},
      {"faces", "off",
       [](std::size_t n) {
         return copies(fmt::format("OFF\n3 {} 0\n0 0 0\n1 0 0\n1 1 0\n", n), "3 0 1 2\n")(n);
       }},
      {"vertices", "off",
       [](std::size_t n) {
         return copies(fmt::format("OFF\n{} 1 0\n", n + 3), "1 2 3\n")(n + 3) + "3 0 1 2\n";
       }},
      {"corners of one face", "off",
       [](std::size_t n) {
         std::string text = fmt::format("OFF\n{} 1 0\n", n + 3);
         for (std::size_t i = 0; i < n + 3; ++i) text += fmt::format("{} {} 0\n", i, i * i % 7);
         text += std::to_string(n + 3);
         for (std::size_t i = 0; i < n + 3; ++i) text += fmt::format(" {}", i);
         return text + "\n";
       }},
      {"faces", "dxf",
       copies("  0\nSECTION\n  2\nENTITIES\n",
              "  0\n3DFACE\n  8\n0\n 10\n0\n 20\n0\n 30\n0\n 11\n1\n 21\n0\n 31\n0\n 12\n1\n 22\n1\n 32\n0\n "
              "13\n1\n "
              "23\n1\n 33\n0\n",
              "  0\nENDSEC\n  0\nEOF\n")},
      {"layers", "dxf",
       pieces(
           "  0\nSECTION\n  2\nENTITIES\n",
           [](std::size_t i) {
             return fmt::format(
                 "  0\n3DFACE\n  8\nlayer{}\n 10\n0\n 20\n0\n 30\n0\n 11\n1\n 21\n0\n 31\n0\n 12\n1\n "
                 "22\n1\n 32\n0\n "
                 "13\n1\n 23\n1\n 33\n0\n",
                 i);
           },
           "  0\nENDSEC\n  0\nEOF\n")},
      {"objects", "ac",
       [](std::size_t n) {
         return copies(
             fmt::format("AC3Db\nMATERIAL \"m\" rgb 1 1 1 amb 0 0 0 emis 0 0 0 spec 0 0 0 shi 0 trans "
                         "0\nOBJECT world\nkids {}\n",
                         n),
             "OBJECT poly\nnumvert 3\n0 0 0\n1 0 0\n1 1 0\nnumsurf 1\nSURF 0x0\nmat 0\nrefs 3\n0 0 0\n1 "
             "0 0\n2 0 0\nkids 0\n")(n);
       }},
  };
}

std::string collada(const std::string& geometries, const std::string& nodes) {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">)"
         "<asset/><library_geometries>" +
         geometries + "</library_geometries><library_visual_scenes><visual_scene id=\"s\">" + nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
         "url=\"#s\"/></scene></COLLADA>";
}

std::string collada_geometry(std::size_t number) {
  return fmt::format(
      R"(<geometry id="g{0}"><mesh><source id="p{0}"><float_array id="a{0}" count="9">0 0 0 1 0 0 1 1 0</float_array>)"
      R"(<technique_common><accessor source="#a{0}" count="3" stride="3"><param name="X" type="float"/>)"
      R"(<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>)"
      R"(<vertices id="v{0}"><input semantic="POSITION" source="#p{0}"/></vertices><triangles count="1">)"
      R"(<input semantic="VERTEX" source="#v{0}" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>)",
      number);
}

std::string collada_node(std::size_t number, std::size_t geometry) {
  return fmt::format(R"(<node id="n{}"><instance_geometry url="#g{}"/></node>)", number, geometry);
}

std::vector<Input> collada_inputs() {
  return {
      {"geometries", "dae",
       [](std::size_t n) {
         return collada(pieces("", collada_geometry)(n),
                        pieces("", [](std::size_t i) { return collada_node(i, i); })(n));
       },
       1000},
      {"nodes", "dae",
       [](std::size_t n) {
         return collada(collada_geometry(0), pieces("", [](std::size_t i) { return collada_node(i, 0); })(n));
       },
       1000},
  };
}

/// The numbers of an IFF file are big-endian.
std::string big_endian(std::uint32_t value, int count) {
  std::string bytes;
  for (int i = count; i-- > 0;) bytes += static_cast<char>(value >> 8 * i & 0xffU);
  return bytes;
}

std::string iff_chunk(const std::string& name, const std::string& contents) {
  const std::string padding(contents.size() % 2, '\0');
  return name + big_endian(static_cast<std::uint32_t>(contents.size()), 4) + contents + padding;
}

/// A LightWave object of one layer with a triangle's points and so many faces.
std::string lwo(std::size_t faces) {
  std::string points;
  for (const std::uint32_t bits : {0U, 0U, 0U, 0x3f800000U, 0U, 0U, 0x3f800000U, 0x3f800000U, 0U}) {
    points += big_endian(bits, 4);
  }
  std::string polygons = "FACE";
  std::string tags = "SURF";
  for (std::uint32_t i = 0; i < faces; ++i) {
    for (const std::uint32_t number : {3U, 0U, 1U, 2U}) polygons += big_endian(number, 2);
    tags += big_endian(i, 2) + big_endian(0, 2);
  }
  const std::string name("s\0", 2);
  return iff_chunk("FORM", "LWO2" + iff_chunk("TAGS", name) + iff_chunk("LAYR", std::string(18, '\0')) +
                               iff_chunk("PNTS", points) + iff_chunk("POLS", polygons) +
                               iff_chunk("PTAG", tags) + iff_chunk("SURF", name + std::string(2, '\0')));
}

std::string x_mesh(std::size_t faces) {
  std::string text = fmt::format("Mesh {{\n3;\n0;0;0;,\n1;0;0;,\n1;1;0;;\n{};\n", faces);
  for (std::size_t i = 0; i < faces; ++i) text += fmt::format("3;0,1,2;{}\n", i + 1 < faces ? "," : ";");
  return text + "}\n";
}

std::string fbx(const std::string& objects, const std::string& connections) {
  return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: "
         "7400\n}\nObjects:  {\n" +
         objects + "}\nConnections:  {\n" + connections + "}\n";
}

std::string fbx_geometry(std::size_t faces) {
  return fmt::format(
             "Geometry: 1, \"Geometry::g\", \"Mesh\" {{\nVertices: *9 {{\na: 0,0,0,1,0,0,1,1,0\n}}\n"
             "PolygonVertexIndex: *{} {{\na: ",
             3 * faces) +
         listed(faces, [](std::size_t) { return std::string("0,1,-3"); }) + "\n}\n}\n";
}

std::string fbx_model(std::size_t number) {
  return fmt::format("Model: {}, \"Model::m{}\", \"Mesh\" {{\nVersion: 232\n}}\n", number + 2, number);
}

std::string fbx_connections(std::size_t number) {
  return fmt::format("C: \"OO\",1,{0}\nC: \"OO\",{0},0\n", number + 2);
}

std::vector<Input> other_inputs() {
  return {
      {"faces", "lwo", lwo, 1000},
      {"faces", "x", [](std::size_t n) { return "xof 0303txt 0032\n" + x_mesh(n); }},
      {"frames", "x",
       pieces("xof 0303txt 0032\n",
              [](std::size_t i) { return fmt::format("Frame f{} {{\n", i) + x_mesh(1) + "}\n"; })},
      {"faces", "fbx", [](std::size_t n) { return fbx(fbx_geometry(n) + fbx_model(0), fbx_connections(0)); }},
      {"models", "fbx",
       [](std::size_t n) {
         return fbx(fbx_geometry(1) + pieces("", fbx_model)(n), pieces("", fbx_connections)(n));
       }},
  };
}

}  // namespace

std::vector<Input> assimp_inputs() {
  std::vector<Input> inputs;
  for (const auto& more : {three_ds_inputs(), soup_inputs(), collada_inputs(), other_inputs()}) {
    inputs.insert(inputs.end(), more.begin(), more.end());
  }
  return inputs;
}

}  // namespace scaling
