#include <cstdint>

#include <fmt/format.h>

#include "tests/converters/gltf/gltf_maker.h"
#include "tests/scaling/inputs.h"

namespace scaling {
namespace {

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
      {"materials", "obj",
       pieces("mtllib all.mtl\n" + triangle,
              [](std::size_t i) { return fmt::format("usemtl m{}\nf 1 2 3\n", i); }),
       500, false,
       [](std::size_t n) {
         const Text material =
             pieces("", [](std::size_t i) { return fmt::format("newmtl m{}\nKd 0.5 0.5 0.{:06}\n", i, i); });
         return std::vector<CompanionFile>{{"all.mtl", material(n)}};
       }},
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
      {"mistakes", "obj", copies(triangle, "f 1 2 99\n"), 500, true},
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
       },
       60},
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

/// Writes primitives of one triangle, each with a material of its own.
std::string primitives_of_materials(std::size_t count) {
  return listed(count, [](std::size_t i) {
    return fmt::format(R"({{"attributes":{{"POSITION":0}},"material":{}}})", i);
  });
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
       55},
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
      {"images of one name", "gltf",
       [=](std::size_t n) {
         constexpr const char* Image =
             R"({"name":"wood","mimeType":"image/png","uri":"data:image/png;base64,iVBORw0KGgo="})";
         return gltf(GltfAccessors + R"("images":[)" + listed(n, [](std::size_t) { return Image; }) +
                     R"(],"textures":[)" +
                     listed(n, [](std::size_t i) { return fmt::format(R"({{"source":{}}})", i); }) +
                     R"(],"materials":[)" +
                     listed(n,
                            [](std::size_t i) {
                              return fmt::format(
                                  R"({{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":{}}}}}}})", i);
                            }) +
                     R"(],"meshes":[{"primitives":[)" + primitives_of_materials(n) + "]}]," + one_node);
       }},
      {"materials", "gltf",
       [=](std::size_t n) {
         return gltf(GltfAccessors + R"("materials":[)" +
                     listed(n,
                            [](std::size_t i) {
                              return fmt::format(
                                  R"({{"name":"m{}","pbrMetallicRoughness":{{"roughnessFactor":0.5}}}})", i);
                            }) +
                     R"(],"meshes":[{"primitives":[)" + primitives_of_materials(n) + "]}]," + one_node);
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
       pieces(
           header,
           [=](std::size_t i) { return fmt::format("PROTO P{} [] {{ {} }}\nP{} {{}}\n", i, shape, i); },
           shape)},
      {"instances of a prototype", "wrl", copies(header + "PROTO P [] { " + shape + " }\n", "P {}\n", shape)},
      {"children", "wrl", copies(header + "Group { children [\n", shape, "] }\n")},
      {"nested groups", "wrl",
       [=](std::size_t n) {
         return header + copies("", "Group { children [ ")(n) + shape + copies("", "] }\n")(n);
       },
       30},
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

/// A binary glTF file of one triangle's vertices and so many faces.
std::string glb(std::size_t faces) {
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < faces; ++i) indices.insert(indices.end(), {0, 1, 2});
  convert::GltfMaker maker;
  const int positions = maker.floats({0, 0, 0, 1, 0, 0, 1, 1, 0}, "VEC3");
  maker.add_mesh(
      {{"attributes", {{"POSITION", positions}}}, {"indices", maker.add(indices, "SCALAR", 5125)}});
  return maker.glb();
}

}  // namespace

std::vector<Input> model_inputs() {
  std::vector<Input> inputs = {{"faces", "glb", glb}};
  for (const auto& more : {obj_inputs(), ply_inputs(), gltf_inputs(), vrml_inputs()}) {
    inputs.insert(inputs.end(), more.begin(), more.end());
  }
  return inputs;
}

}  // namespace scaling
