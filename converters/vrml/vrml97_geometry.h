#pragma once

#include <optional>
#include <string_view>

#include "converters/vrml/geometry_readers.h"
#include "converters/vrml/polygons.h"
#include "converters/vrml/report.h"

namespace convert::vrml {

/// Returns whether a node type is a VRML97 geometry node with faces.
bool has_faces97(std::string_view type);

/// Reads the faces of such a node, with texture coordinates if textured; returns nothing after an error.
std::optional<Polygons> polygons_of97(const Node& geometry, bool is_textured, Report& report);

/// Tessellates an ElevationGrid (ISO/IEC 14772-1, 6.17).
std::optional<Polygons> read_elevation_grid(const Node& node, Report& report);

/// Tessellates an Extrusion (ISO/IEC 14772-1, 6.18).
std::optional<Polygons> read_extrusion(const Node& node, Report& report);

/// Reads the colours of a Color node, clamped to 0..1.
std::vector<grf::Colour> read_colours(const Node& node, Report& report);

}  // namespace convert::vrml
