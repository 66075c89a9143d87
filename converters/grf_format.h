#pragma once

#include "converters/format.h"

namespace convert {

/// GRF and IGRF themselves, read and written.
Format grf_format();

}  // namespace convert
