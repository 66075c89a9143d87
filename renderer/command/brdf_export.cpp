// `bpt brdf export` tabulates a BRDF in a format of measured data, and states how far the table is from it.
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"
#include "renderer/command/brdf_command.h"
#include "renderer/command/json_values.h"
#include "renderer/command/printed.h"
#include "renderer/image/image.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/brdf_instance.h"
#include "renderer/reflectance/merl_table.h"
#include "renderer/reflectance/rgl_export.h"
#include "renderer/reflectance/spectrum.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;
using reflectance::interpolation_error;
using reflectance::InterpolationError;
using reflectance::Reflector;
using reflectance::Rgb;
using reflectance::Vec3f;

/// Directional albedos of a BRDF and of its table.
struct AlbedoPair {
  double degrees = 0;  ///< of the view from the normal
  Rgb albedo;
  Rgb table_albedo;
};

std::vector<AlbedoPair> albedos_of(const Reflector& reflector, const Reflector& table) {
  std::vector<AlbedoPair> pairs;
  for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
    const double theta = degrees * double(reflectance::Pi) / 180;
    const Vec3f u(static_cast<float>(std::sin(theta)), 0, static_cast<float>(std::cos(theta)));
    const Rgb without_delta =
        reflectance::albedo(reflector, u) - reflectance::specular_weight(reflector.brdf(), u);
    pairs.push_back({degrees, without_delta, reflectance::albedo(table, u)});
  }
  return pairs;
}

/// The result of an export, as it is printed.
struct Exported {
  InterpolationError error;
  std::vector<AlbedoPair> albedos;  ///< empty for MERL
  double resolution = 0;            ///< of an RGL file; 0 for MERL
};

void print_export(const Exported& exported, const BrdfArguments& arguments) {
  const InterpolationError& error = exported.error;
  if (!arguments.json) {
    fmt::print("{}: the interpolation error is {:.2g} on average and {:.2g} at most, in 1/sr\n",
               arguments.output, error.mean, error.largest);
    if (exported.albedos.empty()) return;
    fmt::print("the average is {:.2g} % of the mean value, at resolution {:.3g}\n", 100 * error.relative,
               exported.resolution);
    for (const AlbedoPair& pair : exported.albedos) {
      fmt::print("albedo at {} degrees: {:.4f} {:.4f} {:.4f}, of the file {:.4f} {:.4f} {:.4f}\n",
                 pair.degrees, pair.albedo.x, pair.albedo.y, pair.albedo.z, pair.table_albedo.x,
                 pair.table_albedo.y, pair.table_albedo.z);
    }
    return;
  }
  nlohmann::ordered_json result = {{"file", arguments.output},
                                   {"largest_interpolation_error", error.largest},
                                   {"mean_interpolation_error", error.mean}};
  if (!exported.albedos.empty()) {
    result["relative_error"] = error.relative;
    result["resolution"] = exported.resolution;
    result["albedos"] = nlohmann::ordered_json::array();
    for (const AlbedoPair& pair : exported.albedos) {
      result["albedos"].push_back({{"degrees", pair.degrees},
                                   {"albedo", json_array(pair.albedo)},
                                   {"of_file", json_array(pair.table_albedo)}});
    }
  }
  fmt::print("{}\n", json_text(result, true));
}

std::optional<Exported> export_merl(const Reflector& reflector, const std::string& path,
                                    Diagnostics& diagnostics) {
  std::string why_not;
  if (reflectance::is_anisotropic(reflector.brdf()))
    why_not = "it is anisotropic, and the MERL format holds isotropic BRDFs only";
  if (reflectance::has_specular_part(reflector.brdf()))
    why_not = "its specular (delta) part has no finite value";
  if (!why_not.empty()) {
    diagnostics.error(grf::whole_file(path), "cannot export the BRDF: " + why_not);
    return std::nullopt;
  }
  const reflectance::MerlTable table(
      [&](const Vec3f& u, const Vec3f& v) { return reflector.evaluate(u, v); });
  if (!table.write(path, diagnostics)) return std::nullopt;
  const auto value = [&](const Vec3f& u, const Vec3f& v) {
    return table.linear(reflectance::half_angles(u, v));
  };
  return Exported{interpolation_error(value, reflector), {}, 0};
}

/// Makes a file of the RGL data base, of which readers differ: pbrt takes spectra only, and Mitsuba 3 spectra
/// in its spectral variants and RGB in the others.
std::optional<Exported> write_rgl(const Reflector& reflector, const BrdfArguments& arguments,
                                  Diagnostics& diagnostics) {
  const bool is_spectral = arguments.reader.empty() ? !reflectance::wavelengths_of(reflector.brdf()).empty()
                                                    : arguments.reader != "mitsuba";
  const grf::SourceLocation location = grf::whole_file(arguments.output);
  if (reflectance::has_specular_part(reflector.brdf()))
    diagnostics.warning(location, "the specular (delta) part is left out: a second material has to add it");
  reflectance::RglExportSettings settings;
  settings.colours = is_spectral ? reflectance::RglColours::Spectra : reflectance::RglColours::LinearSrgb;
  settings.resolution = arguments.resolution;
  settings.largest_error = arguments.largest_error;
  settings.description = "made by Granada of " + arguments.instance;
  const reflectance::RglExport file = reflectance::export_rgl(reflector, settings);
  if (!file.is_fine) {
    diagnostics.error(location,
                      fmt::format("the error is {:.2g} of the mean value at the finest resolution, {:.3g}; "
                                  "--error {} is not reached",
                                  file.error.relative, file.resolution, arguments.largest_error));
    return std::nullopt;
  }
  if (!grf::replace_file(arguments.output, file.bytes, diagnostics)) return std::nullopt;
  return Exported{file.error, albedos_of(reflector, reflectance::reflector_of_rgl(file.bytes)),
                  file.resolution};
}

}  // namespace

ExitCode export_brdf(const BrdfArguments& arguments) {
  const auto reflector = printed(
      [&](Diagnostics& diagnostics) { return reflectance::read_instance(arguments.instance, diagnostics); });
  if (!reflector) return ExitCode::BadInput;
  Diagnostics diagnostics;
  const bool is_rgl = image::has_extension(arguments.output, "bsdf");
  const auto exported = is_rgl ? write_rgl(*reflector, arguments, diagnostics)
                               : export_merl(*reflector, arguments.output, diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (!exported) return ExitCode::BadInput;
  print_export(*exported, arguments);
  return ExitCode::Done;
}

}  // namespace command
