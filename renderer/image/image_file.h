// An image file has an image, layers and metadata, in one of several formats.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "grf/math.h"
#include "renderer/image/image.h"

namespace image {

/// An extra layer of per-pixel values, such as `normal` with the channels X, Y and Z.
struct ImageLayer {
  std::string name;
  std::string channels;       ///< one letter per channel; empty: a single channel with the layer's name
  std::vector<float> values;  ///< pixel by pixel, rows from the top

  std::size_t channel_count() const { return channels.empty() ? 1 : channels.size(); }
};

/// Metadata of an image, such as an option of its render.
struct ImageAttribute {
  std::string name;
  std::variant<std::string, float, grf::Vec3f, Imath::M44f> value;
};

/// The contents of an image file. EXR stores all of it, the other formats only the image.
struct ImageFile {
  Image image;
  std::vector<ImageLayer> layers = {};
  std::vector<ImageAttribute> attributes = {};
  /// The width of the image plane at distance 1 from the eye; 0: unknown.
  float screen_width = 0;
  /// Exposure in stops, for 8-bit formats.
  float exposure = 0;
};

/// An image file format, identified by the extension.
struct ImageFormat {
  std::string_view extension;  ///< lower case, without the dot
  std::string_view title;
  int largest_side = 0;  ///< in pixels
  bool holds_layers = false;
  bool is_linear = false;  ///< else 8 bits encoded in sRGB, after exposure
  std::string (*encode)(const ImageFile& file) = nullptr;
};

const std::vector<ImageFormat>& image_formats();

/// The extensions of image files that can be read, lower case and without the dot.
constexpr std::array<std::string_view, 9> ReadableExtensions = {"exr", "hdr",  "pfm", "raw", "png",
                                                                "jpg", "jpeg", "tga", "webp"};

/// Returns patterns of the names of these files, `*.exr *.hdr` and so on, as file dialogs take them.
std::string readable_name_patterns();

/// Returns the format for a path's extension, or null after an error.
const ImageFormat* image_format_of(const std::string& path, grf::Diagnostics& diagnostics);

/// Replaces the file with the image, or leaves it unchanged and reports why.
bool write_image(const ImageFile& file, const std::string& path, grf::Diagnostics& diagnostics);

/// Writes an image that must not be lost. If that fails, as on a full disk, the image is written to a
/// new folder in the first of `fallbacks` that accepts it, a note says where, and false is returned all the
/// same.
bool keep_image(const ImageFile& file, const std::string& path, const std::vector<std::string>& fallbacks,
                grf::Diagnostics& diagnostics);

/// Returns the system's folder for temporary files, and the user's home folder.
std::vector<std::string> fallback_folders();

/// Makes a layer from an image's three channels.
ImageLayer layer_of(std::string name, std::string channels, const Image& image);

/// Makes an image of a layer: a single channel is grey, and channels behind the third one are left out.
Image image_of(const ImageLayer& layer, int width, int height);

/// Reads an image as `read_image` does, and the layers of an OpenEXR file (its first part): the channels
/// `name.X`, `name.Y`, ... are a layer, and each further channel without a point is one. If none of them is
/// the image, as in files with several render passes, the image is the first layer in colour, or else the
/// first one. Subsampled channels are left out.
std::optional<ImageFile> read_image_file(const std::string& path, grf::Diagnostics& diagnostics);

}  // namespace image
