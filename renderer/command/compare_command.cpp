#include "renderer/command/compare_command.h"

#include <cstdio>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/command/json_values.h"
#include "renderer/image/image_error.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;
using image::ImageError;

struct Comparison {
  ImageError error;
  image::VisibleDifference visible;
};

/// Returns nothing after an error.
std::optional<Comparison> compare(const CompareArguments& arguments, Diagnostics& diagnostics) {
  const auto image = image::read_image(arguments.image, diagnostics);
  const auto reference = image::read_image(arguments.reference, diagnostics);
  if (!image || !reference) return std::nullopt;
  if (image->width != reference->width || image->height != reference->height) {
    diagnostics.error(grf::whole_file(arguments.image),
                      fmt::format("the image has {} x {} pixels, expected {} x {} as '{}' has", image->width,
                                  image->height, reference->width, reference->height, arguments.reference));
    return std::nullopt;
  }
  const ImageError error = image::error_of(*image, *reference);
  if (error.nan_pixels < image->pixels.size()) {
    const image::Viewing viewing = {arguments.exposure, arguments.pixels_per_degree};
    return Comparison{error, image::summary_of(visible_differences(image::seen(*image, viewing),
                                                                   image::seen(*reference, viewing)))};
  }
  diagnostics.error(grf::whole_file(arguments.image),
                    fmt::format("no pixel is finite both here and in '{}'", arguments.reference));
  return std::nullopt;
}

void print_json(const Comparison& comparison, const CompareArguments& arguments) {
  const auto& [error, visible] = comparison;
  nlohmann::ordered_json json;
  json["rmse"] = error.rmse;
  json["relmse"] = error.relmse;
  json["average_relative_error"] = number_or_null(error.average_relative_error);
  json["psnr"] = number_or_null(error.psnr);
  json["max"] = error.max;
  json["nan_pixels"] = error.nan_pixels;
  json["fireflies"] = error.fireflies;
  json["visible_difference"] = json_of(visible, {arguments.exposure, arguments.pixels_per_degree});
  fmt::print("{}\n", json_text(json, false));
}

void print_text(const Comparison& comparison) {
  const auto& [error, visible] = comparison;
  const auto print = [](const char* name, const std::string& value) {
    fmt::print("  {:<24}{}\n", name, value);
  };
  const auto number = [](double value) { return fmt::format("{:.6g}", value); };
  print("rmse", number(error.rmse));
  print("relmse", number(error.relmse));
  print("average relative error", error.average_relative_error
                                      ? fmt::format("{:.4g} %", 100 * *error.average_relative_error)
                                      : "none, the reference is black");
  print("psnr", error.psnr ? fmt::format("{:.4g} dB", *error.psnr) : "none");
  print("max", number(error.max));
  print("pixels that are NaN", fmt::format("{}", error.nan_pixels));
  print("fireflies", fmt::format("{}", error.fireflies));
  print("visible difference",
        fmt::format("mean {:.3g}, 95th percentile {:.3g}", visible.mean, visible.percentile_95));
}

}  // namespace

ExitCode compare(const CompareArguments& arguments) {
  Diagnostics diagnostics;
  const auto comparison = compare(arguments, diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (!comparison) return ExitCode::BadInput;
  if (arguments.json) {
    print_json(*comparison, arguments);
  } else {
    print_text(*comparison);
  }
  return ExitCode::Done;
}

}  // namespace command
