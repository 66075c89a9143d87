#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "converters/losses.h"
#include "converters/vrml/node.h"
#include "grf/diagnostics.h"

namespace convert::vrml {

/// What is said of a file while it is read: errors at once, and at the end what a scene cannot hold of it.
class Report {
 public:
  explicit Report(grf::Diagnostics& diagnostics)
      : diagnostics_(diagnostics), errors_before_(diagnostics.error_count()) {}

  grf::Diagnostics& diagnostics() { return diagnostics_; }
  Losses& losses() { return losses_; }
  bool failed() const { return diagnostics_.error_count() > errors_before_; }

  /// A node that stands where it makes no faces.
  void pass_over(const Node& node);

  /// So many of what no `Loss` stands for: "`count` `one`" or "`count` `many`", and why.
  void add(std::string_view one, std::string_view many, std::string_view why, std::size_t count = 1);

  /// The node in a field, if it is of the type. A node of no known type is passed over; one of another type
  /// is an error.
  const Node* node_of(const Node& node, std::string_view field, std::string_view type);

  /// Counts faces that a node stands for without listing them; false after the error that they are too many.
  bool count_generated(const Node& node, std::size_t faces);

  /// Says what was lost, in one warning a kind.
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
  std::map<std::string, Line, std::less<>> lines_;  // by their text for a count of one
  std::size_t generated_faces_ = 0;
};

}  // namespace convert::vrml
