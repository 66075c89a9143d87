#pragma once

#include <string>
#include <vector>

namespace grf {

/// The comments that belong to a block, a definition or an attribute. Each is kept without its `//`
/// and without a line end, and has none inside.
struct Comments {
  std::vector<std::string> before;  ///< on lines of their own, before it
  std::string behind;               ///< on its last line

  bool empty() const { return before.empty() && behind.empty(); }
  bool operator==(const Comments&) const = default;
};

}  // namespace grf
