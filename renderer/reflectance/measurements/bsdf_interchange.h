// Two text formats of optical design programs with the ending `.bsdf`, as RGL's binary one has.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "grf/diagnostics.h"
#include "renderer/reflectance/measurements/angle_grid.h"

namespace reflectance {

/// Returns whether a text is of the BSDF Data Interchange format of Radiant Imaging, which Zemax reads.
bool sniff_zemax(std::string_view text);

/// Reads that format ("BSDF Data Interchange File Format Specification", Rykowski 2008). Angles of the
/// scattered direction are about the mirror direction of the incident one, which is the light. Of samples
/// that were rotated, and of transmission, it says that they are not read. Returns null after an error, which
/// names line and column.
std::shared_ptr<const AngleGrid> parse_zemax(std::string_view text, const std::string& path,
                                             grf::Diagnostics& diagnostics);

/// Returns whether a text is a BSDF file of LightTools, whose words are nearly the same.
bool sniff_lighttools(std::string_view text);

/// Reads that format. Angles of the scattered direction are about the normal, with the incident direction at
/// azimuth 90 degrees. Blocks of the back and of transmission are left out with a warning.
std::shared_ptr<const AngleGrid> parse_lighttools(std::string_view text, const std::string& path,
                                                  grf::Diagnostics& diagnostics);

}  // namespace reflectance
