// Images on their way to files: with what is known of them, in the formats that there are.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "grf/math.h"
#include "renderer/transport/image/image.h"

namespace transport {

/// Values for each pixel besides the image: `normal` with the channels X, Y and Z, say.
struct ImageLayer {
  std::string name;
  std::string channels;       ///< a letter each; empty: one channel, called as the layer
  std::vector<float> values;  ///< pixel after pixel, rows from the top
};

/// Something that is known of an image, such as an option of its render.
struct ImageAttribute {
  std::string name;
  std::variant<std::string, float, grf::Vec3f, Imath::M44f> value;
};

/// What a file is made of. Each format takes what it can hold: EXR all, the others the image.
struct ImageFile {
  Image image;
  std::vector<ImageLayer> layers = {};
  std::vector<ImageAttribute> attributes = {};
  /// The width of the image's plane at distance 1 from the eye; 0: not known.
  float screen_width = 0;
  /// Stops, for formats of 8 bits.
  float exposure = 0;
};

/// A file format for images, told by the extension.
struct ImageFormat {
  std::string_view extension;  ///< lower case, without the dot
  std::string_view title;
  int largest_side = 0;  ///< in pixels
  bool holds_layers = false;
  std::string (*encode)(const ImageFile& file) = nullptr;
};

const std::vector<ImageFormat>& image_formats();

/// The format that a path's extension means, or null after an error.
const ImageFormat* image_format_of(const std::string& path, grf::Diagnostics& diagnostics);

/// Replaces the file by the image, or leaves it as it was and says why.
bool write_image(const ImageFile& file, const std::string& path, grf::Diagnostics& diagnostics);

/// The same for an image that must not be lost. If it cannot be written there, as on a full disk, it is kept
/// in a new folder in the first of these that takes it, and a note says where; false all the same.
bool keep_image(const ImageFile& file, const std::string& path, const std::vector<std::string>& fallbacks,
                grf::Diagnostics& diagnostics);

/// The system's folder for temporary files, and the user's own.
std::vector<std::string> fallback_folders();

/// A layer of an image's three values.
ImageLayer layer_of(std::string name, std::string channels, const Image& image);

}  // namespace transport
