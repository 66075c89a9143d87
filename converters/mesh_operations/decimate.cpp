#include "converters/mesh_operations/decimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "converters/mesh_operations/rebuild.h"
#include "converters/mesh_operations/triangulate.h"
#include "grf/topology.h"

namespace convert {
namespace {

using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
using Vertex = HalfEdgeMesh::VertexHandle;
using Face = HalfEdgeMesh::FaceHandle;
using Edge = HalfEdgeMesh::EdgeHandle;
using CollapseInfo = OpenMesh::Decimater::CollapseInfoT<HalfEdgeMesh>;

/// A face of the half-edge mesh, with its attributes.
struct Triangle {
  std::array<Vertex, 3> ends;
  std::array<std::uint32_t, 3> corners;  ///< vertices of the mesh; several can be at one half-edge vertex
  std::uint32_t surface = 0;

  std::size_t place_of(Vertex vertex) const {
    return static_cast<std::size_t>(std::find(ends.begin(), ends.end(), vertex) - ends.begin());
  }
  std::uint32_t corner_at(Vertex vertex) const { return corners[place_of(vertex)]; }
};

/// The replacement of vertices of the mesh when an edge collapses onto one of its ends.
class CornerMap {
 public:
  CornerMap(const CollapseInfo& collapse, const std::vector<Triangle>& triangles) {
    for (const Face face : {collapse.fl, collapse.fr}) {
      if (!face.is_valid()) continue;
      const Triangle& triangle = triangles[static_cast<std::size_t>(face.idx())];
      pairs_[count_++] = {triangle.corner_at(collapse.v0), triangle.corner_at(collapse.v1)};
    }
    // One side of a seam cannot collapse onto both sides of another one.
    is_unique_ = count_ < 2 || pairs_[0].first != pairs_[1].first || pairs_[0].second == pairs_[1].second;
  }

  bool is_unique() const { return is_unique_; }
  std::optional<std::uint32_t> target_of(std::uint32_t corner) const {
    for (std::size_t i = 0; i < count_; ++i) {
      if (pairs_[i].first == corner) return pairs_[i].second;
    }
    return std::nullopt;
  }

 private:
  std::array<std::pair<std::uint32_t, std::uint32_t>, 2> pairs_;
  std::size_t count_ = 0;
  bool is_unique_ = true;
};

/// A decimation module that preserves borders and seams, and updates the triangles after each collapse.
class BordersModule : public OpenMesh::Decimater::ModBaseT<HalfEdgeMesh> {
 public:
  using Base = OpenMesh::Decimater::ModBaseT<HalfEdgeMesh>;
  using Handle = OpenMesh::Decimater::ModHandleT<BordersModule>;

  explicit BordersModule(HalfEdgeMesh& half_edges) : Base(half_edges, true) {}
  const std::string& name() const override { return name_; }
  void watch(std::vector<Triangle>& triangles) { triangles_ = &triangles; }

  float collapse_priority(const CollapseInfo& collapse) override {
    const bool is_legal = keeps_seams(collapse) && keeps_borders(collapse);
    return static_cast<float>(is_legal ? LEGAL_COLLAPSE : ILLEGAL_COLLAPSE);
  }

  void preprocess_collapse(const CollapseInfo& collapse) override {
    const CornerMap corners(collapse, *triangles_);
    for (const Face face : mesh().vf_range(collapse.v0)) {
      Triangle& triangle = (*triangles_)[static_cast<std::size_t>(face.idx())];
      const std::size_t place = triangle.place_of(collapse.v0);
      if (face == collapse.fl || face == collapse.fr) continue;
      triangle.corners[place] = *corners.target_of(triangle.corners[place]);
      triangle.ends[place] = collapse.v1;
    }
  }

 private:
  const Triangle& triangle(Face face) const { return (*triangles_)[static_cast<std::size_t>(face.idx())]; }

