#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "grf/scene.h"
#include "renderer/transport/scene/compiled_scene.h"

namespace transport {

/// How a scene whose irradiance is to be baked is compiled: without instances, so that each mesh has vertices
/// of its own wherever it is placed.
CompileSettings without_instances(CompileSettings settings);

/// The vertices of a scene's meshes, without those of lights: mesh after mesh, in the order of `grf::visit`,
/// once for each place.
///
/// What arrives at a vertex is taken from the faces around it, each in proportion to its angle there. A
/// vertex lies on the edge of its faces, where other faces may touch them, as walls do in a room's corner: so
/// the point on a face is a thousandth of the way from the vertex to the middle of the triangle, or as much
/// more as rounding errors call for. It is one as paths meet it, with the interpolated normal if all corners
/// have one, else with the face's own.
///
/// Where another body stands on a face, or is sunk into it, the dark below must not be interpolated with the
/// light beside it: a triangle whose point is covered does not count, and if that are all triangles around a
/// vertex, their points move towards the opposite edges until they are out in the open. A point is covered if
/// whatever looks up from it, steeply and at a low angle to all sides, meets the back of a surface, or the
/// underside of one that all but touches it. Where nothing of the triangles is open, they count as they are.
class BakePoints {
 public:
  /// `compiled` is the scene, without instances, and must outlive this.
  BakePoints(const grf::Scene& scene, const CompiledScene& compiled, int threads = 0);

  std::size_t count() const { return vertices_.size(); }
  /// Whether a vertex has a face with area around it.
  bool has_faces(std::size_t vertex) const { return !corners_of(vertex).empty(); }

  struct Point {
    SurfacePoint point;
    float share_end = 1;  ///< of the angles around the vertex: those of this point and of those before it
  };
  /// Replaces `points` by those of a vertex, one for each triangle.
  void points_at(std::size_t vertex, std::vector<Point>& points) const;

  /// The mean of the shading normals around a vertex that has faces, by their angles.
  static Vec3f normal_of(std::span<const Point> points);

 private:
  static constexpr float Start = 1e-3F;

  struct Corner {
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;
    float angle = 0;    ///< 0 for one that does not count
    float way = Start;  ///< of the point, from the vertex to the middle of the triangle
  };

  void list_vertices(const grf::Scene& scene);
  void list_corners();
  void uncover(std::size_t vertex);
  SurfacePoint point_at(const Corner& corner) const;
  bool is_covered(const Corner& corner) const;
  float way_out(Corner corner) const;
  std::span<const Corner> corners_of(std::size_t vertex) const {
    const std::size_t index = vertices_[vertex];
    return std::span(corners_).subspan(first_corner_[index], first_corner_[index + 1] - first_corner_[index]);
  }

  const CompiledScene& compiled_;
  std::vector<std::uint32_t> vertices_;  ///< by their numbers in the compiled scene's one mesh
  std::vector<Corner> corners_;          ///< of all vertices of that mesh, one after the other
  std::vector<std::uint32_t> first_corner_;
};

}  // namespace transport
