#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "converters/losses.h"
#include "converters/vrml/node.h"
#include "grf/diagnostics.h"

namespace convert::vrml {

/// The diagnostics of a file that is read: errors at once, and losses at the end.
class Report {
 public:
  explicit Report(grf::Diagnostics& diagnostics)
      : diagnostics_(diagnostics), errors_before_(diagnostics.error_count()) {}

  grf::Diagnostics& diagnostics() { return diagnostics_; }
  Losses& losses() { return losses_; }
  bool failed() const { return diagnostics_.error_count() > errors_before_; }

  /// Counts a skipped node that makes no faces.
  void skip(const Node& node);

  /// Adds a loss that is no `Loss`, with its reason: "`count` `one`: `why`" or "`count` `many`: `why`".
  void add(std::string_view one, std::string_view many, std::string_view why, std::size_t count = 1);

  /// Returns the node in a field, if it is of the type. A node of an unknown type is skipped; one of another
  /// type is an error.
  const Node* node_of(const Node& node, std::string_view field, std::string_view type);

  /// Counts generated faces of a node; returns false after an error if they are too many.
  bool count_generated(const Node& node, std::size_t faces);

  /// Reports losses, in one warning per kind.
  void finish(const grf::SourceLocation& location) const;

 private:
  struct Line {
    std::string many;
    std::string why;
    std::size_t count = 0;
  };

  grf::Diagnostics& diagnostics_;
  std::size_t errors_before_;
  Losses losses_;
  std::map<std::string, Line, std::less<>> lines_;  // by the text for a count of one
  std::size_t generated_faces_ = 0;
};

}  // namespace convert::vrml
