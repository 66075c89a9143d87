#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/parser.h"
#include "grf/text_file.h"

namespace grf {
namespace {

bool is_boolean(const Token& token) {
  return token.kind == TokenKind::Word &&
         (same_keyword(token.text, "true") || same_keyword(token.text, "false"));
}

bool is_word_as_value(const Token& token) {
  return token.kind == TokenKind::Word && is_value_word(token.text);
}

bool is_layer(std::string_view keyword, std::string_view parameter) {
  const auto names = layer_names(keyword);
  return std::any_of(names.begin(), names.end(),
                     [parameter](std::string_view layer) { return same_keyword(layer, parameter); });
}

bool starts_value(const Token& token) {
  return token.kind == TokenKind::Number || token.is('(') || is_boolean(token) || is_word_as_value(token);
}

}  // namespace

std::optional<BrdfModel> Parser::parse_lone_brdf() {
  accept("brdf");
  BrdfModel brdf;
  if (!parse_keyword(brdf)) return std::nullopt;
  if (same_keyword(brdf.keyword, "combine") || !layer_names(brdf.keyword).empty()) {
    context_.diagnostics.error(
        brdf.location,
        fmt::format("a '{}' of names, but a single BRDF has no definitions", lower_case(brdf.keyword)));
    return std::nullopt;
  }
  if (lexer_.peek().kind == TokenKind::String) brdf.data_file = lexer_.next().text;
  if (!parse_arguments(brdf, nullptr)) return std::nullopt;
  return if_alone(brdf, "BRDF");
}

std::optional<PdfModel> Parser::parse_lone_pdf() {
  accept("pdf");
  PdfModel pdf;
  if (!parse_model(pdf, nullptr)) return std::nullopt;
  return if_alone(pdf, "PDF");
}

template <class ModelOfKind>
std::optional<ModelOfKind> Parser::if_alone(const ModelOfKind& model, std::string_view kind) {
  if (lexer_.peek().kind != TokenKind::EndOfFile) fail_expected(fmt::format("the end of the {}", kind));
  return context_.has_errors() ? std::nullopt : std::optional(model);
}

bool Parser::parse_model(BrdfModel& brdf, std::optional<NextDefinition>* next) {
  if (lexer_.peek().kind == TokenKind::String) return parse_brdf_file(brdf);
  if (!parse_keyword(brdf)) return false;
  if (same_keyword(brdf.keyword, "combine") && lexer_.peek().kind == TokenKind::Number) {
    if (!parse_terms(brdf.terms)) return false;
  } else if (lexer_.peek().kind == TokenKind::String) {
    brdf.data_file = lexer_.next().text;
  } else if (same_keyword(brdf.keyword, "combine") && lexer_.peek().kind == TokenKind::Word) {
    const Scope scope = context_.scope.scope();
    const bool lacks_weight = scope.find<BrdfModel>(lexer_.peek().text) != nullptr &&
                              scope.find<BrdfModel>(brdf.keyword) == nullptr && !lexer_.peek_second().is('=');
    if (lacks_weight) return fail_expected("the weight of a BRDF before its name");
  }
  return layer_names(brdf.keyword).empty() ? parse_arguments(brdf, next) : parse_layered(brdf, next);
}

bool Parser::parse_model(PdfModel& pdf, std::optional<NextDefinition>* next) {
  return parse_keyword(pdf) && parse_arguments(pdf, next);
}

bool Parser::parse_keyword(Model& model) {
  if (!at_identifier()) return fail_expected("a model's keyword or the name of a definition");
  const Token keyword = lexer_.next();
  model.keyword = keyword.text;
  model.location = lexer_.location(keyword);
  return true;
}

// In a list of definitions, `name = value` is one more parameter and `name = brdf ...` the next definition:
// that name, already read, is returned in `next`. If `brdf` was forgotten, the model's keyword is parsed as
// the value, and `check` explains the mistake.
bool Parser::parse_arguments(Model& model, std::optional<NextDefinition>* next) {
  while (lexer_.peek().kind == TokenKind::Word && lexer_.peek_second().is('=')) {
    const std::uint32_t line_before = lexer_.line_of_last();
    const Token name = lexer_.next();
    lexer_.next();
    const bool names_layer = is_layer(model.keyword, name.text);
    const bool is_map = at_map();
    if (next != nullptr && !is_map && at_definition_body(names_layer)) {
      *next = NextDefinition{name, line_before};
      return true;
    }
    const bool at_layer = names_layer && at_identifier();
    if (next != nullptr && !is_map && !starts_value(lexer_.peek()) && !at_layer) {
      return fail_expected(
          fmt::format("a value for the parameter '{0}' of '{1}', or 'rgb', 'brdf', 'pdf', 'texture' or "
                      "'begin mesh' for a definition called '{0}'",
                      name.text, model.keyword));
    }
    Argument argument{std::string(name.text), {}, lexer_.location(name)};
    if (at_layer) {
      argument.value = Word{std::string(lexer_.next().text)};
    } else if (!(is_map ? parse_map(argument) : parse_value(argument.name, argument.value))) {
      return false;
    }
    if (const auto* word = std::get_if<Word>(&argument.value); next != nullptr && word != nullptr) {
      context_.word_parameters.try_emplace(argument.name, word->text);
    }
    model.arguments.push_back(std::move(argument));
  }
  return true;
}

// A definition may be called as a keyword, such as `rgb` or `brdf`: the name of a layer is told from the body
// of the next definition by what follows.
bool Parser::at_definition_body(bool may_be_name) {
  const Token& first = lexer_.peek();
  if (!starts_definition_body(first) || !may_be_name || !at_identifier())
    return starts_definition_body(first);
  const Token second = lexer_.peek_second();
  if (is_colour_keyword(first.text)) return second.is('(') || second.kind == TokenKind::Number;
  if (second.kind == TokenKind::String || same_keyword(first.text, "texture"))
    return second.kind == TokenKind::String;
  return second.kind == TokenKind::Word && !same_keyword(second.text, "begin") &&
         !lexer_.peek_third().is('=');
}

// The channel tells the image of a parameter from the texture of the next definition, or of the face.
bool Parser::at_map() {
  if (!at("texture") || lexer_.peek_second().kind != TokenKind::String) return false;
  const Token channel = lexer_.peek_third();
  return channel.kind == TokenKind::Word && find_channel(channel.text) && !lexer_.peek_fourth().is('=');
}

bool Parser::parse_map(Argument& argument) {
  lexer_.next();
  ParameterMap& map = argument.map.emplace();
  map.file = lexer_.next().text;
  map.channel = *find_channel(lexer_.next().text);
  argument.value = 1.0F;
  if (!accept('*')) return true;
  if (lexer_.peek().is('(') || lexer_.peek().kind == TokenKind::Number)
    return parse_value(argument.name, argument.value);
  return fail_expected(
      fmt::format("a number or three numbers in parentheses, a factor of '{}'", argument.name));
}

bool Parser::parse_value(std::string_view name, Value& value) {
  if (lexer_.peek().is('(')) return parse_vector(value.emplace<Colour>());
  if (is_boolean(lexer_.peek())) {
    value = same_keyword(lexer_.next().text, "true");
    return true;
  }
  if (is_word_as_value(lexer_.peek())) {
    value = Word{std::string(lexer_.next().text)};
    return true;
  }
  if (at("texture") && lexer_.peek_second().kind == TokenKind::String) {
    lexer_.next();
    lexer_.next();
    return fail_expected(fmt::format("the channel of the image for '{}': r, g, b, a or rgb", name));
  }
  if (lexer_.peek().kind != TokenKind::Number) {
    return fail_expected(fmt::format(
        "a number, 'true', 'false', a word, three numbers in parentheses or 'texture' for '{}'", name));
  }
  return parse_number(value.emplace<float>());
}

// Parses the terms of a `combine`; commas are optional. A number is the weight of another term if a word
// follows it, and otherwise begins a face.
bool Parser::parse_terms(std::vector<CombineTerm>& terms) {
  const auto at_term = [this] {
    return lexer_.peek().kind == TokenKind::Number && lexer_.peek_second().kind == TokenKind::Word;
  };
  do {
    CombineTerm term;
    const Token weight = lexer_.peek();
    if (weight.kind != TokenKind::Number) return fail_expected("the weight of one more BRDF");
    if (!parse_number(term.weight)) return false;
    if (term.weight < 0)
      error(weight, fmt::format("the weight {} of a BRDF, expected 0 or more", weight.text));
    if (!at_identifier()) return fail_expected("the name of a BRDF, after its weight");
    parse_reference<BrdfModel>(term.brdf);
    terms.push_back(std::move(term));
  } while (accept(',') || at_term());
  return true;
}

// Parses the parameters of a layered model. Those that name a BRDF become its terms if all are there, and
// else `check` says which are missing: a bare word may be the name of a definition.
bool Parser::parse_layered(BrdfModel& brdf, std::optional<NextDefinition>* next) {
  if (!parse_arguments(brdf, next)) return false;
  std::vector<CombineTerm> terms;
  std::vector<Argument> rest = brdf.arguments;
  for (const std::string_view layer : layer_names(brdf.keyword)) {
    const auto names_it = [layer](const Argument& argument) {
      return same_keyword(argument.name, layer) && std::holds_alternative<Word>(argument.value);
    };
    const auto argument = std::find_if(rest.begin(), rest.end(), names_it);
    if (argument == rest.end()) return true;
    terms.push_back({1, {std::get<Word>(argument->value).text, argument->location}});
    rest.erase(argument);
    const auto twice = std::find_if(rest.begin(), rest.end(), names_it);
    if (twice == rest.end()) continue;
    context_.diagnostics.error(twice->location, fmt::format("the parameter '{}' is given twice", layer));
    rest.erase(twice);
  }
  brdf.terms = std::move(terms);
  brdf.arguments = std::move(rest);
  return true;
}

// The statement itself is parsed even if the file cannot be read, so parsing continues after it.
bool Parser::parse_brdf_file(BrdfModel& brdf) {
  const Token name = lexer_.next();
  const SourceLocation location = lexer_.location(name);
  const std::string path = path_beside(file_->path, name.text);
  const FileInFolder key = file_in_folder(path);
  auto known = context_.brdf_files.find(key);
  if (known == context_.brdf_files.end()) {
    const auto text = read_file(path, context_.diagnostics, location);
    if (!text) return true;
    const auto file = source_file(path, text, location);
    if (!is_text(*text, "a BRDF", {file, 0, 0}, context_.diagnostics)) return true;
    const auto instance = Parser(text, file, context_).parse_lone_brdf();
    if (!instance) return true;
    known = context_.brdf_files.emplace(key, *instance).first;
  }
  brdf = known->second;
  brdf.instance_file = name.text;
  return true;
}

}  // namespace grf
