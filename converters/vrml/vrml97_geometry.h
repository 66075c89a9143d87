#pragma once

#include <optional>
#include <string_view>

#include "converters/vrml/geometry_parts.h"
#include "converters/vrml/polygons.h"
#include "converters/vrml/report.h"

namespace convert::vrml {

/// True of the geometry nodes of VRML97 that have faces.
bool has_faces97(std::string_view type);

/// The faces of such a node; where they are textured, with texture coordinates. Nothing after an error.
std::optional<Polygons> polygons_of97(const Node& geometry, bool is_textured, Report& report);

/// An ElevationGrid (ISO/IEC 14772-1, 6.17).
std::optional<Polygons> read_elevation_grid(const Node& node, Report& report);

/// An Extrusion (6.18).
std::optional<Polygons> read_extrusion(const Node& node, Report& report);

/// The colours of a Color node, between 0 and 1.
std::vector<grf::Colour> read_colours(const Node& node, Report& report);

}  // namespace convert::vrml
