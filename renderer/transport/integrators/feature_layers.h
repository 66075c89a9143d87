// Feature layers (AOVs) give albedo, normal and depth to viewers, denoisers and compositing.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/image/image.h"
#include "renderer/transport/camera.h"
#include "renderer/transport/scene/compiled_scene.h"

namespace transport {

/// First-hit features, averaged over a few camera rays per pixel.
struct FeatureLayers {
  /// The directional albedo towards the eye, with the surface's colour. Black on the background, and on
  /// surfaces that reflect nothing.
  image::Image albedo;
  image::Image normal;  ///< shading normal on the eye's side, in world space; 0 on the background
  std::vector<float>
      depth;  ///< along the view's axis, over the rays that hit something; infinite if none does
};

/// Computes the layers. They depend only on the seed, not on the number of threads (0: one per core). With a
/// crop window, the layers are of its pixels.
FeatureLayers feature_layers(const CompiledScene& scene, const View& view, int width, int height,
                             int samples = 16, std::uint32_t seed = 0, int threads = 0,
                             const std::optional<CropWindow>& crop = {});

}  // namespace transport
