#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/parser.h"

namespace grf {
bool starts_definition_body(const Token& token) {
  return token.kind == TokenKind::Word &&
         (is_colour_keyword(token.text) || same_keyword(token.text, "brdf") ||
          same_keyword(token.text, "pdf") || same_keyword(token.text, "texture") ||
          same_keyword(token.text, "begin"));
}

bool Parser::parse_definitions(const Token& opening, DefinitionScope& scope) {
  Definitions definitions;
  bool parsed = parse_definition_list(definitions);
  if (parsed) {
    const std::size_t number_outside = std::exchange(context_.scope_number, number_of_scope(definitions));
    parsed = parse_body(opening, scope.body);
    context_.scope_number = number_outside;
  }
  context_.scope.leave(definitions.size());
  scope.definitions.assign(std::make_move_iterator(definitions.begin()),
                           std::make_move_iterator(definitions.end()));
  return parsed;
}

// Each definition is in scope from the next one on.
bool Parser::parse_definition_list(Definitions& definitions) {
  Names names;
  std::optional<NextDefinition> next;
  do {
    if (!next) {
      while (accept("def")) {
      }
    }
    const std::size_t open_before = open_;
    if (next || parse_name(next)) {
      const Token name = std::exchange(next, std::nullopt)->name;
      check_name(name, names);
      if (parse_definition(name, definitions, next)) continue;
    }
    context_.lacks_names = true;
    if (context_.is_over() || !skip_to_definition(open_before)) return false;
  } while (next || !at("begin"));
  return true;
}

std::size_t Parser::number_of_scope(const Definitions& definitions) {
  std::string names;
  for (const Definition& definition : definitions) {
    names += fmt::format("{} {} ", definition.name, definition.body.index());
  }
  const std::size_t next_number = context_.scope_numbers.size() + 1;
  return context_.scope_numbers.emplace(std::pair(context_.scope_number, names), next_number).first->second;
}

bool Parser::parse_name(std::optional<NextDefinition>& next) {
  const bool is_named = lexer_.peek_second().is('=');
  // The next tokens can be the first block of a body whose `begin` was left out.
  if (!is_named && at_block()) return fail_expected("'begin' or one more definition");
  const bool is_name =
      lexer_.peek().kind == TokenKind::Word && (is_named || is_identifier(lexer_.peek().text));
  if (!is_name) return fail_expected("the name of a definition");
  const Token name = lexer_.next();
  if (!expect('=', "after the name of a definition")) return false;
  next = NextDefinition{name, 0};
  return true;
}

void Parser::check_name(const Token& name, Names& names) {
  if (!is_identifier(name.text)) {
    error(name, fmt::format("'{}' is a reserved word, expected another name", name.text));
  }
  const auto [same, is_new] = names.emplace(name.text, name.line);
  if (!is_new) {
    error(name, fmt::format("'{}' is already defined in this 'def', at line {}", name.text, same->second));
  }
}

// Error recovery after a definition: skips out of the mesh that it may be, to the next `def` of the list or
// to the body.
bool Parser::skip_to_definition(std::size_t open_before) {
  while (open_ > open_before && lexer_.peek().kind != TokenKind::EndOfFile) take();
  if (at("mesh") && !at_block()) lexer_.next();
  while (lexer_.peek().kind != TokenKind::EndOfFile && !at("end")) {
    if (at("def")) return true;
    if (at_block()) return false;
    if (at("begin")) return true;
    lexer_.next();
  }
  return false;
}

bool Parser::parse_definition(const Token& name, Definitions& definitions,
                              std::optional<NextDefinition>& next) {
  Definition definition;
  definition.name = name.text;
  definition.location = lexer_.location(name);
  definition.comments.before = take_comments();
  if (!parse_definition_body(definition, next)) return false;
  take_comments_of(definition.comments, next ? next->line_before : lexer_.line_of_last());
  context_.scope.enter(definitions.emplace_back(std::move(definition)));
  return true;
}

bool Parser::parse_definition_body(Definition& definition, std::optional<NextDefinition>& next) {
  if (accept_colour()) return parse_vector(definition.body.emplace<Colour>());
  if (accept("brdf")) return parse_model(definition.body.emplace<BrdfModel>(), &next);
  if (accept("pdf")) return parse_model(definition.body.emplace<PdfModel>(), &next);
  if (accept("texture")) {
    Texture& texture = definition.body.emplace<Texture>();
    texture.location = lexer_.location(lexer_.peek());
    return parse_string(texture.file, "the name of an image file, in quotes");
  }
  const Token opening = lexer_.peek();
  if (!accept("begin")) return fail_expected("'rgb', 'brdf', 'pdf', 'texture' or 'begin mesh'");
  MeshDraft mesh;
  if (!expect("mesh", "after this 'begin'") || !parse_mesh(opening, MeshKind::Mesh, mesh)) return false;
  definition.body = Shared<Mesh>(std::move(mesh));
  return true;
}

}  // namespace grf
