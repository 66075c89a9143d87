#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "grf/diagnostics.h"
#include "renderer/reflectance/measurements/angle_grid.h"

namespace reflectance {

/// Returns whether bytes have the length of a file of the UTIA data base, which has no header.
bool sniff_utia(std::string_view bytes);

/// Reads an anisotropic BRDF of the UTIA data base (Filip and Vavra 2014, "Template-Based Sampling of
/// Anisotropic BRDFs"): doubles of one channel after the other, for 6 angles of the light from the normal,
/// every 15 degrees, 48 azimuths of it, every 7.5 degrees, and likewise of the view, which is fastest. As by
/// the data base's own reader, values from 75 to 90 degrees follow the last two angles. Returns null after an
/// error.
std::shared_ptr<const AngleGrid> parse_utia(std::string_view bytes, const std::string& path,
                                            grf::Diagnostics& diagnostics);

}  // namespace reflectance
