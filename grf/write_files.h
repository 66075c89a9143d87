// The parts of writing that `write.h` puts together.
#pragma once

#include <string>

#include "grf/scene.h"
#include "grf/visit.h"

namespace grf {

/// The text of a file that holds these blocks and is read where those definitions are in force.
std::string text_of_file(const BlockList& contents, const Scope& scope);

}  // namespace grf
