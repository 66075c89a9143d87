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
          same_keyword(token.text, "pdf") || same_keyword(token.text, "texture"));
}

}  // namespace

bool Parser::parse_definitions(const Token& opening, DefinitionScope& scope) {
  Names names;
  std::optional<NextDefinition> next;
  do {
    if (!next) {
      while (accept("def")) {
      }
    }
    if (next || parse_name(next)) {
      const Token name = std::exchange(next, std::nullopt)->name;
      check_name(name, names);
      if (parse_definition(name, scope, next)) continue;
    }
    context_.lacks_names = true;
    if (context_.is_over() || !skip_to_definition()) return false;
  } while (next || !at("begin"));
  const std::size_t number_outside = std::exchange(context_.scope_number, number_of_scope(scope));
  for (const Definition& definition : scope.definitions) context_.scope.enter(definition);
  const bool parsed = parse_body(opening, scope.body);
  context_.scope.leave(scope.definitions.size());
  context_.scope_number = number_outside;
  return parsed;
}

std::size_t Parser::number_of_scope(const DefinitionScope& scope) {
  std::string names;
  for (const Definition& definition : scope.definitions) {
    names += fmt::format("{} {} ", definition.name, definition.body.index());
  }
  const std::size_t next_number = context_.scope_numbers.size() + 1;
  return context_.scope_numbers.emplace(std::pair(context_.scope_number, names), next_number).first->second;
}

bool Parser::parse_name(std::optional<NextDefinition>& next) {
  const bool is_named = lexer_.peek_second().is('=');
  // What follows can be the first block of a body whose `begin` was left out.
  if (!is_named && starts_block(lexer_.peek())) return fail_expected("'begin' or one more definition");
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

// After an error in a definition: on to the next `def` of the list, or to the body.
bool Parser::skip_to_definition() {
  while (lexer_.peek().kind != TokenKind::EndOfFile && !at("end")) {
    if (at("def")) return true;
    if (starts_block(lexer_.peek())) return false;
    if (at("begin")) return true;
    lexer_.next();
  }
  return false;
}

bool Parser::parse_definition(const Token& name, DefinitionScope& scope,
                              std::optional<NextDefinition>& next) {
  Definition definition;
  definition.name = name.text;
  definition.location = lexer_.location(name);
  definition.comments.before = take_comments();
  if (!parse_definition_body(definition, next)) return false;
  take_comments_of(definition.comments, next ? next->line_before : lexer_.line_of_last());
  scope.definitions.push_back(std::move(definition));
  return true;
}

bool Parser::parse_definition_body(Definition& definition, std::optional<NextDefinition>& next) {
  if (lexer_.peek().kind == TokenKind::Word && is_colour_keyword(lexer_.peek().text)) {
    lexer_.next();
    return parse_vector(definition.body.emplace<Colour>());
  }
  if (accept("brdf")) return parse_model(definition.body.emplace<BrdfModel>(), &next);
  if (accept("pdf")) return parse_model(definition.body.emplace<PdfModel>(), &next);
  if (accept("texture")) {
    Texture& texture = definition.body.emplace<Texture>();
    texture.location = lexer_.location(lexer_.peek());
    return parse_string(texture.file, "the name of an image file, in quotes");
  }
  return fail_expected("'rgb', 'brdf', 'pdf' or 'texture'");
}

// In a list of definitions, `name = value` is one more parameter and `name = brdf ...` the next definition:
// that name, already taken from the text, is handed back.
bool Parser::parse_model(Model& model, std::optional<NextDefinition>* next) {
  const bool is_model = lexer_.peek().kind == TokenKind::Word && is_identifier(lexer_.peek().text);
  if (!is_model) return fail_expected("a model's keyword or the name of a definition");
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
          fmt::format("a value for the parameter '{0}' of '{1}', or 'rgb', 'brdf', 'pdf' or 'texture' for a "
                      "definition called '{0}'",
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
    return fail_expected(
        fmt::format("a number, 'true', 'false' or three numbers in parentheses for '{}'", name.text));
  }
  return parse_number(value.emplace<float>());
}

}  // namespace grf
