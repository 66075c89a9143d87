#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "converters/format.h"
#include "converters/gltf/gltf_accessors.h"
#include "converters/gltf/gltf_file.h"
#include "grf/unique_names.h"

namespace convert {

/// Unique file names for embedded images, within one folder.
class ImageNames {
 public:
  /// Returns the name with the image's extension (with a dot), preceded by `_2` and so on if the name was
  /// taken before. Names returned from here stay unchanged.
  std::string take(std::string_view wanted, std::string_view extension);

 private:
  // Some file systems are case-insensitive.
  grf::UniqueNames names_{grf::UniqueNames::Case::Ignored};
};

/// The images of a glTF file: files beside it, or embedded bytes that are extracted to files.
class GltfImages {
 public:
  GltfImages(const GltfFile& file, GltfAccessors& accessors) : file_(file), accessors_(accessors) {}

  /// Extracts the embedded images of the file; returns false after an error.
  bool load();

  /// Returns the image of a texture of the file, by its name in the scene, or nothing.
  std::optional<grf::Texture> texture(int index) const;

  /// Returns whether the texture's wrap mode is repeat, as in GRF.
  bool repeats(int texture) const;

  std::vector<EmbeddedFile> take_files() { return std::move(embedded_); }

 private:
  std::string free_name(const tinygltf::Image& image, std::size_t index, std::string_view bytes);

  const GltfFile& file_;
  GltfAccessors& accessors_;
  std::vector<std::string> names_;  ///< by image
  ImageNames free_names_;
  std::vector<EmbeddedFile> embedded_;
};

/// Detects the format of an image from its bytes, as a file extension with a dot; empty if unknown.
std::string_view image_extension(std::string_view bytes);

/// Percent-encodes a name as a URI, and decodes it (RFC 3986, section 2.1).
std::string to_uri(std::string_view path);
std::string from_uri(std::string_view uri);

}  // namespace convert
