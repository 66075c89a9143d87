#include "converters/mesh_operations/subdivide.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "converters/mesh_operations/edge_rules.h"
#include "converters/mesh_operations/normals.h"
#include "converters/mesh_operations/rebuild.h"
#include "converters/mesh_operations/triangulate.h"

namespace convert {
namespace {

using Ids = std::vector<std::uint32_t>;
using Rule = EdgeRules::Rule;

/// A mesh at one level, without normals. Identities of vertices are inherited from the previous level:
/// vertices that coincide by chance are not merged.
struct Level {
  grf::MeshDraft mesh;
  // For each vertex the first one
  Ids places;   // at the same place,
  Ids uvs;      // with the same texture coordinates there,
  Ids colours;  // and with the same colour.
};

/// Refined values of one attribute: at representative vertices, at edges, and at faces.
template <class Value>
struct Refined {
  std::vector<Value> at_vertex;
  std::vector<Value> at_edge;
  std::vector<Value> at_face;
};

/// Computes the refined values of one attribute from the old ones, `old(vertex)`, by the masks of a scheme.
template <class Value, class Old>
class Masks {
 public:
  Masks(const grf::Geometry& geometry, const EdgeRules& rules, SubdivisionScheme scheme, const Old& old)
      : geometry_(geometry), rules_(rules), is_loop_(scheme == SubdivisionScheme::Loop), old_(old) {}

  Refined<Value> run() {
    for (std::size_t face = 0; face < geometry_.face_count(); ++face) {
      Value sum(0);
      for (const std::uint32_t vertex : geometry_.face(face)) sum += value(vertex);
      refined_.at_face.push_back(sum / static_cast<double>(geometry_.face(face).size()));
    }
    find_edge_values();
    find_vertex_values();
    return std::move(refined_);
  }

 private:
  Value value(std::uint32_t vertex) const { return old_(rules_.id(vertex)); }

  std::array<std::uint32_t, 2> ends(const grf::HalfEdge& edge) const {
    return {rules_.id(geometry_.corners[edge.corner]),
            rules_.id(geometry_.corners[grf::end_corner(geometry_, edge)])};
  }

  /// Returns a face's contribution to an interior edge, which has the weight 1/4. For a triangle, (a + b +
  /// c)/3 includes the opposite vertex; Loop's mask is 3/8 of the ends and 1/8 of the opposite vertices.
  Value of_face(const grf::HalfEdge& edge, const Value& sum_of_ends) const {
    const Value& middle = refined_.at_face[edge.face];
    return is_loop_ ? (3.0 * middle - sum_of_ends + sum_of_ends / 2) / 2 : middle;
  }

  void find_edge_values() {
    const grf::SharedEdges& edges = rules_.edges();
    for (std::uint32_t edge = 0; edge < edges.edge_count(); ++edge) {
      const auto faces = edges.faces_at(edge);
      const auto [a, b] = ends(faces.front());
      const Value sum = old_(a) + old_(b);
      refined_.at_edge.push_back(
          rules_.is_sharp(edge) ? sum / 2 : (sum + of_face(faces[0], sum) + of_face(faces[1], sum)) / 4);
    }
  }

  /// Sums around vertices: of the neighbours, of the neighbours by sharp edges only, and of faces.
  struct Around {
    Value neighbours = Value(0);
    Value sharp_neighbours = Value(0);
    Value faces = Value(0);
    std::uint32_t edge_count = 0;
    std::uint32_t face_count = 0;
  };

  void find_vertex_values() {
    std::vector<Around> around(geometry_.positions.size());
    const grf::SharedEdges& edges = rules_.edges();
    for (std::uint32_t edge = 0; edge < edges.edge_count(); ++edge) {
      const auto [a, b] = ends(edges.faces_at(edge).front());
      for (const auto& [vertex, other] : {std::pair(a, b), std::pair(b, a)}) {
        around[vertex].neighbours += old_(other);
        if (rules_.is_sharp(edge)) around[vertex].sharp_neighbours += old_(other);
        ++around[vertex].edge_count;
      }
    }
    for (std::size_t face = 0; face < geometry_.face_count(); ++face) {
      for (const std::uint32_t corner : geometry_.face(face)) {
        Around& vertex = around[rules_.id(corner)];
        vertex.faces += refined_.at_face[face];
        ++vertex.face_count;
      }
    }
    for (std::uint32_t i = 0; i < around.size(); ++i) {
      refined_.at_vertex.push_back(rules_.id(i) == i ? vertex_value(i, around[i]) : Value(0));
    }
  }

