#include "converters/mesh_operations/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "converters/mesh_operations/rebuild.h"
#include "grf/topology.h"

namespace convert {
namespace {

/// A hash grid of the vertices that stay, none closer to another than a distance, with cells of twice that
/// size: neighbours of a point are in one of eight cells.
class Grid {
 public:
  Grid(const grf::Mesh& mesh, double distance) : mesh_(mesh), distance_(distance) {}

  /// Returns the nearest vertex that stays, if it is within the distance; else adds this one.
  std::uint32_t nearest_or_add(std::uint32_t vertex) {
    const grf::Vec3d position(mesh_.geometry->positions[vertex]);
    const grf::Vec3d scaled = position / (2 * distance_);
    const Cell own = {std::floor(scaled.x), std::floor(scaled.y), std::floor(scaled.z)};
    std::uint32_t nearest = vertex;
    double least2 = distance_ * distance_;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const auto vertices = cells_.find(neighbour(own, scaled, corner));
      if (vertices == cells_.end()) continue;
      for (const std::uint32_t other : vertices->second) {
        const double distance2 = (grf::Vec3d(mesh_.geometry->positions[other]) - position).length2();
        if (distance2 >= least2) continue;
        least2 = distance2;
        nearest = other;
      }
    }
    if (nearest == vertex) cells_[own].push_back(vertex);
    return nearest;
  }

 private:
  using Cell = std::array<double, 3>;  // integral values, which can overflow an integer
  struct CellHash {
    std::size_t operator()(const Cell& cell) const {
      const std::hash<double> hash;
      return (hash(cell[0]) * 31 + hash(cell[1])) * 1009 + hash(cell[2]);
    }
  };

  /// Returns one of the eight cells: along each axis the own one, or the neighbour nearer to the point.
  static Cell neighbour(const Cell& own, const grf::Vec3d& scaled, unsigned corner) {
    Cell cell = own;
    for (unsigned axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1U) == 0) continue;
      cell[axis] += scaled[static_cast<int>(axis)] - own[axis] < 0.5 ? -1 : 1;
    }
    return cell;
  }

  const grf::Mesh& mesh_;
  double distance_;
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
};

/// Returns, for each vertex, the one whose position it gets.
std::vector<std::uint32_t> places_after_welding(const grf::Mesh& mesh, double distance) {
  std::vector<std::uint32_t> places = grf::first_at_position(*mesh.geometry);
  if (distance <= 0) return places;
  Grid grid(mesh, distance);
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    places[i] = places[i] == i ? grid.nearest_or_add(i) : places[places[i]];
  }
  return places;
}

/// Removes corners at the position of the previous one.
void drop_repeated(std::vector<std::uint32_t>& corners, const std::vector<std::uint32_t>& places) {
  const auto same_place = [&](std::uint32_t a, std::uint32_t b) { return places[a] == places[b]; };
  corners.erase(std::unique(corners.begin(), corners.end(), same_place), corners.end());
  while (corners.size() > 1 && same_place(corners.front(), corners.back())) corners.pop_back();
}

std::size_t different_places(const std::vector<std::uint32_t>& corners,
                             const std::vector<std::uint32_t>& places) {
  std::set<std::uint32_t> different;
  for (const std::uint32_t corner : corners) different.insert(places[corner]);
  return different.size();
}

}  // namespace

Welded weld(const grf::Mesh& mesh, double distance) {
  const std::vector<std::uint32_t> places = places_after_welding(mesh, distance);
  grf::MeshDraft draft(mesh);
  for (std::uint32_t i = 0; i < places.size(); ++i) draft.positions[i] = mesh.geometry->positions[places[i]];
  const grf::Mesh moved(std::move(draft));
  const std::vector<std::uint32_t> alike = first_equal_vertex(moved);
  Welded welded;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (places[i] != i || alike[i] != i) ++welded.merged_vertices;
  }
  Rebuild rebuild(moved);
  std::vector<std::uint32_t> corners;
  for (std::size_t face = 0; face < moved.face_count(); ++face) {
    corners.clear();
    for (const std::uint32_t corner : moved.face(face)) corners.push_back(alike[corner]);
    drop_repeated(corners, places);
    if (corners.size() < 3 || (corners.size() > 3 && different_places(corners, places) < 3)) {
      ++welded.collapsed_faces;
    } else {
      rebuild.add_face(corners, (*moved.surface_of_face)[face]);
    }
  }
  welded.mesh = rebuild.take();
  return welded;
}

}  // namespace convert
