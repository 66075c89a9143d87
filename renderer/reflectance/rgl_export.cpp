#include "renderer/reflectance/rgl_export.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>

#include "renderer/reflectance/halton.h"
#include "renderer/reflectance/rgl_tables.h"
#include "renderer/reflectance/tensor_file.h"

namespace reflectance {

InterpolationError interpolation_error(const BrdfValue& table, const Reflector& reflector) {
  constexpr std::uint32_t Count = 100'000;
  constexpr float LeastCosine = 0.0871557F;
  constexpr double GoldenRatio = 0.6180339887498949;
  const bool has_azimuths = is_anisotropic(reflector.brdf());
  InterpolationError error;
  double mean_value = 0;
  for (std::uint32_t i = 0; i < Count; ++i) {
    const Uniforms xi = halton_point(i);
    const float cosine = 1 - xi.choice * (1 - LeastCosine);
    const auto turns = static_cast<float>(std::fmod(i * GoldenRatio, 1.0));
    const float azimuth = has_azimuths ? 2 * Pi * turns : 0;
    const Vec3f u = from_angles(cosine, std::sqrt(1 - cosine * cosine), azimuth);
    const float other = 1 - xi.direction.x * (1 - LeastCosine);
    const Vec3f v = from_angles(other, std::sqrt(1 - other * other), azimuth + 2 * Pi * xi.direction.y);
    const Rgb value = reflector.evaluate(u, v);
    const Rgb difference = table(u, v) - value;
    const double size = std::max({std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)});
    error.largest = std::max(error.largest, size);
    error.mean += size / Count;
    mean_value += double(std::max({value.x, value.y, value.z})) / Count;
  }
  error.relative = mean_value > 0 ? error.mean / mean_value : 0;
  return error;
}

Reflector reflector_of_rgl(std::string bytes) {
  std::string problem;
  const auto file = TensorFile::parse(std::make_shared<const std::string>(std::move(bytes)), problem);
  auto tables = file ? read_rgl_tables(*file, problem) : std::nullopt;
  if (!tables) throw std::logic_error("the file that was made cannot be read: " + problem);
  Rgl rgl;
  rgl.data = std::make_shared<const RglData>(*std::move(tables));
  return {rgl, OwnScheme()};
}

RglExport export_rgl(const Reflector& reflector, const RglExportSettings& settings) {
  constexpr double Finer = 1.5;
  RglExport result;
  result.resolution = settings.resolution.value_or(1);
  for (;; result.resolution *= Finer) {
    const RglResolution resolution = RglResolution().times(result.resolution);
    result.bytes = rgl_file_of(reflector.brdf(), resolution, settings.colours, settings.description);
    const Reflector table = reflector_of_rgl(result.bytes);
    result.error =
        interpolation_error([&](const Vec3f& u, const Vec3f& v) { return table.evaluate(u, v); }, reflector);
    result.is_fine = settings.resolution || result.error.relative <= settings.largest_error;
    if (!result.is_fine && result.resolution * Finer <= settings.finest) continue;
    if (settings.colour == Rgb(1)) return result;
    result.bytes =
        rgl_file_of(reflector.brdf(), resolution, settings.colours, settings.description, settings.colour);
    return result;
  }
}

}  // namespace reflectance
