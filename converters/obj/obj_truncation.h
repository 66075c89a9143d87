#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <string_view>

#include "converters/obj/wavefront_text.h"

namespace convert {

/// Detects from the statements of an OBJ file whether the last one, which has no line end, is truncated. A
/// statement truncated inside its last number may still look complete, which cannot be detected.
class TruncationDetector {
 public:
  /// Records a complete statement.
  void add(const Statement& statement);

  /// Returns the evidence that the statement was truncated, or an empty string.
  std::string evidence_of_truncation(const Statement& statement) const;

 private:
  /// Statistics of the statements with one keyword.
  struct Usage {
    std::size_t fewest_arguments = std::numeric_limits<std::size_t>::max();
    std::size_t fewest_separators = std::numeric_limits<std::size_t>::max();  ///< `/` in a corner of a face
    std::size_t fewest_decimals = std::numeric_limits<std::size_t>::max();
    std::size_t most_decimals = 0;
  };

  const Usage* usage_of(std::string_view keyword) const;
  std::string evidence_in_numbers(const Statement& statement) const;
  std::string evidence_in_corners(const Statement& statement) const;

  std::map<std::string, Usage, std::less<>> usages_;
};

}  // namespace convert
