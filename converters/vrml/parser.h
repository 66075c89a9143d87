#pragma once

#include <memory>

#include "converters/vrml/node.h"

namespace convert::vrml {

/// No file that is meant to be seen nests nodes so deep.
inline constexpr unsigned DeepestNode = 500;

/// The nodes of a file, or null after an error, which is the first.
std::unique_ptr<const Document> parse(std::shared_ptr<const Source> source, grf::Diagnostics& diagnostics);

}  // namespace convert::vrml
