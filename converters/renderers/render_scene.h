// A scene as renderers with one material a shape take it: shapes, each with all faces of one surface, and
// their materials, with all references resolved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "converters/losses.h"
#include "grf/diagnostics.h"
#include "grf/mesh.h"
#include "grf/scene.h"
#include "grf/visit.h"
#include "renderer/reflectance/brdf_maker.h"

namespace convert {

/// The reflection of a shape.
struct RenderMaterial {
  std::string name;          ///< the keyword of its model; not unique
  reflectance::Brdf brdf;    ///< without the colour
  grf::Colour colour;        ///< multiplies the BRDF; 0 for faces that reflect nothing
  std::string texture;       ///< path of an image that multiplies it, too; empty: none
  bool reads_alpha = false;  ///< the opacity of its shapes does: only the colours of opaque parts count
  bool has_vertex_colours = false;  ///< the colours of vertices multiply it; only if it is diffuse
  std::size_t faces = 0;            ///< that have it, instances not counted
};

/// All faces of a surface of a mesh, in the order of the mesh.
struct RenderShape {
  std::string name;  ///< of the mesh; may be empty
  const grf::Mesh* mesh = nullptr;
  std::uint32_t surface = 0;
  grf::Matrix44d to_world;  ///< the identity for a part of an instanced object
  std::size_t material = 0;
  std::optional<grf::Colour> emission;  ///< radiance from the front, W/(sr m2); none if black
  grf::Opacity opacity;
  std::string alpha;  ///< path of the image whose alpha the opacity reads; empty: none
};

/// An instance of shapes that are placed several times.
struct RenderInstance {
  std::size_t object = 0;  ///< index into `RenderScene::objects`
  grf::Matrix44d to_world;
};

/// The parts that a scene consists of. The scene it was made of must outlive it.
struct RenderScene {
  std::vector<RenderShape> shapes;                ///< placed once
  std::vector<std::vector<RenderShape>> objects;  ///< the parts of objects that are placed by instances
  std::vector<RenderInstance> instances;
  std::vector<RenderMaterial> materials;
  std::deque<grf::Mesh> parallelograms;  ///< the meshes of area lights
  grf::Box3d bounds;                     ///< in world space, of all shapes and instances
  Losses losses;                         ///< what no such renderer has

  RenderScene() = default;
  RenderScene(const RenderScene&) = delete;  // shapes point into it
  RenderScene& operator=(const RenderScene&) = delete;
  RenderScene(RenderScene&&) = default;
  RenderScene& operator=(RenderScene&&) = default;
  ~RenderScene() = default;
};

/// Resolves a scene without includes, whose file names are absolute. Meshes that emit become shapes for each
/// instance, since emitters cannot be instanced, and so do meshes with colours of vertices, of which Mitsuba
/// loses track in instances. Nothing after an error.
std::optional<RenderScene> render_scene_of(const grf::Scene& scene, grf::Diagnostics& diagnostics);

}  // namespace convert