  Value vertex_value(std::uint32_t vertex, const Around& around) const {
    const Value& old = old_(vertex);
    if (rules_.rule(vertex) == Rule::Crease) return 0.75 * old + around.sharp_neighbours / 8;
    // A vertex with fewer than two edges is isolated.
    if (rules_.rule(vertex) == Rule::Corner || around.edge_count < 2) return old;
    const double n = around.edge_count;
    if (is_loop_) {
      const double c = 0.375 + std::cos(2 * std::numbers::pi / n) / 4;
      const double beta = (0.625 - c * c) / n;
      return (1 - n * beta) * old + beta * around.neighbours;
    }
    // Catmull-Clark's vertex rule, (F + 2 R + (n - 3) P)/n, where R is the mean of the edges' midpoints.
    return (around.faces / static_cast<double>(around.face_count) + around.neighbours / n + (n - 2) * old) /
           n;
  }

  const grf::Geometry& geometry_;
  const EdgeRules& rules_;
  bool is_loop_;
  const Old& old_;
  Refined<Value> refined_;
};

/// An inserter of values of an optional vertex attribute that all vertices have here.
template <class Value>
auto append_to(grf::OptionalVertexValues<Value>& values) {
  return [&values, i = std::size_t(0)](const auto& value) mutable { values.set(i++, Value(value)); };
}

/// A refinement step from a level to the next. Its vertices are the old ones, then one per edge, then, for
/// Catmull-Clark, one per face.
class Refinement {
 public:
  Refinement(const Level& level, SubdivisionScheme scheme)
      : level_(level),
        scheme_(scheme),
        edges_(level.mesh, {}),
        first_of_edges_(static_cast<std::uint32_t>(level.mesh.positions.size())),
        first_of_faces_(first_of_edges_ + edges_.edge_count()) {}

  Level run() {
    next_.mesh.surfaces = level_.mesh.surfaces;
    const EdgeRules places(level_.mesh, level_.places);
    refine<grf::Vec3d>(places, level_.mesh.positions, next_.places,
                       [this](const grf::Vec3d& v) { next_.mesh.positions.emplace_back(v); });
    if (!level_.mesh.uvs.empty()) {
      const EdgeRules rules(level_.mesh, level_.uvs, places);
      refine<grf::Vec2d>(rules, level_.mesh.uvs, next_.uvs, append_to(next_.mesh.uvs));
    }
    if (!level_.mesh.colours.empty()) {
      const EdgeRules rules(level_.mesh, level_.colours, places);
      refine<grf::Vec3d>(rules, level_.mesh.colours, next_.colours, append_to(next_.mesh.colours));
    }
    const bool is_loop = scheme_ == SubdivisionScheme::Loop;
    for (std::size_t face = 0; face < level_.mesh.face_count(); ++face) {
      is_loop ? cut_triangle(face) : cut_polygon(face);
    }
    return std::move(next_);
  }

 private:
  std::uint32_t vertex_count() const {
    const bool has_face_points = scheme_ == SubdivisionScheme::CatmullClark;
    return first_of_faces_ + (has_face_points ? static_cast<std::uint32_t>(level_.mesh.face_count()) : 0);
  }

  /// Appends the new value of each vertex, and the first vertex with that value.
  template <class Value, class Values, class Append>
  void refine(const EdgeRules& rules, const Values& values, Ids& ids, Append append) {
    const auto old = [&](std::uint32_t vertex) { return Value(values[vertex]); };
    const Refined<Value> refined = Masks<Value, decltype(old)>(level_.mesh, rules, scheme_, old).run();
    std::vector<std::uint32_t> first_at_edge(refined.at_edge.size(), grf::SharedEdges::InvalidIndex);
    for (std::uint32_t i = 0; i < vertex_count(); ++i) {
      if (i >= first_of_faces_) {
        append(refined.at_face[i - first_of_faces_]);
        ids.push_back(i);
        continue;
      }
      std::uint32_t vertex = i;
      if (i >= first_of_edges_) {
        const std::uint32_t corner = edges_.faces_at(i - first_of_edges_).front().corner;
        const std::uint32_t edge = rules.edges().at_corner(corner);
        if (edge != grf::SharedEdges::InvalidIndex) {
          if (first_at_edge[edge] == grf::SharedEdges::InvalidIndex) first_at_edge[edge] = i;
          append(refined.at_edge[edge]);
          ids.push_back(first_at_edge[edge]);
          continue;
        }
        vertex = level_.mesh.corners[corner];  // both ends have one value
      }
      append(refined.at_vertex[rules.id(vertex)]);
      ids.push_back(rules.id(vertex));
    }
  }

