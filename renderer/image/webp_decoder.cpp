// WebP images are decoded by libwebp.
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <webp/decode.h>

#include "renderer/image/decoders.h"

namespace image {
namespace {

const char* message_of(VP8StatusCode status) {
  switch (status) {
    case VP8_STATUS_OUT_OF_MEMORY:
      return "out of memory";
    case VP8_STATUS_UNSUPPORTED_FEATURE:
      return "unsupported feature";
    case VP8_STATUS_SUSPENDED:
    case VP8_STATUS_NOT_ENOUGH_DATA:
      return "unexpected end of file";
    default:
      return "bad bitstream";
  }
}

void check(VP8StatusCode status) {
  if (status != VP8_STATUS_OK) throw std::runtime_error(message_of(status));
}

}  // namespace

Image decode_webp(std::string_view bytes, Alpha alpha) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPDecoderConfig config;
  if (WebPInitDecoderConfig(&config) == 0) throw std::runtime_error("another version of libwebp");
  check(WebPGetFeatures(data, bytes.size(), &config.input));
  if (config.input.has_animation != 0) throw std::runtime_error("it is an animation");
  Image image = blank_image(config.input.width, config.input.height);
  std::vector<std::uint8_t> pixels(4 * image.pixels.size());
  config.output.colorspace = MODE_RGBA;
  config.output.is_external_memory = 1;
  config.output.u.RGBA = {pixels.data(), 4 * image.width, pixels.size()};
  check(WebPDecode(data, bytes.size(), &config));
  // Colours times alpha are those over black, as those of PNG are.
  decode_srgb_with_alpha(pixels.data(), image);
  if (alpha == Alpha::OverBlack || config.input.has_alpha == 0) image.alpha = {};
  return image;
}

}  // namespace image
