// The layers of an image (AOVs) are computed as its render options ask for them.
#pragma once

#include <string>
#include <vector>

#include "renderer/image/image_file.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/render.h"

namespace job {

/// Computes the layers that need the scene, as far as the options ask for them: albedo, normal and depth.
std::vector<image::ImageLayer> feature_layers(const transport::Render& render,
                                              const transport::CompiledScene& scene,
                                              const options::RenderOptions& render_options);

/// Computes the layers that follow from a film's samples, as far as they are asked for: variance, error and
/// samples.
std::vector<image::ImageLayer> film_layers(const transport::Film& film,
                                           const std::vector<std::string>& asked);

}  // namespace job
