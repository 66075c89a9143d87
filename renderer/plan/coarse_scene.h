// A coarse scene is what the plan of a render works on: surfaces, and roughly where they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "grf/scene.h"
#include "grf/visit.h"
#include "renderer/transport/scene/geometry.h"

namespace plan {

/// A surface, shared by faces of a mesh, as resolved where the mesh is placed.
struct CoarseSurface {
  const grf::Mesh* mesh = nullptr;  ///< null: a light
  /// In the mesh's list of surfaces; of a light, its number in the order in which `grf::visit` comes to them.
  std::uint32_t index = 0;
  std::size_t faces = 0;  ///< over all placements
  bool emits = false;
  /// The components of the BRDF; a black face has none.
  bool is_diffuse = false, is_glossy = false, is_specular = false;
  bool is_glass = false;  ///< it lets light through by its BRDF
  bool is_anisotropic = false;
  bool is_measured = false;
  bool has_irradiance = false;
  bool is_smooth = false;         ///< some face has vertex normals that differ from its own
  bool has_colours = false;       ///< some vertex of the mesh has a colour other than white
  bool is_cutout = false;         ///< it lets light pass, somewhere or in part
  std::string texture;            ///< path; empty: none
  std::vector<std::string> maps;  ///< paths of the images that vary its BRDF
  std::string alpha;              ///< path of the texture whose alpha its opacity reads; empty: none
  std::string brdf, scheme;       ///< as written in the scene; empty without a BRDF
  std::string identity;  ///< identifies the BRDF as resolved there, see BrdfMaker; empty: GRF's default

  bool reads_images() const { return !texture.empty() || !maps.empty(); }
  bool reflects() const { return is_diffuse || is_glossy || is_specular; }
  bool is_only_diffuse() const { return is_diffuse && !is_glossy && !is_specular; }
};

/// A triangle, a parallelogram, or the bounding box of faces, in the coordinates of the compiled scene.
struct CoarsePart {
  std::uint32_t surface = 0;  ///< index into CoarseScene::surfaces
  std::uint32_t first_point = 0;
  std::uint32_t points = 0;
  bool is_smooth = false;                         ///< its vertex normals differ from its own
  grf::Vec3d normal = grf::Vec3d(0);              ///< unit, on the front; 0: a box, or degenerate
  double height = 0;                              ///< distance of its plane from the origin, along the normal
  std::uint32_t solid = transport::InvalidIndex;  ///< index into CoarseScene::solids, of which it is a face
  double extent = 0;                              ///< its largest absolute coordinate

  bool is_plane() const { return normal != grf::Vec3d(0); }
};

/// Parts that enclose a convex solid, with their fronts outwards.
struct CoarseSolid {
  std::uint32_t first_part = 0;
  std::uint32_t parts = 0;
};

/// The rounding error of a point, as a fraction of its largest coordinate. Rays start at more than twice that
/// distance from surfaces.
constexpr double CoarseRounding = 0x1p-21;

struct CoarseScene {
  /// Does not read the files that the scene names. A mesh that is placed more than once may become an
  /// instance, see CompileSettings.
  CoarseScene(const grf::Scene& scene, std::size_t most_copied_triangles);

  std::vector<CoarseSurface> surfaces;
  /// Empty if the scene is too large to inspect each part.
  std::vector<CoarsePart> parts;
  std::vector<CoarseSolid> solids;
  std::vector<grf::Vec3d> points;
  grf::Vec3d origin = grf::Vec3d(0);  ///< subtracted from world coordinates
  grf::Box3d bounds;                  ///< in world space, as CompiledScene::bounds
  std::size_t triangles = 0;          ///< each instance counted
  std::size_t instances = 0;          ///< of shared meshes
};

}  // namespace plan
