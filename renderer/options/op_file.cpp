#include "renderer/options/op_file.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/text_file.h"

namespace options {
namespace {

struct Word {
  std::string text;
  std::uint32_t column = 1;  ///< in characters
  bool is_open = false;      ///< its second quote is missing
};

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

/// A comment starts a line or follows white space, so that `a#b` and `http://x` are words.
bool starts_comment(std::string_view line, std::size_t at) {
  const std::string_view rest = line.substr(at);
  return (at == 0 || is_space(line[at - 1])) && (rest.starts_with('#') || rest.starts_with("//"));
}

/// Of a byte of UTF-8 text: those that continue a character do not count.
std::uint32_t column_of(std::string_view line, std::size_t at) {
  const auto starts_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return 1 + static_cast<std::uint32_t>(std::count_if(
                 line.begin(), line.begin() + static_cast<std::ptrdiff_t>(at), starts_character));
}

/// Words of a line; a quoted one may contain spaces.
std::vector<Word> words_of(std::string_view line) {
  std::vector<Word> words;
  for (std::size_t i = 0; i < line.size();) {
    if (is_space(line[i])) {
      ++i;
      continue;
    }
    if (starts_comment(line, i)) break;
    const std::uint32_t column = column_of(line, i);
    if (line[i] == '"') {
      const std::size_t end = line.find('"', i + 1);
      const bool is_open = end == std::string_view::npos;
      words.push_back({std::string(line.substr(i + 1, is_open ? end : end - i - 1)), column, is_open});
      i = is_open ? line.size() : end + 1;
      continue;
    }
    std::size_t end = i;
    while (end < line.size() && !is_space(line[end])) ++end;
    words.push_back({std::string(line.substr(i, end - i)), column});
    i = end;
  }
  return words;
}

class OpReader {
 public:
  OpReader(const std::string& path, std::shared_ptr<const std::string> text, grf::Diagnostics& diagnostics)
      : path_(path),
        text_(std::move(text)),
        file_(std::make_shared<grf::SourceFile>(grf::SourceFile{path, {}, text_})),
        diagnostics_(diagnostics) {}

  std::optional<RenderOptions> run() {
    std::string_view rest = *text_;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    for (line_ = 1; !rest.empty(); ++line_) {
      const std::size_t end = rest.find('\n');
      read_line(words_of(rest.substr(0, end)));
      rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    if (options_.scene.empty() && !diagnostics_.has_errors()) {
      diagnostics_.error({file_, 0, 0},
                         "no scene is named, expected a line 'BPT_Scene' and the path of a GRF file");
    }
    if (diagnostics_.has_errors()) return std::nullopt;
    return options_;
  }

 private:
  grf::SourceLocation at(const Word& word) const { return {file_, line_, word.column}; }

  /// The option that the line is about, and how many words its key has: underscores may be spaces.
  std::pair<const OptionInfo*, std::size_t> key_of(const std::vector<Word>& words) const {
    std::string key;
    for (std::size_t i = 0; i < words.size(); ++i) {
      key += (i > 0 ? "_" : "") + words[i].text;
      if (const OptionInfo* option = find_option(key)) return {option, i + 1};
    }
    return {nullptr, 0};
  }

  void read_line(const std::vector<Word>& words) {
    if (words.empty()) return;
    if (words.back().is_open) {
      diagnostics_.error(at(words.back()), "a quote that is not closed, expected another one in this line");
      return;
    }
    const auto [option, key_words] = key_of(words);
    if (option == nullptr) return report_unknown(words);
    if (const auto [first, is_new] = lines_.emplace(option, line_); !is_new) {
      diagnostics_.error(at(words[0]),
                         fmt::format("{} is given twice, first in line {}", option->key, first->second));
      return;
    }
    std::vector<std::string> values;
    for (std::size_t i = key_words; i < words.size(); ++i) values.push_back(words[i].text);
    const auto* path = std::get_if<PathOption>(&option->value);
    if (path != nullptr && values.size() == 1 && !path->means_none(values[0]))
      values[0] = grf::path_beside(path_, values[0]);
    const Word& place = words.size() > key_words ? words[key_words] : words[0];
    options_.locations[option->key] = at(place);
    if (const auto problem = set_option(options_, *option, values)) {
      diagnostics_.error(at(place), fmt::format("{}: {}", option->key, *problem));
    }
  }

  void report_unknown(const std::vector<Word>& words) {
    std::vector<std::string> keys;
    for (const OptionInfo& option : option_table()) keys.emplace_back(option.key);
    // A key may be written with spaces: of the words up to a number, as many as are near a key.
    std::string suggestion;
    std::string named = words[0].text;
    std::string key;
    for (const Word& word : words) {
      if (word.text.find_first_of("0123456789+-.") == 0) break;
      key += (key.empty() ? "" : "_") + word.text;
      const std::string near = grf::did_you_mean(key, keys);
      if (near.empty()) continue;
      suggestion = near;
      named = key;
    }
    diagnostics_.error(at(words[0]), suggestion.empty()
                                         ? fmt::format("unknown option '{}', expected one of {}", named,
                                                       fmt::join(keys, ", "))
                                         : fmt::format("unknown option '{}': {}", named, suggestion));
  }

  const std::string& path_;
  std::shared_ptr<const std::string> text_;
  std::shared_ptr<const grf::SourceFile> file_;
  grf::Diagnostics& diagnostics_;
  RenderOptions options_;
  std::map<const OptionInfo*, std::uint32_t> lines_;
  std::uint32_t line_ = 1;
};

}  // namespace

std::optional<RenderOptions> read_op_file(const std::string& path, grf::Diagnostics& diagnostics) {
  auto text = grf::read_file(path, diagnostics);
  if (!text) return std::nullopt;
  if (text->empty()) {
    diagnostics.error(grf::whole_file(path), "the file is empty, expected options, one a line");
    return std::nullopt;
  }
  return OpReader(path, std::move(text), diagnostics).run();
}

}  // namespace options
