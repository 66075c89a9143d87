#include <span>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/parser.h"

namespace grf {

bool Parser::parse_mesh(const Token& opening, Mesh& mesh) {
  if (lexer_.peek().kind == TokenKind::String) mesh.name = lexer_.next().text;
  Surface own;
  while (is_attribute(lexer_.peek())) {
    const std::vector<std::string> before = take_comments();
    Comments* comments = comments_of_attribute(mesh, lexer_.peek());
    if (!parse_attribute(own, false)) return false;
    comments->before.insert(comments->before.end(), before.begin(), before.end());
    comments->behind = take_comment_behind();
  }
  mesh.surfaces.front() = own;
  mesh.comments.vertices.before = take_comments();
  if (!parse_vertices(mesh)) return false;
  mesh.comments.vertices.behind = take_comment_behind();
  mesh.comments.faces.before = take_comments();
  bool mesh_closed = false;
  if (!parse_faces(opening, mesh, mesh_closed)) return false;
  if (mesh_closed) return true;
  mesh.comments.faces.behind = take_comment_behind();
  mesh.comments.end = take_comments();
  return end_mesh(opening);
}

bool Parser::parse_vertices(Mesh& mesh) {
  const Token opening = lexer_.peek();
  const auto at_word = [this] { return at("vertexs") || at("vertices"); };
  if (!expect("begin", "before 'vertexs'")) return false;
  if (!at_word()) return fail_expected("'vertexs', an attribute of the mesh,");
  lexer_.next();
  while (!at("end")) {
    if (lexer_.peek().kind == TokenKind::EndOfFile) return fail_unclosed(opening, "end vertexs");
    if (!parse_vertex(mesh)) return false;
  }
  drop_comments();
  lexer_.next();
  if (at_word()) lexer_.next();
  return true;
}

bool Parser::parse_vertex(Mesh& mesh) {
  const std::size_t vertex = mesh.positions.size();
  Vec3f value;
  while (lexer_.peek().kind == TokenKind::Word) {
    if (accept("normal")) {
      if (!parse_vector(value)) return false;
      mesh.normals.set(vertex, value);
    } else if (is_colour_keyword(lexer_.peek().text)) {
      lexer_.next();
      if (!parse_vector(value)) return false;
      mesh.colours.set(vertex, value);
    } else {
      return fail_expected("'normal', 'rgb', the three numbers of a vertex or 'end vertexs'");
    }
  }
  if (!parse_vector(value)) return false;
  mesh.positions.push_back(value);
  return true;
}

bool Parser::parse_faces(const Token& mesh_opening, Mesh& mesh, bool& mesh_closed) {
  const Token opening = lexer_.peek();
  if (!expect("begin", "before 'faces'") || !expect("faces", "after the vertices and 'begin'")) return false;
  Surface surface = mesh.surfaces.front();
  SurfaceIndex surfaces(mesh);
  std::uint32_t surface_index = 0;
  std::vector<std::uint32_t> corners;
  while (!at("end")) {
    if (lexer_.peek().kind == TokenKind::EndOfFile) return fail_unclosed(opening, "end faces");
    if (is_attribute(lexer_.peek())) {
      if (!parse_attribute(surface, true)) return false;
      surface_index = surfaces.index_of(surface);
    } else {
      corners.clear();
      if (!parse_face(mesh, corners)) return false;
      mesh.add_face(corners, surface_index);
    }
  }
  drop_comments();
  return end_faces(mesh_opening, mesh_closed);
}

// A face is `(0, 1, 2)`, `3 (0, 1, 2)` or `3 0 1 2`.
bool Parser::parse_face(const Mesh& mesh, std::vector<std::uint32_t>& corners) {
  const Token first = lexer_.peek();
  std::uint32_t count = 0;
  const bool has_count = first.kind == TokenKind::Number;
  if (has_count && !parse_index(count, "the number of a face's corners")) return false;
  if (!has_count && !first.is('(')) return fail_expected("a face, an attribute or 'end faces'");
  if (accept('(')) {
    do {
      if (!parse_corner(mesh, corners)) return false;
    } while (accept(','));
    if (!expect(')', "or ',' after the corner of a face")) return false;
  } else {
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!parse_corner(mesh, corners)) return false;
    }
  }
  if (has_count && count != corners.size()) {
    return fail(first,
                fmt::format("the face says that it has {} corners, and has {}", count, corners.size()));
  }
  if (corners.size() < 3) {
    return fail(first,
                fmt::format("a face of {}: three corners or more were expected",
                            corners.size() == 1 ? "one corner" : fmt::format("{} corners", corners.size())));
  }
  return true;
}

