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

/// Names of their own for the images inside a file, good for files in one folder.
class ImageNames {
 public:
  /// The name with the extension (with a dot) of the image's kind, and with `_2` and so on before that where
  /// it was taken before. A name that came from here stays as it is.
  std::string take(std::string_view wanted, std::string_view extension);

 private:
  // Some file systems know no case.
  grf::UniqueNames names_{grf::UniqueNames::Case::Ignored};
};

/// The images of a glTF file: files beside it, or bytes inside it that become files of their own.
class GltfImages {
 public:
  GltfImages(const GltfFile& file, GltfAccessors& accessors) : file_(file), accessors_(accessors) {}

  /// Takes the embedded images out of the file; false after an error.
  bool load();

  /// The image of a texture of the file by the name under which a scene has it, or nothing.
  std::optional<grf::Texture> texture(int index) const;

  /// Whether lookups outside the image repeat it, as GRF's do.
  bool repeats(int texture) const;

  std::vector<EmbeddedFile> take_files() { return std::move(embedded_); }

 private:
  std::string free_name(const tinygltf::Image& image, std::size_t index, std::string_view bytes);

  const GltfFile& file_;
  GltfAccessors& accessors_;
  std::vector<std::string> names_;  ///< of each image
  ImageNames free_names_;
  std::vector<EmbeddedFile> embedded_;
};

/// What kind of image the bytes are, as the extension of a file with a dot; empty if that is not known.
std::string_view image_extension(std::string_view bytes);

/// A name as a URI has it, and back (RFC 3986, section 2.1).
std::string to_uri(std::string_view path);
std::string from_uri(std::string_view uri);

}  // namespace convert
