// Assimp imports one file, and its log messages become diagnostics.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <assimp/scene.h>

namespace convert {

/// A warning or an error of Assimp that did not end its import.
struct AssimpMessage {
  std::string text;
  std::size_t count = 1;  ///< number of occurrences
  bool is_error = false;
};

/// A scene as imported by Assimp without any post-processing, so that polygons are whole and no face, vertex
/// or node was moved, merged or removed.
struct AssimpReading {
  std::unique_ptr<aiScene> scene;       ///< null if the import failed
  std::string error;                    ///< the reason of the failure
  std::vector<AssimpMessage> messages;  ///< each text once, in order
};

// These throw std::bad_alloc if Assimp runs out of memory.

/// Imports bytes by Assimp's importer for an extension.
AssimpReading import_bytes(std::string_view bytes, const std::string& extension);

/// Imports a file, and those beside it that it names, by the importer that Assimp selects.
AssimpReading import_file(const std::string& path);

/// Converts a string of Assimp to UTF-8 on one line, as names, file names and comments of a scene are.
std::string text_of(const aiString& string);

}  // namespace convert
