#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "renderer/image/decoders.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_TGA
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace image {
namespace {

/// Feeds bytes to stb_image, and notes if it asked for more than there are: it reads those as zeros.
class Source {
 public:
  explicit Source(std::string_view bytes) : bytes_(bytes) {}

  bool ended_early() const { return ended_early_; }

  // stb_image fills its own buffer with as much as there is first; only reads into other buffers must be
  // complete.
  int read(char* to, int count) {
    if (buffer_ == nullptr) buffer_ = to;
    const std::size_t given =
        std::min(static_cast<std::size_t>(std::max(count, 0)), bytes_.size() - position_);
    if (given == 0 || (to != buffer_ && given < static_cast<std::size_t>(count))) ended_early_ = true;
    std::memcpy(to, bytes_.data() + position_, given);
    position_ += given;
    return static_cast<int>(given);
  }
  void skip(int count) {
    const std::size_t rest = bytes_.size() - position_;
    if (count < 0 || static_cast<std::size_t>(count) > rest) ended_early_ = true;
    position_ += std::min(static_cast<std::size_t>(std::max(count, 0)), rest);
  }
  bool at_end() const { return position_ == bytes_.size(); }

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
  const char* buffer_ = nullptr;
  bool ended_early_ = false;
};

// A constant, which clang's analyzer cannot see through: it takes a lambda that is called by its pointer for
// one that reads nothing.
constexpr stbi_io_callbacks Callbacks = {
    [](void* source, char* to, int count) { return static_cast<Source*>(source)->read(to, count); },
    [](void* source, int count) { static_cast<Source*>(source)->skip(count); },
    [](void* source) { return static_cast<Source*>(source)->at_end() ? 1 : 0; }};

struct Free {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

[[noreturn]] void fail() {
  const char* reason = stbi_failure_reason();
  throw std::runtime_error(reason != nullptr ? reason : "unsupported type");
}

}  // namespace

Image decode_tga(std::string_view bytes, Alpha alpha) {
  int width = 0;
  int height = 0;
  int channels = 0;
  Source header(bytes);
  if (stbi_info_from_callbacks(&Callbacks, &header, &width, &height, &channels) == 0) fail();
  Image image = blank_image(width, height, bytes, 128);  // the longest run
  const bool has_alpha = alpha == Alpha::Kept && (channels == 2 || channels == 4);
  Source source(bytes);
  const std::unique_ptr<stbi_uc, Free> pixels(
      stbi_load_from_callbacks(&Callbacks, &source, &width, &height, &channels, has_alpha ? 4 : 3));
  if (source.ended_early()) throw std::runtime_error("unexpected end of file");
  if (!pixels) fail();
  has_alpha ? decode_srgb_with_alpha(pixels.get(), image) : decode_srgb(pixels.get(), image);
  return image;
}

}  // namespace image
