// What a plan knows of a scene: its surfaces, and roughly where they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "grf/scene.h"
#include "grf/visit.h"
#include "renderer/transport/scene/geometry.h"

namespace transport {

/// What faces of a mesh share, where the mesh stands.
struct OutlineSurface {
  const grf::Mesh* mesh = nullptr;  ///< null: a light
  std::uint32_t index = 0;          ///< in the mesh's list
  std::size_t faces = 0;            ///< of all places together
  bool emits = false;
  /// What the BRDF is made of; a black face has none of it.
  bool is_diffuse = false, is_glossy = false, is_mirror = false;
  bool is_anisotropic = false;
  bool is_measured = false;
  bool has_irradiance = false;
  bool is_smooth = false;    ///< some face's vertices have normals other than its own
  bool has_colours = false;  ///< some vertex of the mesh has one that is not white
  std::string texture;       ///< path; empty: none
  std::string brdf, scheme;  ///< as a scene writes them; empty without a BRDF
  std::string identity;      ///< what the BRDF's text means there, see BrdfMaker; empty: GRF's default

  bool reflects() const { return is_diffuse || is_glossy || is_mirror; }
  bool is_matte() const { return is_diffuse && !is_glossy && !is_mirror; }
};

/// A triangle, a parallelogram, or a box around faces: in the coordinates of the compiled scene.
struct OutlinePart {
  std::uint32_t surface = 0;  ///< of Outline::surfaces
  std::uint32_t first_point = 0;
  std::uint32_t points = 0;
  bool is_smooth = false;             ///< its vertices have normals other than its own
  grf::Vec3d normal = grf::Vec3d(0);  ///< unit, on the front; 0: of a box, or of what has no area
  double height = 0;                  ///< of its plane, along the normal
  std::uint32_t solid = None;         ///< of Outline::solids, of which it is a face
  double extent = 0;                  ///< its largest coordinate

  bool is_plane() const { return normal != grf::Vec3d(0); }
};

/// Parts that enclose a convex solid, their fronts outwards.
struct OutlineSolid {
  std::uint32_t first_part = 0;
  std::uint32_t parts = 0;
};

/// What rounding can do to a point, as a share of its largest coordinate. Rays start from surfaces at more
/// than twice that.
constexpr double OutlineRounding = 0x1p-21;

struct Outline {
  /// Does not read a file that the scene names. A mesh that is placed more than once may be an instance, see
  /// CompileSettings.
  Outline(const grf::Scene& scene, std::size_t most_copied_triangles);

  std::vector<OutlineSurface> surfaces;
  /// Empty if the scene is so large that it would take long to look at each part.
  std::vector<OutlinePart> parts;
  std::vector<OutlineSolid> solids;
  std::vector<grf::Vec3d> points;
  grf::Vec3d origin = grf::Vec3d(0);  ///< what was subtracted from the world's coordinates
  grf::Box3d bounds;                  ///< in the world, as CompiledScene::bounds
  std::size_t triangles = 0;          ///< each instance counted
  std::size_t instances = 0;          ///< of shared meshes
};

}  // namespace transport
