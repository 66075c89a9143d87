#pragma once

#include "renderer/transport/image/image.h"

namespace benchmark {

/// An environment map of 1024x512: a clear sky that brightens towards the horizon and a strong sun, half a
/// degree in radius and 50 degrees high, over darker ground. Latitude-longitude as `bpt` reads it.
transport::Image outdoor_map();

}  // namespace benchmark
