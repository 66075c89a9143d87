#include "renderer/options/op_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "renderer/options/op_line.h"

namespace options {
namespace {

/// The column of values in a new file, after the longest key, so that values are aligned.
constexpr std::size_t ValueColumn = 22;

bool needs_quotes(const std::string& word) {
  return word.empty() || word.find_first_of(" \t\f\v") != std::string::npos || word.starts_with('#') ||
         word.starts_with("//") || word.starts_with('"');
}

bool can_be_written(const std::string& word) {
  if (word.find_first_of("\n\r") != std::string::npos) return false;
  return !needs_quotes(word) || word.find('"') == std::string::npos;
}

std::string written(const std::string& word) { return needs_quotes(word) ? '"' + word + '"' : word; }

std::string written(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + written(word);
  return text;
}

bool is_default(const OptionInfo& option, const std::vector<std::string>& words) {
  RenderOptions options;
  return !set_option(options, option, words) && options == RenderOptions();
}

/// The layout of a line, to copy to a new line.
struct Layout {
  std::string indentation;
  std::size_t column = ValueColumn;  ///< of the value, in bytes after the indentation
  bool has_tab = false;              ///< between key and value
};

Layout layout_of(const std::string& line) {
  const std::vector<OpWord> words = op_words(line);
  const std::size_t key_words = op_key(words).word_count;
  Layout layout;
  layout.indentation = line.substr(0, words[0].begin);
  if (words.size() <= key_words) return layout;
  const std::size_t key_end = words[key_words - 1].end;
  layout.column = words[key_words].begin - layout.indentation.size();
  layout.has_tab = line.substr(key_end, words[key_words].begin - key_end).find('\t') != std::string::npos;
  return layout;
}

std::string line_like(const Layout& layout, std::string_view key, const std::string& values) {
  const std::size_t gap = layout.column > key.size() ? layout.column - key.size() : 1;
  return fmt::format("{}{}{}{}", layout.indentation, key, layout.has_tab ? "\t" : std::string(gap, ' '),
                     values);
}

}  // namespace

OpText::OpText(std::string_view text) {
  if (text.starts_with(grf::ByteOrderMark)) {
    byte_order_mark_ = grf::ByteOrderMark;
    text.remove_prefix(byte_order_mark_.size());
  }
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::size_t next = std::min(end + 1, text.size());
    const std::size_t content = end < text.size() && end > 0 && text[end - 1] == '\r' ? end - 1 : end;
    lines_.push_back(
        {std::string(text.substr(0, content)), std::string(text.substr(content, next - content))});
    text.remove_prefix(next);
  }
}

std::string OpText::text() const {
  std::string text = byte_order_mark_;
  for (const Line& line : lines_) text += line.text + line.end;
  return text;
}

std::string OpText::plain_text() const {
  std::string text;
  for (const Line& line : lines_) text += line.text + (line.end.empty() ? "" : "\n");
  return text;
}

void OpText::set_plain_text(std::string_view text) {
  const std::string newline = lines_.empty() || lines_.front().end.empty() ? "\n" : lines_.front().end;
  std::vector<Line> lines = OpText(text).lines_;
  for (Line& line : lines) line.end = line.end.empty() ? "" : newline;
  const auto is_same = [](const Line& a, const Line& b) {
    return a.text == b.text && a.end.empty() == b.end.empty();
  };
  const std::size_t fewer = std::min(lines.size(), lines_.size());
  std::size_t first = 0;
  for (; first < fewer && is_same(lines[first], lines_[first]); ++first) lines[first] = lines_[first];
  for (std::size_t i = 1; i <= fewer - first; ++i) {
    Line& line = lines[lines.size() - i];
    const Line& before = lines_[lines_.size() - i];
    if (!is_same(line, before)) break;
    line = before;
  }
  lines_ = std::move(lines);
}

std::vector<std::size_t> OpText::lines_of(const OptionInfo& option) const {
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (op_key(op_words(lines_[i].text)).option == &option) lines.push_back(i);
  }
  return lines;
}

std::optional<std::vector<std::string>> OpText::words_of(const OptionInfo& option) const {
  std::vector<std::size_t> lines = lines_of(option);
  if (lines.empty()) return std::nullopt;
  if (!is_repeated(option)) lines.resize(1);
  std::vector<std::string> words;
  for (const std::size_t line : lines) {
    const std::vector<std::string> of_line = words_at(line);
    words.insert(words.end(), of_line.begin(), of_line.end());
  }
  return words;
}

/// The words of a line after its key.
std::vector<std::string> OpText::words_at(std::size_t line) const {
  const std::vector<OpWord> all = op_words(lines_[line].text);
  std::vector<std::string> words;
  for (std::size_t i = op_key(all).word_count; i < all.size(); ++i) words.push_back(all[i].text);
  return words;
}

