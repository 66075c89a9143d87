#include "converters/obj/obj_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "converters/obj/obj_cut.h"

namespace convert {
namespace {

/// What a face says of one of its corners. An index is 0 where it is left out.
struct CornerIndices {
  long long vertex = 0;
  long long texture_coordinate = 0;
  long long normal = 0;
};

/// Takes an index from the front of the text: digits that do not begin with 0, with or without a minus sign.
bool take_index(std::string_view& text, long long& index) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, index);
  const bool has_leading_zero = text.substr(text.starts_with('-') ? 1 : 0).starts_with('0');
  if (result.ec != std::errc() || has_leading_zero) return false;
  text.remove_prefix(static_cast<std::size_t>(result.ptr - text.data()));
  return true;
}

/// `v`, `v/t`, `v//n` or `v/t/n`; the parts behind the vertex may be left empty.
std::optional<CornerIndices> parse_corner(std::string_view word) {
  CornerIndices corner;
  if (!take_index(word, corner.vertex)) return std::nullopt;
  for (long long* part : {&corner.texture_coordinate, &corner.normal}) {
    if (!word.starts_with('/')) break;
    word.remove_prefix(1);
    if (!word.empty() && word.front() != '/' && !take_index(word, *part)) return std::nullopt;
  }
  return word.empty() ? std::optional(corner) : std::nullopt;
}

/// The elements of one kind (vertices, say), and the highest index that a face has of them. Faces may stand
/// before what they refer to, so that it is compared with the number of elements at the end.
struct Elements {
  std::string_view name;
  long long count = 0;
  long long highest_index = 0;
  std::string_view highest_word;  ///< in the statement being checked
  grf::SourceLocation highest_at;
};

class Checker {
 public:
  Checker(const SourceText& source, grf::Diagnostics& diagnostics)
      : reader_(source.text, source.file),
        diagnostics_(diagnostics),
        errors_before_(diagnostics.error_count()) {}

  std::optional<ObjText> run();

 private:
  void check(const Statement& statement);
  void check_cut(const Statement& statement);
  bool check_numbers(const Statement& statement, Elements& elements,
                     std::initializer_list<std::size_t> counts);
  void check_vertex(const Statement& statement);
  void check_face(const Statement& statement);
  bool check_corners(const Statement& statement);
  bool check_index(std::string_view word, long long index, Elements& elements);
  void check_highest_index(const Elements& elements);

  void keep(std::string_view keyword, std::string_view rest) {
    text_.statements.append(keyword).append(" ").append(rest).append("\n");
  }
  void keep(std::string_view keyword, const std::vector<std::string_view>& arguments) {
    text_.statements += keyword;
    for (const std::string_view argument : arguments) text_.statements.append(" ").append(argument);
    text_.statements += '\n';
  }
  bool fail(std::string_view part, const std::string& message) {
    diagnostics_.error(reader_.location(part), message);
    return false;
  }
  bool failed() const { return diagnostics_.error_count() > errors_before_; }

  StatementReader reader_;
  grf::Diagnostics& diagnostics_;
  std::size_t errors_before_;
  ObjText text_;
  CutDetector cut_detector_;
  Elements vertices_{"vertex", 0, 0, {}, {}};
  Elements texture_coordinates_{"texture coordinate", 0, 0, {}, {}};
  Elements normals_{"normal", 0, 0, {}, {}};
  bool smooth_ = false;
};

std::optional<ObjText> Checker::run() {
  // Assimp gives the faces before the first `usemtl` of an object the material that comes with it.
  keep("usemtl", NoMaterial);
  Statement statement;
  while (!diagnostics_.is_full() && reader_.next(statement)) {
    if (statement.has_line_end) {
      check(statement);
    } else {
      check_cut(statement);
    }
  }
  for (const Elements* elements : {&vertices_, &texture_coordinates_, &normals_}) {
    if (!failed()) check_highest_index(*elements);
  }
  if (failed()) return std::nullopt;
  if (reader_.ends_inside_line()) {
    diagnostics_.warning(reader_.whole_file(),
                         "the file does not end with a line end: it may have been cut off");
  }
  if (normals_.count > 0) text_.smooth_faces = 0;
  return std::move(text_);
}

void Checker::check(const Statement& statement) {
  const std::string_view keyword = statement.keyword;
  if (keyword == "v") {
    check_vertex(statement);
  } else if (keyword == "vn") {
    check_numbers(statement, normals_, {3});
  } else if (keyword == "vt") {
    check_numbers(statement, texture_coordinates_, {2, 3});
  } else if (keyword == "f" || keyword == "fo") {
    check_face(statement);
  } else if (keyword == "o" || keyword == "g") {
    // Assimp puts the faces of an object whose name comes again into the wrong one; a group is always new.
    keep("g", statement.text());
  } else if (keyword == "usemtl") {
    keep(keyword, statement.rest.empty() ? std::string(NoMaterial) : statement.text());
  } else if (keyword == "mtllib") {
    text_.libraries.push_back({statement.text(), reader_.location(statement.keyword)});
  } else if (keyword == "s") {
    smooth_ = statement.rest != "off" && statement.rest != "0";
  } else if (keyword == "l") {
    ++text_.lines;
  } else if (keyword == "p") {
    text_.points += statement.arguments.size();
  } else {
    ++text_.unread[std::string(keyword)];
  }
  cut_detector_.add(statement);
}

