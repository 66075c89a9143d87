#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/model.h"
#include "renderer/transport/scene/texture.h"

namespace transport {

/// The content of a texture is one of these readings of an image file.
enum class TextureContent {
  OverBlack,   ///< colours, over black where the image is transparent
  WithAlpha,   ///< colours, and alpha apart, 1 if the file has none
  Data,        ///< red, green and blue as the file stores them, as parameters of BRDFs are
  AlphaAsData  ///< alpha in all three channels
};

/// An image file at the time when it was read.
struct TextureFile {
  std::string path;
  TextureContent content = TextureContent::OverBlack;
  std::filesystem::file_time_type changed;
  std::shared_ptr<const Texture> texture;

  bool is_same_as(const TextureFile& other) const {
    return path == other.path && content == other.content && changed == other.changed;
  }
};

/// Collects the image files that surfaces name, and reads each once for each content that they need.
class TextureSetBuilder {
 public:
  TextureSetBuilder(const image::ImageReader& read_image, grf::Diagnostics& diagnostics)
      : read_image_(read_image), diagnostics_(diagnostics) {}

  /// Returns the index that the texture of a file will have.
  std::uint32_t index_of(const std::string& path, const grf::SourceLocation& location,
                         TextureContent content);
  /// Returns the index that a surface's texture will have.
  std::uint32_t index_of(const grf::Texture& texture, TextureContent content);

  /// Reads all files, in parallel, except those that were read before and have not changed. One that cannot
  /// be read is an error at its first use, and leaves a white texture.
  std::vector<TextureFile> build(std::span<const TextureFile> before = {});

 private:
  struct File {
    std::string path;
    TextureContent content;
    grf::SourceLocation asked_for_at;
  };

  const image::ImageReader& read_image_;
  grf::Diagnostics& diagnostics_;
  std::vector<File> files_;
  std::map<std::pair<std::string, TextureContent>, std::uint32_t> index_by_path_;
};

}  // namespace transport
