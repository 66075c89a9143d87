#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <assimp/scene.h>

#include "converters/format.h"
#include "grf/unique_names.h"

namespace convert {

/// The images that stand inside a file, as files of their own.
class EmbeddedTextures {
 public:
  explicit EmbeddedTextures(const aiScene& scene) : scene_(scene) {}

  /// The file that a material names: the name itself, or for an embedded image that of the file which is to
  /// be written.
  std::string file_of(const std::string& name);

  /// How many of the images no material named so far.
  std::size_t unused() const { return scene_.mNumTextures - names_.size(); }

  /// The images that were named.
  std::vector<EmbeddedFile> take() { return std::move(files_); }

 private:
  std::string free_name(const aiTexture& texture, std::size_t index);

  const aiScene& scene_;
  std::map<const aiTexture*, std::string> names_;
  std::vector<EmbeddedFile> files_;
  grf::UniqueNames free_names_;
};

}  // namespace convert
