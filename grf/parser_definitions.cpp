#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/parser.h"

namespace grf {
namespace {

bool is_boolean(const Token& token) {
  return token.kind == TokenKind::Word &&
         (same_keyword(token.text, "true") || same_keyword(token.text, "false"));
}

bool starts_value(const Token& token) {
  return token.kind == TokenKind::Number || token.is('(') || is_boolean(token);
}

bool starts_definition_body(const Token& token) {
  return token.kind == TokenKind::Word &&
         (is_colour_keyword(token.text) || same_keyword(token.text, "brdf") ||
          same_keyword(token.text, "pdf"));
}

}  // namespace

bool Parser::parse_definitions(const Token& opening, DefinitionScope& scope) {
  std::optional<NextDefinition> next;
  do {
    if (!next) {
      while (accept("def")) {
      }
      if (lexer_.peek().kind != TokenKind::Word) return fail_expected("the name of a definition");
      next = NextDefinition{lexer_.next(), 0};
      if (!expect('=', "after the name of a definition")) return false;
    }
    const Token name = std::exchange(next, std::nullopt)->name;
    if (!parse_definition(name, scope, next)) return false;
  } while (next || !at("begin"));
  for (const Definition& definition : scope.definitions) context_.scope.enter(definition);
  const bool parsed = parse_body(opening, scope.body);
  context_.scope.leave(scope.definitions.size());
  return parsed;
}

bool Parser::parse_definition(const Token& name, DefinitionScope& scope,
                              std::optional<NextDefinition>& next) {
  if (!check_new_name(name, scope)) return false;
  Definition definition;
  definition.name = name.text;
  definition.location = lexer_.location(name);
  definition.comments.before = take_comments();
  if (!parse_definition_body(definition, next)) return false;
  definition.comments.behind = take_comment_behind(next ? next->line_before : lexer_.line_of_last());
  scope.definitions.push_back(std::move(definition));
  return true;
}

bool Parser::check_new_name(const Token& name, const DefinitionScope& scope) {
  if (!is_identifier(name.text)) {
    return fail(name, fmt::format("'{}' is a reserved word: another name was expected", name.text));
  }
  const auto same = std::find_if(scope.definitions.begin(), scope.definitions.end(),
                                 [&](const Definition& definition) { return definition.name == name.text; });
  if (same == scope.definitions.end()) return true;
  return fail(
      name, fmt::format("'{}' is already defined in this 'def', at line {}", name.text, same->location.line));
}

bool Parser::parse_definition_body(Definition& definition, std::optional<NextDefinition>& next) {
  if (lexer_.peek().kind == TokenKind::Word && is_colour_keyword(lexer_.peek().text)) {
    lexer_.next();
    return parse_vector(definition.body.emplace<Colour>());
  }
  if (accept("brdf")) return parse_model(definition.body.emplace<BrdfModel>(), &next);
  if (accept("pdf")) return parse_model(definition.body.emplace<PdfModel>(), &next);
  return fail_expected("'rgb', 'brdf' or 'pdf', and then what the name means,");
}

// In a list of definitions, `name = value` is one more parameter and `name = brdf ...` the next definition:
// that name, already taken from the text, is handed back.
bool Parser::parse_model(Model& model, std::optional<NextDefinition>* next) {
  if (lexer_.peek().kind != TokenKind::Word) return fail_expected("the name of a model");
  const Token keyword = lexer_.next();
  model.keyword = keyword.text;
  model.location = lexer_.location(keyword);
  while (lexer_.peek().kind == TokenKind::Word && lexer_.peek_second().is('=')) {
    const std::uint32_t line_before = lexer_.line_of_last();
    const Token name = lexer_.next();
    lexer_.next();
    if (next != nullptr && starts_definition_body(lexer_.peek())) {
      *next = NextDefinition{name, line_before};
      return true;
    }
    if (next != nullptr && !starts_value(lexer_.peek())) {
      return fail_expected(
          fmt::format("either a value for the parameter '{0}' of '{1}', or 'rgb', 'brdf' or "
                      "'pdf' for a definition called '{0}',",
                      name.text, model.keyword));
    }
    Argument argument{std::string(name.text), {}, lexer_.location(name)};
    if (!parse_value(name, argument.value)) return false;
    model.arguments.push_back(std::move(argument));
  }
  return true;
}

bool Parser::parse_value(const Token& name, Value& value) {
  if (lexer_.peek().is('(')) return parse_vector(value.emplace<Colour>());
  if (is_boolean(lexer_.peek())) {
    value = same_keyword(lexer_.next().text, "true");
    return true;
  }
  if (lexer_.peek().kind != TokenKind::Number) {
    return fail_expected(fmt::format("a number, true, false or a triple for '{}'", name.text));
  }
  return parse_number(value.emplace<float>());
}

}  // namespace grf
