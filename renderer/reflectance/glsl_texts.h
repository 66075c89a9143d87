// The .glsl files of this folder, as they were when the library was built.
#pragma once

#include <string_view>
#include <vector>

namespace reflectance {

struct GlslText {
  std::string_view name;  ///< of the file, without its ending
  std::string_view text;
};

const std::vector<GlslText>& glsl_texts();

}  // namespace reflectance
