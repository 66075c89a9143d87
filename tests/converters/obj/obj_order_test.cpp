// Files of statements in random order: each face keeps its place, its material and its mesh.
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/converters/reading.h"

namespace convert {
namespace {

struct OrderedFace {
  std::string mesh;
  std::string material;
  float x = 0;  ///< of its first corner, different for each face

  bool operator==(const OrderedFace&) const = default;
};

std::ostream& operator<<(std::ostream& stream, const OrderedFace& face) {
  return stream << "[" << face.mesh << ", " << face.material << ", " << face.x << "]";
}

/// An OBJ file in the making, and what its faces should become.
struct Script {
  std::string obj = "mtllib model.mtl\nv 0 0 0\nv 0 1 0\n";
  std::string mesh;
  std::string material;
  std::vector<OrderedFace> faces;

  void add_face() {
    const auto x = static_cast<float>(faces.size() + 1);
    obj += fmt::format("v {} 0 0\nf -1 1 2\n", x);
    faces.push_back({mesh, material, x});
  }
  void add_object(const std::string& keyword, const std::string& name) {
    obj += fmt::format("{} {}\n", keyword, name);
    mesh = name;
  }
  void add_material(const std::string& name) {
    obj += fmt::format("usemtl {}\n", name);
    material = name;
  }
  void add(int statement) {
    switch (statement) {
      case 0:
        return add_object("o", "a");
      case 1:
        return add_object("o", "b c");
      case 2:
        return add_object("g", "a");
      case 3:
        return add_object("g", "d");
      case 4:
        return add_material("known");
      case 5:
        return add_material("unknown");
      case 6:
        return add_material("last");
      case 7:
        obj += "mtllib model.mtl\n";
        return;
      default:
        return add_face();
    }
  }
};

std::vector<OrderedFace> placed_faces(const grf::Scene& scene) {
  std::vector<OrderedFace> faces;
  for (const grf::Mesh& mesh : meshes_of(scene)) {
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      faces.push_back({mesh.name, material_of(mesh, i), mesh.geometry->positions[mesh.face(i)[0]].x});
    }
  }
  return faces;
}

RC_GTEST_PROP(ObjOrder, EachFaceKeepsItsPlaceItsMaterialAndItsMesh, ()) {
  Script script;
  for (const int statement : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 12)))
    script.add(statement);
  script.add_face();
  const Reading reading = read_obj_text(script.obj, "newmtl known\nnewmtl last\n");
  RC_ASSERT(reading.scene.has_value());
  RC_ASSERT(placed_faces(*reading.scene) == script.faces);
}

}  // namespace
}  // namespace convert
