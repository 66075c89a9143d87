#pragma once

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

/// A file format for images, told by the extension.
struct ImageFormat {
  std::string_view extension;  ///< lower case, without the dot
  std::string_view title;
  std::string (*encode)(const Image& image);
};

const std::vector<ImageFormat>& image_formats();

/// The format that a path's extension means, or null after an error.
const ImageFormat* image_format_of(const std::string& path, grf::Diagnostics& diagnostics);

/// Replaces the file by the image, or leaves it as it was and says why. EXR keeps linear radiance in 32-bit
/// floats; PNG is sRGB-encoded, with radiance 1 as white.
bool write_image(const Image& image, const std::string& path, grf::Diagnostics& diagnostics);

/// Reads OpenEXR, Radiance, pfm, PNG, JPEG or TGA, told by what the file holds (TGA by its name). 8-bit
/// images are taken to be sRGB-encoded, and 16-bit ones to be linear unless they say otherwise. Anything
/// wrong with the file is one error, at the place that asked for it or of the file itself. Values are as they
/// stand there, NaN and negative ones too.
std::optional<Image> read_image(const std::string& path, grf::Diagnostics& diagnostics,
                                const grf::SourceLocation& asked_for_at = {});

/// Whether a file's name ends so, without regard to case.
bool has_extension(const std::string& path, std::string_view extension);

}  // namespace transport
