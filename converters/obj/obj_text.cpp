#include "converters/obj/obj_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "converters/index_table.h"
#include "converters/obj/obj_truncation.h"
#include "converters/wording.h"
#include "grf/write.h"

namespace convert {
namespace {

/// The elements of one kind (vertices, say), and the highest index in a face. Faces may precede the elements
/// that they refer to, so that it is compared with the number of elements at the end.
struct Elements {
  std::string_view name;
  long long count = 0;
  long long highest_index = 0;
  std::string_view highest_word;  ///< the word of the highest index in the current statement
  grf::SourceLocation highest_at;
};

class ObjParser {
 public:
  ObjParser(const SourceText& source, grf::Diagnostics& diagnostics)
      : reader_(source.text, source.file),
        diagnostics_(diagnostics),
        errors_before_(diagnostics.error_count()),
        may_be_cut_(reader_.ends_inside_line()) {}

  std::optional<ObjText> run();

 private:
  void read(const Statement& statement);
  void read_other(const Statement& statement);
  void read_cut(const Statement& statement);
  std::span<const float> read_numbers(const Statement& statement, Elements& elements,
                                      std::initializer_list<std::size_t> counts);
  void read_vertex(const Statement& statement);
  std::optional<grf::Vec3f> weighted(const Statement& statement);
  void read_texture_coordinate(const Statement& statement);
  void read_normal(const Statement& statement);
  void read_smoothing_group(const Statement& statement);
  void begin_mesh(const Statement& statement);
  void begin_material(const std::string& name);
  void read_face(const Statement& statement);
  bool read_corners(const Statement& statement);
  std::optional<ObjCorner> resolve(std::string_view word, const WrittenCorner& corner);
  bool resolve(std::string_view word, long long written, Elements& elements, std::uint32_t& index);
  void add_corner(const ObjCorner& corner);
  bool add_face();
  void check_highest_index(const Elements& elements);
  std::size_t count_loose_vertices() const;

  bool fail(std::string_view part, const std::string& message) {
    diagnostics_.error(reader_.location(part), message);
    return false;
  }
  bool failed() const { return diagnostics_.error_count() > errors_before_; }

