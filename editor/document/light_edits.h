// Edits lights and observers, and computes emitted power.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/document/face_selection.h"
#include "editor/document/scene_objects.h"
#include "editor/document/surface_edits.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "grf/scene_path.h"

namespace editor {

/// The power in watts of a one-sided diffuse emitter: Phi = pi A L, with its world-space area A in m2 and L,
/// the mean of its radiance over the three channels, in W/(sr m2).
double power_of(const grf::Colour& radiance, double area);

/// The radiance for that power, in the chromaticity of the given colour; white if that is black. For zero
/// area it is the given one.
grf::Colour radiance_of(double power, double area, const grf::Colour& colour);

/// World-space area of the light, in m2.
double world_area(const LightObject& light);

/// An emitter of a scene: an area light, a mesh light, or the emissive faces of a mesh, all instances
/// together.
struct Emitter {
  enum class Kind { AreaLight, MeshLight, Faces };
  Kind kind = Kind::AreaLight;
  grf::ScenePath path;
  std::string name;       ///< of the mesh; may be empty
  std::size_t count = 1;  ///< number of emissive faces
  double area = 0;        ///< world space, m2
  double power = 0;       ///< W
};
std::vector<Emitter> emitters_of(const SceneObjects& objects);
/// Whether a mesh has an emissive surface.
bool emits(const MeshObject& mesh);

/// Sets the total power of the selected faces in watts, in the chromaticity of the given radiance.
SurfaceEdit emission_of_power(const SceneObjects& objects, const FaceSelection& selection, double power,
                              const grf::Colour& colour);

// Each of these returns a new scene; those that can fail return nothing, with the reason in the diagnostics.

/// Adds a light, given in world coordinates, to the scene.
grf::Scene add_light(const grf::Scene& scene, const grf::AreaLight& light);
/// Sets corner, edges and radiance of a light, in its local coordinates.
std::optional<grf::Scene> change_light(const grf::Scene& scene, grf::ScenePathView path,
                                       const grf::AreaLight& light, grf::Diagnostics& diagnostics);

/// Adds an observer at a position in world space.
grf::Scene add_observer(const grf::Scene& scene, const grf::Vec3d& position);
/// Moves an observer to a position in world space.
std::optional<grf::Scene> move_observer(const grf::Scene& scene, const ObserverObject& observer,
                                        const grf::Vec3d& position, grf::Diagnostics& diagnostics);

}  // namespace editor
