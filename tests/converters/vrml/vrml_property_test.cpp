// Meshes that are written as VRML text come back the same.
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/converters/vrml/vrml_reading.h"

namespace convert {
namespace {

/// A mesh in which each corner has its values by their own indices.
struct Written {
  std::vector<grf::Vec3f> points, normals;
  std::vector<grf::Vec2f> uvs;
  std::vector<grf::Colour> colours;
  std::vector<std::vector<std::uint32_t>> faces, normal_indices, uv_indices, colour_indices;
};

float some_float(std::mt19937& random) {
  // Of many magnitudes, and with all bits.
  const float mantissa = std::uniform_real_distribution<float>(-1, 1)(random);
  return std::ldexp(mantissa, std::uniform_int_distribution<int>(-20, 20)(random));
}

Written some_mesh(std::mt19937& random) {
  const auto below = [&random](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  Written mesh;
  for (std::size_t i = 3 + below(30); i > 0; --i) {
    mesh.points.emplace_back(some_float(random), some_float(random), some_float(random));
    mesh.normals.emplace_back(some_float(random), some_float(random), 1.0F);
    mesh.uvs.emplace_back(some_float(random), some_float(random));
    mesh.colours.emplace_back(std::abs(std::sin(some_float(random))), 0.0F, 1.0F);
  }
  const auto indices = [&](std::size_t count) {
    std::vector<std::uint32_t> list;
    for (std::size_t i = 0; i < count; ++i)
      list.push_back(static_cast<std::uint32_t>(below(mesh.points.size())));
    return list;
  };
  for (std::size_t i = 1 + below(20); i > 0; --i) {
    const std::size_t corners = 3 + below(5);
    for (auto* list : {&mesh.faces, &mesh.normal_indices, &mesh.uv_indices, &mesh.colour_indices}) {
      list->push_back(indices(corners));
    }
  }
  return mesh;
}

template <class Vectors>
std::string list_of(const Vectors& vectors) {
  std::string text = "[ ";
  for (const auto& v : vectors) {
    for (unsigned i = 0; i < v.dimensions(); ++i) text += fmt::format("{} ", v[static_cast<int>(i)]);
    text += ", ";
  }
  return text + "]\n";
}

std::string list_of(const std::vector<std::vector<std::uint32_t>>& faces) {
  std::string text = "[ ";
  for (const auto& face : faces) text += fmt::format("{}, -1, ", fmt::join(face, ", "));
  return text + "]\n";
}

void expect_same(const Written& written, const Reading& reading) {
  RC_ASSERT(reading.scene.has_value());
  const auto meshes = meshes_of(*reading.scene);
  RC_ASSERT(meshes.size() == 1U);
  const grf::Mesh& mesh = meshes[0];
  RC_ASSERT(mesh.face_count() == written.faces.size());
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    const auto face = mesh.face(i);
    RC_ASSERT(face.size() == written.faces[i].size());
    for (std::size_t k = 0; k < face.size(); ++k) {
      RC_ASSERT(mesh.geometry->positions[face[k]] == written.points[written.faces[i][k]]);
      RC_ASSERT(mesh.geometry->normals[face[k]] == written.normals[written.normal_indices[i][k]]);
      RC_ASSERT(mesh.geometry->uvs[face[k]] == written.uvs[written.uv_indices[i][k]]);
      RC_ASSERT(mesh.geometry->colours[face[k]] == written.colours[written.colour_indices[i][k]]);
    }
  }
}

RC_GTEST_PROP(VrmlProperty, AMeshWrittenAsVrml97ComesBack, (unsigned seed)) {
  std::mt19937 random(seed);
  const Written mesh = some_mesh(random);
  expect_same(
      mesh,
      read_vrml97(shape(
          "IndexedFaceSet { coord Coordinate { point " + list_of(mesh.points) + "} normal Normal { vector " +
              list_of(mesh.normals) + "} texCoord TextureCoordinate { point " + list_of(mesh.uvs) +
              "} color Color { color " + list_of(mesh.colours) + "} coordIndex " + list_of(mesh.faces) +
              "normalIndex " + list_of(mesh.normal_indices) + "texCoordIndex " + list_of(mesh.uv_indices) +
              "colorIndex " + list_of(mesh.colour_indices) + "}",
          "material Material { }")));
}

RC_GTEST_PROP(VrmlProperty, AMeshWrittenAsVrml1ComesBack, (unsigned seed)) {
  std::mt19937 random(seed);
  const Written mesh = some_mesh(random);
  expect_same(
      mesh,
      read_vrml1("Separator { Coordinate3 { point " + list_of(mesh.points) + "} Normal { vector " +
                 list_of(mesh.normals) + "} TextureCoordinate2 { point " + list_of(mesh.uvs) +
                 "} Material { diffuseColor " + list_of(mesh.colours) +
                 "} MaterialBinding { value PER_VERTEX_INDEXED } IndexedFaceSet { coordIndex " +
                 list_of(mesh.faces) + "normalIndex " + list_of(mesh.normal_indices) + "textureCoordIndex " +
                 list_of(mesh.uv_indices) + "materialIndex " + list_of(mesh.colour_indices) + "} }"));
}

// Whatever is cut off or changed: a scene, or an error, and no crash.
RC_GTEST_PROP(VrmlProperty, ADamagedFileIsASceneOrAnError, (unsigned seed)) {
  std::mt19937 random(seed);
  std::string text = "DEF a Transform { translation 1 2 3 children [ " +
                     shape(square("creaseAngle 1 colorPerVertex FALSE color Color "
                                  "{ color [ 1 0 0 0 1 0 ] }"),
                           "material Material { shininess 0.5 }") +
                     shape("Extrusion { }") +
                     " Switch { whichChoice 0 choice USE b } ] } PROTO p [ ] { } p { } ROUTE a.b TO c.d";
  text.replace(text.find("USE b"), 5, "Group { }");
  for (int i = 0; i < 3; ++i) {
    const std::size_t at = std::uniform_int_distribution<std::size_t>(0, text.size() - 1)(random);
    switch (random() % 3) {
      case 0:
        text[at] = static_cast<char>(random() % 127 + 1);
        break;
      case 1:
        text.erase(at, 1 + random() % 5);
        break;
      default:
        text.insert(at, text.substr(random() % text.size(), random() % 30));
    }
  }
  const Reading reading = read_vrml97(text);
  RC_ASSERT(reading.scene.has_value() != reading.diagnostics.has_errors());
}

}  // namespace
}  // namespace convert
