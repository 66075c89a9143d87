// A compiled scene has arrays of triangle meshes, and of their instances.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/math.h"

namespace transport {

using grf::Colour;
using grf::Vec2f;
using grf::Vec3f;

constexpr std::uint32_t InvalidIndex = std::numeric_limits<std::uint32_t>::max();

/// A triangle of the scene: an instance, and a triangle of its mesh.
struct TriangleId {
  std::uint32_t instance = InvalidIndex;
  std::uint32_t triangle = InvalidIndex;

  bool operator==(const TriangleId&) const = default;
};

/// A triangle's own data, in the 16 bytes that a hit has to fetch for it.
struct Triangle {
  std::array<std::uint32_t, 3> corners = {};
  std::uint32_t surface : 31 = 0;  ///< relative to the first surface of the instance
  std::uint32_t is_flat : 1 = 1;   ///< shaded with its geometric normal, not with vertex normals
};
static_assert(sizeof(Triangle) == 16);

/// A run of consecutive emitting triangles. Emitting triangles are numbered through the mesh.
struct EmittingRun {
  std::uint32_t first_triangle = 0;
  std::uint32_t first_number = 0;
};

/// Triangles with shared vertices. An optional array is empty if no vertex has such a value.
struct TriangleMesh {
  std::vector<Vec3f> positions;    ///< with an unused one at the end, see RayCaster
  std::vector<Vec3f> normals;      ///< unit, or 0 where a vertex has none
  std::vector<Colour> colours;     ///< 1 where a vertex has none
  std::vector<Vec2f> uvs;          ///< (0,0) where a vertex has none
  std::vector<Colour> irradiance;  ///< W/m2, over all directions; NaN where a vertex has none
  std::vector<Triangle> triangles;
  std::vector<EmittingRun> emitting_runs;
  bool has_cutouts = false;  ///< some triangle is not opaque

  /// The number of an emitting triangle among the mesh's emitting triangles.
  std::uint32_t emitting_number(std::uint32_t triangle) const;
  std::size_t bytes() const;
};

/// An affine map of points, `p * linear + translation`.
struct AffineMap {
  grf::Matrix33f linear;
  Vec3f translation = Vec3f(0);

  Vec3f point(const Vec3f& p) const { return p * linear + translation; }
  Vec3f vector(const Vec3f& v) const { return v * linear; }
};

/// A placement of a mesh in the scene.
struct Instance {
  explicit Instance(const grf::Matrix44d& matrix);

  AffineMap to_scene;
  /// The inverse transpose, which keeps fronts on the same side of normals even under a reflection.
  grf::Matrix33f normal_map;
  /// Bounds the rounding error of mapping to the instance and back by `error_factor * (|p| + error_extent)`
  /// along each axis, where p is the point in the scene (largest components).
  float error_factor = 0;
  float error_extent = 0;
  std::uint32_t mesh = 0;
  std::uint32_t first_surface = 0;
  /// The index into `Geometry::emitter_table` where the emitting triangles of its mesh begin.
  std::uint32_t first_emitter = 0;
};

/// A lamp: an area light, a mesh light, or the emitting faces of a mesh, where it is placed.
struct Lamp {
  std::uint32_t first_emitter = 0;  ///< its emitters end where those of the next lamp begin
  std::string name;                 ///< of the mesh; may be empty
  bool is_area_light = false;
  /// Its place among the area lights, or among the meshes and mesh lights, of the scene, as grf::visit meets
  /// them.
  std::uint32_t number = 0;
  grf::SourceLocation location;
};

/// The geometry that rays can hit. Meshes that are placed once are merged into the first mesh, in scene
/// coordinates; the first instance is that mesh, and its map is unused.
struct Geometry {
  std::vector<TriangleMesh> meshes;
  std::vector<Instance> instances;
  /// The emitter of each emitting triangle of each instance; InvalidIndex for a degenerate one.
  std::vector<std::uint32_t> emitter_table;
  /// The first triangle of each emitter; a parallelogram has two in a row.
  std::vector<TriangleId> emitter_triangles;
  std::vector<Lamp> lamps;
  /// Subtracted from world coordinates.
  grf::Vec3d origin = grf::Vec3d(0);
  grf::Box3d bounds;  ///< in world space

  std::size_t bytes() const;
};

/// Whether rays hit the same triangles in both, whatever their surfaces, and the same meshes have cut-outs.
bool have_same_shape(const Geometry& a, const Geometry& b);

}  // namespace transport
