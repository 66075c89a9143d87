#include "converters/gltf/gltf_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <new>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "converters/gltf/gltf_check.h"
#include "converters/gltf/gltf_compression.h"
#include "converters/gltf/gltf_document.h"
#include "converters/text_encoding.h"
#include "converters/wording.h"
#include "grf/keywords.h"
#include "grf/text_file.h"

namespace convert {
namespace {

namespace fs = std::filesystem;

/// The maximum nesting of JSON arrays and objects, since tinygltf reads extras recursively.
constexpr int DeepestJson = 200;

/// The extensions that the reader supports, or reports as losses.
constexpr std::array<std::string_view, 23> KnownExtensions = {"KHR_draco_mesh_compression",
                                                              "KHR_lights_punctual",
                                                              "KHR_materials_anisotropy",
                                                              "KHR_materials_clearcoat",
                                                              "KHR_materials_diffuse_transmission",
                                                              "KHR_materials_dispersion",
                                                              "KHR_materials_emissive_strength",
                                                              "KHR_materials_ior",
                                                              "KHR_materials_iridescence",
                                                              "KHR_materials_pbrSpecularGlossiness",
                                                              "KHR_materials_sheen",
                                                              "KHR_materials_specular",
                                                              "KHR_materials_transmission",
                                                              "KHR_materials_unlit",
                                                              "KHR_materials_variants",
                                                              "KHR_materials_volume",
                                                              "KHR_mesh_quantization",
                                                              "KHR_texture_basisu",
                                                              "KHR_texture_transform",
                                                              "EXT_meshopt_compression",
                                                              "EXT_texture_avif",
                                                              "EXT_texture_webp",
                                                              "MSFT_texture_dds"};

constexpr std::array<std::string_view, 14> ImageExtensions = {".png",   ".jpg", ".jpeg", ".webp", ".ktx",
                                                              ".ktx2",  ".dds", ".bmp",  ".gif",  ".tga",
                                                              ".basis", ".hdr", ".exr",  ".avif"};

template <std::size_t Count>
bool is_one_of(const std::array<std::string_view, Count>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
  std::array<unsigned char, 4> word = {};
  std::memcpy(word.data(), bytes.data() + offset, word.size());
  return word[0] | word[1] << 8U | word[2] << 16U | static_cast<std::uint32_t>(word[3]) << 24U;
}

/// Returns the JSON of a GLB file, or an empty text and an error message (glTF 2.0, section 4.4). tinygltf
/// would read up to eight bytes past the end of a file whose last chunk is too short.
std::pair<std::string_view, std::string> json_of_glb(std::string_view bytes) {
  constexpr std::uint32_t JsonChunk = 0x4E4F534A;
  constexpr std::size_t HeaderBytes = 12;
  constexpr std::size_t ChunkHeaderBytes = 8;
  if (bytes.size() < HeaderBytes + ChunkHeaderBytes) return {"", "the file ends inside its header"};
  const std::uint32_t version = word_at(bytes, 4);
  if (version != 2) return {"", fmt::format("the file is glTF {}, and only glTF 2 can be read", version)};
  const std::size_t length = word_at(bytes, 8);
  if (length != bytes.size() && (length > bytes.size() || !is_padding(bytes.substr(length)))) {
    return {"", fmt::format("the file has {} bytes, and says that it has {}", bytes.size(), length)};
  }
  const std::size_t json = HeaderBytes + ChunkHeaderBytes;
  const std::size_t json_bytes = word_at(bytes, HeaderBytes);
  if (word_at(bytes, HeaderBytes + 4) != JsonChunk || json + json_bytes > length) {
    return {"", "the first part of the file is not JSON, or is truncated"};
  }
  std::size_t rest = length - json - json_bytes;
  while (rest != 0) {
    const std::size_t part = rest < ChunkHeaderBytes ? 0 : word_at(bytes, length - rest);
    if (rest < ChunkHeaderBytes || part > rest - ChunkHeaderBytes) {
      return {"", "the binary part of the file is truncated"};
    }
    rest -= ChunkHeaderBytes + part;
  }
  return {bytes.substr(json, json_bytes), ""};
}

/// Returns a GLB file, whose JSON is a part of it, with another JSON.
std::string with_json(std::string_view glb, std::string_view json, std::string_view other) {
  constexpr std::size_t ChunkHeaderBytes = 8;
  std::string_view rest = glb.substr(static_cast<std::size_t>(json.end() - glb.begin()));
  rest.remove_prefix(std::min(rest.size(), ChunkHeaderBytes));
  return glb_of(other, rest);
}

bool is_nested_too_deep(std::string_view json) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > DeepestJson) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

/// The context of tinygltf's callbacks.
struct Folder {
  std::string path;
};

// tinygltf searches beside the file, and then in the current directory, where a file of the same name is
// unrelated. Images are not read: they are referenced, not decoded. Folders above the file's own are allowed:
// models share their buffers and textures there, and GRF and OBJ files may name any file, too.
bool file_exists(const std::string& path, void* user_data) {
  const auto& folder = *static_cast<const Folder*>(user_data);
  if (!path.starts_with(folder.path + "/")) return false;
  if (is_one_of(ImageExtensions, grf::lower_case(fs::path(path).extension().string()))) return false;
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::string unexpanded(const std::string& path, void*) { return path; }

bool read_whole_file(std::vector<unsigned char>* bytes, std::string* problem, const std::string& path,
                     void*) {
  grf::Diagnostics diagnostics;
  const auto text = grf::read_file(path, diagnostics);
  if (!text) {
    *problem = diagnostics.entries().empty() ? "" : diagnostics.entries().front().message;
    return false;
  }
  bytes->assign(text->begin(), text->end());
  return true;
}

// Embedded images are not decoded: tinygltf has not validated that the buffer has their bytes.
bool keep_image(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
                const unsigned char* bytes, int size, void*) {
  if (image->uri.empty() && image->bufferView < 0) image->image.assign(bytes, bytes + size);
  image->as_is = true;
  return true;
}

/// Filters tinygltf's messages: it treats optional properties as errors (skins without matrices), and reports
/// some errors only as text (a primitive that it drops).
std::string errors_of(std::string text) {
  constexpr std::string_view Allowed = "'inverseBindMatrices' property is missing in Skin.\n";
  for (std::size_t at = 0; (at = text.find(Allowed)) != std::string::npos;) text.erase(at, Allowed.size());
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  constexpr std::size_t LongestMessage = 300;  // it may quote a data URI
  if (text.size() > LongestMessage) text = text.substr(0, LongestMessage) + " ...";
  return text;
}

class Loader {
 public:
  Loader(const std::string& path, grf::Diagnostics& diagnostics)
      : path_(path), location_(grf::whole_file(path)), diagnostics_(diagnostics) {}

  std::optional<GltfFile> run() {
    auto bytes = grf::read_file(path_, diagnostics_);
    if (!bytes) return std::nullopt;
    if (bytes->empty()) return fail("the file is empty, expected a glTF model");
    if (bytes->size() > std::numeric_limits<std::uint32_t>::max())
      return fail("the file is larger than 4 GB");
    is_binary_ = bytes->starts_with(GlbMagic);
    std::string_view json = *bytes;
    if (is_binary_) {
      std::string problem;
      std::tie(json, problem) = json_of_glb(*bytes);
      if (!problem.empty()) return fail(problem);
    }
    if (is_nested_too_deep(json)) {
      return fail(fmt::format("the JSON has more than {} arrays and objects, one in another", DeepestJson));
    }
    std::string replaced = with_placeholders(json);
    if (!replaced.empty() && is_binary_) replaced = with_json(*bytes, json, replaced);
    if (!parse(replaced.empty() ? *bytes : replaced) || !is_understood()) return std::nullopt;
    take_note_of(json, bytes->size());
    if (!decompress(file_, diagnostics_)) return std::nullopt;
    return std::move(file_);
  }

 private:
  bool parse(const std::string& bytes) {
    Folder folder{fs::path(path_).parent_path().string()};
    if (folder.path.empty()) folder.path = ".";
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(keep_image, nullptr);
    parser.SetFsCallbacks({file_exists, unexpanded, read_whole_file, nullptr, &folder});
    std::string errors;
    std::string warnings;  // only about images
    const auto size = static_cast<unsigned>(bytes.size());
    bool parsed = false;
    try {
      parsed = is_binary_ ? parser.LoadBinaryFromMemory(&file_.model, &errors, &warnings,
                                                        reinterpret_cast<const unsigned char*>(bytes.data()),
                                                        size, folder.path)
                          : parser.LoadASCIIFromString(&file_.model, &errors, &warnings, bytes.data(), size,
                                                       folder.path);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& exception) {
      errors += exception.what();
    }
    errors = errors_of(errors);
    if (parsed && errors.empty()) return true;
    if (lacks_extension()) return false;  // the likely cause of the error
    fail(errors.empty() ? "the file is not a glTF 2 model" : errors);
    return false;
  }

  bool lacks_extension() {
    std::vector<std::string> missing;
    for (const std::string& extension : file_.model.extensionsRequired) {
      if (!is_one_of(KnownExtensions, extension)) missing.push_back(extension);
    }
    if (missing.empty()) return false;
    fail(fmt::format("the file requires what is not supported: {}", listed(missing)));
    return true;
  }

  bool is_understood() {
    const std::string& version = file_.model.asset.version;
    if (version != "2" && !version.starts_with("2.")) {
      fail(fmt::format("the file is glTF {}, and only glTF 2 can be read", version));
      return false;
    }
    if (lacks_extension()) return false;
    const auto& required = file_.model.extensionsRequired;
    if (std::find(required.begin(), required.end(), "KHR_texture_basisu") != required.end()) {
      fail(
          "the file requires KHR_texture_basisu: its textures are KTX2 images, which cannot be read; save "
          "the model with PNG, JPEG or WebP textures");
      return false;
    }
    std::vector<std::string> skipped;
    for (const std::string& extension : file_.model.extensionsUsed) {
      if (!is_one_of(KnownExtensions, extension)) skipped.push_back(extension);
    }
    if (!skipped.empty()) {
      diagnostics_.warning(location_, fmt::format("{} skipped: {}",
                                                  counted(skipped.size(), "extension was", "extensions were"),
                                                  listed(skipped)));
    }
    return true;
  }

  void take_note_of(std::string_view json, std::size_t bytes) {
    file_.path = path_;
    file_.bytes = bytes;
    for (const tinygltf::Buffer& buffer : file_.model.buffers) file_.bytes += buffer.data.size();
    const std::string_view stated = stated_check(json);
    if (stated.empty() || !file_.model.extras.Has("grf")) return;
    std::string_view buffer;
    if (!file_.model.buffers.empty()) {
      const auto& data = file_.model.buffers.front().data;
      buffer = {reinterpret_cast<const char*>(data.data()), data.size()};
    }
    while (json.ends_with(' ') || json.ends_with('\n')) json.remove_suffix(1);  // padding of the chunk
    file_.is_unchanged_grf = stated == check_of(std::string(json), buffer);
    if (!file_.is_unchanged_grf) {
      diagnostics_.warning(
          location_,
          "the file was changed since it was made of a GRF scene, which its extras hold: the "
          "glTF model itself is read");
    }
  }

  std::nullopt_t fail(std::string_view message) {
    diagnostics_.error(location_, message);
    return std::nullopt;
  }

  const std::string& path_;
  grf::SourceLocation location_;
  grf::Diagnostics& diagnostics_;
  bool is_binary_ = false;
  GltfFile file_;
};

}  // namespace

std::optional<GltfFile> load_gltf(const std::string& path, grf::Diagnostics& diagnostics) {
  return Loader(path, diagnostics).run();
}

}  // namespace convert
