#pragma once

#include <string_view>

namespace convert {

/// A row of a material table in FORMATS.md. It is next to the code that implements it, and tests read or
/// write its example, so that document and code agree.
struct MaterialRule {
  std::string_view source;  ///< the feature of a material, or of a surface of GRF
  std::string_view result;  ///< its conversion
  std::string_view
      example;             ///< a material as its file has it (`; ` is a line end), or a surface as GRF has it
  std::string_view gives;  ///< the result of the example, in the same notation
  std::string_view loses;  ///< text of the warning about it; empty: there is none
};

}  // namespace convert
