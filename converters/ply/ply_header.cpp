#include "converters/ply/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "converters/text_encoding.h"
#include "converters/wording.h"
#include "grf/keywords.h"

namespace convert {
namespace {

struct TypeNames {
  std::string_view old_name;
  std::string_view new_name;
  std::size_t size = 0;
};

/// The names and sizes of types, in the order of `PlyType`.
constexpr std::array<TypeNames, 8> Types = {{{"char", "int8", 1},
                                             {"uchar", "uint8", 1},
                                             {"short", "int16", 2},
                                             {"ushort", "uint16", 2},
                                             {"int", "int32", 4},
                                             {"uint", "uint32", 4},
                                             {"float", "float32", 4},
                                             {"double", "float64", 8}}};

std::optional<PlyType> type_of(std::string_view word) {
  for (std::size_t i = 0; i < Types.size(); ++i) {
    if (word == Types[i].old_name || word == Types[i].new_name) return static_cast<PlyType>(i);
  }
  return std::nullopt;
}

constexpr std::string_view Blanks = " \t\r";

/// Splits a line, without its line end, into words.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (;;) {
    line.remove_prefix(std::min(line.find_first_not_of(Blanks), line.size()));
    if (line.empty()) return words;
    words.push_back(line.substr(0, line.find_first_of(Blanks)));
    line.remove_prefix(words.back().size());
  }
}

