#include "converters/grf_format.h"

#include <algorithm>
#include <array>
#include <utility>

#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/text_file.h"
#include "grf/write.h"

namespace convert {
namespace {

constexpr std::string_view Space = " \t\r\n\f\v";
constexpr std::array<std::string_view, 8> FirstWords = {"begin",     "mesh", "light",  "include",
                                                        "transform", "def",  "params", "use"};

/// Skips leading white space and comments.
std::string_view without_comments(std::string_view text) {
  if (text.starts_with(grf::ByteOrderMark)) text.remove_prefix(grf::ByteOrderMark.size());
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(Space), text.size()));
    if (!text.starts_with("//")) return text;
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
}

bool sniff(std::string_view first_bytes) {
  const std::string_view text = without_comments(first_bytes);
  const auto end = std::find_if_not(text.begin(), text.end(), grf::is_word_character);
  const std::string_view word(text.data(), static_cast<std::size_t>(end - text.begin()));
  return std::any_of(FirstWords.begin(), FirstWords.end(),
                     [word](std::string_view first) { return grf::same_keyword(first, word); });
}

std::optional<Import> read_grf(const std::string& path, const ReadOptions&, grf::Diagnostics& diagnostics) {
  auto scene = grf::read(path, diagnostics);
  if (!scene) return std::nullopt;
  return Import{std::move(*scene), {}, true};
}

}  // namespace

Format grf_format() {
  Format format;
  format.name = "grf";
  format.title = "GRF scene";
  format.extensions = {"grf", "igrf"};
  format.sniff = sniff;
  format.read = read_grf;
  format.write = grf::write;
  format.keeps = "everything";
  format.loses = "comments inside lists of vertices and faces";
  return format;
}

}  // namespace convert
