// The folder with the files that an exported scene names: meshes, tables and images.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "grf/diagnostics.h"
#include "renderer/image/image.h"

namespace convert {

/// A folder beside a scene's file, named after it: `room_pbrt` for `room.pbrt`. It is made when the first
/// file is added.
class SceneFolder {
 public:
  SceneFolder(const std::string& scene_path, std::string_view suffix);

  /// A file of the folder.
  struct Name {
    std::string in_scene;  ///< relative to the scene's file, with `/`
    std::string path;
  };
  /// Returns the name of the next file of a kind, `mesh_1.ply`, and makes the folder; empty after an error.
  Name next(std::string_view kind, std::string_view extension, grf::Diagnostics& diagnostics);

  /// Writes an image and returns its name for the scene; empty after an error.
  std::string add_image(std::string_view kind, image::Image image, grf::Diagnostics& diagnostics);

 private:
  std::string folder_;  ///< path
  std::string name_;    ///< relative to the scene
  std::map<std::string, std::size_t, std::less<>> count_of_kind_;
};

}  // namespace convert
