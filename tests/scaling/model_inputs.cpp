#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "tests/scaling/inputs.h"

namespace scaling {
namespace {

using Text = std::function<std::string(std::size_t)>;

/// One piece of text for each number, after a beginning and before an end.
Text pieces(std::string begin, std::function<std::string(std::size_t)> piece, std::string end = "") {
  return [=](std::size_t count) {
    std::string text = begin;
    for (std::size_t i = 0; i < count; ++i) text += piece(i);
    return text + end;
  };
}

/// The same piece again and again.
Text copies(std::string begin, std::string piece, std::string end = "") {
  return pieces(
      std::move(begin), [=](std::size_t) { return piece; }, std::move(end));
}

/// Pieces with commas between them.
std::string listed(std::size_t count, const std::function<std::string(std::size_t)>& piece) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? "," : "") + piece(i);
  return text;
}

std::string numbers(std::size_t count) {
  return listed(count, [](std::size_t i) { return std::to_string(i); });
}

std::vector<Input> obj_inputs() {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  return {
      {"faces", "obj", copies(triangle, "f 1 2 3\n")},
      {"vertices", "obj", copies(triangle + "f 1 2 3\n", "v 1 2 3\nvn 0 0 1\nvt 0 1\n")},
      {"relative indices", "obj", copies("", triangle + "f -3 -2 -1\n")},
      {"corners with different normals", "obj",
       pieces(triangle,
              [](std::size_t i) { return fmt::format("vn 0 0 1\nf 1//{0} 2//{0} 3//{0}\n", i + 1); })},
      {"corners of one face", "obj",
       [](std::size_t n) {
         std::string text;
         for (std::size_t i = 0; i < n + 3; ++i) text += fmt::format("v {} {} 0\n", i, i * i % 7);
         text += "f";
         for (std::size_t i = 0; i < n + 3; ++i) text += fmt::format(" {}", i + 1);
         return text + "\n";
       }},
      {"groups", "obj",
       pieces(triangle, [](std::size_t i) { return fmt::format("g group{}\nf 1 2 3\n", i); })},
      {"groups by turns", "obj",
       pieces(triangle, [](std::size_t i) { return fmt::format("g group{}\nf 1 2 3\n", i % 2); })},
      {"objects", "obj",
       pieces(triangle, [](std::size_t i) { return fmt::format("o object{}\nf 1 2 3\n", i); })},
      {"materials that are missing", "obj",
       pieces(triangle, [](std::size_t i) { return fmt::format("usemtl m{}\nf 1 2 3\n", i); })},
      {"switches of material", "obj",
       pieces(triangle, [](std::size_t i) { return fmt::format("usemtl m{}\nf 1 2 3\n", i % 2); })},
      {"libraries that are missing", "obj",
       pieces(
           "", [](std::size_t i) { return fmt::format("mtllib l{}.mtl\n", i); }, triangle + "f 1 2 3\n"),
       1000},
      {"smoothing groups", "obj",
       pieces(triangle, [](std::size_t i) { return fmt::format("s {}\nf 1 2 3\n", i + 1); })},
      {"smooth faces at one vertex", "obj", copies(triangle + "s 1\n", "f 1 2 3\n")},
      {"comments", "obj", copies(triangle, "# about\n", "f 1 2 3\n")},
      {"continued lines", "obj", copies(triangle, "\\\n", "f 1 2 3\n")},
      {"unknown statements", "obj",
       pieces(triangle + "f 1 2 3\n", [](std::size_t i) { return fmt::format("unknown{} 1\n", i); })},
      {"mistakes", "obj", copies(triangle, "f 1 2 99\n")},
  };
}