void Checker::check_cut(const Statement& statement) {
  const std::string why = cut_detector_.why_cut(statement);
  if (why.empty()) {
    check(statement);
  } else {
    fail(statement.keyword, "the file was cut off inside this statement: " + why);
  }
}

bool Checker::check_numbers(const Statement& statement, Elements& elements,
                            std::initializer_list<std::size_t> counts) {
  ++elements.count;
  for (const std::string_view word : statement.arguments) {
    if (!parse_number(word)) return fail(word, fmt::format("found '{}', expected a finite number", word));
  }
  const std::size_t count = statement.arguments.size();
  if (std::find(counts.begin(), counts.end(), count) == counts.end()) {
    return fail(statement.keyword, fmt::format("found {} numbers for a {}, expected {}", count, elements.name,
                                               fmt::join(counts, " or ")));
  }
  keep(statement.keyword, statement.arguments);
  return true;
}

void Checker::check_vertex(const Statement& statement) {
  if (!check_numbers(statement, vertices_, {3, 4, 6})) return;
  const std::vector<std::string_view>& numbers = statement.arguments;
  if (numbers.size() == 4 && parse_number(numbers[3]) == 0.0) {
    fail(numbers[3], "a vertex with a weight of 0 is infinitely far away");
  }
  for (std::size_t i = 3; numbers.size() == 6 && i < 6; ++i) {
    if (parse_number(numbers[i]) < 0.0) fail(numbers[i], "a colour's components are 0 or more");
  }
  ++(numbers.size() == 6 ? text_.coloured_vertices : text_.uncoloured_vertices);
}

void Checker::check_face(const Statement& statement) {
  if (statement.arguments.empty()) {
    fail(statement.keyword, "a face without corners, expected three or more");
  } else if (check_corners(statement)) {
    if (statement.arguments.size() < 3) {
      ++text_.short_faces;
      return;
    }
    ++text_.faces;
    if (smooth_) ++text_.smooth_faces;
    keep("f", statement.arguments);
  }
}

bool Checker::check_corners(const Statement& statement) {
  const std::array<Elements*, 3> all_elements = {&vertices_, &texture_coordinates_, &normals_};
  for (Elements* elements : all_elements) elements->highest_word = {};
  const std::optional<CornerIndices> first = parse_corner(statement.arguments.front());
  for (const std::string_view word : statement.arguments) {
    const std::optional<CornerIndices> corner = parse_corner(word);
    if (!first || !corner) {
      return fail(word, fmt::format("found '{}', expected a corner: 'v', 'v/t', 'v//n' or 'v/t/n'", word));
    }
    // Assimp would give the normals that are there to the corners in their order, and so to the wrong ones.
    const bool like_first = (corner->texture_coordinate == 0) == (first->texture_coordinate == 0) &&
                            (corner->normal == 0) == (first->normal == 0);
    if (!like_first) {
      return fail(word, fmt::format("'{}': the corners of a face all have a normal, or none has; the same is "
                                    "true of texture coordinates",
                                    word));
    }
    if (!check_index(word, corner->vertex, vertices_) ||
        !check_index(word, corner->texture_coordinate, texture_coordinates_) ||
        !check_index(word, corner->normal, normals_)) {
      return false;
    }
  }
  // Once a face, not once a corner: to find a column costs the length of the line.
  for (Elements* elements : all_elements) {
    if (elements->highest_word.empty()) continue;
    elements->highest_at = reader_.location(elements->highest_word);
  }
  if (first->texture_coordinate != 0) ++text_.textured_faces;
  return true;
}

// Negative indices count back from the last element so far.
bool Checker::check_index(std::string_view word, long long index, Elements& elements) {
  if (index < -elements.count) {
    return fail(word, fmt::format("'{}': no {} with the index {} exists: there are {} before this face", word,
                                  elements.name, index, elements.count));
  }
  if (index > elements.highest_index) {
    elements.highest_index = index;
    elements.highest_word = word;
  }
  return true;
}

void Checker::check_highest_index(const Elements& elements) {
  if (elements.highest_index <= elements.count) return;
  diagnostics_.error(elements.highest_at, fmt::format("no {} with the index {} exists: the file has {}",
                                                      elements.name, elements.highest_index, elements.count));
}

}  // namespace

std::optional<ObjText> check_obj(const SourceText& source, grf::Diagnostics& diagnostics) {
  return Checker(source, diagnostics).run();
}

}  // namespace convert
