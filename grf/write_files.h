// The parts of writing that `write.h` puts together.
#pragma once

#include <string>

#include "grf/scene.h"
#include "grf/visit.h"

namespace grf {

struct FileText {
  std::string text;
  bool is_finite = true;  ///< false: numbers among it are not, so it cannot be read again
};

/// The text of a file that holds these blocks and is read where those definitions are in force.
FileText text_of_file(const BlockList& contents, const Scope& scope);

}  // namespace grf
