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

bool is_of_bytes(const Image& image) {
  const SrgbTable& linear = srgb_table();
  return std::all_of(image.pixels.begin(), image.pixels.end(), [&](const Rgb& pixel) {
    for (int k = 0; k < 3; ++k) {
      if (linear[to_srgb_byte(pixel[k])] != pixel[k]) return false;
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
  Image result{(image.width + 1) / 2, image.height, {}};
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
  Image result{image.width, (image.height + 1) / 2, {}};
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

}  // namespace

Image halved(const Image& image) { return lowered(narrowed(image)); }

Texture::Texture(Image image) {
  repair(image);
  if (is_of_bytes(image)) {
    store(std::move(image), std::vector<std::uint8_t>(), to_srgb_byte);
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
}

template <class Channel, class Encode>
void Texture::store(Image image, std::vector<Channel> channels, const Encode& encode) {
  channels.reserve(4 * image.pixels.size() + 256);
  while (true) {
    levels_.push_back({image.width, image.height, channels.size() / 3});
    for (const Rgb& pixel : image.pixels) {
      for (int k = 0; k < 3; ++k) channels.push_back(encode(pixel[k]));
    }
    if (image.pixels.size() == 1) break;
    image = halved(image);
  }
  channels.shrink_to_fit();
  channels_ = std::move(channels);
}

Rgb Texture::texel(const Level& level, int x, int y) const {
  const std::size_t index = level.first +
                            static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) +
                            static_cast<std::size_t>(x);
  if (const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&channels_)) {
    const SrgbTable& linear = srgb_table();
    const std::uint8_t* texel = &(*bytes)[3 * index];
    return {linear[texel[0]], linear[texel[1]], linear[texel[2]]};
  }
  const half* texel = &(*std::get_if<std::vector<half>>(&channels_))[3 * index];
  return {texel[0], texel[1], texel[2]};
}

Rgb Texture::lookup_level(const Vec2f& uv, std::size_t level) const {
  const Level& texels = levels_[level];
  const float x = wrapped(uv.x) * static_cast<float>(texels.width) - 0.5F;
  const float y = (1 - wrapped(uv.y)) * static_cast<float>(texels.height) - 0.5F;
  const float left = std::floor(x);
  const float top = std::floor(y);
  const auto wrap = [](float place, int size) {
    const int i = static_cast<int>(place);
    return i < 0 ? i + size : i >= size ? i - size : i;
  };
  const int x0 = wrap(left, texels.width);
  const int x1 = wrap(left + 1, texels.width);
  const int y0 = wrap(top, texels.height);
  const int y1 = wrap(top + 1, texels.height);
  const float s = x - left;
  const float t = y - top;
  return (texel(texels, x0, y0) * (1 - s) + texel(texels, x1, y0) * s) * (1 - t) +
         (texel(texels, x0, y1) * (1 - s) + texel(texels, x1, y1) * s) * t;
}

Rgb Texture::lookup(const Vec2f& uv, float footprint) const {
  const float texels = footprint * std::sqrt(static_cast<float>(width()) * static_cast<float>(height()));
  if (!(texels > 1)) return lookup_level(uv, 0);
  const float level = std::log2(texels);
  const float last = static_cast<float>(levels_.size() - 1);
  if (level >= last) return lookup_level(uv, levels_.size() - 1);
  const float below = std::floor(level);
  const auto index = static_cast<std::size_t>(below);
  const float t = level - below;
  return lookup_level(uv, index) * (1 - t) + lookup_level(uv, index + 1) * t;
}

std::size_t Texture::bytes() const {
  return std::visit([](const auto& channels) { return channels.size() * sizeof(channels[0]); }, channels_);
}

}  // namespace transport
