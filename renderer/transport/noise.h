// The noise of an image is shared out among the lights, the bounces and the BRDFs that it comes from.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "renderer/transport/render.h"

namespace transport {

/// A part of an image's light, and of its noise. Shares of a list sum to 1. A share below 0 lowers the noise
/// of the others: where one lamp is sampled, another one is not.
struct NoiseShare {
  std::uint32_t index = 0;  ///< see NoiseShares
  double noise = 0;         ///< of the image's variance, relative to its radiance as in relMSE
  double light = 0;         ///< of the image's radiance, relative likewise
};

/// The shares of an image's variance, each list from the largest noise on.
struct NoiseShares {
  double error = 0;                    ///< sqrt(relMSE) of an image with `samples` per pixel
  int samples = 0;                     ///< per pixel
  std::vector<NoiseShare> lamps;       ///< index into Geometry::lamps; their number for all other light
  std::vector<NoiseShare> bounces;     ///< index: bounces between light and eye; 0 is light that the eye sees
  std::vector<NoiseShare> reflectors;  ///< index of the reflector that light met first; their number for none
};

struct NoiseSettings {
  int images = 8;    ///< independent images, at least 2, whose pixels are compared
  int samples = 16;  ///< per pixel of each
};

/// Shares out the noise of an image of these settings, with the integrator `Path` and without adaptive
/// sampling. Each pixel is rendered as several independent images. A sum's variance is the sum of the
/// covariances of its terms with it, so that these are the terms' shares. Empty if `stopped` was set, or if
/// the image has no noise.
std::optional<NoiseShares> noise_shares(const CompiledScene& scene, const RenderSettings& settings,
                                        const NoiseSettings& noise, const std::atomic<bool>& stopped);

/// The noise of images of some settings, and the time that they take.
struct MeasuredNoise {
  double error = 0;                   ///< sqrt(relMSE) of an image
  std::vector<double> row_variances;  ///< relMSE of each row of pixels; their mean is the square of `error`
  std::vector<double> seconds_of_images;  ///< processor time of each image, without its preparation

  double seconds() const;  ///< the mean
};

/// Renders several independent images of these settings, with any integrator and also adaptively, and calls
/// `after_image` with the number of each. Empty if `stopped` was set, or if the image has no noise.
std::optional<MeasuredNoise> measure_noise(
    const CompiledScene& scene, const RenderSettings& settings, int images, const std::atomic<bool>& stopped,
    const std::function<void(int)>& after_image = [](int) {});

/// Renders one of these images for the processor time that it takes.
double seconds_of_image(const CompiledScene& scene, const RenderSettings& settings, int image);

/// A ratio of two measured values, with its 95 % confidence interval.
struct MeasuredRatio {
  double value = 1;
  double low = 1;
  double high = 1;
};

/// What a change of settings does, relative to what was before.
struct NoiseRatios {
  MeasuredRatio variance;
  MeasuredRatio time;
  /// Their product: the time for the same error, if the variance falls as 1 / samples.
  MeasuredRatio cost;
};

/// Compares images of the same scene and size. The interval of the variance is that of a ratio of sums over
/// rows of pixels (Cochran 1977, "Sampling techniques", 2.11), as if the rows were independent, and that of
/// the time is from as many images each, best rendered in turn.
NoiseRatios ratios_of(const MeasuredNoise& before, const MeasuredNoise& after);

}  // namespace transport
