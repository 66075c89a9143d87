// What a picture shows of surfaces alone, for viewers, denoisers and compositing.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/transport/camera.h"
#include "renderer/transport/image/image.h"
#include "renderer/transport/scene/compiled_scene.h"

namespace transport {

/// Means over a few camera rays through each pixel, of what they meet first.
struct FeatureLayers {
  /// The share of light that the surface reflects towards the eye, its colour included. Black where nothing
  /// is, and of surfaces that reflect nothing.
  Image albedo;
  Image normal;              ///< the shading normal on the eye's side, in world space; 0 where nothing is
  std::vector<float> depth;  ///< along the view's axis, over the rays that meet something; infinite if none
};

/// Depends on the seed alone, whatever the number of threads (0: as many as the machine has).
FeatureLayers feature_layers(const CompiledScene& scene, const View& view, int width, int height,
                             int samples = 16, std::uint32_t seed = 0, int threads = 0);

}  // namespace transport
