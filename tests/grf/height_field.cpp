#include "tests/grf/height_field.h"

#include <array>
#include <cmath>
#include <utility>

namespace grf {

namespace {

/// As exporters round: the text of a number is then what it is in most files, and not nine digits.
float rounded(float value, float steps) { return std::round(value * steps) / steps; }

}  // namespace

Mesh height_field(std::uint32_t side) {
  MeshDraft mesh;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const float x = static_cast<float>(i % side) / static_cast<float>(side);
    const float y = static_cast<float>(i / side) / static_cast<float>(side);
    const float z = std::sin(9 * x) * std::cos(7 * y) / 5;
    const Vec3f normal = Vec3f(-1.8F * std::cos(9 * x), 1.4F * std::sin(7 * y), 1).normalized();
    mesh.positions.emplace_back(rounded(x, 1000), rounded(y, 1000), rounded(z, 1000));
    mesh.normals.set(i, Vec3f(rounded(normal.x, 100), rounded(normal.y, 100), rounded(normal.z, 100)));
  }
  for (std::uint32_t row = 0; row + 1 < side; ++row) {
    for (std::uint32_t column = 0; column + 1 < side; ++column) {
      const std::uint32_t corner = row * side + column;
      mesh.add_face(std::array{corner, corner + 1, corner + side}, 0);
      mesh.add_face(std::array{corner + 1, corner + side + 1, corner + side}, 0);
    }
  }
  return mesh;
}

Scene scene_of_mesh(Mesh mesh) {
  Scene scene;
  Block block;
  block.content = Shared<Mesh>(std::move(mesh));
  scene.contents.blocks.push_back(std::move(block));
  return scene;
}

std::size_t bytes_of(const Mesh& mesh) {
  const std::size_t vertices = mesh.geometry->positions.size();
  const std::size_t values =
      (mesh.geometry->normals.empty() ? 0 : 1) + (mesh.geometry->colours.empty() ? 0 : 1);
  return vertices * sizeof(Vec3f) * (1 + values) +
         (mesh.geometry->uvs.empty() ? 0 : vertices * sizeof(Vec2f)) +
         (mesh.geometry->corners.size() + mesh.geometry->face_offsets.size() + mesh.face_count()) *
             sizeof(std::uint32_t);
}

}  // namespace grf
