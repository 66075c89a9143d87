// Image decoders. Each throws for what it cannot read; `read_image` turns that into a diagnostic.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <type_traits>

#include <fmt/format.h>
#include <png.h>
#include <turbojpeg.h>

#include "grf/text_file.h"
#include "renderer/image/decoded_image.h"
#include "renderer/image/decoders.h"
#include "renderer/image/image.h"
#include "renderer/image/srgb.h"

namespace image {
namespace {

using grf::Colour;

// Portable float map: three lines of text, then rows from the bottom. A negative scale means little-endian.

std::string_view next_word(std::string_view& bytes) {
  constexpr std::string_view Space = " \t\r\n";
  const std::size_t start = std::min(bytes.find_first_not_of(Space), bytes.size());
  const std::size_t end = std::min(bytes.find_first_of(Space, start), bytes.size());
  const std::string_view word = bytes.substr(start, end - start);
  bytes.remove_prefix(std::min(end + 1, bytes.size()));  // one space: the next byte may be a pixel's
  return word;
}

template <class Number>
Number next_number(std::string_view& bytes) {
  const std::string_view word = next_word(bytes);
  Number number = {};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) {
    throw std::runtime_error("its header is not a type, a width, a height and a scale");
  }
  return number;
}

float float_of(const char* bytes, bool is_little_endian) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, bytes, sizeof(bits));
  return std::bit_cast<float>(is_little_endian ? bits : __builtin_bswap32(bits));
}

Image decode_pfm(std::string_view bytes, Alpha) {
  const std::size_t channels = next_word(bytes) == "PF" ? 3 : 1;
  const auto width = next_number<std::int32_t>(bytes);
  const auto height = next_number<std::int32_t>(bytes);
  const auto scale = next_number<float>(bytes);
  const std::size_t row = std::size_t(std::max(width, 0)) * channels * sizeof(float);
  if (width > 0 && height > 0 && bytes.size() / row < static_cast<std::size_t>(height)) {
    throw std::runtime_error("unexpected end of file");
  }
  Image image = blank_image(width, height);
  for (int y = 0; y < height; ++y) {
    const char* from = bytes.data() + row * static_cast<std::size_t>(height - 1 - y);
    for (int x = 0; x < width; ++x, from += channels * sizeof(float)) {
      Colour& pixel = image.pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
      for (std::size_t k = 0; k < 3; ++k) {
        pixel[static_cast<int>(k)] = float_of(from + (channels == 3 ? k * sizeof(float) : 0), scale < 0);
      }
    }
  }
  return image;
}

// The format of `encode_raw`: width and height, then floats, rows from the top.

Image decode_raw(std::string_view bytes, Alpha) {
  std::array<std::uint32_t, 2> size = {};
  if (bytes.size() < sizeof(size)) throw std::runtime_error("unexpected end of file");
  std::memcpy(size.data(), bytes.data(), sizeof(size));
  bytes.remove_prefix(sizeof(size));
  const std::size_t row = std::max<std::size_t>(1, sizeof(Colour) * size[0]);
  if (bytes.size() / row < size[1]) throw std::runtime_error("unexpected end of file");
  Image image = blank_image(size[0], size[1]);
  if (bytes.size() != row * size[1])
    throw std::runtime_error("it is longer than its width and height require");
  std::memcpy(&image.pixels.front().x, bytes.data(), bytes.size());
  return image;
}

// PNG; 16-bit files keep their 16 bits.

void decode_deep(const std::vector<std::uint8_t>& bytes, Image& image) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    std::array<std::uint16_t, 3> pixel = {};
    std::memcpy(pixel.data(), bytes.data() + i * sizeof(pixel), sizeof(pixel));
    image.pixels[i] = Colour(pixel[0], pixel[1], pixel[2]) / 65535.0F;
  }
}

