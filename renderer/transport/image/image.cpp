#include "renderer/transport/image/image.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>
#include <png.h>

#include "grf/keywords.h"
#include "grf/text_file.h"

namespace transport {
namespace {

using reflectance::Rgb;

/// Lets OpenEXR write to memory, so that the file itself can be replaced at one stroke.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : OStream("image") {}

  void write(const char* bytes, int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (bytes_.size() < position_ + size) bytes_.resize(position_ + size);
    std::memcpy(bytes_.data() + position_, bytes, size);
    position_ += size;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::string take_bytes() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

std::string encode_exr(const Image& image) {
  MemoryStream stream;
  {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer buffer;
    const char* first = reinterpret_cast<const char*>(image.pixels.data());
    const std::size_t row = sizeof(Rgb) * static_cast<std::size_t>(image.width);
    std::size_t offset = 0;
    for (const char* channel : {"R", "G", "B"}) {
      header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
      // OpenEXR's type is for reading and writing, and only reads here.
      buffer.insert(channel, Imf::Slice(Imf::FLOAT, const_cast<char*>(first) + offset, sizeof(Rgb), row));
      offset += sizeof(float);
    }
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(buffer);
    file.writePixels(image.height);
  }  // the file is complete when it is closed
  return stream.take_bytes();
}

std::uint8_t srgb_byte(float linear) {
  const float clamped = std::clamp(linear, 0.0F, 1.0F);
  const float encoded =
      clamped <= 0.0031308F ? 12.92F * clamped : 1.055F * std::pow(clamped, 1 / 2.4F) - 0.055F;
  return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

std::string encode_png(const Image& image) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels) {
    for (const float channel : {pixel.x, pixel.y, pixel.z}) bytes.push_back(srgb_byte(channel));
  }
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string encoded(size, '\0');
  if (png_image_write_to_memory(&png, encoded.data(), &size, 0, bytes.data(), 0, nullptr) == 0) {
    throw std::runtime_error(fmt::format("libpng: {}", png.message));
  }
  encoded.resize(size);
  return encoded;
}

}  // namespace

const std::vector<ImageFormat>& image_formats() {
  static const std::vector<ImageFormat> formats = {{"exr", "OpenEXR, linear 32-bit floats", encode_exr},
                                                   {"png", "PNG, 8 bits, sRGB", encode_png}};
  return formats;
}

bool has_extension(const std::string& path, std::string_view extension) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return !ending.empty() && grf::same_keyword(ending.substr(1), extension);
}

const ImageFormat* image_format_of(const std::string& path, grf::Diagnostics& diagnostics) {
  const auto& formats = image_formats();
  const auto found = std::find_if(formats.begin(), formats.end(), [&](const ImageFormat& format) {
    return has_extension(path, format.extension);
  });
  if (found != formats.end()) return &*found;
  std::vector<std::string_view> known;
  for (const ImageFormat& format : formats) known.push_back(format.extension);
  diagnostics.error(
      grf::whole_file(path),
      fmt::format("unknown type of image, expected one of the extensions {}", fmt::join(known, ", ")));
  return nullptr;
}

bool write_image(const Image& image, const std::string& path, grf::Diagnostics& diagnostics) {
  const ImageFormat* format = image_format_of(path, diagnostics);
  return format != nullptr && grf::replace_file(path, format->encode(image), diagnostics);
}

}  // namespace transport