std::vector<Input> ply_inputs() {
  const auto header = [](std::size_t vertices, std::size_t faces, const std::string& more = "") {
    return fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float "
        "z\n{}element "
        "face {}\nproperty list int int vertex_indices\nend_header\n",
        vertices, more, faces);
  };
  const auto vertices = [](std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += fmt::format("{} {} 0\n", i, i * i % 7);
    return text;
  };
  return {
      {"faces", "ply", [=](std::size_t n) { return copies(header(3, n) + vertices(3), "3 0 1 2\n")(n); }},
      {"vertices", "ply", [=](std::size_t n) { return header(n + 3, 1) + vertices(n + 3) + "3 0 1 2\n"; }},
      {"corners of one face", "ply",
       [=](std::size_t n) {
         std::string text = header(n + 3, 1) + vertices(n + 3) + std::to_string(n + 3);
         for (std::size_t i = 0; i < n + 3; ++i) text += fmt::format(" {}", i);
         return text + "\n";
       }},
      {"properties", "ply",
       [=](std::size_t n) {
         const Text more = pieces("", [](std::size_t i) { return fmt::format("property float p{}\n", i); });
         std::string text = header(3, 1, more(n));
         for (const char* vertex : {"0 0 0", "1 0 0", "1 1 0"}) text += vertex + copies("", " 0", "\n")(n);
         return text + "3 0 1 2\n";
       }},
      {"elements", "ply",
       [=](std::size_t n) {
         const Text more =
             pieces("", [](std::size_t i) { return fmt::format("element e{} 1\nproperty int a\n", i); });
         return copies(header(3, 1, more(n)) + vertices(3), "1\n", "3 0 1 2\n")(n);
       }},
      {"comments", "ply",
       [=](std::size_t n) {
         return header(3, 1, copies("", "comment about\n")(n)) + vertices(3) + "3 0 1 2\n";
       }},
  };
}

/// A glTF file with a buffer of one triangle, its bytes and views, and these parts.
std::string gltf(const std::string& parts) {
  return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
         R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAA"}],"bufferViews":[{"buffer":0,"byteLength":36}],)" +
         parts + "}";
}

const std::string Accessor =
    R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]})";
const std::string GltfAccessors = R"("accessors":[)" + Accessor + "],";
const std::string Primitive = R"({"attributes":{"POSITION":0}})";
const std::string GltfMeshes = R"("meshes":[{"primitives":[)" + Primitive + "]}],";

std::string scene_of_nodes(std::size_t count) {
  return R"("scene":0,"scenes":[{"nodes":[)" + numbers(count) + "]}]";
}

std::vector<Input> gltf_inputs() {
  const std::string one_node = R"("nodes":[{"mesh":0}],)" + scene_of_nodes(1);
  const auto mesh_with = [=](const std::string& primitives) {
    return gltf(GltfAccessors + R"("meshes":[{"primitives":[)" + primitives + "]}]," + one_node);
  };
  return {
      {"nodes", "gltf",
       [](std::size_t n) {
         return gltf(
             GltfAccessors + GltfMeshes + R"("nodes":[)" +
             listed(n, [](std::size_t) { return std::string(R"({"mesh":0,"translation":[1,2,3]})"); }) +
             "]," + scene_of_nodes(n));
       }},
      {"chain of nodes", "gltf",
       [](std::size_t n) {
         return gltf(GltfAccessors + GltfMeshes + R"("nodes":[)" +
                     listed(n,
                            [](std::size_t i) {
                              return fmt::format(R"({{"children":[{}],"translation":[0,0,1]}})", i + 1);
                            }) +
                     R"(,{"mesh":0}],)" + scene_of_nodes(1));
       },
       60},
      {"children of a node", "gltf",
       [](std::size_t n) {
         return gltf(GltfAccessors + GltfMeshes + R"("nodes":[{"children":[)" +
                     listed(n, [](std::size_t i) { return std::to_string(i + 1); }) + "]}," +
                     listed(n, [](std::size_t) { return std::string(R"({"mesh":0})"); }) + "]," +
                     scene_of_nodes(1));
       }},
      {"meshes", "gltf",
       [](std::size_t n) {
         return gltf(GltfAccessors + R"("meshes":[)" +
                     listed(n, [](std::size_t) { return R"({"primitives":[)" + Primitive + "]}"; }) +
                     R"(],"nodes":[)" +
                     listed(n, [](std::size_t i) { return fmt::format(R"({{"mesh":{}}})", i); }) + "]," +
                     scene_of_nodes(n));
       }},
      {"primitives", "gltf",
       [=](std::size_t n) { return mesh_with(listed(n, [](std::size_t) { return Primitive; })); }},
      {"accessors", "gltf",
       [=](std::size_t n) {
         return gltf(R"("accessors":[)" + listed(n, [](std::size_t) { return Accessor; }) + "]," +
                     GltfMeshes + one_node);
       }},
      {"materials", "gltf",
       [=](std::size_t n) {
         return gltf(GltfAccessors + R"("materials":[)" +
                     listed(n,
                            [](std::size_t i) {
                              return fmt::format(
                                  R"({{"name":"m{}","pbrMetallicRoughness":{{"roughnessFactor":0.5}}}})", i);
                            }) +
                     R"(],"meshes":[{"primitives":[)" +
                     listed(n,
                            [](std::size_t i) {
                              return fmt::format(R"({{"attributes":{{"POSITION":0}},"material":{}}})", i);
                            }) +
                     "]}]," + one_node);
       }},
      {"morph targets", "gltf",
       [=](std::size_t n) {
         return mesh_with(R"({"attributes":{"POSITION":0},"targets":[)" +
                          listed(n, [](std::size_t) { return std::string(R"({"POSITION":0})"); }) + "]}");
       }},
      {"images", "gltf",
       [=](std::size_t n) {
         return gltf(GltfAccessors + GltfMeshes + R"("images":[)" +
                     listed(n, [](std::size_t i) { return fmt::format(R"({{"uri":"i{}.png"}})", i); }) +
                     R"(],"textures":[)" +
                     listed(n, [](std::size_t i) { return fmt::format(R"({{"source":{}}})", i); }) + "]," +
                     one_node);
       },
       1000},
      {"scenes", "gltf",
       [=](std::size_t n) {
         return gltf(GltfAccessors + GltfMeshes + R"("nodes":[{"mesh":0}],"scene":0,"scenes":[)" +
                     listed(n, [](std::size_t) { return std::string(R"({"nodes":[0]})"); }) + "]");
       }},
  };
}

