#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/model.h"
#include "renderer/transport/scene/texture.h"

namespace transport {

/// Collects the images that faces name, and then reads them: each file once.
class TextureSetBuilder {
 public:
  explicit TextureSetBuilder(grf::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// Which texture a surface will have.
  std::uint32_t index_of(const grf::Texture& texture);

  /// Reads all files, in parallel. One that cannot be read is an error where it is named first, and leaves a
  /// white texture.
  std::vector<Texture> build(int threads);

 private:
  struct File {
    std::string path;
    grf::SourceLocation asked_for_at;
  };

  grf::Diagnostics& diagnostics_;
  std::vector<File> files_;
  std::map<std::string, std::uint32_t> index_by_path_;
};

}  // namespace transport
