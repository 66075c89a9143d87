// The .glsl files of this folder are embedded when the library is built.
#pragma once

#include <string_view>
#include <vector>

namespace reflectance {

/// One .glsl file.
struct GlslText {
  std::string_view name;  ///< file name without extension
  std::string_view text;
};

const std::vector<GlslText>& glsl_texts();  ///< Returns all .glsl files of the folder.

}  // namespace reflectance
