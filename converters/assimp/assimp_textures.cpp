#include "converters/assimp/assimp_textures.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "converters/assimp/assimp_import.h"
#include "grf/keywords.h"

namespace convert {
namespace {

void append_word(std::string& bytes, unsigned value) {
  bytes += static_cast<char>(value & 0xFFU);
  bytes += static_cast<char>(value >> 8U);
}

/// Encodes pixels, in Assimp's order from the top row down, as an uncompressed TGA file of 32 bits per pixel.
std::string tga_of(const aiTexture& texture) {
  std::string bytes("\0\0\2\0\0\0\0\0\0\0\0\0", 12);  // no name, no palette, true colour, at (0, 0)
  append_word(bytes, texture.mWidth);
  append_word(bytes, texture.mHeight);
  bytes += "\x20\x28";  // 8 of the bits are alpha; the first row is the top one
  const std::size_t count = std::size_t{texture.mWidth} * texture.mHeight;
  bytes.reserve(bytes.size() + 4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const aiTexel& texel = texture.pcData[i];
    for (const unsigned char byte : {texel.b, texel.g, texel.r, texel.a}) bytes += static_cast<char>(byte);
  }
  return bytes;
}

bool is_compressed(const aiTexture& texture) { return texture.mHeight == 0; }

std::string bytes_of(const aiTexture& texture) {
  if (texture.pcData == nullptr) return {};
  if (is_compressed(texture)) return {reinterpret_cast<const char*>(texture.pcData), texture.mWidth};
  return tga_of(texture);
}

/// Returns the file name of a path, `wood.png` of `C:\textures\wood.png`.
std::string without_folder(std::string_view path) {
  const std::size_t separator = path.find_last_of("/\\:");
  return std::string(separator == std::string_view::npos ? path : path.substr(separator + 1));
}

std::string extension_of(const aiTexture& texture) {
  if (!is_compressed(texture)) return "tga";
  const std::string_view hint(texture.achFormatHint);
  return hint.empty() || !std::all_of(hint.begin(), hint.end(), grf::is_word_character) ? "image"
                                                                                        : std::string(hint);
}

}  // namespace

std::string EmbeddedTextures::file_of(const std::string& name) {
  const auto [texture, index] = scene_.GetEmbeddedTextureAndIndex(name.c_str());
  if (texture == nullptr) return name;
  const auto [known, is_new] = names_.emplace(texture, "");
  if (is_new) {
    known->second = free_name(*texture, static_cast<std::size_t>(index));
    files_.push_back({known->second, bytes_of(*texture)});
  }
  return known->second;
}

std::string EmbeddedTextures::free_name(const aiTexture& texture, std::size_t index) {
  const std::string extension = "." + extension_of(texture);
  std::string stem = without_folder(text_of(texture.mFilename));
  if (stem.ends_with(extension)) stem.resize(stem.size() - extension.size());
  if (stem.empty() || stem.starts_with('.') || stem.starts_with('*')) stem = fmt::format("texture{}", index);
  return free_names_.take(stem, extension);
}

}  // namespace convert
