#pragma once

#include "renderer/image/image.h"

namespace benchmark {

/// A latitude-longitude environment map of 1024x512: a clear sky that brightens towards the horizon and a
/// strong sun, half a degree in radius and 50 degrees high, over darker ground.
image::Image outdoor_map();

}  // namespace benchmark
