#include "converters/format.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "converters/assign_default_brdf.h"
#include "converters/assimp/assimp_formats.h"
#include "converters/gltf/gltf.h"
#include "converters/grf_format.h"
#include "converters/obj/obj.h"
#include "converters/off/off.h"
#include "converters/ply/ply.h"
#include "converters/renderers/renderer_formats.h"
#include "converters/usd/usd_formats.h"
#include "converters/vrml/vrml.h"
#include "grf/keywords.h"
#include "grf/text_file.h"

namespace convert {
namespace {

/// The number of bytes to sniff, enough to skip the comments at the beginning of exporters' files.
constexpr std::size_t SniffedBytes = 4096;

// Only regular files are sniffed: opening a pipe would wait for a writer.
std::string first_bytes(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  std::ifstream file(path, std::ios::binary);
  std::string bytes(SniffedBytes, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

template <class Condition>
const Format* find_if(Condition condition) {
  const auto all = formats();
  const auto found = std::find_if(all.begin(), all.end(), condition);
  return found == all.end() ? nullptr : &*found;
}

/// Returns the extension in lower case, without the dot.
std::string extension_of(const std::string& path) {
  const std::string extension = grf::lower_case(std::filesystem::path(path).extension().string());
  return extension.empty() ? extension : extension.substr(1);
}

bool has_extension(const Format& format, const std::string& extension) {
  return std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end();
}

std::string readable_formats() {
  std::string names;
  for (const Format& format : formats()) {
    if (format.read != nullptr) names += fmt::format("{}{}", names.empty() ? "" : ", ", format.name);
  }
  return names;
}

}  // namespace

std::span<const Format> formats() {
  static const std::array all = {
      grf_format(),          obj_format(),      ply_format(),       ply_ascii_format(), gltf_format(),
      glb_format(),          usd_format(),      materialx_format(), pbrt_format(),      mitsuba_format(),
      vrml_format(),         three_ds_format(), stl_format(),       off_format(),       dxf_format(),
      collada_format(),      fbx_format(),      lwo_format(),       ac3d_format(),      x_format(),
      other_assimp_format(),
  };
  return all;
}

const Format* find_format(std::string_view name) {
  return find_if([name](const Format& format) { return grf::same_keyword(format.name, name); });
}

const Format* format_of_name(const std::string& path) {
  const std::string extension = extension_of(path);
  return find_if([&extension](const Format& format) { return has_extension(format, extension); });
}

const Format* read_format_of_name(const std::string& path) {
  const std::string extension = extension_of(path);
  const Format* read = find_if([&extension](const Format& format) {
    return format.read != nullptr && has_extension(format, extension);
  });
  return read != nullptr ? read : format_of_name(path);
}

const Format* recognise(const std::string& path, grf::Diagnostics& diagnostics) {
  const std::string bytes = first_bytes(path);
  if (const Format* format = find_if([&](const Format& candidate) { return candidate.sniff(bytes); })) {
    return format;
  }
  if (const Format* format = read_format_of_name(path)) return format;
  // An unreadable file has an unknown format for another reason, which is reported instead.
  if (const auto whole = grf::read_file(path, diagnostics)) {
    diagnostics.error(grf::whole_file(path),
                      whole->empty() ? "the file is empty"
                                     : fmt::format("the format is unknown, by content and by name ({})",
                                                   readable_formats()));
  }
  return nullptr;
}

std::optional<Import> read(const Format& format, const std::string& path, const ReadOptions& options,
                           grf::Diagnostics& diagnostics) {
  if (format.read == nullptr) {
    diagnostics.error(grf::whole_file(path),
                      fmt::format("{} files are only written, and cannot be read", format.name));
    return std::nullopt;
  }
  if (!options.variant.empty() && !format.has_variants) {
    diagnostics.error(grf::whole_file(path),
                      fmt::format("{} files have no variants, expected '{}'", format.name, options.variant));
    return std::nullopt;
  }
  std::optional<Import> import = format.read(path, options, diagnostics);
  if (import && options.brdf) assign_default_brdf(import->scene, *options.brdf);
  return import;
}

}  // namespace convert
