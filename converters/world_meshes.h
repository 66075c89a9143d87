// The meshes of a scene are transformed to world space, for formats without transforms and instances.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "converters/losses.h"
#include "converters/scene_building.h"
#include "grf/math.h"
#include "grf/scene.h"
#include "grf/visit.h"

namespace convert {

/// Looks up the BRDFs of the terms of a `combine`; null if a name is no BRDF, empty for other models.
std::vector<const grf::BrdfModel*> named_brdfs(const grf::BrdfModel& brdf, const grf::Scope& scope);

/// A surface of a mesh with its references resolved. Pointers are into the scene; null or absent attributes
/// were not given.
struct WorldSurface {
  std::optional<grf::Colour> colour;
  const grf::BrdfModel* brdf = nullptr;
  std::vector<const grf::BrdfModel*> terms;  ///< the terms of a `combine`, resolved in the scope of the mesh
  const grf::PdfModel* pdf = nullptr;
  const grf::Texture* texture = nullptr;
  std::optional<grf::Colour> emission;  ///< radiance from the front, W/(sr m2)
  grf::Opacity opacity;
  std::optional<std::size_t>
      material;           ///< index into the materials of `WorldMeshes`; none if the BRDF has no name
  std::size_t faces = 0;  ///< number of faces with this surface
};

/// An instance of a mesh in world space. Nothing is copied: positions and normals are transformed on access.
class WorldMesh {
 public:
  WorldMesh(const grf::Mesh& mesh, const grf::Matrix44d& to_world, bool is_light);

  /// Returns the mesh, for data that no transform changes: indices, uvs, colours and irradiance.
  const grf::Mesh& mesh() const { return *mesh_; }
  /// Returns true for a light, which only emits: its surfaces have only an emission.
  bool is_light() const { return is_light_; }
  /// Returns the mesh's own name, or that of the definition it is an instance of; may be empty.
  const std::string& name() const { return name_; }

  /// Returns a world-space position, computed in double, then rounded; exact bits if no transform moves it.
  grf::Vec3f position(std::size_t vertex) const;
  /// Returns the world-space normal of a vertex that has one; unit length, but exact bits if nothing rotates
  /// it.
  grf::Vec3f normal(std::size_t vertex) const;
  /// Returns the corners of a face, counter-clockwise seen from its front: the winding is reversed if the
  /// transform mirrors, beginning with the same corner. Valid until the next call.
  std::span<const std::uint32_t> face(std::size_t index) const;

  /// Returns a resolved surface per surface of the mesh.
  const std::vector<WorldSurface>& surfaces() const { return surfaces_; }
  const WorldSurface& surface(std::size_t face) const { return surfaces_[(*mesh_->surface_of_face)[face]]; }

 private:
  friend class WorldMeshes;

  const grf::Mesh* mesh_;
  grf::Matrix44d to_world_;
  grf::Matrix44d normals_to_world_;  // the inverse transpose
  bool moves_ = false;
  bool turns_normals_ = false;
  bool mirrors_ = false;
  bool is_light_ = false;
  std::string name_;
  std::vector<WorldSurface> surfaces_;
  mutable std::vector<std::uint32_t> turned_face_;
};

/// All meshes of a scene in world space, including instances and lights, in order. The scene must outlive
/// this.
class WorldMeshes {
 public:
  explicit WorldMeshes(const grf::Scene& scene);
  WorldMeshes(const WorldMeshes&) = delete;  // meshes point into it
  WorldMeshes& operator=(const WorldMeshes&) = delete;

  /// Returns the meshes in the order of the scene.
  const std::vector<WorldMesh>& meshes() const { return meshes_; }

  /// Returns the names of the BRDF definitions that faces use, in the order of first use. They are unique: if
  /// two definitions have one name, the second is called `name_2`.
  const std::vector<std::string>& materials() const { return materials_; }

  /// Returns false if a transformed position or normal overflows a float.
  bool is_finite() const;

  /// Counts losses of the given kinds, except those of lights, for a writer that cannot keep them.
  void count(std::initializer_list<Loss> kinds, Losses& losses) const;

 private:
  void add(const grf::Mesh& mesh, const grf::Placement& placement);
  void add_light(const grf::Mesh& mesh, const grf::Placement& placement);
  std::size_t material_of(const grf::Definition& definition);

  std::vector<WorldMesh> meshes_;
  std::deque<grf::Mesh> parallelograms_;  // meshes of `light` blocks; others are the scene's
  DefinitionNames names_;
  std::map<const grf::Definition*, std::size_t> material_of_definition_;
  std::vector<std::string> materials_;
};

}  // namespace convert