std::string_view rest_behind(std::string_view line, std::string_view word) {
  line.remove_prefix(static_cast<std::size_t>(word.data() - line.data()) + word.size());
  line.remove_prefix(std::min(line.find_first_not_of(Blanks), line.size()));
  const std::size_t last = line.find_last_not_of(Blanks);
  return line.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

/// Finds the end of a line; in files of old Macintoshes lines end in only a carriage return.
char line_end_of(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  const bool is_return =
      end != std::string_view::npos && text[end] == '\r' && text.substr(end + 1, 1) != "\n";
  return is_return ? '\r' : '\n';
}

std::ptrdiff_t count_characters(std::string_view text) {
  return std::count_if(text.begin(), text.end(),
                       [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
}

/// The maximum number of elements and properties, few enough for linear searches.
constexpr std::size_t MostElements = 1000;

class HeaderReader {
 public:
  HeaderReader(const PlySource& source, grf::Diagnostics& diagnostics)
      : source_(source),
        text_(*source.bytes),
        line_end_(line_end_of(text_)),
        diagnostics_(diagnostics),
        errors_before_(diagnostics.error_count()) {}

  std::optional<PlyHeader> run();

 private:
  bool next_line();
  void read_line();
  void read_end();
  void read_format();
  void read_element();
  void read_property();
  void skip_line();
  void check_names(const PlyElement& element);
  void check_room();

  bool failed() const { return diagnostics_.error_count() > errors_before_; }
  void fail(std::string_view part, const std::string& message) {
    diagnostics_.error(place_of(part), message);
  }
  // Returns the location of a part of the last line; counting lines from the beginning of the file would be
  // quadratic if many lines have a warning.
  grf::SourceLocation place_of(std::string_view part) const {
    const auto column =
        1 + count_characters(line_.substr(0, static_cast<std::size_t>(part.data() - line_.data())));
    return {source_.file, static_cast<std::uint32_t>(lines_), static_cast<std::uint32_t>(column)};
  }

  const PlySource& source_;
  std::string_view text_;
  char line_end_;
  grf::Diagnostics& diagnostics_;
  std::size_t errors_before_;
  std::size_t position_ = 0;
  std::size_t lines_ = 0;
  std::string_view line_;
  std::vector<std::string_view> words_;
  bool has_format_ = false;
  PlyHeader header_;
};

std::optional<PlyHeader> HeaderReader::run() {
  next_line();  // `ply`
  bool ended = false;
  while (!failed() && !ended && next_line()) {
    ended = !words_.empty() && words_.front() == "end_header";
    ended ? read_end() : read_line();
  }
  if (failed()) return std::nullopt;
  header_.size = position_;
  if (!ended) {
    fail(line_, "the file ends inside its header, expected 'end_header'");
  } else if (!has_format_) {
    fail(line_, "the header does not say its format, expected 'format ascii 1.0' or one that is binary");
  } else {
    for (const PlyElement& element : header_.elements) check_names(element);
    if (!failed()) check_room();
  }
  return failed() ? std::nullopt : std::optional(std::move(header_));
}

bool HeaderReader::next_line() {
  if (position_ >= text_.size()) return false;
  const std::size_t end = text_.find(line_end_, position_);
  line_ = text_.substr(position_, end == std::string_view::npos ? end : end - position_);
  position_ = end == std::string_view::npos ? text_.size() : end + 1;
  words_ = words_of(line_);
  ++lines_;
  return true;
}

void HeaderReader::read_line() {
  const bool is_format = !words_.empty() && words_.front() == "format";
  if (is_format) return read_format();
  const std::string_view keyword = words_.empty() ? std::string_view() : words_.front();
  if (keyword == "element") return read_element();
  if (keyword == "property") return read_property();
  if (keyword == "comment") {
    header_.comments.push_back(to_utf8(rest_behind(line_, keyword)));
  } else {
    skip_line();
  }
}

// This line may end in only a carriage return, followed by the values.
void HeaderReader::read_end() {
  constexpr std::string_view Word = "end_header";
  const std::string_view behind = line_.substr(line_.find(Word) + Word.size());
  if (words_.size() == 1) return;
  if (!behind.starts_with('\r')) return fail(words_[1], "the line 'end_header' goes on, expected its end");
  position_ = static_cast<std::size_t>(behind.data() - text_.data()) + 1;
}

void HeaderReader::read_format() {
  constexpr std::array<std::string_view, 3> Encodings = {"ascii", "binary_little_endian",
                                                         "binary_big_endian"};
  const auto known =
      words_.size() < 2 ? Encodings.end() : std::find(Encodings.begin(), Encodings.end(), words_[1]);
  if (known == Encodings.end() || words_.size() > 3) {
    return fail(words_.size() < 2 ? words_.front() : words_[1],
                fmt::format("expected 'format' and one of {}, then 1.0", fmt::join(Encodings, ", ")));
  }
  if (words_.size() < 3 || words_[2] != "1.0") return fail(words_.back(), "expected the version 1.0");
  header_.encoding = static_cast<PlyEncoding>(known - Encodings.begin());
  has_format_ = true;
}

void HeaderReader::read_element() {
  if (words_.size() != 3) return fail(words_.front(), "expected 'element', its name and its count");
  PlyElement element;
  element.name = words_[1];
  element.location = place_of(words_.front());
  const char* end = words_[2].data() + words_[2].size();
  const auto result = std::from_chars(words_[2].data(), end, element.count);
  if (result.ec != std::errc() || result.ptr != end) {
    return fail(words_[2], fmt::format("found '{}', expected a count", words_[2]));
  }
  if (header_.elements.size() == MostElements) {
    return fail(words_[1], fmt::format("there are more than {} kinds of elements", MostElements));
  }
  if (header_.find(element.name) != nullptr) {
    return fail(words_[1], fmt::format("there are elements '{}' already", element.name));
  }
  header_.elements.push_back(std::move(element));
}

void HeaderReader::read_property() {
  if (header_.elements.empty()) return fail(words_.front(), "this property belongs to no element");
  const bool is_list = words_.size() > 1 && words_[1] == "list";
  if (words_.size() != (is_list ? 5U : 3U)) {
    return fail(words_.front(), is_list ? "expected 'property list', two types and a name"
                                        : "expected 'property', a type and a name");
  }
  PlyProperty property;
  property.name = words_.back();
  for (std::size_t i = is_list ? 2 : 1; i + 1 < words_.size(); ++i) {
    const auto type = type_of(words_[i]);
    if (!type) return fail(words_[i], fmt::format("'{}' is not a type of PLY", words_[i]));
    if (is_list && i == 2) {
      if (is_float(*type)) return fail(words_[i], "a list is counted by an integer");
      property.count_type = type;
    } else {
      property.type = *type;
    }
  }
  header_.elements.back().properties.push_back(std::move(property));
}

// Lines without a keyword are skipped, since exporters write comments that way. A misspelt keyword is an
// error, since it would shift all values after it.
void HeaderReader::skip_line() {
  if (words_.empty() || words_.front() == "obj_info") return;
  const std::string suggestion = grf::did_you_mean(
      words_.front(), {"comment", "element", "end_header", "format", "obj_info", "property"});
  const std::string message = fmt::format("found '{}', expected a keyword of PLY headers", words_.front());
  if (!suggestion.empty()) return fail(words_.front(), fmt::format("{}: {}", message, suggestion));
  diagnostics_.warning(place_of(words_.front()), message + ": the line is skipped");
}

void HeaderReader::check_names(const PlyElement& element) {
  std::vector<std::string_view> names;
  for (const PlyProperty& property : element.properties) names.push_back(property.name);
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice == names.end()) return;
  diagnostics_.error(element.location,
                     fmt::format("elements '{}' have two properties '{}'", element.name, *twice));
}

void HeaderReader::check_room() {
  const std::uint64_t room = text_.size() - header_.size;
  // The last value in a text needs no line end.
  std::uint64_t left = room + (header_.encoding == PlyEncoding::Ascii ? 1 : 0);
  for (const PlyElement& element : header_.elements) {
    const std::uint64_t size = element.fewest_bytes(header_.encoding);
    if (size > 0 && element.count > left / size) {
      diagnostics_.error(element.location,
                         fmt::format("the file is too short for {} '{}': it has {} after its header",
                                     counted(element.count, "element", "elements"), element.name,
                                     counted(room, "byte", "bytes")));
      return;
    }
    left -= element.count * size;
  }
}

}  // namespace

std::size_t size_of(PlyType type) { return Types[static_cast<std::size_t>(type)].size; }
bool is_float(PlyType type) { return type == PlyType::Float32 || type == PlyType::Float64; }
std::string_view name_of(PlyType type) { return Types[static_cast<std::size_t>(type)].old_name; }

std::uint64_t PlyElement::fewest_bytes(PlyEncoding encoding) const {
  if (encoding == PlyEncoding::Ascii) return 2 * properties.size();
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : properties)
    bytes += size_of(property.count_type.value_or(property.type));
  return bytes;
}