  bool keeps_seams(const CollapseInfo& collapse) {
    const CornerMap corners(collapse, *triangles_);
    if (!corners.is_unique()) return false;
    const auto faces = mesh().vf_range(collapse.v0);
    return std::all_of(faces.begin(), faces.end(), [&](Face face) {
      return corners.target_of(triangle(face).corner_at(collapse.v0)).has_value();
    });
  }

  bool is_border(Edge edge) {
    const Face left = mesh().face_handle(mesh().halfedge_handle(edge, 0));
    const Face right = mesh().face_handle(mesh().halfedge_handle(edge, 1));
    return !left.is_valid() || !right.is_valid() || triangle(left).surface != triangle(right).surface;
  }

  bool keeps_borders(const CollapseInfo& collapse) {
    std::array<Vertex, 2> neighbours;
    std::size_t count = 0;
    for (const auto half_edge : mesh().voh_range(collapse.v0)) {
      if (!is_border(mesh().edge_handle(half_edge))) continue;
      if (count == 2) return false;
      neighbours[count++] = mesh().to_vertex_handle(half_edge);
    }
    if (count == 0) return true;
    if (count == 1 || (neighbours[0] != collapse.v1 && neighbours[1] != collapse.v1)) return false;
    return is_between(collapse.p0, mesh().point(neighbours[0]), mesh().point(neighbours[1]));
  }

  /// Returns whether a point is on the straight line between two points, up to float rounding.
  static bool is_between(const HalfEdgeMesh::Point& point, const HalfEdgeMesh::Point& a,
                         const HalfEdgeMesh::Point& b) {
    constexpr double Rounding = 1e-6;
    const auto line = b - a;
    const auto way = point - a;
    const double along = way | line;
    const double length2 = line.sqrnorm();
    return along > 0 && along < length2 && (way % line).sqrnorm() <= Rounding * Rounding * length2 * length2;
  }

  std::string name_ = "Borders";
  std::vector<Triangle>* triangles_ = nullptr;
};

/// OpenMesh's quadric module, fixed for planar regions: there the error can round below 0, which would make a
/// collapse illegal.
class QuadricModule : public OpenMesh::Decimater::ModQuadricT<HalfEdgeMesh> {
 public:
  using Base = OpenMesh::Decimater::ModQuadricT<HalfEdgeMesh>;
  using Handle = OpenMesh::Decimater::ModHandleT<QuadricModule>;

  explicit QuadricModule(HalfEdgeMesh& half_edges) : Base(half_edges) {}
  float collapse_priority(const CollapseInfo& collapse) override {
    return std::max(Base::collapse_priority(collapse), 0.0F);
  }
};

/// Silences OpenMesh's error stream, on which it reports non-manifold faces.
class Silence {
 public:
  Silence() { omerr().disable(); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence() { omerr().enable(); }
};

/// A triangle mesh under decimation.
class Decimation {
 public:
  explicit Decimation(const grf::Mesh& mesh) : mesh_(mesh), alike_(first_equal_vertex(mesh)) {
    const Silence silence;
    const std::vector<std::uint32_t> places = grf::first_at_position(*mesh.geometry);
    const std::vector<bool> is_left_alone = faces_to_leave_alone(places);
    std::vector<Vertex> vertex_at(mesh.geometry->positions.size());
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
      const auto corners = mesh.face(face);
      Triangle triangle;
      triangle.surface = (*mesh.surface_of_face)[face];
      for (std::size_t k = 0; k < 3; ++k) {
        Vertex& vertex = vertex_at[places[corners[k]]];
        if (!vertex.is_valid()) vertex = add_vertex(mesh.geometry->positions[corners[k]]);
        triangle.ends[k] = vertex;
        triangle.corners[k] = alike_[corners[k]];
      }
      add(triangle, is_left_alone[face]);
    }
    for (const Vertex vertex : half_edges_.vertices()) {
      if (!half_edges_.is_manifold(vertex)) lock(vertex);
    }
  }

