// WebP images are decoded by libwebp.
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <webp/decode.h>

#include "renderer/image/decoders.h"
#include "renderer/image/srgb.h"

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

Image decode_webp(std::string_view bytes) {
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
  const SrgbTable& linear = srgb_table();
  const std::uint8_t* pixel = pixels.data();
  for (grf::Colour& colour : image.pixels) {
    // Transparent pixels are composited over black, as those of PNG are.
    const float opacity = static_cast<float>(pixel[3]) / 255;
    colour = grf::Colour(linear[pixel[0]], linear[pixel[1]], linear[pixel[2]]) * opacity;
    pixel += 4;
  }
  return image;
}

}  // namespace image