std::uint32_t OpText::line_of(const OptionInfo& option) const {
  const std::vector<std::size_t> lines = lines_of(option);
  return lines.empty() ? 0 : static_cast<std::uint32_t>(lines.front() + 1);
}

const OptionInfo* OpText::option_at(std::uint32_t line) const {
  if (line == 0 || line > lines_.size()) return nullptr;
  return op_key(op_words(lines_[line - 1].text)).option;
}

RenderOptions OpText::options() const {
  RenderOptions options;
  for (std::size_t i = lines_.size(); i-- > 0;) {  // backwards, so that the first of duplicate keys wins
    const OptionInfo* option = op_key(op_words(lines_[i].text)).option;
    if (option == nullptr) continue;
    std::vector<std::string> words = words_at(i);
    if (is_repeated(*option)) {
      if (words.size() != word_count(*option)) continue;
      const std::vector<std::string> behind = option_words(options, *option);
      words.insert(words.end(), behind.begin(), behind.end());
    }
    set_option(options, *option, words);  // keeps the value if the words are invalid
  }
  return options;
}

bool OpText::set(const OptionInfo& option, const std::vector<std::string>& words) {
  if (!std::all_of(words.begin(), words.end(), can_be_written)) return false;
  if (words.empty() || is_default(option, words)) {
    remove(option);
    return true;
  }
  const std::size_t words_of_line = is_repeated(option) ? word_count(option) : words.size();
  const std::vector<std::size_t> lines = lines_of(option);
  const std::size_t wanted = (words.size() + words_of_line - 1) / words_of_line;
  for (std::size_t i = lines.size(); i-- > wanted;) remove_line(lines[i]);
  for (std::size_t i = 0; i < wanted; ++i) {
    const auto first = words.begin() + static_cast<std::ptrdiff_t>(i * words_of_line);
    const auto last =
        words.begin() + static_cast<std::ptrdiff_t>(std::min((i + 1) * words_of_line, words.size()));
    if (i < lines.size()) {
      replace(lines[i], {first, last});
    } else {
      add(option, {first, last});
    }
  }
  return true;
}

void OpText::remove(const OptionInfo& option) {
  const std::vector<std::size_t> lines = lines_of(option);
  for (std::size_t i = lines.size(); i-- > 0;) remove_line(lines[i]);
}

void OpText::replace(std::size_t line, const std::vector<std::string>& words) {
  std::string& text = lines_[line].text;
  const std::vector<OpWord> all = op_words(text);
  const std::size_t key_words = op_key(all).word_count;
  if (all.size() == key_words) {
    text.insert(all.back().end, " " + written(words));
    return;
  }
  // Replace word by word to keep the spaces between them, unless two words touch.
  bool has_gaps = all.size() - key_words == words.size();
  for (std::size_t i = key_words + 1; i < all.size(); ++i) has_gaps &= all[i].begin > all[i - 1].end;
  if (!has_gaps) {
    const std::size_t begin = all[key_words].begin;
    text.replace(begin, all.back().end - begin, written(words));
    return;
  }
  for (std::size_t i = all.size(); i-- > key_words;) {
    const std::string& word = words[i - key_words];
    if (all[i].text == word && !all[i].is_open) continue;
    text.replace(all[i].begin, all[i].end - all[i].begin, written(word));
  }
}

/// Returns the line after which a new one is inserted: the last of its group, or of the groups before.
std::optional<std::size_t> OpText::insertion_line(const OptionInfo& option) const {
  std::optional<std::size_t> line_before;
  OptionGroup nearest = OptionGroup::Image;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const OptionInfo* other = op_key(op_words(lines_[i].text)).option;
    if (other == nullptr || other->group > option.group || (line_before && other->group < nearest)) continue;
    line_before = i;
    nearest = other->group;
  }
  return line_before;
}

void OpText::add(const OptionInfo& option, const std::vector<std::string>& words) {
  const std::string newline = lines_.empty() || lines_.front().end.empty() ? "\n" : lines_.front().end;
  const std::optional<std::size_t> line_before = insertion_line(option);
  const Layout layout = line_before ? layout_of(lines_[*line_before].text) : Layout();
  const std::size_t place = line_before ? *line_before + 1 : lines_.size();
  Line line{line_like(layout, option.key, written(words)), newline};
  if (place > 0 && lines_[place - 1].end.empty()) std::swap(line.end, lines_[place - 1].end);
  lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(place), std::move(line));
}

void OpText::remove_line(std::size_t line) {
  std::string& text = lines_[line].text;
  const std::vector<OpWord> words = op_words(text);
  const std::size_t comment = text.find_first_not_of(" \t\r\f\v", words.back().end);
  if (comment == std::string::npos) {
    lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(line));
  } else {
    text.erase(words.front().begin, comment - words.front().begin);
  }
}

}  // namespace options
