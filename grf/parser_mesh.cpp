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

}  // namespace

bool Parser::parse_mesh(const Token& opening, Mesh& mesh) {
  if (lexer_.peek().kind == TokenKind::String) mesh.name = lexer_.next().text;
  Surface own;
  while (is_attribute(lexer_.peek())) {
    const std::vector<std::string> before = take_comments();
    Comments* comments = comments_of_attribute(mesh, lexer_.peek());
    if (!parse_attribute(own, false)) return false;
    comments->before.insert(comments->before.end(), before.begin(), before.end());
    take_comments_of(*comments);
  }
  mesh.surfaces.front() = own;
  mesh.comments.vertices.before = take_comments();
  if (!parse_vertices(mesh)) return false;
  take_comments_of(mesh.comments.vertices);
  mesh.comments.faces.before = take_comments();
  bool mesh_closed = false;
  if (!parse_faces(opening, mesh, mesh_closed)) return false;
  if (mesh_closed) return true;
  take_comments_of(mesh.comments.faces);
  mesh.comments.end = take_comments();
  return end_mesh(opening);
}

bool Parser::parse_vertices(Mesh& mesh) {
  const Token opening = lexer_.peek();
  const auto accept_word = [this] { return accept("vertexs") || accept("vertices"); };
  if (!accept("begin")) return fail_expected("an attribute of the mesh or 'begin vertexs'");
  if (!accept_word()) return fail_expected("'vertexs' (a mesh lists its vertices before its faces)");
  while (!at("end")) {
    if (lexer_.peek().kind == TokenKind::EndOfFile) return fail_unclosed(opening, "end vertexs");
    if (!parse_vertex(mesh)) return false;
  }
  drop_comments();
  take();
  accept_word();
  return true;
}

bool Parser::parse_vertex(Mesh& mesh) {
  const std::size_t vertex = mesh.positions.size();
  Vec3f value(0);
  while (lexer_.peek().kind == TokenKind::Word) {
    if (accept("normal")) {
      if (!parse_vector(value)) return false;
      mesh.normals.set(vertex, value);
    } else if (is_colour_keyword(lexer_.peek().text)) {
      lexer_.next();
      if (!parse_vector(value)) return false;
      mesh.colours.set(vertex, value);
    } else if (accept("uv")) {
      Vec2f uv(0);
      if (!parse_vector(uv)) return false;
      mesh.uvs.set(vertex, uv);
    } else {
      return fail_expected("'normal', 'rgb', 'uv', the three numbers of a vertex or 'end vertexs'");
    }
  }
  if (!parse_vector(value)) return false;
  mesh.positions.push_back(value);
  return true;
}

bool Parser::parse_faces(const Token& mesh_opening, Mesh& mesh, bool& mesh_closed) {
  const Token opening = lexer_.peek();
  if (!accept("begin")) return fail_expected("'begin faces'");
  if (!expect("faces", "after the vertices")) return false;
  Surface surface = mesh.surfaces.front();
  SurfaceIndex surfaces(mesh);
  std::uint32_t surface_index = 0;
  std::vector<std::uint32_t> corners;
  index_reported_ = false;
  while (!at("end") && !context_.is_over()) {
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
    const auto next_begins = [this] {
      return lexer_.peek().is('(') || is_attribute(lexer_.peek()) || at("end");
    };
    while (corners.size() < count && !next_begins()) {
      if (!parse_corner(mesh, corners)) return false;
    }
  }
  if (has_count && count != corners.size()) {
    error(first,
          fmt::format("the face says that it has {} and lists {}", corners_in_words(count), corners.size()));
  } else if (corners.size() < 3) {
    error(first, fmt::format("a face of {}, expected three or more", corners_in_words(corners.size())));
  }
  return true;
}

bool Parser::parse_corner(const Mesh& mesh, std::vector<std::uint32_t>& corners) {
  const Token token = lexer_.peek();
  std::uint32_t corner = 0;
  if (!parse_index(corner, "the index of a vertex")) return false;
  corners.push_back(corner);
  if (corner < mesh.positions.size() || index_reported_) return true;
  // A vertex that is missing makes many indices wrong: one message is enough.
  index_reported_ = true;
  const std::size_t vertices = mesh.positions.size();
  error(token, vertices == 0 ? fmt::format("vertex {} does not exist: the mesh has no vertices", token.text)
                             : fmt::format("vertex {} does not exist: the mesh has {}, from 0 to {}",
                                           token.text, vertices, vertices - 1));
  return true;
}

