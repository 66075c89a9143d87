#include "renderer/transport/scene/texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "renderer/image/srgb.h"

namespace transport {
namespace {

using grf::Vec2f;
using image::Image;
using image::srgb_table;
using image::SrgbTable;
using image::to_srgb_byte;
using reflectance::Rgb;

const SrgbTable& linear_table() {
  static const SrgbTable table = [] {
    SrgbTable values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i) / 255;
    return values;
  }();
  return table;
}

std::uint8_t to_linear_byte(float value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::min(value, 1.0F)));
}

template <class ToByte>
bool is_of_bytes(const Image& image, const SrgbTable& value_of_byte, const ToByte& to_byte) {
  return std::all_of(image.pixels.begin(), image.pixels.end(), [&](const Rgb& pixel) {
    for (int k = 0; k < 3; ++k) {
      if (value_of_byte[to_byte(pixel[k])] != pixel[k]) return false;
    }
    return true;
  });
}

half to_half(float value) { return {std::min(value, static_cast<float>(HALF_MAX))}; }

/// The texels of a row or column that a texel of the next mip level covers.
struct Cover {
  int first = 0;
  std::vector<float> weights;
};

Cover cover(int index, int size, int half_size) {
  const double scale = static_cast<double>(size) / half_size;
  const double begin = index * scale;
  const double end = std::min<double>(begin + scale, size);
  Cover cover{static_cast<int>(begin), {}};
  for (int i = cover.first; i < end; ++i) {
    cover.weights.push_back(
        static_cast<float>((std::min<double>(end, i + 1) - std::max<double>(begin, i)) / scale));
  }
  return cover;
}

/// Halves the width.
Image narrowed(const Image& image) {
  Image result{(image.width + 1) / 2, image.height, {}, {}};
  result.pixels.resize(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height));
  for (int x = 0; x < result.width; ++x) {
    const Cover columns = cover(x, image.width, result.width);
    for (int y = 0; y < result.height; ++y) {
      Rgb sum(0);
      for (std::size_t i = 0; i < columns.weights.size(); ++i) {
        sum += image.at(columns.first + static_cast<int>(i), y) * columns.weights[i];
      }
      result.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(result.width) +
                    static_cast<std::size_t>(x)] = sum;
    }
  }
  return result;
}

/// Halves the height.
Image lowered(const Image& image) {
  Image result{image.width, (image.height + 1) / 2, {}, {}};
  result.pixels.reserve(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height));
  for (int y = 0; y < result.height; ++y) {
    const Cover rows = cover(y, image.height, result.height);
    for (int x = 0; x < result.width; ++x) {
      Rgb sum(0);
      for (std::size_t i = 0; i < rows.weights.size(); ++i) {
        sum += image.at(x, rows.first + static_cast<int>(i)) * rows.weights[i];
      }
      result.pixels.push_back(sum);
    }
  }
  return result;
}

/// Wraps any value to [0, 1).
float wrapped(float x) {
  const float place = x - std::floor(x);
  return place >= 0 && place < 1 ? place : 0;
}

constexpr auto MixColours = [](const Rgb& a, const Rgb& b, float t) { return a * (1 - t) + b * t; };
/// Exact for equal values: rounding must not let light pass where all texels are opaque.
constexpr auto MixAlphas = [](float a, float b, float t) { return a + (b - a) * t; };

/// Calls `texel` with a column and a row, and interpolates bilinearly by `mix`.
template <class Texel, class Mix>
auto bilinear(const Vec2f& uv, int width, int height, const Texel& texel, const Mix& mix) {
  const float x = wrapped(uv.x) * static_cast<float>(width) - 0.5F;
  const float y = (1 - wrapped(uv.y)) * static_cast<float>(height) - 0.5F;
  const float left = std::floor(x);
  const float top = std::floor(y);
  const auto wrap = [](float place, int size) {
    const int i = static_cast<int>(place);
    return i < 0 ? i + size : i >= size ? i - size : i;
  };
  const int x0 = wrap(left, width);
  const int x1 = wrap(left + 1, width);
  const int y0 = wrap(top, height);
  const int y1 = wrap(top + 1, height);
  const float s = x - left;
  const float t = y - top;
  return mix(mix(texel(x0, y0), texel(x1, y0), s), mix(texel(x0, y1), texel(x1, y1), s), t);
}

