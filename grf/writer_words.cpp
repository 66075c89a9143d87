#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <variant>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/write.h"
#include "grf/writer.h"

namespace grf {
namespace {

bool is_finite(float number) { return std::isfinite(number); }

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\0'; }, ' ');
  return text;
}

std::string text_of(const std::vector<Argument>& arguments) {
  std::string text;
  for (const Argument& argument : arguments) {
    text += ' ' + argument.name + '=';
    if (argument.map) {
      text += fmt::format("texture {} {}", quoted(argument.map->file), word_of(argument.map->channel));
      if (argument.value == Value(1.0F)) continue;
      text += " * ";
    }
    if (const auto* number = std::get_if<float>(&argument.value)) text += fmt::format("{}", *number);
    if (const auto* word = std::get_if<Word>(&argument.value)) text += word->text;
    if (const auto* flag = std::get_if<bool>(&argument.value)) text += *flag ? "true" : "false";
    if (const auto* colour = std::get_if<Colour>(&argument.value)) append(text, *colour);
  }
  return text;
}

std::string text_of_layers(const BrdfModel& brdf) {
  std::string text;
  const auto names = layer_names(brdf.keyword);
  for (std::size_t i = 0; i < std::min(names.size(), brdf.terms.size()); ++i) {
    text += fmt::format(" {}={}", names[i], brdf.terms[i].brdf.name);
  }
  return text;
}

}  // namespace

void append(std::string& text, const Vec2f& v) {
  std::array<char, 64> digits;
  const auto* const end = fmt::format_to(digits.data(), FMT_COMPILE("({}, {})"), v.x, v.y);
  text.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

void append(std::string& text, const Vec3f& v) {
  std::array<char, 64> digits;
  const auto* const end = fmt::format_to(digits.data(), FMT_COMPILE("({}, {}, {})"), v.x, v.y, v.z);
  text.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

void append(std::string& text, std::span<const std::uint32_t> corners) {
  char separator = '(';
  for (const std::uint32_t corner : corners) {
    text += separator;
    if (separator == ',') text += ' ';
    const fmt::format_int digits(corner);
    text.append(digits.data(), digits.size());
    separator = ',';
  }
  text += ')';
}

bool is_finite(const Vec2f& v) { return std::isfinite(v.x) && std::isfinite(v.y); }
bool is_finite(const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::string_view problem_of(const Model& model) {
  for (const Argument& argument : model.arguments) {
    const auto* number = std::get_if<float>(&argument.value);
    const auto* colour = std::get_if<Colour>(&argument.value);
    const auto* word = std::get_if<Word>(&argument.value);
    if (argument.map && number == nullptr && colour == nullptr) return MapWithoutFactor;
    if (number != nullptr && !is_finite(*number)) return NotFinite;
    if (colour != nullptr && !is_finite(*colour)) return NotFinite;
    if (word != nullptr && !is_value_word(word->text)) return NoValueWord;
  }
  return {};
}

std::string_view problem_of(const BrdfModel& brdf) {
  const bool has_weights = std::all_of(brdf.terms.begin(), brdf.terms.end(),
                                       [](const CombineTerm& term) { return is_finite(term.weight); });
  return has_weights ? problem_of(static_cast<const Model&>(brdf)) : NotFinite;
}

// A carriage return at the end of a line would be read as part of the line end.
std::string comment_text(const std::string& comment) {
  std::string text = on_one_line(comment);
  while (text.ends_with('\r')) text.pop_back();
  return text;
}

std::string with_one_kind_of_quotes(std::string text) {
  if (text.find('"') == std::string::npos) return text;
  for (const std::string_view quote : {"\u201C", "\u201D"}) {
    for (auto at = text.find(quote); at != std::string::npos; at = text.find(quote, at)) {
      text.replace(at, quote.size(), "\"");
    }
  }
  return text;
}

std::string quoted(const std::string& string) {
  const std::string text = with_one_kind_of_quotes(on_one_line(string));
  if (text.find('"') == std::string::npos) return fmt::format("\"{}\"", text);
  return fmt::format("\u201C{}\u201D", text);
}

std::string respelled(std::string word, std::uint64_t number) {
  for (char& c : word) {
    const char lower = lower_case(c);
    if (lower < 'a' || lower > 'z') continue;
    if ((number & 1U) != 0) c = c == lower ? static_cast<char>(lower - 'a' + 'A') : lower;
    number >>= 1U;
  }
  return word;
}

std::string to_text(const BrdfModel& brdf) {
  std::string text = brdf.keyword;
  if (!brdf.data_file.empty()) text += ' ' + quoted(brdf.data_file);
  if (is_layered(brdf)) return text + text_of_layers(brdf) + text_of(brdf.arguments);
  for (const CombineTerm& term : brdf.terms) {
    text += fmt::format("{}{} {}", &term == brdf.terms.data() ? " " : ", ", term.weight, term.brdf.name);
  }
  return text + text_of(brdf.arguments);
}

double shortest(float value) {
  const std::string digits = fmt::format("{}", value);
  double number = value;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

std::string to_text(const Opacity& opacity) {
  constexpr std::array<std::string_view, 3> Kinds = {"", "mask ", "blend "};
  return fmt::format("opacity {}{}", Kinds[static_cast<std::size_t>(opacity.kind)], opacity.value);
}

std::string to_text(const PdfModel& pdf) { return pdf.keyword + text_of(pdf.arguments); }

}  // namespace grf