bool Parser::parse_corner(const Mesh& mesh, std::vector<std::uint32_t>& corners) {
  const Token token = lexer_.peek();
  std::uint32_t corner = 0;
  if (!parse_index(corner, "the index of a vertex")) return false;
  if (corner >= mesh.positions.size()) {
    if (mesh.positions.empty())
      return fail(token, fmt::format("vertex {} of a mesh without vertices", token.text));
    return fail(token, fmt::format("vertex {} is out of range: the mesh has {}, from 0 to {}", token.text,
                                   mesh.positions.size(), mesh.positions.size() - 1));
  }
  corners.push_back(corner);
  return true;
}

bool Parser::end_faces(const Token& opening, bool& mesh_closed) {
  const Token end = lexer_.next();
  if (accept("faces") || !at("mesh")) return true;
  const Token second = lexer_.peek_second();
  if (second.kind == TokenKind::Word && same_keyword(second.text, "light")) {
    return fail(end,
                "an 'end' is missing here: this is either 'end faces end mesh' and a light, or the same "
                "and a mesh light");
  }
  lexer_.next();
  context_.diagnostics.warning(
      lexer_.location(end),
      fmt::format("'end faces' is missing in the mesh of line {}: it was supplied", opening.line));
  mesh_closed = true;
  return true;
}

bool Parser::end_mesh(const Token& opening) {
  if (accept("end")) {
    accept("mesh");
    return true;
  }
  if (lexer_.peek().kind == TokenKind::EndOfFile) return fail_unclosed(opening, "end mesh");
  if (!starts_block(lexer_.peek())) return fail_expected("'end mesh'");
  context_.diagnostics.warning(
      lexer_.location(lexer_.peek()),
      fmt::format("'end mesh' is missing for the mesh of line {}: it was supplied", opening.line));
  return true;
}

bool Parser::is_attribute(const Token& token) const {
  return token.kind == TokenKind::Word &&
         (is_colour_keyword(token.text) || same_keyword(token.text, "brdf") ||
          same_keyword(token.text, "pdf") || same_keyword(token.text, "light"));
}

Comments* Parser::comments_of_attribute(Mesh& mesh, const Token& keyword) const {
  if (same_keyword(keyword.text, "brdf")) return &mesh.comments.brdf;
  if (same_keyword(keyword.text, "pdf")) return &mesh.comments.pdf;
  if (same_keyword(keyword.text, "light")) return &mesh.comments.emission;
  return &mesh.comments.colour;
}

bool Parser::parse_attribute(Surface& surface, bool reset_allowed) {
  const Token keyword = lexer_.next();
  const bool reset = reset_allowed && accept("none");
  if (same_keyword(keyword.text, "brdf")) {
    if (!reset) return parse_model_attribute(surface.brdf);
    surface.brdf.reset();
  } else if (same_keyword(keyword.text, "pdf")) {
    if (!reset) return parse_model_attribute(surface.pdf);
    surface.pdf.reset();
  } else if (same_keyword(keyword.text, "light")) {
    if (!reset) {
      if (lexer_.peek().kind != TokenKind::Word || !is_colour_keyword(lexer_.peek().text)) {
        return fail_expected("'rgb' and the emitted radiance");
      }
      lexer_.next();
      return parse_vector(surface.emission.emplace());
    }
    surface.emission.reset();
  } else {
    if (!reset) return parse_colour_attribute(surface);
    surface.colour.reset();
  }
  return true;
}

bool Parser::parse_colour_attribute(Surface& surface) {
  if (lexer_.peek().kind != TokenKind::Word) {
    Colour colour;
    if (!parse_vector(colour)) return false;
    surface.colour = colour;
    return true;
  }
  const Token name = lexer_.next();
  if (context_.scope.find<Colour>(name.text) == nullptr) {
    const std::string suggestion = did_you_mean(name.text, context_.scope.names());
    return fail(name, fmt::format("no colour called '{}' is defined here{}{}", name.text,
                                  suggestion.empty() ? "" : ": ", suggestion));
  }
  surface.colour = Reference{std::string(name.text), lexer_.location(name)};
  return true;
}

// A bare word is a reference where a definition of the kind has that name, and else a model's keyword.
template <class ModelOfKind>
bool Parser::parse_model_attribute(std::optional<std::variant<ModelOfKind, Reference>>& attribute) {
  ModelOfKind model;
  if (!parse_model(model, nullptr)) return false;
  if (model.arguments.empty() && context_.scope.template find<ModelOfKind>(model.keyword) != nullptr) {
    attribute = Reference{model.keyword, model.location};
  } else {
    attribute = std::move(model);
  }
  return true;
}

}  // namespace grf
