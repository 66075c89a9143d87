#include "converters/gltf/gltf_images.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/text_file.h"

namespace convert {
namespace {

namespace fs = std::filesystem;

/// Returns a file name without characters that are special to file systems and shells.
std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    const bool is_special = static_cast<unsigned char>(c) < 0x20 || c == 0x7F ||
                            std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos;
    plain += is_special ? '_' : c;
  }
  while (plain.starts_with('.')) plain.erase(0, 1);
  return plain;
}

std::string_view extension_of_type(std::string_view mime_type) {
  if (mime_type == "image/jpeg") return ".jpg";
  if (mime_type == "image/webp") return ".webp";
  if (mime_type == "image/ktx2") return ".ktx2";
  if (mime_type == "image/vnd-ms.dds") return ".dds";
  return ".png";
}

int hex_digit(char c) {
  const char lower = grf::lower_case(c);
  if (grf::is_digit(c)) return c - '0';
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// Returns the image of a texture, or the one that an extension names for programs that support its format.
int source_of(const tinygltf::Texture& texture) {
  if (texture.source >= 0) return texture.source;
  for (const auto& [name, extension] : texture.extensions) {
    if (name == "KHR_texture_basisu") continue;  // no program here reads KTX2 images
    if (extension.Has("source") && extension.Get("source").IsInt()) return extension.Get("source").Get<int>();
  }
  return -1;
}

}  // namespace

std::string_view image_extension(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return ".png";
  if (bytes.starts_with("\xFF\xD8\xFF")) return ".jpg";
  if (bytes.starts_with("RIFF") && bytes.substr(std::min<std::size_t>(8, bytes.size()), 4) == "WEBP")
    return ".webp";
  if (bytes.starts_with("\xABKTX 20")) return ".ktx2";
  if (bytes.starts_with("DDS ")) return ".dds";
  if (bytes.starts_with("GIF8")) return ".gif";
  if (bytes.starts_with("BM")) return ".bmp";
  return {};
}

std::string to_uri(std::string_view path) {
  std::string uri;
  for (char c : path) {
    if (c == '\\') c = '/';
    const bool is_plain = grf::is_digit(c) || (grf::lower_case(c) >= 'a' && grf::lower_case(c) <= 'z') ||
                          std::string_view("-._~/").find(c) != std::string_view::npos;
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

std::string from_uri(std::string_view uri) {
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hex_digit(uri[i + 1]) : -1;
    const int low = high < 0 ? -1 : hex_digit(uri[i + 2]);
    if (low < 0) {
      path += uri[i];
    } else {
      path += static_cast<char>(high * 16 + low);
      i += 2;
    }
  }
  return path;
}

std::string ImageNames::take(std::string_view wanted, std::string_view extension) {
  std::string stem = plain_name(wanted);
  for (const std::string_view own : {extension, std::string_view(extension == ".jpg" ? ".jpeg" : "")}) {
    if (grf::lower_case(stem).ends_with(own)) stem.resize(stem.size() - own.size());
  }
  if (stem.empty()) stem = "image";
  return names_.take(stem, extension);
}

bool GltfImages::load() {
  for (std::size_t i = 0; i < file_.model.images.size(); ++i) {
    const tinygltf::Image& image = file_.model.images[i];
    if (!image.uri.empty()) {
      names_.push_back(from_uri(image.uri));
      continue;
    }
    std::string_view bytes(reinterpret_cast<const char*>(image.image.data()), image.image.size());
    if (image.bufferView >= 0) {
      const auto view = accessors_.view(image.bufferView);
      if (!view) return false;
      bytes = {reinterpret_cast<const char*>(view->data()), view->size()};
    }
    if (bytes.empty()) {
      names_.emplace_back();
      continue;
    }
    names_.push_back(free_name(image, i, bytes));
    embedded_.push_back({names_.back(), std::string(bytes)});
  }
  return true;
}

std::string GltfImages::free_name(const tinygltf::Image& image, std::size_t index, std::string_view bytes) {
  std::string_view extension = image_extension(bytes);
  if (extension.empty()) extension = extension_of_type(image.mimeType);
  const std::string stem = fs::path(file_.path).stem().string();
  return free_names_.take(image.name.empty() ? fmt::format("{}_{}", stem, index) : image.name, extension);
}

std::optional<grf::Texture> GltfImages::texture(int index) const {
  const auto& textures = file_.model.textures;
  if (index < 0 || static_cast<std::size_t>(index) >= textures.size()) return std::nullopt;
  const int source = source_of(textures[static_cast<std::size_t>(index)]);
  if (source < 0 || static_cast<std::size_t>(source) >= names_.size()) return std::nullopt;
  const std::string& name = names_[static_cast<std::size_t>(source)];
  if (name.empty()) return std::nullopt;
  return grf::Texture{name, {}};
}

bool GltfImages::repeats(int texture) const {
  const auto& textures = file_.model.textures;
  if (texture < 0 || static_cast<std::size_t>(texture) >= textures.size()) return true;
  const int sampler = textures[static_cast<std::size_t>(texture)].sampler;
  const auto& samplers = file_.model.samplers;
  if (sampler < 0 || static_cast<std::size_t>(sampler) >= samplers.size()) return true;
  const tinygltf::Sampler& found = samplers[static_cast<std::size_t>(sampler)];
  return found.wrapS == TINYGLTF_TEXTURE_WRAP_REPEAT && found.wrapT == TINYGLTF_TEXTURE_WRAP_REPEAT;
}

}  // namespace convert
