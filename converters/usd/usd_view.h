#pragma once

#include <string>

#include "converters/format.h"
#include "converters/losses.h"
#include "converters/usd/usd_text.h"
#include "grf/diagnostics.h"
#include "grf/math.h"

namespace convert {

/// Puts the cameras, the surroundings and the settings of a render into the prim with this path; names of its
/// other children are not `Camera`, `Cameras`, `Surroundings` or `Render`. Returns false after an error.
bool put_usd_view(UsdText& text, const std::string& parent, const std::string& path,
                  const WriteOptions& options, const grf::Box3d& bounds, Losses& losses,
                  grf::Diagnostics& diagnostics);

}  // namespace convert