/// Interpolates between the mip levels whose texels are about as large as the footprint.
template <class OfLevel, class Mix>
auto trilinear(float texels, std::size_t levels, const OfLevel& of_level, const Mix& mix) {
  if (!(texels > 1)) return of_level(0);
  const float level = std::log2(texels);
  const float last = static_cast<float>(levels - 1);
  if (level >= last) return of_level(levels - 1);
  const float below = std::floor(level);
  const auto index = static_cast<std::size_t>(below);
  const float t = level - below;
  return mix(of_level(index), of_level(index + 1), t);
}

}  // namespace

Image halved(const Image& image) {
  Image result = lowered(narrowed(image));
  if (image.alpha.empty()) return result;
  Image alpha{image.width, image.height, {}, {}};
  for (const float value : image.alpha) alpha.pixels.emplace_back(value);
  for (const Rgb& value : lowered(narrowed(alpha)).pixels) result.alpha.push_back(value.x);
  return result;
}

Texture::Texture(Image image, TexelEncoding encoding)
    : value_of_byte_(encoding == TexelEncoding::Srgb ? &srgb_table() : &linear_table()) {
  repair(image);
  const auto to_byte = encoding == TexelEncoding::Srgb ? to_srgb_byte : to_linear_byte;
  if (is_of_bytes(image, *value_of_byte_, to_byte)) {
    store(std::move(image), std::vector<std::uint8_t>(), to_byte);
  } else {
    store(std::move(image), std::vector<half>(), to_half);
  }
}

void Texture::repair(Image& image) {
  for (Rgb& pixel : image.pixels) {
    bool is_right = true;
    for (int k = 0; k < 3; ++k) {
      if (pixel[k] >= 0 && std::isfinite(pixel[k])) continue;
      pixel[k] = 0;
      is_right = false;
    }
    if (!is_right) ++invalid_texels_;
  }
  for (float& alpha : image.alpha) alpha = alpha > 0 ? std::min(alpha, 1.0F) : 0;
}

template <class Channel, class Encode>
void Texture::store(Image image, std::vector<Channel> channels, const Encode& encode) {
  channels.reserve(4 * image.pixels.size() + 256);
  while (true) {
    levels_.push_back({image.width, image.height, channels.size() / 3});
    for (const Rgb& pixel : image.pixels) {
      for (int k = 0; k < 3; ++k) channels.push_back(encode(pixel[k]));
    }
    alpha_.insert(alpha_.end(), image.alpha.begin(), image.alpha.end());
    if (image.pixels.size() == 1) break;
    image = halved(image);
  }
  channels.shrink_to_fit();
  alpha_.shrink_to_fit();
  channels_ = std::move(channels);
}

Rgb Texture::texel(std::size_t index) const {
  if (const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&channels_)) {
    const SrgbTable& value = *value_of_byte_;
    const std::uint8_t* texel = &(*bytes)[3 * index];
    return {value[texel[0]], value[texel[1]], value[texel[2]]};
  }
  const half* texel = &(*std::get_if<std::vector<half>>(&channels_))[3 * index];
  return {texel[0], texel[1], texel[2]};
}

Rgb Texture::lookup_level(const Vec2f& uv, std::size_t level) const {
  const Level& texels = levels_[level];
  const auto at = [&](int x, int y) { return texel(index_of(texels, x, y)); };
  return bilinear(uv, texels.width, texels.height, at, MixColours);
}

float Texture::texels_across(float footprint) const {
  return footprint * std::sqrt(static_cast<float>(width()) * static_cast<float>(height()));
}

Rgb Texture::lookup(const Vec2f& uv, float footprint) const {
  const auto at = [&](std::size_t level) { return lookup_level(uv, level); };
  const Rgb colour = trilinear(texels_across(footprint), levels_.size(), at, MixColours);
  if (alpha_.empty()) return colour;
  const float opaque = alpha(uv, footprint);
  return opaque > 0 ? colour / opaque : Rgb(0);
}

float Texture::alpha(const Vec2f& uv, float footprint) const {
  if (alpha_.empty()) return 1;
  const auto at = [&](std::size_t level) {
    const Level& texels = levels_[level];
    const auto texel_at = [&](int x, int y) { return alpha_[index_of(texels, x, y)]; };
    return bilinear(uv, texels.width, texels.height, texel_at, MixAlphas);
  };
  return trilinear(texels_across(footprint), levels_.size(), at, MixAlphas);
}

std::size_t Texture::bytes() const {
  return alpha_.size() * sizeof(float) +
         std::visit([](const auto& channels) { return channels.size() * sizeof(channels[0]); }, channels_);
}

}  // namespace transport
