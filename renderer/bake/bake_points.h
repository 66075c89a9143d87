#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "grf/scene.h"
#include "renderer/transport/scene/compiled_scene.h"

namespace bake {

/// Returns settings that compile a scene for baking irradiance: without instances, so that each mesh has its
/// own vertices wherever it is placed.
transport::CompileSettings without_instances(transport::CompileSettings settings);

/// The vertices of a scene's meshes, lights excepted: mesh by mesh in the order of `grf::visit`, once per
/// placement.
///
/// The irradiance at a vertex is gathered over the faces around it, each weighted by its angle there. A
/// vertex lies on the edge of its faces, where other faces may touch them, such as the walls in a room's
/// corner: so the point on a face is a thousandth of the way from the vertex to the triangle's centroid, or
/// more if rounding errors require it. It has the interpolated normal if all corners have normals, else the
/// face's own.
///
/// Where another body stands on a face, or is sunk into it, the dark below it must not be interpolated with
/// the light beside it. So a triangle whose point is covered does not count, and if all triangles around a
/// vertex are covered, their points move towards the opposite edges until they are unoccluded. A point is
/// covered if all rays that leave it, steep ones and grazing ones to all sides, hit the back of a surface, or
/// the underside of one that almost touches it. If no point of the triangles is open, they count as they are.
class BakePoints {
 public:
  /// `compiled` is the same scene, without instances, and must outlive this.
  BakePoints(const grf::Scene& scene, const transport::CompiledScene& compiled, int threads = 0);

  std::size_t count() const { return vertices_.size(); }
  /// Whether a vertex has an adjacent face with area.
  bool has_faces(std::size_t vertex) const { return !corners_of(vertex).empty(); }

  struct Point {
    transport::SurfacePoint point;
    float cumulative_fraction = 1;  ///< cumulative fraction of the angles, this point included
  };
  /// Replaces `points` with those of a vertex, one per triangle.
  void points_at(std::size_t vertex, std::vector<Point>& points) const;

  /// The angle-weighted mean of the shading normals around a vertex that has faces.
  static grf::Vec3f normal_of(std::span<const Point> points);

 private:
  static constexpr float Start = 1e-3F;

  struct Corner {
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;
    float angle = 0;         ///< 0: excluded
    float fraction = Start;  ///< fraction of the way from the vertex to the triangle's centroid
  };

  void list_vertices(const grf::Scene& scene);
  void list_corners();
  void uncover(std::size_t vertex);
  transport::SurfacePoint point_at(const Corner& corner) const;
  bool is_covered(const Corner& corner) const;
  float uncovered_fraction(Corner corner) const;
  std::span<const Corner> corners_of(std::size_t vertex) const {
    const std::size_t index = vertices_[vertex];
    return std::span(corners_).subspan(first_corner_[index], first_corner_[index + 1] - first_corner_[index]);
  }

  const transport::CompiledScene& compiled_;
  std::vector<std::uint32_t> vertices_;  ///< indices into the vertices of the compiled scene's only mesh
  std::vector<Corner> corners_;          ///< of all vertices of that mesh, consecutively
  std::vector<std::uint32_t> first_corner_;
};

}  // namespace bake
