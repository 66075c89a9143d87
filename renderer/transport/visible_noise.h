// The visible noise of a render: how far its image still looks different from the converged one.
#pragma once

#include <functional>
#include <optional>

#include "renderer/image/visible_difference.h"
#include "renderer/transport/render.h"

namespace transport {

/// An estimate of the visible difference between an image and the one that it converges to.
struct VisibleNoise {
  image::VisibleDifference difference;
  /// The samples per pixel with which the 95th percentile of the differences falls below 1, if the variance
  /// falls as 1 / samples; 0 if nothing is seen. Low-discrepancy samples need fewer.
  double samples_needed = 0;
};

/// Estimates the visible noise of an image from its own samples. With a and b the means of a pixel's halves,
/// x = (a + b) / 2 differs from a and from b as much as from the truth, in distribution: (a - b) / 2 has the
/// variance of x. So the differences between the images of x, a and b as they are seen stand for those
/// between x and the truth. With other weights p and 1 - p of the halves, x +- sqrt(p (1 - p)) (a - b) take
/// their place. Empty while there are pixels without samples of both halves, and for images of more than 33
/// million pixels (8K), for the memory that it takes: 200 bytes per pixel.
///
/// May be called from any thread while the render runs, and works on the threads of its settings. Empty if
/// `stops` returns true meanwhile, which is asked a few times.
std::optional<VisibleNoise> visible_noise(
    const Render& render, const image::Viewing& viewing,
    const std::function<bool()>& stops = [] { return false; });

}  // namespace transport
