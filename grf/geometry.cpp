#include "grf/geometry.h"

#include <algorithm>
#include <mutex>
#include <optional>

#include "grf/topology.h"
#include "grf/triangulation.h"
#include "grf/vertex_tree.h"

namespace grf {

namespace {

/// A lazily computed value, cached on first use; thread-safe.
template <class Value>
class Found {
 public:
  template <class Find>
  const Value& or_find(const Find& find) const {
    std::call_once(once_, [&] { value_.emplace(find()); });
    return *value_;
  }

 private:
  mutable std::once_flag once_;
  mutable std::optional<Value> value_;
};

}  // namespace

/// A geometry with its cached derived data.
struct GeometryFacts : Geometry {
  explicit GeometryFacts(Geometry geometry) : Geometry(std::move(geometry)) {}

  Found<VertexTree> vertices;
  Found<Triangulation> triangulation;
  Found<Topology> topology;
  Found<SharedEdges> edges;
  Found<std::vector<Vec3f>> area_vectors;
  Found<double> area;
};

void Geometry::add_face(std::span<const std::uint32_t> face_corners) {
  corners.insert(corners.end(), face_corners.begin(), face_corners.end());
  face_offsets.push_back(static_cast<std::uint32_t>(corners.size()));
}

void Geometry::reverse_face(std::size_t index) {
  std::reverse(corners.begin() + face_offsets[index] + 1, corners.begin() + face_offsets[index + 1]);
}

void Geometry::free_spare_memory() {
  const auto free = [](auto& values) {
    if (has_spare_memory(values)) values.shrink_to_fit();
  };
  free(positions);
  free(corners);
  free(face_offsets);
  normals.free_spare_memory();
  colours.free_spare_memory();
  uvs.free_spare_memory();
}

Vec3d doubled_area_vector(std::span<const std::uint32_t> face, std::span<const Vec3f> positions,
                          const Matrix44d& to_world) {
  const Vec3d origin = Vec3d(positions[face[0]]) * to_world;
  Vec3d sum(0);
  for (std::size_t k = 1; k + 1 < face.size(); ++k) {
    const Vec3d a = Vec3d(positions[face[k]]) * to_world - origin;
    const Vec3d b = Vec3d(positions[face[k + 1]]) * to_world - origin;
    sum += a.cross(b);
  }
  return sum;
}

bool has_area(const Geometry& geometry, std::size_t face, const Vec3d& doubled_area) {
  constexpr double LeastArea = 1e-7;
  const auto corners = geometry.face(face);
  double longest = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3d a(geometry.positions[corners[k]]);
    const Vec3d b(geometry.positions[corners[(k + 1) % corners.size()]]);
    longest = std::max(longest, (a - b).length2());
  }
  return doubled_area.length() > LeastArea * longest;
}

bool has_normals_behind(const Geometry& geometry, std::size_t face, const Vec3d& doubled_area) {
  const auto corners = geometry.face(face);
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
    return geometry.normals.has(corner) && Vec3d(geometry.normals[corner]).dot(doubled_area) < 0;
  });
}

double area_of(const Geometry& geometry, const Matrix44d& to_world) {
  double area = 0;
  for (std::size_t i = 0; i < geometry.face_count(); ++i) {
    area += doubled_area_vector(geometry, i, to_world).length() / 2;
  }
  return area;
}

Triangulation::Triangulation(const Geometry& geometry) : geometry_(&geometry) {
  bool has_polygons = false;
  for (std::size_t i = 0; i < geometry.face_count() && !has_polygons; ++i) {
    has_polygons = geometry.face(i).size() != 3;
  }
  if (!has_polygons) return;
  triangles_.reserve(geometry.triangle_count());
  std::vector<Vec3f> positions;
  for (std::size_t i = 0; i < geometry.face_count(); ++i) {
    const auto face = geometry.face(i);
    positions.clear();
    for (const std::uint32_t corner : face) positions.push_back(geometry.positions[corner]);
    const std::size_t first = triangles_.size();
    triangulate(positions, triangles_);
    for (std::size_t k = first; k < triangles_.size(); ++k) {
      for (std::uint32_t& corner : triangles_[k]) corner = face[corner];
    }
  }
}

SharedGeometry::SharedGeometry() {
  static const SharedGeometry nothing = Geometry();
  geometry_ = nothing.geometry_;
}

SharedGeometry::SharedGeometry(Geometry geometry)
    : geometry_(std::make_shared<const GeometryFacts>(std::move(geometry))) {}

const GeometryFacts& SharedGeometry::facts() const { return static_cast<const GeometryFacts&>(*geometry_); }

const VertexTree& SharedGeometry::vertices() const {
  return facts().vertices.or_find([this] { return VertexTree(facts()); });
}

const Triangulation& SharedGeometry::triangulation() const {
  return facts().triangulation.or_find([this] { return Triangulation(facts()); });
}

const Topology& SharedGeometry::topology() const {
  return facts().topology.or_find([this] { return topology_of(facts()); });
}

const SharedEdges& SharedGeometry::edges() const {
  return facts().edges.or_find([this] { return SharedEdges(facts(), first_at_position(facts())); });
}

const std::vector<Vec3f>& SharedGeometry::area_vectors() const {
  return facts().area_vectors.or_find([this] {
    std::vector<Vec3f> vectors;
    vectors.reserve(facts().face_count());
    for (std::size_t face = 0; face < facts().face_count(); ++face)
      vectors.emplace_back(doubled_area_vector(facts(), face, {}));
    return vectors;
  });
}

double SharedGeometry::area() const {
  return facts().area.or_find([this] { return area_of(facts(), Matrix44d()); });
}

}  // namespace grf
