#include "renderer/command/decode_command.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <new>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "confinement/confinement.h"
#include "grf/diagnostics.h"
#include "renderer/image/encoders.h"
#include "renderer/image/image_file.h"

namespace command {
namespace {

using grf::ExitCode;

bool write_out(const void* bytes, std::size_t count) { return std::fwrite(bytes, 1, count, stdout) == count; }

bool write_out(const image::ImageLayer& layer) {
  const std::array lengths = {static_cast<std::uint32_t>(layer.name.size()),
                              static_cast<std::uint32_t>(layer.channels.size())};
  return write_out(lengths.data(), sizeof(lengths)) && write_out(layer.name.data(), layer.name.size()) &&
         write_out(layer.channels.data(), layer.channels.size()) &&
         write_out(layer.values.data(), layer.values.size() * sizeof(float));
}

bool write_out(const image::ImageFile& file) {
  const std::string bytes = image::encode_raw({file.image});
  return write_out(bytes.data(), bytes.size()) &&
         std::ranges::all_of(file.layers, [](const auto& layer) { return write_out(layer); }) &&
         std::fflush(stdout) == 0;
}

}  // namespace

ExitCode decode(const DecodeArguments& arguments) {
  const auto fail = [](const std::string& why) {
    fmt::print(stderr, "{}\n", why);
    return ExitCode::BadInput;
  };
  confinement::confine({{arguments.image}, {}});
  try {
    grf::Diagnostics diagnostics;
    std::optional<image::ImageFile> file;
    const image::Alpha alpha = arguments.has_alpha ? image::Alpha::Kept : image::Alpha::OverBlack;
    if (arguments.has_layers) {
      file = image::read_image_file(arguments.image, diagnostics);
    } else if (auto image = image::read_image(arguments.image, diagnostics, {}, alpha)) {
      file = image::ImageFile{std::move(*image)};
      if (!file->image.alpha.empty()) file->layers.push_back({"A", "", std::move(file->image.alpha)});
    }
    if (!file) return fail(diagnostics.entries().front().message);
    return write_out(*file) ? ExitCode::Done : fail("cannot write the image to standard output");
  } catch (const std::bad_alloc&) {
    return fail("cannot read the image: out of memory");
  }
}

}  // namespace command
