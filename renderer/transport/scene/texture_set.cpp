#include "renderer/transport/scene/texture_set.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/wording.h"
#include "renderer/image/srgb.h"
#include "renderer/parallel/loops.h"

namespace transport {
namespace {

struct Read {
  TextureFile file;
  grf::Diagnostics diagnostics = grf::Diagnostics::to_be_repeated();
};

/// Finds the files that were read before.
class FilesBefore {
 public:
  explicit FilesBefore(std::span<const TextureFile> files) {
    for (const TextureFile& file : files) by_path_.try_emplace({file.path, file.content}, &file);
  }

  /// Returns the texture of a file that has not changed since it was read, or null.
  std::shared_ptr<const Texture> texture_of(const TextureFile& file) const {
    const auto known = by_path_.find({file.path, file.content});
    return known != by_path_.end() && known->second->is_same_as(file) ? known->second->texture : nullptr;
  }

 private:
  std::map<std::pair<std::string_view, TextureContent>, const TextureFile*> by_path_;
};

/// Returns whether a value is that of a byte in sRGB, but for the rounding by alpha.
bool is_of_srgb_byte(float value) {
  constexpr float Rounding = 1e-6F;
  return std::abs(image::srgb_table()[image::to_srgb_byte(value)] - value) <= Rounding * value;
}

/// Makes an image of what a file stores: integers of 8 bits are read as encoded in sRGB, other numbers as
/// they are.
image::Image as_stored(image::Image image) {
  for (std::size_t i = 0; i < image.alpha.size(); ++i) {
    if (image.alpha[i] > 0) image.pixels[i] /= image.alpha[i];
  }
  const bool has_bytes = std::ranges::all_of(image.pixels, [](const reflectance::Rgb& pixel) {
    return is_of_srgb_byte(pixel.x) && is_of_srgb_byte(pixel.y) && is_of_srgb_byte(pixel.z);
  });
  if (!has_bytes) return image;
  for (reflectance::Rgb& pixel : image.pixels) {
    for (int k = 0; k < 3; ++k) pixel[k] = static_cast<float>(image::to_srgb_byte(pixel[k])) / 255;
  }
  return image;
}

image::Image contents(image::Image image, TextureContent content) {
  if (content == TextureContent::AlphaAsData) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      image.pixels[i] = reflectance::Rgb(image.alpha.empty() ? 1 : image.alpha[i]);
    }
  } else if (content == TextureContent::Data) {
    image = as_stored(std::move(image));
  }
  if (content != TextureContent::WithAlpha) image.alpha.clear();
  return image;
}

void read(const std::string& path, TextureContent content, const grf::SourceLocation& asked_for_at,
          const image::ImageReader& read_image, const FilesBefore& before, Read& result) {
  TextureFile& file = result.file;
  file.path = grf::canonical_path(path);
  file.content = content;
  std::error_code missing;  // which reading reports
  file.changed = std::filesystem::last_write_time(file.path, missing);
  if (!missing) file.texture = before.texture_of(file);
  if (!file.texture) {
    const auto alpha = content == TextureContent::OverBlack ? image::Alpha::OverBlack : image::Alpha::Kept;
    auto image = read_image(path, result.diagnostics, asked_for_at, alpha);
    if (!image) image = image::Image{1, 1, {reflectance::Rgb(1)}, {}};
    const bool is_data = content == TextureContent::Data || content == TextureContent::AlphaAsData;
    file.texture = std::make_shared<const Texture>(contents(*std::move(image), content),
                                                   is_data ? TexelEncoding::Linear : TexelEncoding::Srgb);
  }
  const std::size_t wrong = file.texture->invalid_texels();
  if (wrong == 0) return;
  result.diagnostics.warning(asked_for_at,
                             fmt::format("'{}': {} as 0", path,
                                         grf::counted(wrong, "texel is negative or not finite, and counts",
                                                      "texels are negative or not finite, and count")));
}

}  // namespace

std::uint32_t TextureSetBuilder::index_of(const std::string& path, const grf::SourceLocation& location,
                                          TextureContent content) {
  const auto [known, is_new] = index_by_path_.try_emplace({grf::canonical_path(path), content},
                                                          static_cast<std::uint32_t>(files_.size()));
  if (is_new) files_.push_back({path, content, location});
  return known->second;
}

std::uint32_t TextureSetBuilder::index_of(const grf::Texture& texture, TextureContent content) {
  const auto& file = texture.location.file;
  return index_of(file ? grf::path_beside(file->path, texture.file) : texture.file, texture.location,
                  content);
}

std::vector<TextureFile> TextureSetBuilder::build(std::span<const TextureFile> before) {
  std::vector<Read> results(files_.size());
  const FilesBefore known(before);
  parallel::for_each_index(files_.size(), [&](std::size_t i) {
    read(files_[i].path, files_[i].content, files_[i].asked_for_at, read_image_, known, results[i]);
  });
  std::vector<TextureFile> textures;
  for (Read& result : results) {
    for (const grf::Diagnostic& entry : result.diagnostics.entries()) {
      if (entry.severity == grf::Severity::Error) diagnostics_.error(entry.location, entry.message);
      if (entry.severity == grf::Severity::Warning) diagnostics_.warning(entry.location, entry.message);
    }
    for (const std::string& file : result.diagnostics.files()) diagnostics_.add_file(file);
    textures.push_back(std::move(result.file));
  }
  return textures;
}

}  // namespace transport
