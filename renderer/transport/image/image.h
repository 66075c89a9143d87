#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/reflectance/geometry.h"

namespace transport {

/// Linear RGB radiance, rows from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<reflectance::Rgb> pixels;

  const reflectance::Rgb& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// Reads OpenEXR, Radiance, pfm, raw, PNG, JPEG or TGA, told by what the file holds (raw and TGA by its
/// name). 8-bit images are taken to be sRGB-encoded, and 16-bit ones to be linear unless they say otherwise.
/// Anything wrong with the file is one error, at the place that asked for it or of the file itself. Values
/// are as they stand there, NaN and negative ones too.
std::optional<Image> read_image(const std::string& path, grf::Diagnostics& diagnostics,
                                const grf::SourceLocation& asked_for_at = {});

/// Reads images as `read_image` does, which it may be. One of another kind may do so in another process.
using ImageReader = std::function<std::optional<Image>(const std::string& path, grf::Diagnostics& diagnostics,
                                                       const grf::SourceLocation& asked_for_at)>;

/// Whether a file's name ends so, without regard to case.
bool has_extension(const std::string& path, std::string_view extension);

}  // namespace transport
