#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/math.h"

namespace image {

/// Linear RGB radiance, rows from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<grf::Colour> pixels;
  std::vector<float> alpha = {};  ///< per pixel, with colours that are multiplied by it; empty: 1

  const grf::Colour& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// The treatment of transparent pixels by readers.
enum class Alpha {
  OverBlack,  ///< they are composited over black
  Kept        ///< the image keeps its alpha, if the file has one
};

/// Reads OpenEXR, Radiance, PFM, raw, PNG, JPEG, TGA or WebP; the format is detected from the contents (raw
/// and TGA from the extension). 8-bit images are taken as sRGB-encoded, 16-bit ones as linear unless the file
/// says otherwise. Anything wrong with the file is one error, located at `asked_for_at` or else at the file
/// itself. Values are returned as stored, NaN and negative ones included.
std::optional<Image> read_image(const std::string& path, grf::Diagnostics& diagnostics,
                                const grf::SourceLocation& asked_for_at = {}, Alpha alpha = Alpha::OverBlack);

/// An image reader such as `read_image`; others may read in another process.
using ImageReader = std::function<std::optional<Image>(const std::string& path, grf::Diagnostics& diagnostics,
                                                       const grf::SourceLocation& asked_for_at, Alpha alpha)>;

/// Whether a file name has this extension; case is ignored.
bool has_extension(const std::string& path, std::string_view extension);

}  // namespace image
