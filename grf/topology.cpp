#include "grf/topology.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace grf {
namespace {

/// Counts the sets that corners belong to.
std::size_t count_sets(DisjointSets& sets, const std::vector<std::uint32_t>& corners) {
  std::vector<std::uint32_t> all;
  all.reserve(corners.size());
  for (const std::uint32_t corner : corners) all.push_back(sets.set_of(corner));
  std::sort(all.begin(), all.end());
  return static_cast<std::size_t>(std::unique(all.begin(), all.end()) - all.begin());
}

/// Returns the place of a vertex; without places, each vertex has its own.
std::uint32_t place_of(std::span<const std::uint32_t> places, std::uint32_t vertex) {
  return places.empty() ? vertex : places[vertex];
}

/// Calls a function for each half-edge that has a length, in the order of faces and their corners.
template <class Action>
void for_each_face_edge(const Geometry& geometry, std::span<const std::uint32_t> places,
                        const Action& action) {
  for (std::uint32_t face = 0; face < geometry.face_count(); ++face) {
    const auto corners = geometry.face(face);
    for (std::uint32_t k = 0; k < corners.size(); ++k) {
      const std::uint64_t a = place_of(places, corners[k]);
      const std::uint64_t b = place_of(places, corners[(k + 1) % corners.size()]);
      if (a == b) continue;
      action(HalfEdge{std::min(a, b) << 32U | std::max(a, b), face, geometry.face_offsets[face] + k});
    }
  }
}

}  // namespace

std::vector<std::uint32_t> first_at_position(const Geometry& geometry) {
  struct Hash {
    std::size_t operator()(const Vec3f& v) const {
      const std::hash<float> hash;
      return hash(v.x + 0.0F) ^ (hash(v.y + 0.0F) * 31) ^ (hash(v.z + 0.0F) * 1009);
    }
  };
  std::unordered_map<Vec3f, std::uint32_t, Hash> places;
  places.reserve(geometry.positions.size());
  std::vector<std::uint32_t> first;
  first.reserve(geometry.positions.size());
  for (std::uint32_t i = 0; i < geometry.positions.size(); ++i) {
    first.push_back(places.emplace(geometry.positions[i], i).first->second);
  }
  return first;
}

std::vector<HalfEdge> half_edges_of(const Geometry& geometry, std::span<const std::uint32_t> places) {
  // A bucket sort by the lower place takes linear time, and leaves few to be sorted in each bucket.
  const auto lower_place = [](const HalfEdge& edge) { return static_cast<std::size_t>(edge.places >> 32U); };
  std::vector<std::size_t> ends(geometry.positions.size() + 1);
  for_each_face_edge(geometry, places, [&](const HalfEdge& edge) { ++ends[lower_place(edge) + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<HalfEdge> edges(ends.back());
  for_each_face_edge(geometry, places,
                     [&](const HalfEdge& edge) { edges[ends[lower_place(edge)]++] = edge; });
  auto begin = edges.begin();
  for (std::size_t place = 0; place + 1 < ends.size(); ++place) {
    const auto end = edges.begin() + static_cast<std::ptrdiff_t>(ends[place]);
    std::sort(begin, end, [](const HalfEdge& a, const HalfEdge& b) {
      return std::tie(a.places, a.corner) < std::tie(b.places, b.corner);
    });
    begin = end;
  }
  return edges;
}

void for_each_edge(std::span<const HalfEdge> edges,
                   const std::function<void(std::span<const HalfEdge> of_faces)>& action) {
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t last = first;
    while (last < edges.size() && edges[last].places == edges[first].places) ++last;
    action(edges.subspan(first, last - first));
    first = last;
  }
}

SharedEdges::SharedEdges(const Geometry& geometry, std::span<const std::uint32_t> places)
    : edges_(half_edges_of(geometry, places)), edge_of_corner_(geometry.corners.size(), InvalidIndex) {
  std::uint32_t first = 0;
  for_each_edge(edges_, [&](std::span<const HalfEdge> of_faces) {
    for (const HalfEdge& edge : of_faces) edge_of_corner_[edge.corner] = edge_count();
    first_.push_back(first);
    first += static_cast<std::uint32_t>(of_faces.size());
  });
}

std::uint32_t end_corner(const Geometry& geometry, const HalfEdge& edge) {
  const std::uint32_t next = edge.corner + 1;
  return next == geometry.face_offsets[edge.face + 1] ? geometry.face_offsets[edge.face] : next;
}

void join_at_edge(DisjointSets& corners, const Geometry& geometry, std::span<const std::uint32_t> places,
                  const HalfEdge& a, const HalfEdge& b) {
  const bool is_alike =
      place_of(places, geometry.corners[a.corner]) == place_of(places, geometry.corners[b.corner]);
  const std::uint32_t end_a = end_corner(geometry, a);
  const std::uint32_t end_b = end_corner(geometry, b);
  corners.join(a.corner, is_alike ? b.corner : end_b);
  corners.join(end_a, is_alike ? end_b : b.corner);
}

std::vector<bool> split_vertices(const Geometry& geometry, std::span<const std::uint32_t> places,
                                 DisjointSets& fans) {
  constexpr std::uint32_t InvalidIndex = ~0U;
  std::vector<std::uint32_t> fan_at(geometry.positions.size(), InvalidIndex);
  std::vector<bool> are_split(geometry.positions.size());
  for (std::uint32_t corner = 0; corner < geometry.corners.size(); ++corner) {
    const std::uint32_t place = place_of(places, geometry.corners[corner]);
    const std::uint32_t fan = fans.set_of(corner);
    if (fan_at[place] == InvalidIndex) fan_at[place] = fan;
    if (fan_at[place] != fan) are_split[place] = true;
  }
  return are_split;
}

Topology topology_of(const Geometry& geometry) {
  const std::vector<std::uint32_t> places = first_at_position(geometry);
  const std::vector<HalfEdge> edges = half_edges_of(geometry, places);
  Topology topology;
  DisjointSets fans(geometry.corners.size());
  std::vector<bool> at_nonmanifold_edge(geometry.positions.size());
  std::vector<HalfEdge> boundary;
  for_each_edge(edges, [&](std::span<const HalfEdge> of_faces) {
    if (of_faces.size() == 1) boundary.push_back(of_faces.front());
    if (of_faces.size() > 2) {
      ++topology.nonmanifold_edges;
      at_nonmanifold_edge[of_faces.front().places >> 32U] = true;
      at_nonmanifold_edge[of_faces.front().places & 0xFFFFFFFFU] = true;
    }
    for (const HalfEdge& other : of_faces.subspan(1)) {
      join_at_edge(fans, geometry, places, of_faces.front(), other);
    }
  });
  topology.boundary_edges = boundary.size();
  const std::vector<bool> are_split = split_vertices(geometry, places, fans);
  for (std::size_t i = 0; i < are_split.size(); ++i) {
    if (are_split[i] && !at_nonmanifold_edge[i]) ++topology.nonmanifold_vertices;
  }
  std::vector<std::uint32_t> begins;
  for (const HalfEdge& edge : boundary) {
    fans.join(edge.corner, end_corner(geometry, edge));
    begins.push_back(edge.corner);
  }
  topology.boundary_loops = count_sets(fans, begins);
  return topology;
}

}  // namespace grf
