#include "renderer/image/image_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grf/text_file.h"
#include "renderer/image/encoders.h"

namespace image {
namespace {

/// Creates a new folder for this program only, so that nobody else can have placed a link at the image's
/// path; empty on failure.
std::string new_folder_in(const std::string& folder) {
  std::string path = (std::filesystem::path(folder) / "granada-XXXXXX").string();
  return ::mkdtemp(path.data()) == nullptr ? std::string() : path;
}

bool keep_in(const std::string& folder, const std::string& name, const std::string& bytes,
             std::string& kept_as) {
  const std::string own = new_folder_in(folder);
  if (own.empty()) return false;
  grf::Diagnostics ignored;  // the first error is the one to report
  kept_as = (std::filesystem::path(own) / name).string();
  if (grf::replace_file(kept_as, bytes, ignored)) return true;
  std::error_code error;
  std::filesystem::remove(own, error);
  return false;
}

}  // namespace

const std::vector<ImageFormat>& image_formats() {
  constexpr int Widest = 65535;
  constexpr int WidestJpeg = 65500;
  static const std::vector<ImageFormat> formats = {
      {"exr", "OpenEXR, linear 32-bit floats", Widest, true, true, encode_exr},
      {"hdr", "Radiance RGBE, linear, 8 bits with a shared exponent", Widest, false, true, encode_radiance},
      {"pfm", "portable float map, linear 32-bit floats", Widest, false, true, encode_pfm},
      {"raw", "raw: width, height and linear 32-bit floats", Widest, false, true, encode_raw},
      {"png", "PNG, 8 bits, sRGB", Widest, false, false, encode_png},
      {"jpg", "JPEG, 8 bits, sRGB, lossy", WidestJpeg, false, false, encode_jpeg},
      {"tga", "Targa, 8 bits, sRGB", Widest, false, false, encode_tga}};
  return formats;
}

std::string readable_name_patterns() { return fmt::format("*.{}", fmt::join(ReadableExtensions, " *.")); }

const ImageFormat* image_format_of(const std::string& path, grf::Diagnostics& diagnostics) {
  const auto& formats = image_formats();
  const auto found = std::find_if(formats.begin(), formats.end(), [&](const ImageFormat& format) {
    return has_extension(path, format.extension) ||
           (format.extension == "jpg" && has_extension(path, "jpeg"));
  });
  if (found != formats.end()) return &*found;
  std::vector<std::string_view> known;
  for (const ImageFormat& format : formats) known.push_back(format.extension);
  diagnostics.error(
      grf::whole_file(path),
      fmt::format("unknown image format, expected one of the extensions {}", fmt::join(known, ", ")));
  return nullptr;
}

bool write_image(const ImageFile& file, const std::string& path, grf::Diagnostics& diagnostics) {
  return keep_image(file, path, {}, diagnostics);
}

bool keep_image(const ImageFile& file, const std::string& path, const std::vector<std::string>& fallbacks,
                grf::Diagnostics& diagnostics) {
  const ImageFormat* format = image_format_of(path, diagnostics);
  if (format == nullptr) return false;
  std::string bytes;
  try {
    bytes = format->encode(file);
  } catch (const std::exception& problem) {
    diagnostics.error(grf::whole_file(path), fmt::format("cannot encode the image: {}", problem.what()));
    return false;
  }
  if (grf::replace_file(path, bytes, diagnostics)) return true;
  if (fallbacks.empty()) return false;
  const std::string name = std::filesystem::path(path).filename().string();
  for (const std::string& folder : fallbacks) {
    std::string kept_as;
    if (!keep_in(folder, name, bytes, kept_as)) continue;
    diagnostics.note(grf::whole_file(path), fmt::format("the image was saved as '{}' instead", kept_as));
    return false;
  }
  diagnostics.error(grf::whole_file(path),
                    fmt::format("the image could not be saved in {} either", fmt::join(fallbacks, ", ")));
  return false;
}

std::vector<std::string> fallback_folders() {
  std::vector<std::string> folders;
  std::error_code error;
  const std::filesystem::path temporary = std::filesystem::temp_directory_path(error);
  folders.push_back(error ? "/tmp" : temporary.string());
  const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe): nobody sets variables
  if (home != nullptr && *home != '\0') folders.emplace_back(home);
  return folders;
}

ImageLayer layer_of(std::string name, std::string channels, const Image& image) {
  const float* first = &image.pixels.front().x;
  return {std::move(name), std::move(channels), {first, first + 3 * image.pixels.size()}};
}

Image image_of(const ImageLayer& layer, int width, int height) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::size_t channels = layer.channel_count();
  Image image{width, height, std::vector<grf::Colour>(pixels, grf::Colour(0))};
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* values = &layer.values[i * channels];
    for (std::size_t k = 0; k < 3; ++k) {
      if (channels == 1 || k < channels) image.pixels[i][static_cast<int>(k)] = values[channels == 1 ? 0 : k];
    }
  }
  return image;
}

}  // namespace image
