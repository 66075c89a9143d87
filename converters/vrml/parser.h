#pragma once

#include <memory>

#include "converters/vrml/node.h"

namespace convert::vrml {

/// The maximum nesting depth of nodes; deeper files are no real scenes.
inline constexpr unsigned DeepestNode = 500;

/// Parses the nodes of a file; returns null after the first error.
std::unique_ptr<const Document> parse(std::shared_ptr<const Source> source, grf::Diagnostics& diagnostics);

}  // namespace convert::vrml
