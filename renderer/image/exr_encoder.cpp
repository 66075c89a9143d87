#include <cstring>

#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfVecAttribute.h>

#include "renderer/image/encoders.h"

namespace image {
namespace {

using grf::Colour;

/// Lets OpenEXR write to memory, so that the file itself can be replaced atomically.
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

/// The channels of a file, and where their values are.
class ExrChannels {
 public:
  ExrChannels(Imf::Header& header, int width) : header_(header), width_(static_cast<std::size_t>(width)) {}

  /// Adds one of `count` interleaved values per pixel, from `first` on.
  void add(const std::string& name, const float* first, std::size_t count) {
    header_.channels().insert(name, Imf::Channel(Imf::FLOAT));
    // OpenEXR's type serves reading and writing; here it is only read.
    char* values = const_cast<char*>(reinterpret_cast<const char*>(first));
    const std::size_t step = count * sizeof(float);
    buffer_.insert(name, Imf::Slice(Imf::FLOAT, values, step, step * width_));
  }

  const Imf::FrameBuffer& buffer() const { return buffer_; }

 private:
  Imf::Header& header_;
  std::size_t width_;
  Imf::FrameBuffer buffer_;
};

void add_layer(const ImageLayer& layer, ExrChannels& channels) {
  if (layer.channels.empty()) return channels.add(layer.name, layer.values.data(), 1);
  for (std::size_t i = 0; i < layer.channels.size(); ++i) {
    channels.add(layer.name + "." + layer.channels[i], layer.values.data() + i, layer.channels.size());
  }
}

void add_attribute(const ImageAttribute& attribute, Imf::Header& header) {
  std::visit(
      [&](const auto& value) {
        header.insert(attribute.name,
                      Imf::TypedAttribute<std::remove_cv_t<std::remove_reference_t<decltype(value)>>>(value));
      },
      attribute.value);
}

}  // namespace

std::string encode_exr(const ImageFile& file) {
  MemoryStream stream;
  {
    Imf::Header header(file.image.width, file.image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    if (file.screen_width > 0) header.screenWindowWidth() = file.screen_width;
    for (const ImageAttribute& attribute : file.attributes) add_attribute(attribute, header);
    ExrChannels channels(header, file.image.width);
    const float* first = &file.image.pixels.front().x;
    constexpr std::size_t Components = sizeof(Colour) / sizeof(float);
    for (const auto& [name, offset] : {std::pair("R", 0), {"G", 1}, {"B", 2}}) {
      channels.add(name, first + offset, Components);
    }
    for (const ImageLayer& layer : file.layers) add_layer(layer, channels);
    Imf::OutputFile output(stream, header);
    output.setFrameBuffer(channels.buffer());
    output.writePixels(file.image.height);
  }  // closing completes the file
  return stream.take_bytes();
}

}  // namespace image