  std::size_t left_alone() const { return mesh_.face_count() - triangles_.size(); }

  void run(std::size_t triangles_wanted) {
    if (triangles_wanted >= mesh_.face_count()) return;
    const std::size_t wanted = triangles_wanted - std::min(triangles_wanted, left_alone());
    half_edges_.request_face_normals();
    half_edges_.update_face_normals();
    OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater(half_edges_);
    QuadricModule::Handle quadrics;
    BordersModule::Handle borders;
    OpenMesh::Decimater::ModNormalFlippingT<HalfEdgeMesh>::Handle flipping;
    decimater.add(quadrics);
    decimater.add(borders);
    decimater.add(flipping);
    decimater.module(borders).watch(triangles_);
    if (decimater.initialize()) decimater.decimate_to_faces(0, wanted);
  }

  grf::Mesh result() const {
    Rebuild rebuild(mesh_);
    for (std::size_t face = 0; face < mesh_.face_count(); ++face) {
      const Face handle = handles_[face];
      if (!handle.is_valid()) {
        rebuild.add_face(mesh_.face(face), (*mesh_.surface_of_face)[face]);
      } else if (!half_edges_.status(handle).deleted()) {
        const Triangle& triangle = triangles_[static_cast<std::size_t>(handle.idx())];
        rebuild.add_face(triangle.corners, triangle.surface);
      }
    }
    return rebuild.take();
  }

 private:
  std::vector<bool> faces_to_leave_alone(const std::vector<std::uint32_t>& places) const {
    std::vector<bool> left_alone(mesh_.face_count());
    const std::vector<grf::HalfEdge> edges = grf::half_edges_of(*mesh_.geometry, places);
    grf::for_each_edge(edges, [&](std::span<const grf::HalfEdge> of_faces) {
      if (of_faces.size() <= 2) return;
      for (const grf::HalfEdge& edge : of_faces) left_alone[edge.face] = true;
    });
    return left_alone;
  }

  Vertex add_vertex(const grf::Vec3f& position) {
    return half_edges_.add_vertex({position.x, position.y, position.z});
  }

  /// Locks the vertices of a face that cannot be part of a manifold.
  void add(const Triangle& triangle, bool is_left_alone) {
    const auto& [a, b, c] = triangle.ends;
    Face face;
    if (!is_left_alone && a != b && b != c && c != a) face = half_edges_.add_face(a, b, c);
    handles_.push_back(face);
    if (face.is_valid()) {
      triangles_.push_back(triangle);
    } else {
      for (const Vertex vertex : triangle.ends) lock(vertex);
    }
  }

  void lock(Vertex vertex) { half_edges_.status(vertex).set_locked(true); }

  /// The traits request status flags of vertices and faces: locked and deleted.
  struct StatusMesh : HalfEdgeMesh {
    StatusMesh() {
      request_vertex_status();
      request_edge_status();
      request_halfedge_status();
      request_face_status();
    }
  };

  const grf::Mesh& mesh_;
  std::vector<std::uint32_t> alike_;
  StatusMesh half_edges_;
  std::vector<Triangle> triangles_;  // by face index in half_edges_
  std::vector<Face> handles_;        // by face of the mesh; invalid for faces that stay unchanged
};

}  // namespace

Decimated decimate(const grf::Mesh& mesh, double ratio) {
  const grf::Mesh triangles = triangulated(mesh);
  Decimated decimated;
  decimated.triangles_before = triangles.face_count();
  const double wanted = ratio * static_cast<double>(triangles.face_count());
  decimated.triangles_wanted = static_cast<std::size_t>(std::llround(wanted));
  Decimation decimation(triangles);
  decimation.run(decimated.triangles_wanted);
  decimated.triangles_left_alone = decimation.left_alone();
  decimated.mesh = decimation.result();
  return decimated;
}

}  // namespace convert
