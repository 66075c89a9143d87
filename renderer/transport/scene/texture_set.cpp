#include "renderer/transport/scene/texture_set.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "renderer/parallel/loops.h"

namespace transport {
namespace {

struct Read {
  std::optional<Texture> texture;
  grf::Diagnostics diagnostics;
};

void read(const std::string& path, const grf::SourceLocation& asked_for_at, Read& result) {
  auto image = read_image(path, result.diagnostics, asked_for_at);
  if (!image) image = Image{1, 1, {reflectance::Rgb(1)}};
  result.texture.emplace(std::move(*image));
  const std::size_t wrong = result.texture->wrong_texels();
  if (wrong == 0) return;
  result.diagnostics.warning(
      asked_for_at, fmt::format("'{}': {} texels are negative or not finite, and count as 0", path, wrong));
}

}  // namespace

std::uint32_t TextureSetBuilder::index_of(const grf::Texture& texture) {
  const auto& file = texture.location.file;
  const std::string path = file ? grf::path_beside(file->path, texture.file) : texture.file;
  const auto [known, is_new] =
      index_by_path_.try_emplace(grf::canonical_path(path), static_cast<std::uint32_t>(files_.size()));
  if (is_new) files_.push_back({path, texture.location});
  return known->second;
}

std::vector<Texture> TextureSetBuilder::build(int threads) {
  std::vector<Read> results(files_.size());
  if (!files_.empty()) {
    parallel::run_with_threads(threads, [&] {
      parallel::for_each_index(
          files_.size(), [&](std::size_t i) { read(files_[i].path, files_[i].asked_for_at, results[i]); });
    });
  }
  std::vector<Texture> textures;
  for (Read& result : results) {
    for (const grf::Diagnostic& entry : result.diagnostics.entries()) {
      if (entry.severity == grf::Severity::Error) diagnostics_.error(entry.location, entry.message);
      if (entry.severity == grf::Severity::Warning) diagnostics_.warning(entry.location, entry.message);
    }
    textures.push_back(std::move(*result.texture));
  }
  return textures;
}

}  // namespace transport