/// Of colours that are multiplied by their alpha, as libpng gives 16-bit files.
void decode_deep_with_alpha(const std::vector<std::uint8_t>& bytes, Image& image) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    std::array<std::uint16_t, 4> pixel = {};
    std::memcpy(pixel.data(), bytes.data() + i * sizeof(pixel), sizeof(pixel));
    image.pixels[i] = Colour(pixel[0], pixel[1], pixel[2]) / 65535.0F;
    image.alpha.push_back(static_cast<float>(pixel[3]) / 65535.0F);
  }
}

Image decode_png(std::string_view bytes, Alpha alpha) {
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> owner(&png, png_image_free);
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
    throw std::runtime_error(png.message);
  }
  // A pixel takes at least one bit, and zlib expands a byte to at most 1032.
  Image image = blank_image(png.width, png.height, bytes, std::size_t(8) * 1032);
  const bool is_deep = (png.format & PNG_FORMAT_FLAG_LINEAR) != 0;
  const bool has_alpha = alpha == Alpha::Kept && (png.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  png.format = is_deep ? PNG_FORMAT_LINEAR_RGB : PNG_FORMAT_RGB;
  if (has_alpha) png.format |= PNG_FORMAT_FLAG_ALPHA;
  // Without alpha, transparent pixels are composited over black.
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(png));
  if (png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr) == 0) {
    throw std::runtime_error(png.message);
  }
  if (has_alpha) {
    is_deep ? decode_deep_with_alpha(pixels, image) : decode_srgb_with_alpha(pixels.data(), image);
  } else {
    is_deep ? decode_deep(pixels, image) : decode_srgb(pixels.data(), image);
  }
  return image;
}

Image decode_jpeg(std::string_view bytes, Alpha) {
  struct Destroy {
    void operator()(void* handle) const { tjDestroy(handle); }
  };
  const std::unique_ptr<void, Destroy> decoder(tjInitDecompress());
  if (!decoder) throw std::bad_alloc();
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  int width = 0;
  int height = 0;
  int subsampling = 0;
  int colours = 0;
  const auto check = [&](int result) {
    if (result != 0) throw std::runtime_error(tjGetErrorStr2(decoder.get()));
  };
  check(tjDecompressHeader3(decoder.get(), data, bytes.size(), &width, &height, &subsampling, &colours));
  Image image = blank_image(width, height);
  std::vector<std::uint8_t> pixels(3 * image.pixels.size());
  // A warning, such as about a truncated file, is a failure too.
  check(tjDecompress2(decoder.get(), data, bytes.size(), pixels.data(), width, 0, height, TJPF_RGB,
                      TJFLAG_ACCURATEDCT));
  decode_srgb(pixels.data(), image);
  return image;
}

struct Decoder {
  std::string_view start;  ///< first bytes of all such files; empty: detected by the extension
  std::string_view extension;
  Image (*decode)(std::string_view, Alpha);
  bool is_of_library = false;
};

constexpr std::array Decoders = {
    Decoder{"", "raw", decode_raw},  // first, because its first bytes, a width, may be anything
    Decoder{"\x76\x2f\x31\x01", "exr", decode_exr, true},
    Decoder{"#?", "hdr", decode_radiance},
    Decoder{"PF", "pfm", decode_pfm},
    Decoder{"Pf", "pfm", decode_pfm},
    Decoder{"\x89PNG", "png", decode_png, true},
    Decoder{"\xff\xd8\xff", "jpg", decode_jpeg, true},
    Decoder{"RIFF", "webp", decode_webp, true},
    Decoder{"", "tga", decode_tga},
};

