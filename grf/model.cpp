#include "grf/model.h"

#include <algorithm>
#include <array>

#include "grf/keywords.h"
#include "grf/text_file.h"

namespace grf {
namespace {

constexpr std::array<std::string_view, 2> LayerNames = {"base", "top"};

/// In the order of ImageChannel.
constexpr std::array<std::string_view, 5> ChannelWords = {"r", "g", "b", "a", "rgb"};

}  // namespace

bool operator==(const Argument& a, const Argument& b) {
  return same_keyword(a.name, b.name) && a.value == b.value && a.map == b.map;
}

bool operator==(const Word& a, const Word& b) { return same_keyword(a.text, b.text); }

bool operator==(const Model& a, const Model& b) {
  return same_keyword(a.keyword, b.keyword) && a.arguments == b.arguments;
}

std::string_view word_of(ImageChannel channel) { return ChannelWords.at(static_cast<std::size_t>(channel)); }

std::optional<ImageChannel> find_channel(std::string_view word) {
  const auto found = std::ranges::find_if(
      ChannelWords, [word](std::string_view channel) { return same_keyword(word, channel); });
  if (found == ChannelWords.end()) return std::nullopt;
  return static_cast<ImageChannel>(found - ChannelWords.begin());
}

bool has_maps(const Model& model) {
  return std::ranges::any_of(model.arguments,
                             [](const Argument& argument) { return argument.map.has_value(); });
}

std::string map_path(const Argument& argument) {
  const auto& file = argument.location.file;
  return file ? path_beside(file->path, argument.map->file) : argument.map->file;
}

bool is_bare_word(const BrdfModel& brdf) {
  return brdf.arguments.empty() && brdf.terms.empty() && brdf.data_file.empty() && brdf.instance_file.empty();
}

std::span<const std::string_view> layer_names(std::string_view keyword) {
  const std::span names(LayerNames);
  return names.first(same_keyword(keyword, "coat") ? 1 : same_keyword(keyword, "layer") ? 2 : 0);
}

bool is_layered(const BrdfModel& brdf) { return !brdf.terms.empty() && !layer_names(brdf.keyword).empty(); }

bool is_bare_word(const PdfModel& pdf) { return pdf.arguments.empty(); }

}  // namespace grf
