// An image file holds more than its samples: this is known before they are rendered.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/image/image_file.h"

namespace command {

/// The metadata and the layers of an image file that are known before its samples.
struct ImageDescription {
  std::vector<image::ImageAttribute> attributes;
  std::vector<image::ImageLayer> features;  ///< albedo, normal and depth, as far as they are asked for
  std::vector<std::string> layers;          ///< the names of all layers that are asked for
  float exposure = 0;                       ///< in stops
  float screen_width = 0;                   ///< as in ImageFile
};

/// Returns a description as bytes, for a part file.
std::string bytes_of(const ImageDescription& description);

/// Reads these bytes; empty if they are no description of an image of this many pixels.
std::optional<ImageDescription> image_description_of(std::string_view bytes, std::size_t pixels);

}  // namespace command
