// A scene with its files written, of which only the text is left to write.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "converters/renderers/render_scene.h"
#include "converters/renderers/render_view.h"
#include "converters/renderers/scene_folder.h"
#include "converters/renderers/written_material.h"
#include "renderer/image/image.h"

namespace convert {

/// A shape with a PLY file of triangles. File names are relative to the scene's file.
struct WrittenShape {
  std::string name;  ///< may be empty
  std::string mesh;
  std::size_t material = 0;
  std::string image;  ///< of the colours of its vertices, times the material's reflectance; may be empty
  std::optional<grf::Colour> emission;
  double opacity = 1;         ///< unless an image has it
  std::string opacity_image;  ///< grey; may be empty
  bool has_normals = false;
  bool has_uvs = false;
};

struct WrittenScene {
  std::string path;
  RenderView view;
  double reach = 1;          ///< from the eye to the farthest corner of the scene's bounds
  std::string surroundings;  ///< the image around the scene; may be empty
  std::vector<WrittenMaterial> materials;
  std::vector<WrittenShape> shapes;
  std::vector<std::vector<WrittenShape>> objects;
  std::vector<RenderInstance> instances;
};

/// A renderer that scenes are written for: what it has and reads.
struct RenderTarget {
  std::string suffix;  ///< of the folder's name
  MaterialTarget material;
  bool masks_emission = false;       ///< absent parts of faces emit nothing
  bool has_mesh_attributes = false;  ///< else colours of vertices become images
  /// Resamples the image around a scene.
  image::Image (*surroundings)(const Surroundings& surroundings) = nullptr;
};

/// Writes all files that a scene in `path` names, with the view of an OP file or, if there is none, a default
/// one. The scene's file names are relative to `path`. Nothing after an error.
std::optional<WrittenScene> write_scene_files(const grf::Scene& scene, const std::string& path,
                                              const std::string& op_file, const RenderTarget& target,
                                              Losses& losses, grf::Diagnostics& diagnostics);

}  // namespace convert
