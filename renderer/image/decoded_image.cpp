#include "renderer/image/decoded_image.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace image {
namespace {

using grf::Colour;

/// Takes values from the start of bytes.
class Taken {
 public:
  explicit Taken(std::string_view bytes) : rest_(bytes) {}

  std::size_t left() const { return rest_.size(); }
  /// Returns false, and takes nothing, if there are too few bytes.
  bool take(void* to, std::uint64_t count) {
    if (count > rest_.size()) return false;
    if (count > 0) std::memcpy(to, rest_.data(), count);
    rest_.remove_prefix(count);
    return true;
  }

 private:
  std::string_view rest_;
};

std::optional<ImageLayer> layer_in(Taken& bytes, std::uint64_t pixels) {
  constexpr std::uint32_t Longest = 1000;
  std::array<std::uint32_t, 2> lengths = {};
  if (!bytes.take(lengths.data(), sizeof(lengths)) || lengths[0] > Longest || lengths[1] > Longest)
    return std::nullopt;
  ImageLayer layer{std::string(lengths[0], ' '), std::string(lengths[1], ' '), {}};
  const bool has_names =
      bytes.take(layer.name.data(), lengths[0]) && bytes.take(layer.channels.data(), lengths[1]);
  const std::uint64_t count = pixels * std::max(1U, lengths[1]);
  if (!has_names || bytes.left() / sizeof(float) < count) return std::nullopt;
  layer.values.resize(count);
  bytes.take(layer.values.data(), count * sizeof(float));
  return layer;
}

}  // namespace

std::optional<ImageFile> decoded_image(std::string_view bytes, bool has_layers) {
  Taken rest(bytes);
  std::array<std::int32_t, 2> size = {};
  if (!rest.take(size.data(), sizeof(size)) || size[0] < 1 || size[1] < 1) return std::nullopt;
  const std::uint64_t pixels = static_cast<std::uint64_t>(size[0]) * static_cast<std::uint64_t>(size[1]);
  constexpr std::uint64_t PixelSize = sizeof(Colour);
  if (rest.left() / PixelSize < pixels || (!has_layers && rest.left() != pixels * PixelSize))
    return std::nullopt;
  ImageFile result;
  result.image = {size[0], size[1], std::vector<Colour>(pixels)};
  rest.take(&result.image.pixels.front().x, pixels * PixelSize);
  while (rest.left() > 0) {
    auto layer = layer_in(rest, pixels);
    if (!layer) return std::nullopt;
    result.layers.push_back(std::move(*layer));
  }
  return result;
}

Image with_alpha_of_layer(ImageFile file) {
  const bool has_alpha = !file.layers.empty() && file.layers.front().channels.empty();
  if (has_alpha) file.image.alpha = std::move(file.layers.front().values);
  return std::move(file.image);
}

}  // namespace image
