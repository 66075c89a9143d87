#include "renderer/command/render_arguments.h"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "renderer/command/isolated_images.h"
#include "renderer/options/op_file.h"

namespace command {
namespace {

using options::RenderOptions;

/// Splits the value of a flag into words: `800x600` is two.
std::vector<std::string> words_of(const options::OptionInfo& option, const std::string& text) {
  const std::size_t x = text.find('x');
  if (options::word_count(option) != 2 || x == std::string::npos) return {text};
  return {text.substr(0, x), text.substr(x + 1)};
}

}  // namespace

std::optional<RenderOptions> read_options(const std::string& path, grf::Diagnostics& diagnostics) {
  std::optional<RenderOptions> render_options(std::in_place);
  if (std::filesystem::path(path).extension() == ".op") {
    render_options = options::read_op_file(path, diagnostics);
  } else {
    render_options->scene = path;
  }
  if (render_options) render_options->image_reader.read = isolated_image_reader();
  return render_options;
}

bool apply_flags(const OptionFlags& flags, RenderOptions& render_options) {
  bool right = true;
  for (const options::OptionInfo& option : options::option_table()) {
    const auto given = flags.find(std::string(option.flag));
    if (option.flag.empty() || given == flags.end()) continue;
    const auto problem = set_option(render_options, option, words_of(option, given->second));
    if (problem) fmt::print(stderr, "error: {}: {}\n", option.flag, *problem);
    right = right && !problem;
    render_options.locations.erase(option.key);  // the value is no longer that of the file
  }
  return right;
}

ProgressStyle progress_style_of(const std::string& word) {
  if (word == "json") return ProgressStyle::Json;
  return word == "bar" ? ProgressStyle::Bar : ProgressStyle::None;
}

}  // namespace command
