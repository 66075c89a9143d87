#pragma once

#include <string_view>

#include "converters/vrml/source.h"

namespace convert::vrml {

/// Returns whether the version's standard has a node type of that name with the regular syntax of fields: its
/// body can be parsed without knowledge of prototypes. (A Script has declarations in it.)
bool is_standard_type(std::string_view type, Version version);

/// Returns the reason why a node of this type is skipped in a search for shapes.
std::string_view reason_for_skipping(std::string_view type, Version version);

// These return whether a node is a light, or a viewpoint.
bool is_light(std::string_view type);
bool is_camera(std::string_view type);

}  // namespace convert::vrml