  /// Returns the new vertex on the edge that begins at a corner.
  std::uint32_t edge_vertex(std::uint32_t corner) const {
    const std::uint32_t edge = edges_.at_corner(corner);
    return edge == grf::SharedEdges::InvalidIndex ? level_.mesh.corners[corner] : first_of_edges_ + edge;
  }

  void cut_polygon(std::size_t face) {
    const std::uint32_t begin = level_.mesh.face_offsets[face];
    const std::uint32_t end = level_.mesh.face_offsets[face + 1];
    for (std::uint32_t corner = begin; corner < end; ++corner) {
      const std::uint32_t previous = corner == begin ? end - 1 : corner - 1;
      next_.mesh.add_face(
          std::array{level_.mesh.corners[corner], edge_vertex(corner),
                     first_of_faces_ + static_cast<std::uint32_t>(face), edge_vertex(previous)},
          level_.mesh.surface_of_face[face]);
    }
  }

  void cut_triangle(std::size_t face) {
    const std::uint32_t begin = level_.mesh.face_offsets[face];
    const auto corners = level_.mesh.face(face);
    const std::array middles = {edge_vertex(begin), edge_vertex(begin + 1), edge_vertex(begin + 2)};
    const std::uint32_t surface = level_.mesh.surface_of_face[face];
    for (std::size_t k = 0; k < 3; ++k) {
      next_.mesh.add_face(std::array{corners[k], middles[k], middles[(k + 2) % 3]}, surface);
    }
    next_.mesh.add_face(middles, surface);
  }

  const Level& level_;
  SubdivisionScheme scheme_;
  grf::SharedEdges edges_;
  std::uint32_t first_of_edges_;
  std::uint32_t first_of_faces_;
  Level next_;
};

/// Fills in attributes that only some vertices have by their defaults: texture coordinates (0, 0), colour 1.
template <class Value>
void fill(grf::OptionalVertexValues<Value>& values, std::size_t vertices, const Value& absent) {
  if (values.empty()) return;
  for (std::size_t i = 0; i < vertices; ++i) {
    if (!values.has(i)) values.set(i, absent);
  }
}

Level first_level(const grf::Mesh& mesh, SubdivisionScheme scheme) {
  grf::MeshDraft bare(mesh);
  bare.irradiance = {};
  fill(bare.uvs, bare.positions.size(), grf::Vec2f(0));
  fill(bare.colours, bare.positions.size(), grf::Colour(1));
  const grf::Mesh flat = with_flat_faces(std::move(bare));
  const grf::Mesh whole = scheme == SubdivisionScheme::Loop ? triangulated(flat) : flat;
  const grf::Geometry& geometry = *whole.geometry;
  return {grf::MeshDraft(whole), grf::first_at_position(geometry),
          first_with_value(geometry, &grf::Geometry::uvs),
          first_with_value(geometry, &grf::Geometry::colours)};
}

}  // namespace

double faces_after(const grf::Mesh& mesh, const Subdivision& subdivision) {
  if (subdivision.levels == 0) return static_cast<double>(mesh.face_count());
  const bool is_loop = subdivision.scheme == SubdivisionScheme::Loop;
  const auto first =
      static_cast<double>(is_loop ? 4 * mesh.geometry->triangle_count() : mesh.geometry->corners.size());
  return first * std::pow(4, subdivision.levels - 1);
}

grf::Mesh subdivided(const grf::Mesh& mesh, const Subdivision& subdivision) {
  if (subdivision.levels == 0) return mesh;
  Level level = first_level(mesh, subdivision.scheme);
  for (int i = 0; i < subdivision.levels; ++i) level = Refinement(level, subdivision.scheme).run();
  level.mesh.name = mesh.name;
  level.mesh.comments = mesh.comments;
  level.mesh.free_spare_memory();
  const bool has_normals = !mesh.geometry->normals.empty();
  const grf::Mesh result = std::move(level.mesh);
  return has_normals ? with_smooth_normals(result, std::numbers::pi) : result;
}

}  // namespace convert