const PlyElement* PlyHeader::find(std::string_view name) const {
  const auto known = std::find_if(elements.begin(), elements.end(),
                                  [name](const PlyElement& element) { return element.name == name; });
  return known == elements.end() ? nullptr : &*known;
}

grf::SourceLocation PlySource::place_in_text(std::size_t offset) const {
  const char line_end = line_end_of(*bytes);
  const std::string_view before = std::string_view(*bytes).substr(0, offset);
  const std::size_t last_line_end = before.rfind(line_end);
  const std::size_t begin = last_line_end == std::string_view::npos ? 0 : last_line_end + 1;
  const auto line = 1 + std::count(before.begin(), before.end(), line_end);
  const auto column = 1 + count_characters(before.substr(begin));
  return {file, static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(column)};
}

bool begins_as_ply(std::string_view first_bytes) {
  return grf::same_keyword(first_bytes.substr(0, 3), "ply") &&
         (Blanks.find(first_bytes.substr(3, 1)) != std::string_view::npos ||
          first_bytes.substr(3, 1) == "\n") &&
         first_bytes.size() > 3;
}

std::optional<PlyHeader> read_ply_header(const PlySource& source, grf::Diagnostics& diagnostics) {
  if (begins_as_ply(*source.bytes)) return HeaderReader(source, diagnostics).run();
  diagnostics.error(source.whole_file(), source.bytes->empty() ? "the file is empty, expected a PLY model"
                                                               : "a PLY file begins with a line 'ply'");
  return std::nullopt;
}

}  // namespace convert
