// An error map shows where in an image the error is.
#pragma once

#include <functional>
#include <vector>

#include "renderer/transport/render.h"

namespace transport {

/// The radius, in pixels, of the square over which an error map takes means.
constexpr int ErrorMapRadius = 2;

/// Returns the relative standard error of each pixel, rows from the top: the root of the mean of variance /
/// (radiance^2 + 0.01) over the channels of the 25 pixels around it, as far as they are in the image. A
/// pixel's variance is that of its mean, and its radiance is estimated as in `error_sums_of`; so the root
/// mean square of the map is the image's estimated error, but for what `error_estimate_of` adds for pixels
/// that few samples hit. Single pixels would not do: the variance of two halves is uncertain by its own size.
///
/// Pixels with less than two halves are infinite. May be called from any thread while the render runs, and
/// works on the threads of its settings. Empty if `stops` returns true meanwhile, which is asked on several
/// threads.
std::vector<float> error_map(
    const Render& render, const std::function<bool()>& stops = [] { return false; });

/// Returns the same of a film that nobody writes, on the threads of the enclosing loop.
std::vector<float> error_map(const Film& film);

}  // namespace transport
