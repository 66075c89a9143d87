#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "grf/mesh.h"

namespace convert::vrml {

/// The faces of one geometry node, before they become a mesh. Arrays per corner or per face have that many
/// entries, or none.
struct Polygons {
  std::vector<grf::Vec3f> positions;
  std::vector<std::uint32_t> corners = {};  ///< indices of positions of all faces, concatenated
  std::vector<std::size_t> face_ends = {};  ///< the end of each face's corners

  // One entry per corner.
  std::vector<grf::Vec3f> normals = {};  ///< zero means none
  std::vector<grf::Colour> colours = {};
  std::vector<grf::Vec2f> uvs = {};

  // One entry per face.
  std::vector<grf::Colour> face_colours = {};
  std::vector<std::uint32_t> face_materials = {};  ///< indices of surfaces; empty: the first one

  std::size_t face_count() const { return face_ends.size(); }
  std::size_t face_begin(std::size_t face) const { return face == 0 ? 0 : face_ends[face - 1]; }
  std::span<const std::uint32_t> face(std::size_t index) const {
    return std::span(corners).subspan(face_begin(index), face_ends[index] - face_begin(index));
  }
  void add_face(std::span<const std::uint32_t> indices);

  /// Reverses the winding of all faces. The first corner of each face stays the first.
  void reverse_faces();
};

/// Adds the default texture coordinates: in the bounding box of the faces, the longest side is u from 0 to 1,
/// the second longest is v (ISO/IEC 14772-1, 6.23 IndexedFaceSet).
void add_default_uvs(Polygons& polygons);

/// Computes normals at corners that are smooth across each edge whose faces' normals differ by less than the
/// crease angle, in radians (ISO/IEC 14772-1, 4.6.3.5). Faces without a smooth edge get none.
void add_crease_normals(Polygons& polygons, double crease_angle);

/// Makes a mesh of the faces, in which equal corners share a vertex.
grf::Mesh make_mesh(std::string name, const Polygons& polygons, std::span<const grf::Surface> surfaces);

}  // namespace convert::vrml
