// Meshes for the tests of mesh operations.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "grf/mesh.h"

namespace convert {

/// Makes a grid of n x n unit squares in the plane z = 0, two triangles each, without normals. If there are
/// two surfaces, triangles whose square begins left of x = n / 2 have the first one.
inline grf::Mesh sheet(std::uint32_t n, bool has_two_surfaces = false) {
  grf::MeshDraft mesh;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) mesh.positions.emplace_back(float(x), float(y), 0.0F);
  }
  if (has_two_surfaces) {
    mesh.surfaces.emplace_back();
    mesh.surfaces.back().colour = grf::Colour(1, 0, 0);
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      const std::uint32_t surface = has_two_surfaces && x >= n / 2 ? 1 : 0;
      mesh.add_face(std::array{a, a + 1, a + n + 2}, surface);
      mesh.add_face(std::array{a, a + n + 2, a + n + 1}, surface);
    }
  }
  return mesh;
}

/// Makes a cube of six squares that share eight vertices.
inline grf::Mesh cube() {
  grf::MeshDraft mesh;
  for (std::uint32_t i = 0; i < 8; ++i) {
    mesh.positions.emplace_back(float(i & 1U), float(i >> 1U & 1U), float(i >> 2U));
  }
  constexpr std::array<std::array<std::uint32_t, 4>, 6> Faces = {
      {{4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}, {0, 2, 3, 1}}};
  for (const auto& face : Faces) mesh.add_face(face, 0);
  return mesh;
}

/// Duplicates the vertices of a mesh for each face.
inline grf::Mesh torn(const grf::Mesh& mesh) {
  grf::MeshDraft apart;
  apart.surfaces = mesh.surfaces;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t corner : mesh.face(face)) corners.push_back(apart.copy_vertex(mesh, corner));
    apart.add_face(corners, (*mesh.surface_of_face)[face]);
  }
  return apart;
}

}  // namespace convert
