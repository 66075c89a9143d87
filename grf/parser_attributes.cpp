#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/parser.h"

namespace grf {

bool Parser::is_attribute(const Token& token) const {
  return token.kind == TokenKind::Word &&
         (is_colour_keyword(token.text) || same_keyword(token.text, "brdf") ||
          same_keyword(token.text, "pdf") || same_keyword(token.text, "texture") ||
          same_keyword(token.text, "light") || same_keyword(token.text, "opacity"));
}

Comments* Parser::comments_of_attribute(MeshDraft& mesh, const Token& keyword) const {
  if (same_keyword(keyword.text, "brdf")) return &mesh.comments.brdf;
  if (same_keyword(keyword.text, "pdf")) return &mesh.comments.pdf;
  if (same_keyword(keyword.text, "texture")) return &mesh.comments.texture;
  if (same_keyword(keyword.text, "light")) return &mesh.comments.emission;
  if (same_keyword(keyword.text, "opacity")) return &mesh.comments.opacity;
  return &mesh.comments.colour;
}

// A mesh light reflects nothing: the only attribute of its faces is the radiance that they emit, `rgb`.
bool Parser::parse_attribute(Surface& surface, MeshKind kind, bool reset_allowed) {
  const Token keyword = lexer_.next();
  surface.location = lexer_.location(keyword);
  if (kind == MeshKind::Light && !is_colour_keyword(keyword.text)) {
    return fail(keyword, fmt::format("'{}' in a mesh light, which reflects nothing: expected 'rgb', the "
                                     "radiance that it emits",
                                     keyword.text));
  }
  if (!reset_allowed && at("none")) {
    return fail_expected(
        fmt::format("a value ('none' is for faces: a mesh just leaves '{}' out)", lower_case(keyword.text)));
  }
  const bool reset = accept("none");
  const auto parse = [&](auto& attribute, auto read_value) {
    if (!reset) return (this->*read_value)(attribute);
    attribute.reset();
    return true;
  };
  if (same_keyword(keyword.text, "brdf")) {
    return parse(surface.brdf, &Parser::parse_model_attribute<BrdfModel>);
  }
  if (same_keyword(keyword.text, "pdf")) return parse(surface.pdf, &Parser::parse_model_attribute<PdfModel>);
  if (same_keyword(keyword.text, "texture")) {
    return parse(surface.texture, &Parser::parse_texture_attribute);
  }
  if (same_keyword(keyword.text, "light")) return parse(surface.emission, &Parser::parse_emission);
  if (same_keyword(keyword.text, "opacity")) return parse(surface.opacity, &Parser::parse_opacity);
  return parse(surface.colour, &Parser::parse_colour_attribute);
}

bool Parser::parse_emission(std::optional<Colour>& emission) {
  if (!accept_colour()) return fail_expected("'rgb' and the emitted radiance");
  return parse_vector(emission.emplace(0.0F));
}

// The cutoff and the factor are never left out: the number of corners of a face can follow.
bool Parser::parse_opacity(std::optional<Opacity>& opacity) {
  Opacity& given = opacity.emplace();
  if (accept("mask")) {
    given.kind = Opacity::Kind::Mask;
  } else if (accept("blend")) {
    given.kind = Opacity::Kind::Blend;
  } else if (lexer_.peek().kind != TokenKind::Number) {
    return fail_expected("a number, 'mask' and a cutoff, or 'blend' and a factor");
  }
  return parse_number(given.value);
}

bool Parser::parse_colour_attribute(std::optional<ColourAttribute>& attribute) {
  if (lexer_.peek().kind != TokenKind::Word) {
    Colour colour(0);
    if (!parse_vector(colour)) return false;
    attribute = colour;
    return true;
  }
  if (!at_identifier()) return fail_expected("three numbers or the name of a colour");
  parse_reference<Colour>(attribute.emplace().emplace<Reference>());
  return true;
}

bool Parser::parse_texture_attribute(std::optional<TextureAttribute>& attribute) {
  if (lexer_.peek().kind == TokenKind::String) {
    const Token file = lexer_.next();
    attribute = Texture{std::string(file.text), lexer_.location(file)};
    return true;
  }
  if (!at_identifier()) return fail_expected("the name of an image file, in quotes, or of a texture");
  parse_reference<Texture>(attribute.emplace().emplace<Reference>());
  return true;
}

// Parses the name of a definition of a kind, which must be in scope.
template <class Body>
void Parser::parse_reference(Reference& reference) {
  const Token name = lexer_.next();
  reference = {std::string(name.text), lexer_.location(name)};
  if (context_.scope.scope().find<Body>(name.text) != nullptr) return;
  if (context_.lacks_names || context_.is_over()) return;
  if (!context_.reported_names.emplace(name.text).second) return;
  const Scope scope = context_.scope.scope();
  const std::string_view expected = kind_of(Definition::Body(Body()));
  const Definition* definition = scope.find(name.text);
  if (definition != nullptr) {
    return error(name,
                 fmt::format("'{}' is a {}, expected a {}", name.text, kind_of(definition->body), expected));
  }
  std::string suggestion = did_you_mean(name.text, scope.names_of<Body>());
  const auto parameter = context_.word_parameters.find(reference.name);
  if (parameter != context_.word_parameters.end()) {
    suggestion = fmt::format("'{} = {}' is a parameter, because 'brdf' or 'pdf' is missing", parameter->first,
                             parameter->second);
  }
  error(name, fmt::format("no {} called '{}' is defined here{}{}", expected, name.text,
                          suggestion.empty() ? "" : ": ", suggestion));
}

template void Parser::parse_reference<BrdfModel>(Reference&);
template void Parser::parse_reference<Shared<Mesh>>(Reference&);

// A bare word is a reference if a definition of the kind has that name, and otherwise a model's keyword.
template <class ModelOfKind>
bool Parser::parse_model_attribute(std::optional<std::variant<ModelOfKind, Reference>>& attribute) {
  ModelOfKind model;
  if (!parse_model(model, nullptr)) return false;
  if (is_bare_word(model) && context_.scope.scope().template find<ModelOfKind>(model.keyword) != nullptr) {
    attribute = Reference{model.keyword, model.location};
  } else {
    attribute = std::move(model);
  }
  return true;
}

}  // namespace grf
