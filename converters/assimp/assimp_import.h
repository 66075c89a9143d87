// Assimp, run on one file, and what it says meanwhile.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <assimp/scene.h>

namespace convert {

/// A warning or an error of Assimp's that did not end its reading.
struct AssimpMessage {
  std::string text;
  std::size_t count = 1;  ///< how often it was said
  bool is_error = false;
};

/// A scene as Assimp's reader made it. None of Assimp's later steps ran, so that polygons are whole and no
/// face, vertex or node was moved, merged or removed.
struct AssimpReading {
  std::unique_ptr<aiScene> scene;       ///< null if the reading failed
  std::string error;                    ///< why it failed
  std::vector<AssimpMessage> messages;  ///< each text once, in order
};

// Throw std::bad_alloc where Assimp had not the memory.

/// Reads bytes by the reader that Assimp has for an extension.
AssimpReading import_bytes(std::string_view bytes, const std::string& extension);

/// Reads a file, and those beside it that it names, by the reader that Assimp finds for it.
AssimpReading import_file(const std::string& path);

/// A name or a text of Assimp's as UTF-8 on one line, as names, file names and comments of a scene are.
std::string text_of(const aiString& string);

}  // namespace convert
