// A BRDF is exported to a file of the RGL data base, which is as fine as an error asks for.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "renderer/reflectance/reflector.h"
#include "renderer/reflectance/rgl_writer.h"

namespace reflectance {

/// A function of the view and the light, such as a BRDF's table.
using BrdfValue = std::function<Rgb(const Vec3f& u, const Vec3f& v)>;

/// The difference between a table and its BRDF.
struct InterpolationError {
  double largest = 0;   ///< in 1/sr
  double mean = 0;      ///< in 1/sr
  double relative = 0;  ///< the mean as a fraction of the BRDF's mean
};

/// Measures the error over directions up to 85 degrees from the normal: beyond, models are unbounded.
InterpolationError interpolation_error(const BrdfValue& table, const Reflector& reflector);

/// How fine an exported file is.
struct RglExportSettings {
  RglColours colours = RglColours::LinearSrgb;
  std::optional<double> resolution;  ///< a factor of the nodes along each axis; absent: by `largest_error`
  double largest_error = 0.02;       ///< relative
  double finest = 4;                 ///< the largest factor that is tried
  Rgb colour = Rgb(1);               ///< multiplies all values
  std::string description;
};

/// A BRDF as tables of the RGL format, and how far they are from it.
struct RglExport {
  std::string bytes;
  double resolution = 1;     ///< the factor
  InterpolationError error;  ///< without the colour
  bool is_fine = true;       ///< whether the error is at most that of the settings, or a resolution was given
};

/// Tabulates a BRDF without its delta part, with more and more nodes until the error is small enough.
RglExport export_rgl(const Reflector& reflector, const RglExportSettings& settings);

/// Reads a file's bytes as the model `rgl` does. They must be those of a written file.
Reflector reflector_of_rgl(std::string bytes);

}  // namespace reflectance
