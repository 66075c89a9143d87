#pragma once

#include "converters/format.h"

namespace convert {

/// The format GRF and IGRF, read and written.
Format grf_format();

}  // namespace convert
