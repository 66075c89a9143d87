#pragma once

#include <string_view>

#include "converters/vrml/source.h"

namespace convert::vrml {

/// Whether the version's standard has a node of that name whose fields are written as those of all others:
/// its body can be parsed without knowledge of prototypes. (A Script has declarations in it.)
bool is_standard_type(std::string_view type, Version version);

/// Why a node of this type is passed over where shapes are looked for.
std::string_view why_passed_over(std::string_view type, Version version);

/// Nodes that stand for lights, or for viewers.
bool is_light(std::string_view type);
bool is_camera(std::string_view type);

}  // namespace convert::vrml
