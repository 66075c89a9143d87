#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "converters/mesh_operations/vertex_normals.h"
#include "converters/vrml/polygons.h"

namespace convert::vrml {

void add_crease_normals(Polygons& polygons, double crease_angle) {
  if (!(crease_angle > 0)) return;  // all edges are creases
  grf::Geometry geometry;
  geometry.positions = polygons.positions;
  geometry.corners = polygons.corners;
  geometry.face_offsets.insert(geometry.face_offsets.end(), polygons.face_ends.begin(),
                               polygons.face_ends.end());
  // The angle between two faces is at most pi, where they fold onto each other.
  const double least_crease = crease_angle >= std::numbers::pi ? 4 : crease_angle;
  CreasedNormals creased = creased_normals(geometry, {}, std::nextafter(least_crease, 0));
  std::vector<std::uint32_t> sizes(geometry.corners.size());
  for (std::uint32_t i = 0; i < sizes.size(); ++i) ++sizes[creased.corners.set_of(i)];
  std::vector<grf::Vec3f> normals(sizes.size(), grf::Vec3f(0));
  bool has_any = false;
  for (std::size_t face = 0; face < geometry.face_count(); ++face) {
    const std::uint32_t end = geometry.face_offsets[face + 1];
    bool is_smooth_somewhere = false;
    for (std::uint32_t i = geometry.face_offsets[face]; i < end; ++i) {
      is_smooth_somewhere = is_smooth_somewhere || sizes[creased.corners.set_of(i)] > 1;
    }
    if (!is_smooth_somewhere) continue;
    for (std::uint32_t i = geometry.face_offsets[face]; i < end; ++i) {
      const auto normal = creased.at(i);
      normals[i] = normal.value_or(grf::Vec3f(0));
      has_any = has_any || normal.has_value();
    }
  }
  if (has_any) polygons.normals = std::move(normals);
}

}  // namespace convert::vrml
