// The flattened scene graph for views and lists of objects: each mesh once, its instances, and the resolved
// surfaces of its faces. A snapshot, which shares the scene's meshes.
#pragma once

#include <array>
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
struct FlatTerm {
  float weight = 1;
  grf::BrdfModel brdf;
  std::vector<grf::Definition> definitions;  ///< of a layered BRDF: those that it needs

  bool operator==(const FlatTerm&) const = default;
};

/// A surface with all names resolved.
struct FlatSurface {
  grf::Colour colour = grf::Colour(1);
  std::optional<grf::BrdfModel> brdf;  ///< absent for GRF's default
  /// The flattened terms of a `combine`, through nested sums, or a layered BRDF; else empty.
  std::vector<FlatTerm> terms;
  std::string texture;  ///< path of the image, or of that of the BRDF's colour; empty for none
  std::optional<grf::Colour> emission;
  grf::Opacity opacity;  ///< reads alpha only if there is a texture
};

/// A mesh or mesh light of the scene, inline or as a definition. A file that is included at several places
/// contributes its meshes once per place.
struct MeshObject {
  grf::ScenePath path;
  std::string name;  ///< of the mesh or of its definition; may be empty
  grf::Shared<grf::Mesh> mesh;
  bool is_definition = false;
  bool is_light = false;  ///< whether it is a mesh light, whose surfaces' colours are radiances
  std::vector<FlatSurface> flat_surfaces;  ///< one per surface of the mesh
};

/// An instance of a mesh in world space.
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

/// The corners of an area light around it in world space, from its own one along edge 1.
std::array<grf::Vec3d, 4> corners_of(const LightObject& light);

struct ObserverObject {
  grf::ScenePath path;  ///< of the `params`
  std::size_t number = 0;
  grf::Vec3d position;  ///< world space
};

struct SceneObjects {
  std::vector<MeshObject> meshes;
  grf::Shared<std::vector<MeshInstance>> instances;
  std::vector<LightObject> lights;
  std::vector<ObserverObject> observers;
  grf::Box3d mesh_bounds;     ///< of all instances, in world space; empty if there are none
  grf::Box3d bounds;          ///< of lights, too
  std::size_t faces = 0;      ///< of all meshes, each once
  std::size_t triangles = 0;  ///< of all instances, after triangulation

  /// The mesh at a path, or nothing.
  std::optional<std::uint32_t> mesh_at(grf::ScenePathView path) const;
};

/// Flattens a scene. The path is the scene's file, relative to which it names textures and includes; empty
/// for the current folder.
SceneObjects objects_of(const grf::Scene& scene, const std::string& path);

/// Updates the objects of a scene after a change that is not structural.
void update(SceneObjects& objects, const grf::Scene& scene, const std::string& path, const Change& change);

}  // namespace editor