  StatementReader reader_;
  grf::Diagnostics& diagnostics_;
  std::size_t errors_before_;
  bool may_be_cut_;
  ObjText text_;
  TruncationDetector truncation_detector_;
  Elements vertices_{"vertex", 0, 0, {}, {}};
  Elements texture_coordinates_{"texture coordinate", 0, 0, {}, {}};
  Elements normals_{"normal", 0, 0, {}, {}};
  std::array<float, 6> numbers_ = {};
  IndexTable corners_;
  std::vector<std::uint32_t> face_;                              // corner indices of the current face
  std::map<std::string, std::uint32_t, std::less<>> materials_;  // by name
  std::uint32_t material_ = 0;
  bool mesh_has_faces_ = false;
  std::uint32_t group_ = 0;  // smoothing group; 0 is none
};

std::optional<ObjText> ObjParser::run() {
  text_.meshes = {""};
  text_.materials = {""};
  Statement statement;
  while (!diagnostics_.is_full() && reader_.next(statement)) {
    if (statement.has_line_end) {
      read(statement);
    } else {
      read_cut(statement);
    }
  }
  for (const Elements* elements : {&vertices_, &texture_coordinates_, &normals_}) {
    if (!failed()) check_highest_index(*elements);
  }
  if (failed()) return std::nullopt;
  if (reader_.ends_inside_line()) {
    diagnostics_.warning(reader_.whole_file(), "the file does not end with a line end: it may be truncated");
  }
  text_.loose_vertices = count_loose_vertices();
  return std::move(text_);
}

void ObjParser::read(const Statement& statement) {
  const std::string_view keyword = statement.keyword;
  if (keyword == "f" || keyword == "fo") {
    read_face(statement);
  } else if (keyword == "v") {
    read_vertex(statement);
  } else if (keyword == "vn") {
    read_normal(statement);
  } else if (keyword == "vt") {
    read_texture_coordinate(statement);
  } else {
    read_other(statement);
  }
  // The statistics are only needed to detect truncation.
  if (may_be_cut_) truncation_detector_.add(statement);
}

void ObjParser::read_other(const Statement& statement) {
  const std::string_view keyword = statement.keyword;
  if (keyword == "o" || keyword == "g") {
    begin_mesh(statement);
  } else if (keyword == "usemtl") {
    begin_material(statement.text());
  } else if (keyword == "mtllib") {
    text_.libraries.push_back({statement.text(), reader_.location(keyword)});
  } else if (keyword == "s") {
    read_smoothing_group(statement);
  } else if (keyword == "l") {
    ++text_.lines;
  } else if (keyword == "p") {
    text_.points += statement.arguments.size();
  } else {
    ++text_.unread[std::string(keyword)];
  }
}

void ObjParser::read_cut(const Statement& statement) {
  const std::string why = truncation_detector_.evidence_of_truncation(statement);
  if (why.empty()) {
    read(statement);
  } else {
    fail(statement.keyword, "the file is truncated in this statement: " + why);
  }
}

std::span<const float> ObjParser::read_numbers(const Statement& statement, Elements& elements,
                                               std::initializer_list<std::size_t> counts) {
  ++elements.count;
  std::size_t count = 0;
  for (const std::string_view word : statement.arguments) {
    const auto number = parse_float(word);
    if (!number) {
      fail(word, fmt::format("found '{}', expected a finite number", word));
      return {};
    }
    if (count < numbers_.size()) numbers_[count] = *number;
    ++count;
  }
  if (std::find(counts.begin(), counts.end(), count) == counts.end()) {
    fail(statement.keyword, fmt::format("found {} for a {}, expected {}", counted(count, "number", "numbers"),
                                        elements.name, fmt::join(counts, " or ")));
    return {};
  }
  return std::span(numbers_).first(count);
}

void ObjParser::read_vertex(const Statement& statement) {
  const std::span<const float> numbers = read_numbers(statement, vertices_, {3, 4, 6});
  if (numbers.empty()) return;
  grf::Vec3f position(numbers[0], numbers[1], numbers[2]);
  if (numbers.size() == 4 && numbers[3] != 1) {
    const auto divided = weighted(statement);
    if (!divided) return;
    position = *divided;
  }
  if (numbers.size() == 6) {
    for (std::size_t i = 3; i < 6; ++i) {
      if (numbers[i] < 0) fail(statement.arguments[i], "a colour's components are 0 or more");
    }
    text_.colours.set(text_.positions.size(), grf::Colour(numbers[3], numbers[4], numbers[5]));
  }
  text_.positions.push_back(position);
}

/// Returns the position of a vertex with a weight (homogeneous coordinates), divided by it.
std::optional<grf::Vec3f> ObjParser::weighted(const Statement& statement) {
  std::array<double, 4> numbers = {};
  for (std::size_t i = 0; i < 4; ++i) numbers[i] = parse_number(statement.arguments[i]).value_or(0);
  if (numbers[3] == 0) {
    fail(statement.arguments[3], "a vertex with a weight of 0 is infinitely far away");
    return std::nullopt;
  }
  const grf::Vec3f position(grf::Vec3d(numbers[0], numbers[1], numbers[2]) / numbers[3]);
  if (std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z)) return position;
  fail(statement.keyword, "the vertex, divided by its weight, is too large for a float");
  return std::nullopt;
}

void ObjParser::read_texture_coordinate(const Statement& statement) {
  const std::span<const float> numbers = read_numbers(statement, texture_coordinates_, {1, 2, 3});
  if (numbers.empty()) return;
  text_.texture_coordinates.emplace_back(numbers[0], numbers.size() > 1 ? numbers[1] : 0.0F);
  if (numbers.size() == 3 && numbers[2] != 0) ++text_.deep_texture_coordinates;
}

void ObjParser::read_normal(const Statement& statement) {
  const std::span<const float> numbers = read_numbers(statement, normals_, {3});
  if (!numbers.empty()) text_.normals.emplace_back(numbers[0], numbers[1], numbers[2]);
}

// Parses the number of a smoothing group, or a word that exporters write instead.
void ObjParser::read_smoothing_group(const Statement& statement) {
  const std::string_view word = statement.rest;
  std::uint32_t number = 0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_number = !word.empty() && result.ec == std::errc() && result.ptr == word.data() + word.size();
  group_ = is_number ? number : word.empty() || word == "off" ? 0 : 1;
}

// Groups and objects without faces are not stored, to save memory.
void ObjParser::begin_mesh(const Statement& statement) {
  if (mesh_has_faces_) text_.meshes.emplace_back();
  text_.meshes.back() = grf::with_one_kind_of_quotes(statement.text());
  mesh_has_faces_ = false;
}

void ObjParser::begin_material(const std::string& name) {
  const auto [known, is_new] = materials_.emplace(name, static_cast<std::uint32_t>(text_.materials.size()));
  if (is_new) text_.materials.push_back(name);
  material_ = known->second;
}

void ObjParser::read_face(const Statement& statement) {
  if (statement.arguments.empty()) {
    fail(statement.keyword, "a face without corners, expected three or more");
  } else if (read_corners(statement)) {
    if (statement.arguments.size() < 3) {
      ++text_.degenerate_faces;
    } else if (!add_face()) {
      fail(statement.keyword, "there are too many corners");
    }
  }
}

bool ObjParser::read_corners(const Statement& statement) {
  face_.clear();
  const std::array<Elements*, 3> all_elements = {&vertices_, &texture_coordinates_, &normals_};
  for (Elements* elements : all_elements) elements->highest_word = {};
  const std::optional<WrittenCorner> first = parse_corner(statement.arguments.front());
  for (const std::string_view word : statement.arguments) {
    const std::optional<WrittenCorner> corner = parse_corner(word);
    if (!first || !corner) {
      return fail(word, fmt::format("found '{}', expected a corner: 'v', 'v/t', 'v//n' or 'v/t/n'", word));
    }
    const bool like_first = (corner->texture_coordinate == 0) == (first->texture_coordinate == 0) &&
                            (corner->normal == 0) == (first->normal == 0);
    if (!like_first) {
      return fail(word, fmt::format("'{}': the corners of a face all have a normal, or none has; the same is "
                                    "true of texture coordinates",
                                    word));
    }
    const std::optional<ObjCorner> resolved = resolve(word, *corner);
    if (!resolved) return false;
    add_corner(*resolved);
  }
  // Locations are found once per face, not per corner: to find a column costs the length of the line.
  for (Elements* elements : all_elements) {
    if (elements->highest_word.empty()) continue;
    elements->highest_at = reader_.location(elements->highest_word);
  }
  return true;
}

std::optional<ObjCorner> ObjParser::resolve(std::string_view word, const WrittenCorner& corner) {
  ObjCorner resolved;
  const bool exist =
      resolve(word, corner.vertex, vertices_, resolved.vertex) &&
      resolve(word, corner.texture_coordinate, texture_coordinates_, resolved.texture_coordinate) &&
      resolve(word, corner.normal, normals_, resolved.normal);
  return exist ? std::optional(resolved) : std::nullopt;
}

// Negative indices count back from the last element so far. An index too high for any file is only recorded
// as the highest, which is an error in the end.
bool ObjParser::resolve(std::string_view word, long long written, Elements& elements, std::uint32_t& index) {
  if (written == 0) return true;
  if (written < -elements.count) {
    return fail(word, fmt::format("'{}': no {} with the index {} exists: there are {} before this face", word,
                                  elements.name, written, elements.count));
  }
  if (written > elements.highest_index) {
    // Only the word is stored: a location takes time, and the first faces of a file each have a new highest
    // index.
    if (written > elements.count) elements.highest_word = word;
    elements.highest_index = written;
  }
  const long long from_zero = written < 0 ? elements.count + written : written - 1;
  index = static_cast<std::uint32_t>(std::min<long long>(from_zero, ObjCorner::InvalidIndex - 1));
  return true;
}

void ObjParser::add_corner(const ObjCorner& corner) {
  const auto next = static_cast<std::uint32_t>(text_.corners.size());
  const std::uint32_t index = corners_.find_or_add(
      hash_of(corner), next, [&](std::uint32_t known) { return text_.corners[known] == corner; });
  if (index == next) text_.corners.push_back(corner);
  face_.push_back(index);
}

bool ObjParser::add_face() {
  if (face_.size() > std::numeric_limits<std::uint32_t>::max() - text_.face_corners.size()) return false;
  const std::size_t index = text_.face_count();
  mesh_has_faces_ = true;
  text_.mesh_of_face.add(index, static_cast<std::uint32_t>(text_.meshes.size() - 1));
  text_.material_of_face.add(index, material_);
  const bool has_normals = text_.corners[face_.front()].normal != ObjCorner::InvalidIndex;
  text_.smoothing.add(index, has_normals ? 0 : group_);
  text_.face_corners.insert(text_.face_corners.end(), face_.begin(), face_.end());
  text_.face_offsets.push_back(static_cast<std::uint32_t>(text_.face_corners.size()));
  return true;
}

void ObjParser::check_highest_index(const Elements& elements) {
  if (elements.highest_index <= elements.count) return;
  diagnostics_.error(elements.highest_at, fmt::format("no {} with the index {} exists: the file has {}",
                                                      elements.name, elements.highest_index, elements.count));
}

std::size_t ObjParser::count_loose_vertices() const {
  std::vector<bool> is_used(text_.positions.size());
  for (const ObjCorner& corner : text_.corners) is_used[corner.vertex] = true;
  return static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), false));
}

}  // namespace

void FaceRuns::add(std::size_t face, std::uint32_t number) {
  const std::uint32_t last = runs_.empty() ? 0 : runs_.back().number;
  if (number != last) runs_.push_back({face, number});
}

std::optional<ObjText> parse_obj(const SourceText& source, grf::Diagnostics& diagnostics) {
  return ObjParser(source, diagnostics).run();
}

}  // namespace convert
