#include "converters/mesh_operations/orient.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "grf/topology.h"

namespace convert {
namespace {

using grf::Geometry;
using grf::Vec3d;

/// Orients the faces of a geometry part by part.
class Orientation {
 public:
  explicit Orientation(const grf::SharedGeometry& geometry, OpenParts open_parts)
      : geometry_(*geometry),
        open_parts_(open_parts),
        places_(grf::first_at_position(geometry_)),
        edges_(geometry.edges()),
        is_seen_(geometry_.face_count()),
        is_reversed_(geometry_.face_count()) {}

  std::vector<bool> find() {
    for (std::uint32_t face = 0; face < geometry_.face_count(); ++face) {
      if (!is_seen_[face]) orient_part(face);
    }
    return std::move(is_reversed_);
  }

 private:
  /// Whether the half-edge runs from the smaller of its places to the greater.
  bool is_forward(const grf::HalfEdge& edge) const {
    return places_[geometry_.corners[edge.corner]] < places_[geometry_.corners[end_corner(geometry_, edge)]];
  }

  void orient_part(std::uint32_t first) {
    std::vector<std::uint32_t> part = {first};
    is_seen_[first] = true;
    is_closed_ = true;
    for (std::size_t i = 0; i < part.size(); ++i) visit_neighbours(part[i], part);
    if (!points_outward(part)) {
      for (const std::uint32_t face : part) is_reversed_[face] = !is_reversed_[face];
    }
  }

  void visit_neighbours(std::uint32_t face, std::vector<std::uint32_t>& part) {
    for (std::uint32_t corner = geometry_.face_offsets[face]; corner < geometry_.face_offsets[face + 1];
         ++corner) {
      const std::uint32_t edge = edges_.at_corner(corner);
      if (edge == grf::SharedEdges::InvalidIndex) continue;
      const auto faces = edges_.faces_at(edge);
      if (faces.size() != 2 || faces[0].face == faces[1].face) {
        is_closed_ = false;
        continue;
      }
      const std::uint32_t other = faces[0].face == face ? faces[1].face : faces[0].face;
      if (is_seen_[other]) continue;
      is_seen_[other] = true;
      // Faces that agree run along their common edge in opposite directions.
      const bool agree = is_forward(faces[0]) != is_forward(faces[1]);
      is_reversed_[other] = is_reversed_[face] == agree;
      part.push_back(other);
    }
  }

  bool points_outward(const std::vector<std::uint32_t>& part) const {
    grf::Box3d bounds;
    for (const std::uint32_t face : part) {
      for (const std::uint32_t corner : geometry_.face(face))
        bounds.extendBy(Vec3d(geometry_.positions[corner]));
    }
    double volume = 0;  // three times that, over the centre
    double area = 0;
    double kept = 0;
    for (const std::uint32_t face : part) {
      Vec3d normal = grf::doubled_area_vector(geometry_, face, {});
      const double doubled = normal.length();
      area += doubled;
      if (!is_reversed_[face]) kept += doubled;
      if (is_reversed_[face]) normal = -normal;
      const Vec3d point(geometry_.positions[geometry_.face(face).front()]);
      volume += normal.dot(point - bounds.center());
    }
    constexpr double Flat = 1e-6;
    const bool has_volume = is_closed_ || open_parts_ == OpenParts::ByVolume;
    if (has_volume && std::abs(volume) > Flat * area * bounds.size().length()) return volume > 0;
    return 2 * kept >= area;
  }

  const Geometry& geometry_;
  const OpenParts open_parts_;
  bool is_closed_ = true;  ///< the current part
  std::vector<std::uint32_t> places_;
  const grf::SharedEdges& edges_;
  std::vector<bool> is_seen_;
  std::vector<bool> is_reversed_;
};

/// Reverses the normals of vertices that point to the backs of most of their faces.
void turn_normals(Geometry& geometry) {
  std::vector<double> agreement(geometry.positions.size());
  for (std::size_t face = 0; face < geometry.face_count(); ++face) {
    const Vec3d normal = grf::doubled_area_vector(geometry, face, {});
    for (const std::uint32_t corner : geometry.face(face)) {
      if (geometry.normals.has(corner)) agreement[corner] += normal.dot(Vec3d(geometry.normals[corner]));
    }
  }
  for (std::size_t vertex = 0; vertex < agreement.size(); ++vertex) {
    if (agreement[vertex] < 0) geometry.normals.set(vertex, -geometry.normals[vertex]);
  }
}

}  // namespace

std::vector<bool> inward_faces(const grf::SharedGeometry& geometry, OpenParts open_parts) {
  return Orientation(geometry, open_parts).find();
}

grf::Mesh oriented_outward(const grf::Mesh& mesh) {
  const std::vector<bool> reversed = inward_faces(mesh.geometry);
  if (std::find(reversed.begin(), reversed.end(), true) == reversed.end()) return mesh;
  Geometry geometry = *mesh.geometry;
  for (std::size_t face = 0; face < reversed.size(); ++face) {
    if (reversed[face]) geometry.reverse_face(face);
  }
  turn_normals(geometry);
  grf::Mesh result = mesh;
  result.geometry = std::move(geometry);
  return result;
}

}  // namespace convert