std::vector<Input> vrml_inputs() {
  const std::string header = "#VRML V2.0 utf8\n";
  const std::string shape = "Shape { geometry Box {} }\n";
  const std::string points = "geometry IndexedFaceSet { coord Coordinate { point [0 0 0, 1 0 0, 1 1 0] } ";
  return {
      {"shapes", "wrl", copies(header, shape)},
      {"nodes with names", "wrl",
       pieces(header, [=](std::size_t i) { return fmt::format("DEF s{} ", i) + shape; })},
      {"uses", "wrl", copies(header + "DEF s " + shape, "USE s\n")},
      {"names given again", "wrl", copies(header, "DEF s " + shape + "USE s\n")},
      {"prototypes", "wrl",
       pieces(header,
              [=](std::size_t i) { return fmt::format("PROTO P{} [] {{ {} }}\nP{} {{}}\n", i, shape, i); })},
      {"instances of a prototype", "wrl", copies(header + "PROTO P [] { " + shape + " }\n", "P {}\n")},
      {"children", "wrl", copies(header + "Group { children [\n", shape, "] }\n")},
      {"nested groups", "wrl",
       [=](std::size_t n) {
         return header + copies("", "Group { children [ ")(n) + shape + copies("", "] }\n")(n);
       },
       40},
      {"faces", "wrl", copies(header + "Shape { " + points + "coordIndex [\n", "0 1 2 -1\n", "] } }\n")},
      {"smooth faces at one vertex", "wrl",
       copies(header + "Shape { " + points + "creaseAngle 1 coordIndex [\n", "0 1 2 -1\n", "] } }\n")},
      {"vertices", "wrl",
       copies(header + "Shape { geometry IndexedFaceSet { coord Coordinate { point [0 0 0, 1 0 0, 1 1 0,\n",
              "1 2 3\n", "] } coordIndex [0 1 2 -1] } }\n")},
      {"corners of one face", "wrl",
       [=](std::size_t n) {
         std::string text = header + "Shape { geometry IndexedFaceSet { coord Coordinate { point [\n";
         for (std::size_t i = 0; i < n + 3; ++i) text += fmt::format("{} {} 0\n", i, i * i % 7);
         return text + "] } coordIndex [" + numbers(n + 3) + ", -1] } }\n";
       }},
      {"routes", "wrl",
       copies(header + "DEF a Transform {}\n" + shape, "ROUTE a.translation TO a.translation\n")},
      {"comments", "wrl", copies(header, "# about\n", shape)},
      {"unknown nodes", "wrl",
       pieces(header + shape, [](std::size_t i) { return fmt::format("Unknown{} {{ a 1 }}\n", i); })},
  };
}

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

}  // namespace

std::vector<Input> model_inputs() {
  std::vector<Input> inputs;
  for (const auto& more : {obj_inputs(), ply_inputs(), gltf_inputs(), vrml_inputs(), three_ds_inputs(),
                           soup_inputs(), collada_inputs()}) {
    inputs.insert(inputs.end(), more.begin(), more.end());
  }
  return inputs;
}

}  // namespace scaling
