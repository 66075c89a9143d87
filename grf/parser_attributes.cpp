#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/parser.h"

namespace grf {

bool Parser::is_attribute(const Token& token) const {
  return token.kind == TokenKind::Word &&
         (is_colour_keyword(token.text) || same_keyword(token.text, "brdf") ||
          same_keyword(token.text, "pdf") || same_keyword(token.text, "texture") ||
          same_keyword(token.text, "light"));
}

Comments* Parser::comments_of_attribute(MeshDraft& mesh, const Token& keyword) const {
  if (same_keyword(keyword.text, "brdf")) return &mesh.comments.brdf;
  if (same_keyword(keyword.text, "pdf")) return &mesh.comments.pdf;
  if (same_keyword(keyword.text, "texture")) return &mesh.comments.texture;
  if (same_keyword(keyword.text, "light")) return &mesh.comments.emission;
  return &mesh.comments.colour;
}

// A mesh light reflects nothing: all that its faces can have is the colour that they emit.
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
  if (same_keyword(keyword.text, "brdf")) {
    if (!reset) return parse_brdf_attribute(surface.brdf);
    surface.brdf.reset();
  } else if (same_keyword(keyword.text, "pdf")) {
    if (!reset) return parse_pdf_attribute(surface.pdf);
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
  parse_reference<Colour>(surface.colour.emplace().emplace<Reference>());
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
  parse_reference<Texture>(surface.texture.emplace().emplace<Reference>());
  return true;
}

// The name of a definition of a kind, which must be in scope.
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
    suggestion = fmt::format("'{} = {}' is a parameter, for want of 'brdf' or 'pdf'", parameter->first,
                             parameter->second);
  }
  error(name, fmt::format("no {} called '{}' is defined here{}{}", expected, name.text,
                          suggestion.empty() ? "" : ": ", suggestion));
}

template void Parser::parse_reference<BrdfModel>(Reference&);
template void Parser::parse_reference<Shared<Mesh>>(Reference&);

bool Parser::parse_brdf_attribute(std::optional<BrdfAttribute>& attribute) {
  BrdfModel brdf;
  if (!parse_brdf(brdf, nullptr)) return false;
  take_reference(std::move(brdf), attribute);
  return true;
}

bool Parser::parse_pdf_attribute(std::optional<PdfAttribute>& attribute) {
  PdfModel pdf;
  if (!parse_model(pdf, nullptr)) return false;
  take_reference(std::move(pdf), attribute);
  return true;
}

// A bare word is a reference where a definition of the kind has that name, and else a model's keyword.
template <class ModelOfKind>
void Parser::take_reference(ModelOfKind model,
                            std::optional<std::variant<ModelOfKind, Reference>>& attribute) const {
  if (is_bare_word(model) && context_.scope.scope().template find<ModelOfKind>(model.keyword) != nullptr) {
    attribute = Reference{model.keyword, model.location};
  } else {
    attribute = std::move(model);
  }
}

}  // namespace grf
