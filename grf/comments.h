#pragma once

#include <string>
#include <vector>

namespace grf {

/// The comments attached to a block, a definition or an attribute. Each is kept without its `//`, and has no
/// line ends.
struct Comments {
  std::vector<std::string> before;  ///< leading comments, on lines of their own
  std::string behind;               ///< trailing comment, on the last line

  bool empty() const { return before.empty() && behind.empty(); }  ///< Returns whether there are none.
  bool operator==(const Comments&) const = default;
};

}  // namespace grf
