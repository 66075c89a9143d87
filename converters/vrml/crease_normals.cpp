#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "converters/vrml/polygons.h"

namespace convert::vrml {
namespace {

/// Where more faces meet in one edge, each is compared with so many others at most: a file could make all of
/// its faces meet in one.
constexpr std::size_t MostComparisons = 8;

/// An edge as one face has it.
struct Edge {
  std::uint64_t vertices;    // the smaller index in the upper half
  std::uint32_t at_smaller;  // the face's corners at the two ends
  std::uint32_t at_larger;
  std::uint32_t face;
};

/// Sets of corners, joined two by two.
class Sets {
 public:
  explicit Sets(std::size_t count) : parents_(count) {
    for (std::size_t i = 0; i < count; ++i) parents_[i] = static_cast<std::uint32_t>(i);
  }
  std::uint32_t of(std::uint32_t member) {
    while (parents_[member] != member) {
      parents_[member] = parents_[parents_[member]];
      member = parents_[member];
    }
    return member;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a);
    b = of(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parents_;
};

class CreaseNormals {
 public:
  CreaseNormals(const Polygons& polygons, double crease_angle)
      : polygons_(polygons), crease_angle_(crease_angle), sets_(polygons.corners.size()) {}

  std::vector<grf::Vec3f> run() {
    for (std::size_t i = 0; i < polygons_.face_count(); ++i) face_normals_.push_back(face_normal(i));
    join_across_smooth_edges();
    return sums_of_sets();
  }

 private:
  grf::Vec3d position(std::size_t corner) const {
    return grf::Vec3d(polygons_.positions[polygons_.corners[corner]]);
  }
  grf::Vec3d face_normal(std::size_t face) const;
  double angle_at(std::size_t face, std::size_t corner) const;
  std::vector<Edge> sorted_edges() const;
  bool is_smooth(const Edge& a, const Edge& b) const;
  void join_across_smooth_edges();
  std::vector<grf::Vec3f> sums_of_sets();

  const Polygons& polygons_;
  double crease_angle_;
  Sets sets_;
  std::vector<grf::Vec3d> face_normals_;  // unit, or zero of a face without area
};

// Newell's method, of any polygon. Taken from the first corner, so that little is lost far from the origin.
grf::Vec3d CreaseNormals::face_normal(std::size_t face) const {
  grf::Vec3d sum(0);
  const std::size_t begin = polygons_.face_begin(face);
  const grf::Vec3d origin = position(begin);
  for (std::size_t i = begin + 1; i + 1 < polygons_.face_ends[face]; ++i) {
    sum += (position(i) - origin).cross(position(i + 1) - origin);
  }
  return sum.normalized();
}

double CreaseNormals::angle_at(std::size_t face, std::size_t corner) const {
  const std::size_t begin = polygons_.face_begin(face);
  const std::size_t end = polygons_.face_ends[face];
  const grf::Vec3d to_next = position(corner + 1 == end ? begin : corner + 1) - position(corner);
  const grf::Vec3d to_last = position(corner == begin ? end - 1 : corner - 1) - position(corner);
  return std::atan2(to_next.cross(to_last).length(), to_next.dot(to_last));
}

std::vector<Edge> CreaseNormals::sorted_edges() const {
  std::vector<Edge> edges;
  edges.reserve(polygons_.corners.size());
  for (std::size_t face = 0; face < polygons_.face_count(); ++face) {
    const std::size_t begin = polygons_.face_begin(face);
    const std::size_t end = polygons_.face_ends[face];
    for (std::size_t i = begin; i < end; ++i) {
      auto a = static_cast<std::uint32_t>(i);
      auto b = static_cast<std::uint32_t>(i + 1 == end ? begin : i + 1);
      if (polygons_.corners[a] > polygons_.corners[b]) std::swap(a, b);
      const std::uint64_t vertices = std::uint64_t{polygons_.corners[a]} << 32U | polygons_.corners[b];
      if (polygons_.corners[a] != polygons_.corners[b]) {
        edges.push_back({vertices, a, b, static_cast<std::uint32_t>(face)});
      }
    }
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const Edge& a, const Edge& b) { return a.vertices < b.vertices; });
  return edges;
}

bool CreaseNormals::is_smooth(const Edge& a, const Edge& b) const {
  const grf::Vec3d& n = face_normals_[a.face];
  const grf::Vec3d& m = face_normals_[b.face];
  if (n == grf::Vec3d(0) || m == grf::Vec3d(0)) return false;
  return std::atan2(n.cross(m).length(), n.dot(m)) < crease_angle_;
}

void CreaseNormals::join_across_smooth_edges() {
  const std::vector<Edge> edges = sorted_edges();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::size_t last = std::min(edges.size(), i + 1 + MostComparisons);
    for (std::size_t k = i + 1; k < last && edges[k].vertices == edges[i].vertices; ++k) {
      if (!is_smooth(edges[i], edges[k])) continue;
      sets_.join(edges[i].at_smaller, edges[k].at_smaller);
      sets_.join(edges[i].at_larger, edges[k].at_larger);
    }
  }
}

// The normals of the faces are weighted by their angle at the vertex, so that it makes no difference how a
// surface is cut into faces.
std::vector<grf::Vec3f> CreaseNormals::sums_of_sets() {
  std::vector<grf::Vec3d> sums(polygons_.corners.size(), grf::Vec3d(0));
  std::vector<std::uint32_t> sizes(polygons_.corners.size(), 0);
  for (std::size_t face = 0; face < polygons_.face_count(); ++face) {
    for (std::size_t i = polygons_.face_begin(face); i < polygons_.face_ends[face]; ++i) {
      const std::uint32_t set = sets_.of(static_cast<std::uint32_t>(i));
      sums[set] += face_normals_[face] * angle_at(face, i);
      ++sizes[set];
    }
  }
  std::vector<grf::Vec3f> normals(polygons_.corners.size(), grf::Vec3f(0));
  for (std::size_t face = 0; face < polygons_.face_count(); ++face) {
    bool is_smooth_somewhere = false;
    for (std::size_t i = polygons_.face_begin(face); i < polygons_.face_ends[face]; ++i) {
      const std::uint32_t set = sets_.of(static_cast<std::uint32_t>(i));
      is_smooth_somewhere = is_smooth_somewhere || sizes[set] > 1;
    }
    for (std::size_t i = polygons_.face_begin(face); is_smooth_somewhere && i < polygons_.face_ends[face];
         ++i) {
      normals[i] = grf::Vec3f(sums[sets_.of(static_cast<std::uint32_t>(i))].normalized());
    }
  }
  return normals;
}

}  // namespace

void add_crease_normals(Polygons& polygons, double crease_angle) {
  if (!(crease_angle > 0)) return;  // all edges are creases
  // Two faces are never more than half a turn apart, and fold onto each other there.
  const double angle = crease_angle >= std::numbers::pi ? 4.0 : crease_angle;
  std::vector<grf::Vec3f> normals = CreaseNormals(polygons, angle).run();
  const bool has_any = std::any_of(normals.begin(), normals.end(),
                                   [](const grf::Vec3f& normal) { return normal != grf::Vec3f(0); });
  if (has_any) polygons.normals = std::move(normals);
}

}  // namespace convert::vrml
