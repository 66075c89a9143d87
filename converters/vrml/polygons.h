#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "grf/mesh.h"

namespace convert::vrml {

/// The faces of one geometry node, before they become a mesh. Arrays that belong to corners or to faces are
/// as long as there are corners or faces, or empty.
struct Polygons {
  std::vector<grf::Vec3f> positions;
  std::vector<std::uint32_t> corners = {};  ///< indices of positions, of all faces, one after the other
  std::vector<std::size_t> face_ends = {};  ///< where each face's corners end

  // One for each corner.
  std::vector<grf::Vec3f> normals = {};  ///< one of no length is none
  std::vector<grf::Colour> colours = {};
  std::vector<grf::Vec2f> uvs = {};

  // One for each face.
  std::vector<grf::Colour> face_colours = {};
  std::vector<std::uint32_t> face_materials = {};  ///< which of the surfaces; empty: the first one

  std::size_t face_count() const { return face_ends.size(); }
  std::size_t face_begin(std::size_t face) const { return face == 0 ? 0 : face_ends[face - 1]; }
  std::span<const std::uint32_t> face(std::size_t index) const {
    return std::span(corners).subspan(face_begin(index), face_ends[index] - face_begin(index));
  }
  void add_face(std::span<const std::uint32_t> indices);

  /// Turns the fronts to the other side. The first corner of each face stays the first.
  void reverse_faces();
};

/// Texture coordinates where the file gives none: of the box around the faces, the longest side is u from 0
/// to 1, the second longest is v (ISO/IEC 14772-1, 6.23 IndexedFaceSet).
void add_default_uvs(Polygons& polygons);

/// Gives the corners normals that are smooth across each edge between faces whose angle is less than the
/// crease angle, in radians (ISO/IEC 14772-1, 4.6.3.5). Faces that are smooth nowhere get none.
void add_crease_normals(Polygons& polygons, double crease_angle);

/// A mesh of the faces. Corners that are alike share a vertex.
grf::Mesh make_mesh(std::string name, const Polygons& polygons, std::span<const grf::Surface> surfaces);

}  // namespace convert::vrml