/// Detects the format from the contents, since extensions can be wrong.
const Decoder* decoder_of(std::string_view bytes, const std::string& path) {
  const auto found = std::find_if(Decoders.begin(), Decoders.end(), [&](const Decoder& decoder) {
    return decoder.start.empty() ? has_extension(path, decoder.extension) : bytes.starts_with(decoder.start);
  });
  return found == Decoders.end() ? nullptr : &*found;
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// Reads a file and decodes it by a function of its decoder and its bytes.
template <class Decode>
auto read_and(const Decode& decode, const std::string& path, grf::Diagnostics& diagnostics,
              const grf::SourceLocation& asked_for_at)
    -> std::optional<std::invoke_result_t<Decode, const Decoder&, std::string_view>> {
  const auto bytes = grf::read_file(path, diagnostics, asked_for_at);
  if (!bytes) return std::nullopt;
  const auto fail = [&](const std::string& why) {
    if (asked_for_at.file) {
      diagnostics.error(asked_for_at, fmt::format("cannot read the image '{}': {}", path, why));
    } else {
      diagnostics.error(grf::whole_file(path), fmt::format("cannot read the image: {}", why));
    }
    return std::nullopt;
  };
  if (bytes->empty()) return fail("the file is empty");
  const Decoder* decoder = decoder_of(*bytes, path);
  if (decoder == nullptr)
    return fail("unknown format, expected OpenEXR, Radiance (hdr), pfm, raw, PNG, JPEG, TGA or WebP");
  try {
    return decode(*decoder, *bytes);
  } catch (const std::bad_alloc&) {
    return fail("it needs more memory than there is");
  } catch (const std::exception& problem) {
    return fail(fmt::format("it is damaged ({})", one_line(problem.what())));
  }
}

}  // namespace

Image blank_image(std::int64_t width, std::int64_t height) {
  constexpr std::int64_t MostPixels = std::int64_t(1) << 27;
  if (width < 1 || height < 1) throw std::runtime_error("it has no pixels");
  if (width > MostPixels / height) {
    throw std::runtime_error(fmt::format("it has {} x {} pixels, expected at most {} million", width, height,
                                         MostPixels / 1'000'000));
  }
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  image.pixels.resize(static_cast<std::size_t>(width * height), Colour(0));
  return image;
}

Image blank_image(std::int64_t width, std::int64_t height, std::string_view file, std::size_t pixels_a_byte) {
  // A few corrupt bytes must not request gigabytes. Larger sizes are left to the other check.
  const bool is_plain = width > 0 && height > 0 && width < (1 << 30) && height < (1 << 30);
  if (is_plain && static_cast<std::size_t>(width * height) / pixels_a_byte > file.size()) {
    throw std::runtime_error("unexpected end of file");
  }
  return blank_image(width, height);
}

void decode_srgb(const std::uint8_t* bytes, Image& image) {
  const SrgbTable& linear = srgb_table();
  for (Colour& pixel : image.pixels) {
    pixel = {linear[bytes[0]], linear[bytes[1]], linear[bytes[2]]};
    bytes += 3;
  }
}

void decode_srgb_with_alpha(const std::uint8_t* bytes, Image& image) {
  const SrgbTable& linear = srgb_table();
  image.alpha.reserve(image.pixels.size());
  for (Colour& pixel : image.pixels) {
    const float alpha = static_cast<float>(bytes[3]) / 255;
    pixel = Colour(linear[bytes[0]], linear[bytes[1]], linear[bytes[2]]) * alpha;
    image.alpha.push_back(alpha);
    bytes += 4;
  }
}

bool is_decoded_by_library(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;  // opening a pipe may block
  std::array<char, 4> start = {};
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), start.size());
  const auto count = static_cast<std::size_t>(file.gcount());
  const Decoder* decoder = decoder_of({start.data(), count}, path);
  return count > 0 && decoder != nullptr && decoder->is_of_library;
}

std::optional<Image> read_image(const std::string& path, grf::Diagnostics& diagnostics,
                                const grf::SourceLocation& asked_for_at, Alpha alpha) {
  const auto decode = [alpha](const Decoder& decoder, std::string_view bytes) {
    return decoder.decode(bytes, alpha);
  };
  return read_and(decode, path, diagnostics, asked_for_at);
}

std::optional<ImageFile> read_image_file(const std::string& path, grf::Diagnostics& diagnostics) {
  const auto decode = [](const Decoder& decoder, std::string_view bytes) {
    return decoder.extension == "exr" ? decode_exr_file(bytes)
                                      : ImageFile{decoder.decode(bytes, Alpha::OverBlack)};
  };
  return read_and(decode, path, diagnostics, {});
}

}  // namespace image
