#include "renderer/options/op_file.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/text_file.h"
#include "renderer/options/op_line.h"

namespace options {
namespace {

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
      read_line(rest.substr(0, end));
      rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    if (options_.scene.empty() && !diagnostics_.has_errors()) {
      diagnostics_.error({file_, 0, 0},
                         "no scene is given, expected a line 'BPT_Scene' with the path of a GRF file");
    }
    if (diagnostics_.has_errors()) return std::nullopt;
    return options_;
  }

 private:
  void read_line(std::string_view line) {
    const std::vector<OpWord> words = op_words(line);
    if (words.empty()) return;
    const auto at = [&](const OpWord& word) {
      return grf::SourceLocation{file_, line_, op_column(line, word.begin)};
    };
    if (words.back().is_open) {
      diagnostics_.error(at(words.back()), "unclosed quote, expected another one on this line");
      return;
    }
    const auto [option, key_words] = op_key(words);
    if (option == nullptr) return report_unknown(words, at(words[0]));
    const auto [first, is_new] = lines_.emplace(option, line_);
    if (!is_new && !is_repeated(*option)) {
      diagnostics_.error(at(words[0]),
                         fmt::format("{} is given twice, first on line {}", option->key, first->second));
      return;
    }
    std::vector<std::string> values;
    for (std::size_t i = key_words; i < words.size(); ++i) values.push_back(words[i].text);
    const auto* path = std::get_if<PathOption>(&option->value);
    if (path != nullptr && values.size() == 1 && !path->means_none(values[0]))
      values[0] = grf::path_beside(path_, values[0]);
    const OpWord& place = words.size() > key_words ? words[key_words] : words[0];
    options_.locations[option->key] = at(place);
    if (const auto problem = add_values(*option, values)) {
      diagnostics_.error(at(place), fmt::format("{}: {}", option->key, *problem));
    }
  }

  /// Sets an option; a repeated one keeps the values of the lines before.
  std::optional<std::string> add_values(const OptionInfo& option, const std::vector<std::string>& values) {
    if (!is_repeated(option)) return set_option(options_, option, values);
    RenderOptions alone;
    if (auto problem = set_option(alone, option, values)) return problem;
    std::vector<std::string> all = option_words(options_, option);
    all.insert(all.end(), values.begin(), values.end());
    return set_option(options_, option, all);
  }

  void report_unknown(const std::vector<OpWord>& words, const grf::SourceLocation& place) {
    std::vector<std::string> keys;
    for (const OptionInfo& option : option_table()) keys.emplace_back(option.key);
    // A key may be written with spaces: of the words up to a number, keep the longest that is near a key.
    std::string suggestion;
    std::string named = words[0].text;
    std::string key;
    for (const OpWord& word : words) {
      if (word.text.find_first_of("0123456789+-.") == 0) break;
      key += (key.empty() ? "" : "_") + word.text;
      const std::string near = grf::did_you_mean(key, keys);
      if (near.empty()) continue;
      suggestion = near;
      named = key;
    }
    diagnostics_.error(place, suggestion.empty() ? fmt::format("unknown option '{}', expected one of {}",
                                                               named, fmt::join(keys, ", "))
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
  return read_op_text(path, std::move(text), diagnostics);
}

std::optional<RenderOptions> read_op_text(const std::string& path, std::shared_ptr<const std::string> text,
                                          grf::Diagnostics& diagnostics) {
  if (text->empty()) {
    diagnostics.error(grf::whole_file(path), "the file is empty, expected options, one per line");
    return std::nullopt;
  }
  return OpReader(path, std::move(text), diagnostics).run();
}

}  // namespace options
