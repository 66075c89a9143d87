#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/parser.h"

namespace grf {
namespace {

std::string corners_in_words(std::size_t count) {
  return count == 1 ? "one corner" : fmt::format("{} corners", count);
}

/// Estimates how many entries to reserve for a list, extrapolating from those read so far to the rest of the
/// text. Doubling would take up to twice the memory of a large mesh, and its copy as much again.
class Growth {
 public:
  explicit Growth(const Lexer& lexer) : lexer_(lexer), bytes_at_start_(lexer.bytes_left()) {}

  std::size_t room(std::size_t count) const {
    constexpr std::size_t Least = 64;
    constexpr std::size_t Factor = 4;  // limits the estimate, since the rest of the text can differ
    if (count < Least) return Least;
    const std::size_t bytes_of_each =
        std::max<std::size_t>(1, (bytes_at_start_ - lexer_.bytes_left()) / count);
    return count + std::min(count * (Factor - 1), lexer_.bytes_left() / bytes_of_each + Least);
  }

 private:
  const Lexer& lexer_;
  std::size_t bytes_at_start_;
};

void reserve_vertices(MeshDraft& mesh, std::size_t count) {
  mesh.positions.reserve(count);
  if (!mesh.normals.empty()) mesh.normals.reserve(count);
  if (!mesh.colours.empty()) mesh.colours.reserve(count);
  if (!mesh.uvs.empty()) mesh.uvs.reserve(count);
  if (!mesh.irradiance.empty()) mesh.irradiance.reserve(count);
}

void reserve_faces(MeshDraft& mesh, std::size_t count) {
  const std::size_t faces = std::max<std::size_t>(mesh.face_count(), 1);
  mesh.corners.reserve(count * mesh.corners.size() / faces + 1);
  mesh.face_offsets.reserve(count + 1);
  mesh.surface_of_face.reserve(count);
}

}  // namespace

bool Parser::parse_mesh(const Token& opening, MeshKind kind, MeshDraft& mesh) {
  if (kind == MeshKind::Mesh && lexer_.peek().kind == TokenKind::String) mesh.name = lexer_.next().text;
  Surface own;
  while (is_attribute(lexer_.peek())) {
    const std::vector<std::string> before = take_comments();
    Comments* comments = comments_of_attribute(mesh, lexer_.peek());
    if (!parse_attribute(own, kind, false)) return false;
    comments->before.insert(comments->before.end(), before.begin(), before.end());
    take_comments_of(*comments);
  }
  mesh.surfaces.front() = own;
  mesh.comments.vertices.before = take_comments();
  if (!parse_vertices(mesh)) return false;
  take_comments_of(mesh.comments.vertices);
  mesh.comments.faces.before = take_comments();
  bool mesh_closed = false;
  if (!parse_faces(opening, kind, mesh, mesh_closed)) return false;
  if (mesh_closed) return true;
  take_comments_of(mesh.comments.faces);
  mesh.comments.end = take_comments();
  return end_mesh(opening, kind);
}

bool Parser::parse_vertices(MeshDraft& mesh) {
  const Token opening = lexer_.peek();
  const auto accept_word = [this] { return accept("vertexs") || accept("vertices"); };
  if (!accept("begin")) return fail_expected("an attribute of the mesh or 'begin vertexs'");
  if (!accept_word()) return fail_expected("'vertexs' (a mesh lists its vertices before its faces)");
  const Growth growth(lexer_);
  while (!at("end")) {
    if (lexer_.peek().kind == TokenKind::EndOfFile) return fail_unclosed(opening, "end vertexs");
    const std::size_t count = mesh.positions.size();
    if (count == mesh.positions.capacity()) reserve_vertices(mesh, growth.room(count));
    if (!parse_vertex(mesh)) return false;
  }
  mesh.free_spare_memory();
  drop_comments();
  take();
  accept_word();
  return true;
}

bool Parser::parse_vertex(MeshDraft& mesh) {
  const std::size_t vertex = mesh.positions.size();
  Vec3f value(0);
  while (lexer_.peek().kind == TokenKind::Word) {
    if (accept("normal")) {
      if (!parse_vector(value)) return false;
      mesh.normals.set(vertex, value);
    } else if (accept_colour()) {
      if (!parse_vector(value)) return false;
      mesh.colours.set(vertex, value);
    } else if (accept("uv")) {
      Vec2f uv(0);
      if (!parse_vector(uv)) return false;
      mesh.uvs.set(vertex, uv);
    } else if (accept("irad")) {
      if (!parse_vector(value)) return false;
      mesh.irradiance.set(vertex, value);
    } else if (at("begin", "list")) {
      std::vector<DirectionalIrradiance> list;
      if (!parse_irradiance_list(list)) return false;
      mesh.irradiance.set(vertex, std::move(list));
    } else {
      return fail_expected(
          "'normal', 'rgb', 'uv', 'irad', 'begin list', the three numbers of a vertex or 'end vertexs'");
    }
  }
  if (!parse_vector(value)) return false;
  mesh.positions.push_back(value);
  return true;
}

bool Parser::parse_irradiance_list(std::vector<DirectionalIrradiance>& list) {
  const Token opening = take();
  lexer_.next();
  while (accept("ray")) {
    DirectionalIrradiance& arrival = list.emplace_back();
    if (!parse_vector(arrival.direction) || !expect("irad", "after the direction of a ray") ||
        !parse_vector(arrival.irradiance)) {
      return false;
    }
  }
  if (lexer_.peek().kind == TokenKind::EndOfFile) return fail_unclosed(opening, "end list");
  if (!accept("end")) return fail_expected("'ray' or 'end list'");
  accept("list");
  return true;
}

bool Parser::parse_faces(const Token& mesh_opening, MeshKind kind, MeshDraft& mesh, bool& mesh_closed) {
  const Token opening = lexer_.peek();
  if (!accept("begin")) return fail_expected("'begin faces'");
  if (!expect("faces", "after the vertices")) return false;
  Surface surface = mesh.surfaces.front();
  SurfaceIndex surfaces(mesh.surfaces);
  std::uint32_t surface_index = 0;
  std::vector<std::uint32_t> corners;
  index_reported_ = false;
  const Growth growth(lexer_);
  while (!at("end") && !context_.is_over()) {
    if (lexer_.peek().kind == TokenKind::EndOfFile) return fail_unclosed(opening, "end faces");
    if (is_attribute(lexer_.peek())) {
      if (!parse_attribute(surface, kind, true)) return false;
      surface_index = surfaces.index_of(surface);
    } else {
      corners.clear();
      if (!parse_face(mesh, corners)) return false;
      const std::size_t count = mesh.face_count();
      if (count == mesh.surface_of_face.capacity()) reserve_faces(mesh, growth.room(count));
      mesh.add_face(corners, surface_index);
    }
  }
  mesh.free_spare_memory();
  drop_comments();
  return end_faces(mesh_opening, kind, mesh_closed);
}

// Parses a face: `(0, 1, 2)`, `3 (0, 1, 2)` or `3 0 1 2`.
bool Parser::parse_face(const MeshDraft& mesh, std::vector<std::uint32_t>& corners) {
  const Token first = lexer_.peek();
  std::uint32_t count = 0;
  const bool has_count = first.kind == TokenKind::Number;
  if (has_count && !parse_index(count, "the number of a face's corners")) return false;
  if (!has_count && !first.is('(')) return fail_expected("a face, an attribute or 'end faces'");
  const bool parsed = lexer_.peek().is('(') ? lexer_.take_indices(corners, mesh.positions.size()) ||
                                                  parse_corner_list(mesh, corners)
                                            : parse_corners(mesh, count, corners);
  if (!parsed) return false;
  if (has_count && count != corners.size()) {
    error(first,
          fmt::format("the face says that it has {} and lists {}", corners_in_words(count), corners.size()));
  } else if (corners.size() < 3) {
    error(first, fmt::format("a face of {}, expected three or more", corners_in_words(corners.size())));
  }
  return true;
}

bool Parser::parse_corner_list(const MeshDraft& mesh, std::vector<std::uint32_t>& corners) {
  lexer_.next();
  do {
    if (!parse_corner(mesh, corners)) return false;
  } while (accept(','));
  return expect(')', "or ',' after the corner of a face");
}

// Parses as many corners as the count says, unless something else begins before.
bool Parser::parse_corners(const MeshDraft& mesh, std::uint32_t count, std::vector<std::uint32_t>& corners) {
  const auto next_begins = [this] {
    return lexer_.peek().is('(') || is_attribute(lexer_.peek()) || at("end");
  };
  while (corners.size() < count && !next_begins()) {
    if (!parse_corner(mesh, corners)) return false;
  }
  return true;
}

bool Parser::parse_corner(const MeshDraft& mesh, std::vector<std::uint32_t>& corners) {
  const Token token = lexer_.peek();
  std::uint32_t corner = 0;
  if (!parse_index(corner, "the index of a vertex")) return false;
  corners.push_back(corner);
  if (corner < mesh.positions.size() || index_reported_) return true;
  // One missing vertex makes many indices invalid: one message is enough.
  index_reported_ = true;
  const std::size_t vertices = mesh.positions.size();
  error(token, vertices == 0 ? fmt::format("vertex {} does not exist: the mesh has no vertices", token.text)
                             : fmt::format("vertex {} does not exist: the mesh has {}, from 0 to {}",
                                           token.text, vertices, vertices - 1));
  return true;
}

bool Parser::end_faces(const Token& opening, MeshKind kind, bool& mesh_closed) {
  const Token end = take();
  if (accept("faces") || !at("mesh") || kind == MeshKind::Light) return true;
  const Token second = lexer_.peek_second();
  if (second.kind == TokenKind::Word && same_keyword(second.text, "light")) {
    lexer_.next();  // a light follows in either interpretation
    return fail(end,
                "'end faces' is missing, and this can be 'end faces end mesh' before a light, or 'end faces "
                "end' before a mesh light");
  }
  take();
  --open_;
  context_.diagnostics.warning(
      lexer_.location(end),
      fmt::format("'end faces' is missing in the mesh of line {}: it was supplied", opening.line));
  mesh_closed = true;
  return true;
}

bool Parser::end_mesh(const Token& opening, MeshKind kind) {
  const bool is_light = kind == MeshKind::Light;
  const std::string_view end = is_light ? "end" : "end mesh";
  if (accept("end")) {
    if (!is_light) accept("mesh");
    return true;
  }
  if (lexer_.peek().kind == TokenKind::EndOfFile) return fail_unclosed(opening, end);
  if (!at_block()) return fail_expected(fmt::format("'{}'", end));
  context_.diagnostics.warning(lexer_.location(lexer_.peek()),
                               fmt::format("'{}' is missing for the {} of line {}: it was supplied", end,
                                           is_light ? "mesh light" : "mesh", opening.line));
  --open_;
  return true;
}

}  // namespace grf
