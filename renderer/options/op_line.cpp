#include "renderer/options/op_line.h"

#include <algorithm>

namespace options {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

bool starts_comment(std::string_view line, std::size_t at) {
  const std::string_view rest = line.substr(at);
  return (at == 0 || is_space(line[at - 1])) && (rest.starts_with('#') || rest.starts_with("//"));
}

}  // namespace

std::vector<OpWord> op_words(std::string_view line) {
  std::vector<OpWord> words;
  for (std::size_t i = 0; i < line.size();) {
    if (is_space(line[i])) {
      ++i;
      continue;
    }
    if (starts_comment(line, i)) break;
    const std::size_t begin = i;
    if (line[i] == '"') {
      const std::size_t quote = line.find('"', i + 1);
      const bool is_open = quote == std::string_view::npos;
      i = is_open ? line.size() : quote + 1;
      words.push_back(
          {std::string(line.substr(begin + 1, (is_open ? i : quote) - begin - 1)), begin, i, is_open});
      continue;
    }
    while (i < line.size() && !is_space(line[i])) ++i;
    words.push_back({std::string(line.substr(begin, i - begin)), begin, i});
  }
  return words;
}

OpKey op_key(const std::vector<OpWord>& words) {
  std::string key;
  for (std::size_t i = 0; i < words.size(); ++i) {
    key += (i > 0 ? "_" : "") + words[i].text;
    if (const OptionInfo* option = find_option(key)) return {option, i + 1};
  }
  return {};
}

std::uint32_t op_column(std::string_view line, std::size_t at) {
  // Continuation bytes of UTF-8 do not count.
  const auto starts_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return 1 + static_cast<std::uint32_t>(std::count_if(
                 line.begin(), line.begin() + static_cast<std::ptrdiff_t>(at), starts_character));
}

}  // namespace options
