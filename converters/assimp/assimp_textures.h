#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <assimp/scene.h>

#include "converters/format.h"
#include "grf/unique_names.h"

namespace convert {

/// Extracts embedded images of a file.
class EmbeddedTextures {
 public:
  explicit EmbeddedTextures(const aiScene& scene) : scene_(scene) {}

  /// Returns the file of a material's image: the name itself, or for an embedded image that of the extracted
  /// file.
  std::string file_of(const std::string& name);

  /// Returns the number of embedded images that no material has used so far.
  std::size_t unused() const { return scene_.mNumTextures - names_.size(); }

  /// Moves out the embedded images that were used.
  std::vector<EmbeddedFile> take() { return std::move(files_); }

 private:
  std::string free_name(const aiTexture& texture, std::size_t index);

  const aiScene& scene_;
  std::map<const aiTexture*, std::string> names_;
  std::vector<EmbeddedFile> files_;
  grf::UniqueNames free_names_;
};

}  // namespace convert
