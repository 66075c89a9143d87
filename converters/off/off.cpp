#include "converters/off/off.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "converters/losses.h"
#include "converters/mesh_builder.h"
#include "converters/obj/wavefront_text.h"
#include "converters/scene_building.h"
#include "converters/text_encoding.h"
#include "converters/wording.h"

namespace convert {
namespace {

/// The attributes per vertex by the first word: `STCN4nOFF`, in which all but `OFF` is optional.
struct Header {
  bool has_uv = false;
  bool has_colour = false;
  bool has_normal = false;
  bool is_homogeneous = false;
  bool has_dimensions = false;

  std::size_t coordinates() const { return is_homogeneous ? 4 : 3; }
  /// Returns the count of numbers per vertex without its colour, which may have three or four.
  std::size_t numbers() const { return coordinates() + (has_normal ? 3 : 0) + (has_uv ? 2 : 0); }
};

bool take(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

std::optional<Header> parse_header(std::string_view word) {
  Header header;
  header.has_uv = take(word, "ST");
  header.has_colour = take(word, "C");
  header.has_normal = take(word, "N");
  header.is_homogeneous = take(word, "4");
  header.has_dimensions = take(word, "n");
  if (word != "OFF") return {};
  return header;
}

bool sniff_off(std::string_view first_bytes) {
  StatementReader reader(std::make_shared<const std::string>(to_utf8(first_bytes)), nullptr);
  Statement first;
  return reader.next(first) && parse_header(first.keyword).has_value();
}

struct OffFace {
  std::vector<std::uint32_t> corners;
  std::optional<grf::Colour> colour;
};

class OffReader {
 public:
  OffReader(const SourceText& source, grf::Diagnostics& diagnostics)
      : reader_(source.text, source.file), diagnostics_(diagnostics) {}

  std::optional<grf::Scene> run() {
    if (!read_header() || !read_vertices() || !read_faces()) return {};
    warn_of_rest();
    if (faces_.empty()) {
      fail(reader_.whole_file(), "the file has no faces, and only faces can be imported");
      return {};
    }
    return scene();
  }

 private:
  bool read_header();
  bool read_vertices();
  bool read_vertex();
  bool read_faces();
  bool read_face();
  bool read_face_colour(OffFace& face, std::size_t first_word);
  void warn_of_rest();
  grf::Scene scene();

  /// Reads the words of the next non-empty line.
  bool next_line();
  bool read_counts();
  bool read_numbers(std::size_t from);
  std::optional<std::size_t> index_at(std::size_t word, std::string_view expected);
  grf::Colour colour_at(std::size_t first) const;
  bool fail(const grf::SourceLocation& location, const std::string& message) {
    diagnostics_.error(location, message);
    return false;
  }

  StatementReader reader_;
  grf::Diagnostics& diagnostics_;
  Losses losses_;
  Header header_;
  std::vector<std::string_view> words_;  // words of the current line
  std::vector<double> numbers_;          // numbers of the current line
  std::size_t vertex_count_ = 0;
  std::size_t face_count_ = 0;
  std::vector<Corner> vertices_;
  std::vector<OffFace> faces_;
  std::size_t further_numbers_ = 0;
  double largest_colour_ = 0;
};

bool OffReader::next_line() {
  Statement statement;
  words_.clear();
  if (!reader_.next(statement)) return false;
  words_.push_back(statement.keyword);
  words_.insert(words_.end(), statement.arguments.begin(), statement.arguments.end());
  return true;
}

bool OffReader::read_header() {
  if (!next_line()) return fail(reader_.whole_file(), "the file has no lines, expected an OFF model");
  const auto header = parse_header(words_.front());
  if (!header) return fail(reader_.location(words_.front()), "expected OFF, the format's name");
  header_ = *header;
  if (header_.has_dimensions) {
    return fail(reader_.location(words_.front()), "vertices of any dimension are not read, expected three");
  }
  if (words_.size() > 1 && words_[1] == "BINARY") {
    return fail(reader_.location(words_[1]), "binary OFF files are not read, expected one in text");
  }
  words_.erase(words_.begin());
  if (words_.empty() && !next_line()) return fail(reader_.whole_file(), "the counts are missing");
  return read_counts();
}

bool OffReader::read_counts() {
  const auto vertices = index_at(0, "the count of vertices");
  const auto faces = vertices ? index_at(1, "the count of faces") : std::nullopt;
  if (!faces) return false;
  vertex_count_ = *vertices;
  face_count_ = *faces;
  return true;
}

std::optional<std::size_t> OffReader::index_at(std::size_t word, std::string_view expected) {
  if (word >= words_.size()) {
    fail(reader_.location(words_.back()), fmt::format("the line ends here, expected {}", expected));
    return {};
  }
  const std::string_view text = words_[word];
  std::uint32_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error == std::errc() && end == text.data() + text.size()) return index;
  fail(reader_.location(text), fmt::format("found '{}', expected {}", text, expected));
  return {};
}

bool OffReader::read_numbers(std::size_t from) {
  numbers_.clear();
  for (std::size_t i = from; i < words_.size(); ++i) {
    const auto number = parse_number(words_[i]);
    if (!number) {
      return fail(reader_.location(words_[i]), fmt::format("found '{}', expected a number", words_[i]));
    }
    numbers_.push_back(*number);
  }
  return true;
}

bool OffReader::read_vertices() {
  while (vertices_.size() < vertex_count_) {
    if (!next_line()) {
      return fail(reader_.whole_file(), fmt::format("the file ends after {} of {}", vertices_.size(),
                                                    counted(vertex_count_, "vertex", "vertices")));
    }
    if (!read_vertex()) return false;
  }
  return true;
}

bool OffReader::read_vertex() {
  if (!read_numbers(0)) return false;
  const std::size_t least = header_.numbers() + (header_.has_colour ? 3 : 0);
  if (numbers_.size() < least) {
    return fail(reader_.location(words_.back()),
                fmt::format("the vertex has {} of at least {} numbers", numbers_.size(), least));
  }
  const std::size_t most = header_.numbers() + (header_.has_colour ? 4 : 0);
  if (numbers_.size() > most) ++further_numbers_;
  const double w = header_.is_homogeneous ? numbers_[3] : 1;
  Corner corner;
  const grf::Vec3d position = grf::Vec3d(numbers_[0], numbers_[1], numbers_[2]) / w;
  if (!(position.length() < std::numeric_limits<float>::max())) {
    return fail(reader_.location(words_.front()), "the vertex is too far away for a float");
  }
  corner.position = grf::Vec3f(position + grf::Vec3d(0));  // normalises -0 to 0
  std::size_t next = header_.coordinates();
  if (header_.has_normal) {
    corner.normal = grf::Vec3f(grf::Vec3d(numbers_[next], numbers_[next + 1], numbers_[next + 2]));
    next += 3;
  }
  if (header_.has_colour) {
    corner.colour = colour_at(next);
    largest_colour_ = std::max({largest_colour_, numbers_[next], numbers_[next + 1], numbers_[next + 2]});
    next += numbers_.size() - header_.numbers() > 3 ? 4 : 3;
  }
  if (header_.has_uv) corner.uv = grf::Vec2f(grf::Vec2d(numbers_[next], numbers_[next + 1]));
  vertices_.push_back(corner);
  return true;
}

grf::Colour OffReader::colour_at(std::size_t first) const {
  return grf::Colour(grf::Vec3d(std::max(numbers_[first], 0.0), std::max(numbers_[first + 1], 0.0),
                                std::max(numbers_[first + 2], 0.0)));
}

bool OffReader::read_faces() {
  for (std::size_t i = 0; i < face_count_; ++i) {
    if (!next_line()) {
      return fail(reader_.whole_file(),
                  fmt::format("the file ends after {} of {}", i, counted(face_count_, "face", "faces")));
    }
    if (!read_face()) return false;
  }
  return true;
}

bool OffReader::read_face() {
  const auto count = index_at(0, "the count of a face's corners");
  if (!count) return false;
  OffFace face;
  for (std::size_t i = 1; i <= *count; ++i) {
    const auto index = index_at(i, "the index of a vertex");
    if (!index) return false;
    if (*index >= vertex_count_) {
      return fail(reader_.location(words_[i]), fmt::format("vertex {} of {}", *index, vertex_count_));
    }
    face.corners.push_back(static_cast<std::uint32_t>(*index));
  }
  if (!read_face_colour(face, *count + 1)) return false;
  if (*count > 2) {
    faces_.push_back(std::move(face));
  } else {
    losses_.add(*count == 0 ? Loss::DegenerateFace : *count == 1 ? Loss::Point : Loss::Line);
  }
  return true;
}

bool OffReader::read_face_colour(OffFace& face, std::size_t first_word) {
  if (!read_numbers(first_word)) return false;
  if (numbers_.size() == 1) losses_.add(Loss::NumberedColour);
  if (numbers_.size() < 3) return true;
  face.colour = colour_at(0);
  largest_colour_ = std::max({largest_colour_, numbers_[0], numbers_[1], numbers_[2]});
  return true;
}

void OffReader::warn_of_rest() {
  if (further_numbers_ > 0) {
    diagnostics_.warning(reader_.whole_file(), fmt::format("{} that the format's name does not announce",
                                                           counted(further_numbers_, "vertex has numbers",
                                                                   "vertices have numbers")));
  }
  std::size_t lines = 0;
  while (next_line()) ++lines;
  if (lines > 0) {
    diagnostics_.warning(reader_.whole_file(), fmt::format("{} not read after the last face",
                                                           counted(lines, "line is", "lines are")));
  }
  losses_.report(reader_.whole_file(), diagnostics_);
}

// The range of colours is 1 or 255, which only the values themselves tell.
grf::Scene OffReader::scene() {
  const float scale = largest_colour_ > 1 ? 1 / 255.0F : 1;
  for (Corner& corner : vertices_) {
    if (corner.colour) *corner.colour *= scale;
  }
  MeshBuilder builder("");
  std::vector<Corner> corners;
  for (const OffFace& face : faces_) {
    grf::Surface surface;
    if (face.colour) surface.colour = *face.colour * scale;
    corners.clear();
    for (const std::uint32_t index : face.corners) corners.push_back(vertices_[index]);
    builder.add_face(corners, builder.surface(surface));
  }
  grf::Block block;
  block.content = grf::Shared<grf::Mesh>(builder.take());
  block.location = reader_.whole_file();
  return scene_of({}, {std::move(block)}, reader_.whole_file());
}

std::optional<Import> read_off(const std::string& path, const ReadOptions&, grf::Diagnostics& diagnostics) {
  const auto source = read_source_text(path, "an OFF model", diagnostics);
  if (!source) return {};
  auto scene = OffReader(*source, diagnostics).run();
  if (!scene) return {};
  return Import{std::move(*scene), {}};
}

}  // namespace

Format off_format() {
  Format format;
  format.name = "off";
  format.title = "Object File Format (Geomview)";
  format.extensions = {"off"};
  format.sniff = sniff_off;
  format.read = read_off;
  format.keeps = "polygons, shared vertices, normals, texture coordinates, colours of vertices and faces";
  format.loses = "lines, points, transparency, colours by number, vertices without faces, binary files";
  return format;
}

}  // namespace convert
