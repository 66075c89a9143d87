#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace benchmark {

struct SceneFiles {
  std::string name;          ///< as in reports and names of files
  std::filesystem::path op;  ///< the GRF scene is beside it
  bool is_in_cycles = true;  ///< whether cycles_scene.py can make the same scene
};

/// Makes the benchmark's scenes in a folder: the Cornell box of samples/, those of scenes/ with their meshes,
/// and those of generated_scenes.h. The environment map is Debian's forest.exr (package `blender-data`), or
/// our own if that is not installed. Throws if a file cannot be written.
///
/// `small` limits meshes to 2,000 triangles; the numbers of lamps stay.
std::vector<SceneFiles> make_scenes(const std::filesystem::path& folder, bool small);

/// Makes the scenes of artefacts/ in a folder: `terminator` with a coarse sphere, `fine_terminator` with a
/// fine one in its place, `closed_room` and `contact`. Throws if a file cannot be written.
std::vector<SceneFiles> make_artefact_scenes(const std::filesystem::path& folder);

/// Makes a scene in a folder: a sphere of radius 1 of the BRDF `material`, whose definition is GRF text, seen
/// from far, in the studio of samples/environments or in white surroundings; the image shows 1.1 times the
/// sphere. Throws if a file cannot be written.
SceneFiles make_material_scene(const std::filesystem::path& folder, const std::string& definition,
                               bool is_in_white);

}  // namespace benchmark
