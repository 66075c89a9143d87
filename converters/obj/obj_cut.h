#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <string_view>

#include "converters/obj/wavefront_text.h"

namespace convert {

/// Tells from the statements of an OBJ file whether the last one, which has no line end, is whole. A
/// statement that was cut inside its last number may still look like one; then nobody can tell.
class CutDetector {
 public:
  /// Takes note of a statement that is whole.
  void add(const Statement& statement);

  /// What shows that the statement was cut off, or an empty string if nothing does.
  std::string why_cut(const Statement& statement) const;

 private:
  /// What the statements with one keyword have in common.
  struct Usage {
    std::size_t fewest_arguments = std::numeric_limits<std::size_t>::max();
    std::size_t fewest_separators = std::numeric_limits<std::size_t>::max();  ///< `/` in a corner of a face
    std::size_t fewest_decimals = std::numeric_limits<std::size_t>::max();
    std::size_t most_decimals = 0;
  };

  const Usage* usage_of(std::string_view keyword) const;
  std::string why_numbers_cut(const Statement& statement) const;
  std::string why_corners_cut(const Statement& statement) const;

  std::map<std::string, Usage, std::less<>> usages_;
};

}  // namespace convert
