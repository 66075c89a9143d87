// A scene as writers need it whose format has neither transforms nor instances: meshes that stand in the
// world.
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
#include "converters/scene_parts.h"
#include "grf/math.h"
#include "grf/scene.h"
#include "grf/visit.h"

namespace convert {

/// Looks up the BRDFs that the terms of a `combine` name; null where a name is no BRDF, empty for other
/// models.
std::vector<const grf::BrdfModel*> named_brdfs(const grf::BrdfModel& brdf, const grf::Scope& scope);

/// A surface of a mesh with its references looked up. Pointers are into the scene; what is null or absent was
/// not given.
struct WorldSurface {
  std::optional<grf::Colour> colour;
  const grf::BrdfModel* brdf = nullptr;
  std::vector<const grf::BrdfModel*> terms;  ///< of a `combine`: what its names mean where the mesh stands
  const grf::PdfModel* pdf = nullptr;
  const grf::Texture* texture = nullptr;
  std::optional<grf::Colour> emission;  ///< radiance from the front, W/(sr m2)
  std::optional<std::size_t>
      material;           ///< among the materials of `WorldMeshes`; none if the BRDF has no name
  std::size_t faces = 0;  ///< how many have it
};

/// A mesh at a place. Nothing of it is copied: positions and normals are moved as they are asked for.
class WorldMesh {
 public:
  WorldMesh(const grf::Mesh& mesh, const grf::Matrix44d& to_world, bool is_light);

  /// What does not depend on the place: indices, uvs, colours and irradiance.
  const grf::Mesh& mesh() const { return *mesh_; }
  /// True of a light, which only emits: its surfaces have an emission, and nothing else.
  bool is_light() const { return is_light_; }
  /// Its own name, or that of the definition which a `use` places; may be empty.
  const std::string& name() const { return name_; }

  /// Computed in double, then rounded; where nothing moves the mesh, the very bits.
  grf::Vec3f position(std::size_t vertex) const;
  /// Of a vertex that has one; of unit length, except where nothing turns the mesh: then the very bits.
  grf::Vec3f normal(std::size_t vertex) const;
  /// The corners of a face, counter-clockwise seen from its front: turned round where the mesh is mirrored,
  /// beginning with the same corner. They hold until the function is called again.
  std::span<const std::uint32_t> face(std::size_t index) const;

  /// One for each of the mesh's surfaces.
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

/// All meshes of a scene, instances and lights too, in order. The scene outlives this.
class WorldMeshes {
 public:
  explicit WorldMeshes(const grf::Scene& scene);
  WorldMeshes(const WorldMeshes&) = delete;  // meshes point into it
  WorldMeshes& operator=(const WorldMeshes&) = delete;

  const std::vector<WorldMesh>& meshes() const { return meshes_; }

  /// The names of the BRDFs that faces have by name, in the order in which faces come to have them. They are
  /// different; where two definitions have one name, the second is called `name_2`.
  const std::vector<std::string>& materials() const { return materials_; }

  /// False if a transform moves a vertex, or stretches a normal, beyond what a float can hold.
  bool is_finite() const;

  /// Counts of the given kinds what the meshes have, lights left out: for a writer that cannot keep them.
  void count(std::initializer_list<Loss> kinds, Losses& losses) const;

 private:
  void add(const grf::Mesh& mesh, const grf::Placement& placement);
  void add_light(const grf::Mesh& mesh, const grf::Placement& placement);
  std::size_t material_of(const grf::Definition& definition);

  std::vector<WorldMesh> meshes_;
  std::deque<grf::Mesh> parallelograms_;  // of `light` blocks; others are the scene's
  DefinitionNames names_;
  std::map<const grf::Definition*, std::size_t> material_of_definition_;
  std::vector<std::string> materials_;
};

}  // namespace convert
