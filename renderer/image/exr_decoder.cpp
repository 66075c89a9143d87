// Decodes OpenEXR images, with their layers.
#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#include "renderer/image/decoders.h"

namespace image {
namespace {

using grf::Colour;

class MemoryInput : public Imf::IStream {
 public:
  explicit MemoryInput(std::string_view bytes) : IStream("image"), bytes_(bytes) {}

  bool read(char* to, int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (position_ > bytes_.size() || size > bytes_.size() - position_) {
      throw std::runtime_error("unexpected end of file");
    }
    std::memcpy(to, bytes_.data() + position_, size);
    position_ += size;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::string_view bytes_;
  std::uint64_t position_ = 0;
};

/// Reads the data window of a file: there are no pixels outside of it.
class ExrFile {
 public:
  explicit ExrFile(std::string_view bytes)
      : stream_(bytes), file_(stream_), window_(file_.header().dataWindow()) {
    image_ = blank_image(std::int64_t(window_.max.x) - window_.min.x + 1,
                         std::int64_t(window_.max.y) - window_.min.y + 1);
  }

  bool has(const char* channel) const { return channels().findChannel(channel) != nullptr; }
  bool has_colour() const { return has("R") || has("G") || has("B"); }
  bool is_grey() const { return !has_colour() && has("Y") && !has("RY"); }

  /// Asks for the image, from the file's own channels in colour or grey.
  void add_image() {
    float* first = &image_.pixels.front().x;
    add(is_grey() ? "Y" : "R", first, 3);
    if (is_grey()) return;
    add("G", first + 1, 3);
    add("B", first + 2, 3);
  }
  void add_alpha() {
    image_.alpha.resize(image_.pixels.size());
    add("A", image_.alpha.data(), 1);
  }
  /// Asks for all channels that are no part of the image.
  void add_layers() {
    for (auto& [name, letters] : letters_of_layers()) {
      ImageLayer& layer = layers_.emplace_back();
      layer.name = name;
      layer.channels = letters;
      const std::size_t count = std::max<std::size_t>(1, letters.size());
      layer.values.resize(count * image_.pixels.size());
      for (std::size_t i = 0; i < count; ++i) {
        add(letters.empty() ? name : name + "." + letters[i], layer.values.data() + i, count);
      }
    }
  }

  void read() {
    file_.setFrameBuffer(buffer_);
    file_.readPixels(window_.min.y, window_.max.y);
    if (!is_grey()) return;
    for (Colour& pixel : image_.pixels) pixel = Colour(pixel.x);
  }

  Image take_image() { return std::move(image_); }
  std::vector<ImageLayer> take_layers() { return std::move(layers_); }

 private:
  const Imf::ChannelList& channels() const { return file_.header().channels(); }

  bool is_of_image(const std::string& channel) const {
    return has_colour() ? channel == "R" || channel == "G" || channel == "B" : is_grey() && channel == "Y";
  }

  /// The letters of each layer's channels in the order of RGBA; none for a layer of a single channel.
  std::map<std::string, std::string> letters_of_layers() const {
    std::map<std::string, std::string> layers;
    for (auto channel = channels().begin(); channel != channels().end(); ++channel) {
      const std::string name = channel.name();
      const bool is_sampled = channel.channel().xSampling == 1 && channel.channel().ySampling == 1;
      if (!is_sampled || is_of_image(name)) continue;
      const bool has_letter = name.size() > 2 && name[name.size() - 2] == '.';
      if (has_letter) {
        layers[name.substr(0, name.size() - 2)] += name.back();
      } else {
        layers[name];
      }
    }
    for (auto& [name, letters] : layers) {
      constexpr std::string_view Order = "RGBAXYZUVW";
      std::ranges::stable_sort(letters, {}, [&](char letter) { return Order.find(letter); });
    }
    return layers;
  }

  void add(const std::string& name, float* first, std::size_t step) {
    buffer_.insert(name, Imf::Slice::Make(Imf::FLOAT, first, window_.min, image_.width, image_.height,
                                          step * sizeof(float),
                                          step * sizeof(float) * static_cast<std::size_t>(image_.width)));
  }

  MemoryInput stream_;
  Imf::InputFile file_;
  Imath::Box2i window_;
  Image image_;
  std::vector<ImageLayer> layers_;
  Imf::FrameBuffer buffer_;
};

[[noreturn]] void refuse_channels() {
  throw std::runtime_error("its channels are neither R, G and B nor only Y");
}

}  // namespace

Image decode_exr(std::string_view bytes, Alpha alpha) {
  ExrFile file(bytes);
  if (!file.has_colour() && !file.is_grey()) refuse_channels();
  file.add_image();
  if (alpha == Alpha::Kept && file.has("A")) file.add_alpha();
  file.read();
  return file.take_image();
}

ImageFile decode_exr_file(std::string_view bytes) {
  ExrFile file(bytes);
  const bool has_image = file.has_colour() || file.is_grey();
  if (!has_image && file.has("RY")) refuse_channels();
  if (has_image) file.add_image();
  file.add_layers();
  file.read();
  ImageFile result{file.take_image(), file.take_layers()};
  if (has_image) return result;
  if (result.layers.empty()) refuse_channels();
  const auto coloured = std::ranges::find_if(
      result.layers, [](const ImageLayer& layer) { return layer.channels.starts_with("RGB"); });
  result.image = image_of(coloured == result.layers.end() ? result.layers.front() : *coloured,
                          result.image.width, result.image.height);
  return result;
}

}  // namespace image
