#pragma once

#include <string_view>

namespace convert {

/// A row of a table of materials in FORMATS.md. It stands beside the code that follows it, and its example is
/// read or written by tests, so that words and code stay together.
struct MaterialRule {
  std::string_view source;  ///< what a material, or a surface of GRF, has
  std::string_view result;  ///< what becomes of it
  std::string_view
      example;             ///< a material as its file has it (`; ` is a line end), or a surface as GRF has it
  std::string_view gives;  ///< what that becomes, in the same way
  std::string_view loses;  ///< words of the warning about it; empty: there is none
};

}  // namespace convert
