// Lights and observers, and what they emit.
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

/// The power in watts that a diffuse emitter of one side sends out: Phi = pi A L, with its area in the world
/// in m2 and the mean L of its radiance over the three channels, in W/(sr m2).
double power_of(const grf::Colour& radiance, double area);

/// The radiance of that power, of the colour that the given one has; white if that is black. Of no area it is
/// the given one.
grf::Colour radiance_of(double power, double area, const grf::Colour& colour);

/// Of the light where it stands, in m2.
double world_area(const LightObject& light);

/// What emits in a scene: a light, a mesh light, or the emitting faces of a mesh, all places together.
struct Emitter {
  enum class Kind { AreaLight, MeshLight, Faces };
  Kind kind = Kind::AreaLight;
  grf::ScenePath path;
  std::string name;       ///< of the mesh; may be empty
  std::size_t count = 1;  ///< of emitting faces
  double area = 0;        ///< in the world, m2
  double power = 0;       ///< W
};
std::vector<Emitter> emitters_of(const SceneObjects& objects);
/// Whether a mesh has a surface that emits.
bool emits(const MeshObject& mesh);

/// Makes the selected faces send out so many watts together, in the colour of the given radiance.
SurfaceEdit emission_of_power(const SceneObjects& objects, const FaceSelection& selection, double power,
                              const grf::Colour& colour);

// Each of these gives a new scene; those that can fail nothing, and the reason in the diagnostics.

/// Puts a light, given in the world's coordinates, into the scene.
grf::Scene add_light(const grf::Scene& scene, const grf::AreaLight& light);
/// Another corner, other edges, another radiance; in the coordinates of the place.
std::optional<grf::Scene> change_light(const grf::Scene& scene, grf::ScenePathView path,
                                       const grf::AreaLight& light, grf::Diagnostics& diagnostics);

/// Adds an observer at a place in the world.
grf::Scene add_observer(const grf::Scene& scene, const grf::Vec3d& position);
/// Moves one to a place in the world.
std::optional<grf::Scene> move_observer(const grf::Scene& scene, const ObserverObject& observer,
                                        const grf::Vec3d& position, grf::Diagnostics& diagnostics);

}  // namespace editor
