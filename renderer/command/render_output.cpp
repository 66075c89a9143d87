#include "renderer/command/render_output.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "renderer/transport/error_map.h"
#include "renderer/transport/integrators/feature_layers.h"

namespace command {
namespace {

using grf::Diagnostics;
using image::ImageAttribute;
using image::ImageLayer;
using options::RenderOptions;
using transport::Film;

bool can_write(const std::string& output, const options::ImageSize& size, Diagnostics& diagnostics) {
  const image::ImageFormat* format = image::image_format_of(output, diagnostics);
  if (format == nullptr) return false;
  if (std::max(size.width, size.height) <= format->largest_side) {
    return can_write_file(output, "image", diagnostics);
  }
  diagnostics.error(grf::whole_file(output),
                    fmt::format("images of this type have at most {} pixels per side", format->largest_side));
  return false;
}

double mean_samples(const Film& film) {
  double sum = 0;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) sum += film.sample_count(x, y);
  }
  return sum / (static_cast<double>(film.width()) * film.height());
}

ImageLayer samples_layer(const Film& film) {
  ImageLayer layer{"samples", "", {}};
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      layer.values.push_back(static_cast<float>(film.sample_count(x, y)));
    }
  }
  return layer;
}

std::vector<ImageLayer> layers_of(const transport::Render& render, const transport::CompiledScene& scene,
                                  const transport::View& view, const RenderOptions& render_options) {
  const auto asks_for = [&](std::string_view name) {
    const auto& layers = render_options.layers;
    return std::find(layers.begin(), layers.end(), name) != layers.end();
  };
  const Film& film = render.film();
  std::vector<ImageLayer> layers;
  if (asks_for("albedo") || asks_for("normal") || asks_for("depth")) {
    constexpr int FeatureSamples = 16;
    auto features = transport::feature_layers(scene, view, film.width(), film.height(), FeatureSamples,
                                              render_options.seed, render_options.threads);
    if (asks_for("albedo")) layers.push_back(image::layer_of("albedo", "RGB", features.albedo));
    if (asks_for("normal")) layers.push_back(image::layer_of("normal", "XYZ", features.normal));
    if (asks_for("depth")) layers.push_back({"depth", "Z", std::move(features.depth)});
  }
  if (asks_for("variance")) layers.push_back(image::layer_of("variance", "RGB", film.variance()));
  if (asks_for("error")) layers.push_back({"error", "", transport::error_map(render)});
  if (asks_for("samples")) layers.push_back(samples_layer(film));
  return layers;
}

void add_options(const RenderOptions& render_options, std::vector<ImageAttribute>& attributes) {
  for (const options::OptionInfo& option : options::option_table()) {
    const std::vector<std::string> words = options::option_words(render_options, option);
    if (!words.empty()) {
      attributes.push_back({std::string(option.key), fmt::format("{}", fmt::join(words, " "))});
    }
  }
}

}  // namespace

bool can_write_file(const std::string& path, std::string_view what, Diagnostics& diagnostics) {
  const auto fail = [&](const std::string& why) {
    diagnostics.error(grf::whole_file(path), why);
    return false;
  };
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const std::string folder_name = folder.empty() ? "." : folder.string();
  if (::access(folder_name.c_str(), W_OK | X_OK) != 0) {
    return fail(fmt::format("cannot write into the folder '{}'", folder_name));
  }
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status))
    return fail(fmt::format("cannot write the {}: it is a directory", what));
  if (!std::filesystem::exists(status)) return true;
  // Replacing a device or a pipe would remove it for everybody.
  if (!std::filesystem::is_regular_file(status)) {
    return fail(fmt::format("cannot write the {}: it is not a regular file", what));
  }
  return ::access(path.c_str(), W_OK) == 0 ||
         fail(fmt::format("cannot write the {}: the file is read-only", what));
}

bool can_write(const std::vector<std::string>& outputs, const RenderOptions& render_options,
               Diagnostics& diagnostics) {
  bool holds_layers = false;
  for (const std::string& output : outputs) {
    if (!can_write(output, render_options.size, diagnostics)) return false;
    holds_layers |= image::image_format_of(output, diagnostics)->holds_layers;
  }
  if (!render_options.layers.empty() && !holds_layers) {
    diagnostics.warning(render_options.locations.of("BPT_Layers"),
                        "BPT_Layers has no effect: only exr images have layers");
  }
  return true;
}

image::ImageFile image_file_of(const transport::Render& render,
                               const std::optional<transport::ErrorEstimate>& estimate,
                               const transport::CompiledScene& scene, const transport::View& view,
                               const RenderOptions& render_options) {
  const Film& film = render.film();
  const transport::Camera camera(view, film.width(), film.height());
  image::ImageFile file;
  file.image = film.mean();
  file.exposure = render_options.exposure;
  file.screen_width = camera.screen_width();
  file.layers = layers_of(render, scene, view, render_options);

  RenderOptions known = render_options;
  known.eye = view.eye;
  known.target = view.target;
  known.samples = render_options.samples_per_pixel();
  add_options(known, file.attributes);
  file.attributes.push_back({"software", "Granada " GRANADA_VERSION});
  file.attributes.push_back({"worldToCamera", camera.world_to_camera()});
  file.attributes.push_back({"worldToNDC", camera.world_to_image()});
  file.attributes.push_back({"renderSeconds", static_cast<float>(render.seconds())});
  file.attributes.push_back({"samplesPerPixel", static_cast<float>(mean_samples(film))});
  if (estimate) {
    file.attributes.push_back({"estimatedError", static_cast<float>(estimate->error)});
    file.attributes.push_back({"estimatedErrorLow", static_cast<float>(estimate->low)});
    file.attributes.push_back({"estimatedErrorHigh", static_cast<float>(estimate->high)});
  }
  return file;
}

}  // namespace command