bool Parser::end_faces(const Token& opening, bool& mesh_closed) {
  const Token end = take();
  if (accept("faces") || !at("mesh")) return true;
  const Token second = lexer_.peek_second();
  if (second.kind == TokenKind::Word && same_keyword(second.text, "light")) {
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
  --open_;
  return true;
}

bool Parser::is_attribute(const Token& token) const {
  return token.kind == TokenKind::Word &&
         (is_colour_keyword(token.text) || same_keyword(token.text, "brdf") ||
          same_keyword(token.text, "pdf") || same_keyword(token.text, "texture") ||
          same_keyword(token.text, "light"));
}

Comments* Parser::comments_of_attribute(Mesh& mesh, const Token& keyword) const {
  if (same_keyword(keyword.text, "brdf")) return &mesh.comments.brdf;
  if (same_keyword(keyword.text, "pdf")) return &mesh.comments.pdf;
  if (same_keyword(keyword.text, "texture")) return &mesh.comments.texture;
  if (same_keyword(keyword.text, "light")) return &mesh.comments.emission;
  return &mesh.comments.colour;
}

bool Parser::parse_attribute(Surface& surface, bool reset_allowed) {
  const Token keyword = lexer_.next();
  if (!reset_allowed && at("none")) {
    return fail_expected(
        fmt::format("a value ('none' is for faces: a mesh just leaves '{}' out)", lower_case(keyword.text)));
  }
  const bool reset = accept("none");
  if (same_keyword(keyword.text, "brdf")) {
    if (!reset) return parse_model_attribute(surface.brdf);
    surface.brdf.reset();
  } else if (same_keyword(keyword.text, "pdf")) {
    if (!reset) return parse_model_attribute(surface.pdf);
    surface.pdf.reset();
  } else if (same_keyword(keyword.text, "texture")) {
    if (!reset) return parse_texture_attribute(surface);
    surface.texture.reset();
  } else if (same_keyword(keyword.text, "light")) {
    if (!reset) return parse_emission(surface);
    surface.emission.reset();
  } else {
    if (!reset) return parse_colour_attribute(surface);
    surface.colour.reset();
  }
  return true;
}

bool Parser::parse_emission(Surface& surface) {
  if (lexer_.peek().kind != TokenKind::Word || !is_colour_keyword(lexer_.peek().text)) {
    return fail_expected("'rgb' and the emitted radiance");
  }
  lexer_.next();
  return parse_vector(surface.emission.emplace(0.0F));
}

bool Parser::parse_colour_attribute(Surface& surface) {
  if (lexer_.peek().kind != TokenKind::Word) {
    Colour colour(0);
    if (!parse_vector(colour)) return false;
    surface.colour = colour;
    return true;
  }
  if (!is_identifier(lexer_.peek().text)) return fail_expected("three numbers or the name of a colour");
  surface.colour = parse_reference<Colour>();
  return true;
}

bool Parser::parse_texture_attribute(Surface& surface) {
  if (lexer_.peek().kind == TokenKind::String) {
    const Token file = lexer_.next();
    surface.texture = Texture{std::string(file.text), lexer_.location(file)};
    return true;
  }
  const bool is_name = lexer_.peek().kind == TokenKind::Word && is_identifier(lexer_.peek().text);
  if (!is_name) return fail_expected("the name of an image file, in quotes, or of a texture");
  surface.texture = parse_reference<Texture>();
  return true;
}

// The name of a definition of a kind, which must be in scope.
template <class Body>
Reference Parser::parse_reference() {
  const Token name = lexer_.next();
  if (context_.scope.find<Body>(name.text) == nullptr) report_unknown<Body>(name);
  return Reference{std::string(name.text), lexer_.location(name)};
}

template <class Body>
void Parser::report_unknown(const Token& name) {
  if (context_.lacks_names || context_.is_over()) return;
  if (!context_.reported_names.emplace(name.text).second) return;
  const std::string_view expected = kind_of(Definition::Body(Body()));
  const Definition* definition = context_.scope.find(name.text);
  if (definition != nullptr) {
    return error(name,
                 fmt::format("'{}' is a {}, expected a {}", name.text, kind_of(definition->body), expected));
  }
  const std::string suggestion = did_you_mean(name.text, context_.scope.names_of<Body>());
  error(name, fmt::format("no {} called '{}' is defined here{}{}", expected, name.text,
                          suggestion.empty() ? "" : ": ", suggestion));
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
