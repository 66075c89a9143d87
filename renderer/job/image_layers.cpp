#include "renderer/job/image_layers.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "renderer/transport/error_map.h"
#include "renderer/transport/integrators/feature_layers.h"

namespace job {
namespace {

using image::ImageLayer;
using transport::Film;

ImageLayer samples_layer(const Film& film) {
  ImageLayer layer{"samples", "", {}};
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      layer.values.push_back(static_cast<float>(film.sample_count(x, y)));
    }
  }
  return layer;
}

bool has_layer(const std::vector<std::string>& layers, std::string_view name) {
  return std::find(layers.begin(), layers.end(), name) != layers.end();
}

}  // namespace

std::vector<ImageLayer> feature_layers(const transport::Render& render, const transport::CompiledScene& scene,
                                       const options::RenderOptions& render_options) {
  const auto& asked = render_options.layers;
  std::vector<ImageLayer> layers;
  if (!has_layer(asked, "albedo") && !has_layer(asked, "normal") && !has_layer(asked, "depth")) return layers;
  constexpr int FeatureSamples = 16;
  const Film& film = render.film();
  auto features = transport::feature_layers(scene, render.settings().view, film.width(), film.height(),
                                            FeatureSamples, render_options.seed, render_options.threads);
  if (has_layer(asked, "albedo")) layers.push_back(image::layer_of("albedo", "RGB", features.albedo));
  if (has_layer(asked, "normal")) layers.push_back(image::layer_of("normal", "XYZ", features.normal));
  if (has_layer(asked, "depth")) layers.push_back({"depth", "Z", std::move(features.depth)});
  return layers;
}

std::vector<ImageLayer> film_layers(const Film& film, const std::vector<std::string>& asked) {
  std::vector<ImageLayer> layers;
  if (has_layer(asked, "variance")) layers.push_back(image::layer_of("variance", "RGB", film.variance()));
  if (has_layer(asked, "error")) layers.push_back({"error", "", transport::error_map(film)});
  if (has_layer(asked, "samples")) layers.push_back(samples_layer(film));
  return layers;
}

}  // namespace job
