#include "renderer/command/render_output.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "renderer/job/image_layers.h"

namespace command {
namespace {

using grf::Diagnostics;
using image::ImageAttribute;
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

ImageDescription description_of(const transport::Render& render, const transport::CompiledScene& scene,
                                const RenderOptions& render_options) {
  const transport::View& view = render.settings().view;
  const transport::Camera camera(view, render.film().width(), render.film().height());
  ImageDescription description;
  description.exposure = render_options.exposure;
  description.screen_width = camera.screen_width();
  description.layers = render_options.layers;
  description.features = job::feature_layers(render, scene, render_options);

  RenderOptions known = render_options;
  known.eye = view.eye;
  known.target = view.target;
  known.samples = render_options.samples_per_pixel();
  add_options(known, description.attributes);
  description.attributes.push_back({"software", "Granada " GRANADA_VERSION});
  description.attributes.push_back({"worldToCamera", camera.world_to_camera()});
  description.attributes.push_back({"worldToNDC", camera.world_to_image()});
  return description;
}

image::ImageFile image_file_of(const Film& film, ImageDescription description, double seconds,
                               const std::optional<transport::ErrorEstimate>& estimate) {
  image::ImageFile file;
  file.image = film.mean();
  file.exposure = description.exposure;
  file.screen_width = description.screen_width;
  file.layers = std::move(description.features);
  for (image::ImageLayer& layer : job::film_layers(film, description.layers))
    file.layers.push_back(std::move(layer));
  file.attributes = std::move(description.attributes);
  file.attributes.push_back({"renderSeconds", static_cast<float>(seconds)});
  file.attributes.push_back({"samplesPerPixel", static_cast<float>(mean_samples(film))});
  if (estimate) {
    file.attributes.push_back({"estimatedError", static_cast<float>(estimate->error)});
    file.attributes.push_back({"estimatedErrorLow", static_cast<float>(estimate->low)});
    file.attributes.push_back({"estimatedErrorHigh", static_cast<float>(estimate->high)});
  }
  return file;
}

}  // namespace command
