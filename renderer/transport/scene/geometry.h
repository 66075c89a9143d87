// The arrays of a compiled scene: meshes of triangles, and where they are placed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "grf/math.h"

namespace transport {

using grf::Colour;
using grf::Vec2f;
using grf::Vec3f;

constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

/// A triangle of the scene: one of an instance's mesh.
struct TriangleId {
  std::uint32_t instance = None;
  std::uint32_t triangle = None;

  bool operator==(const TriangleId&) const = default;
};

/// All that is known of a triangle alone, in the 16 bytes that a hit has to fetch for it.
struct Triangle {
  std::array<std::uint32_t, 3> corners = {};
  std::uint32_t surface : 31 = 0;  ///< counted from the first one of the instance
  std::uint32_t is_flat : 1 = 1;   ///< shaded with its own normal and not with its corners'
};
static_assert(sizeof(Triangle) == 16);

/// Triangles that emit, one after the other. Emitting triangles are numbered through the mesh.
struct EmittingRun {
  std::uint32_t first_triangle = 0;
  std::uint32_t first_number = 0;
};

/// Triangles that share vertices. The optional arrays are empty if no vertex has such a value.
struct TriangleMesh {
  std::vector<Vec3f> positions;    ///< with one more at the end that is not used, see RayCaster
  std::vector<Vec3f> normals;      ///< unit, or 0 where a vertex has none
  std::vector<Colour> colours;     ///< 1 where a vertex has none
  std::vector<Vec2f> uvs;          ///< (0,0) where a vertex has none
  std::vector<Colour> irradiance;  ///< W/m2, of all directions together; NaN where a vertex has none
  std::vector<Triangle> triangles;
  std::vector<EmittingRun> emitting_runs;

  /// Which of the emitting triangles one of them is.
  std::uint32_t emitting_number(std::uint32_t triangle) const;
  std::size_t bytes() const;
};

/// A map of points, `p * linear + translation`.
struct AffineMap {
  grf::Matrix33f linear;
  Vec3f translation = Vec3f(0);

  Vec3f point(const Vec3f& p) const { return p * linear + translation; }
  Vec3f vector(const Vec3f& v) const { return v * linear; }
};

/// A mesh as it stands in the scene.
struct Instance {
  explicit Instance(const grf::Matrix44d& matrix);

  AffineMap to_scene;
  /// The inverse transpose: under a map that mirrors, too, fronts stay where they were relative to normals.
  grf::Matrix33f normal_map;
  /// Bounds what rounding does on the way to the instance and back, as `error_factor * (|p| + error_extent)`
  /// along each axis, p being the point in the scene (largest components).
  float error_factor = 0;
  float error_extent = 0;
  std::uint32_t mesh = 0;
  std::uint32_t first_surface = 0;
  /// Where in `Geometry::emitter_table` its mesh's emitting triangles begin.
  std::uint32_t first_emitter = 0;
};

/// What rays meet. What is placed once stands in the first mesh, already where it is in the scene; the first
/// instance is that mesh, and its map is not to be used.
struct Geometry {
  std::vector<TriangleMesh> meshes;
  std::vector<Instance> instances;
  /// The emitter of each emitting triangle of each instance, None for one without area.
  std::vector<std::uint32_t> emitter_table;
  /// The first triangle of each emitter: those of a parallelogram are two in a row.
  std::vector<TriangleId> emitter_triangles;
  /// What was subtracted from the coordinates of the world.
  grf::Vec3d origin = grf::Vec3d(0);
  grf::Box3d bounds;  ///< in the world

  std::size_t bytes() const;
};

/// Whether rays meet the same triangles in both, whatever surfaces these have.
bool have_same_shape(const Geometry& a, const Geometry& b);

}  // namespace transport
