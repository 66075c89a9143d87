// A denoiser smooths previews. Final images are never denoised: it is biased.
#pragma once

#include <functional>

#include "renderer/image/image.h"
#include "renderer/transport/integrators/feature_layers.h"

namespace job {

/// Returns a smoother estimate of a noisy image, by an edge-avoiding a-trous wavelet filter (Dammertz, Sewtz,
/// Hanika and Lensch 2010, "Edge-avoiding a-trous wavelet transform for fast global illumination filtering").
/// Normal, albedo and depth of the first hit stop it at edges, and so do differences of colour that are large
/// against the standard deviation of the pixels' means. `variance` is that of the means; while it is unknown,
/// with one sample per pixel, colours stop nothing. All images have one size.
/// Returns the noisy image if `stops` returns true meanwhile, which is asked a few times.
image::Image denoised(
    const image::Image& noisy, const image::Image& variance, bool is_variance_known,
    const transport::FeatureLayers& guides, const std::function<bool()>& stops = [] { return false; });

}  // namespace job
