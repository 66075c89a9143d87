// A scene as views and lists of objects need it: each mesh once, where it is placed, and what its faces look
// like with all names looked up. A snapshot, which shares the scene's meshes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "editor/document/change.h"
#include "grf/scene.h"
#include "grf/scene_path.h"

namespace editor {

/// A BRDF that is no sum, with its weight in one.
struct LookTerm {
  float weight = 1;
  grf::BrdfModel brdf;

  bool operator==(const LookTerm&) const = default;
};

/// What faces look like, names looked up.
struct Look {
  grf::Colour colour = grf::Colour(1);
  std::optional<grf::BrdfModel> brdf;  ///< absent: GRF's default
  std::vector<LookTerm> terms;         ///< what a `combine` adds up, through all sums of sums; else empty
  std::string texture;                 ///< path of the image; empty: none
  std::optional<grf::Colour> emission;
};

/// A mesh, or a mesh light, that stands in the scene once, as itself or as a definition. What a file holds
/// that is included at several places stands there as often.
struct MeshObject {
  grf::ScenePath path;
  std::string name;  ///< of the mesh or of its definition; may be empty
  grf::Shared<grf::Mesh> mesh;
  bool is_definition = false;
  bool is_light = false;    ///< a mesh light: its surfaces' colours are radiances
  std::vector<Look> looks;  ///< of each of the mesh's surfaces
};

/// One place at which a mesh stands in the world.
struct MeshInstance {
  std::uint32_t mesh = 0;  ///< index of a MeshObject
  grf::ScenePath path;     ///< of the mesh, or of the `use`
  grf::Matrix44d to_world;
};

struct LightObject {
  grf::ScenePath path;
  grf::AreaLight light;
  grf::Matrix44d to_world;
};

struct ObserverObject {
  grf::ScenePath path;  ///< of the `params`
  std::size_t number = 0;
  grf::Vec3d position;  ///< in the world
};

struct SceneObjects {
  std::vector<MeshObject> meshes;
  grf::Shared<std::vector<MeshInstance>> instances;
  std::vector<LightObject> lights;
  std::vector<ObserverObject> observers;
  grf::Box3d mesh_bounds;     ///< of all instances, in the world; empty if there are none
  grf::Box3d bounds;          ///< of lights too
  std::size_t faces = 0;      ///< of all meshes, each once
  std::size_t triangles = 0;  ///< of all instances, faces cut

  /// The mesh at a path, or nothing.
  std::optional<std::uint32_t> mesh_at(grf::ScenePathView path) const;
};

/// The path is the scene's file, from whose folder it names textures and includes; empty: the current folder.
SceneObjects objects_of(const grf::Scene& scene, const std::string& path);

/// Brings the objects of a scene up to date after a change that is not structural.
void update(SceneObjects& objects, const grf::Scene& scene, const std::string& path, const Change& change);

}  // namespace editor
