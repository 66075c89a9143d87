#include "converters/vrml/parser.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "converters/vrml/lexer.h"
#include "converters/vrml/node_types.h"

namespace convert::vrml {
namespace {

/// The maximum number of nodes and fields per file, which a malicious text can make many times its size.
constexpr std::size_t MostItems = 8'000'000;

// The recursive-descent parser; functions return false or null after the first error.
class Parser {
 public:
  Parser(std::shared_ptr<const Source> source, grf::Diagnostics& diagnostics)
      : lexer_(*source), diagnostics_(diagnostics), document_(std::make_unique<Document>()) {
    document_->source = std::move(source);
  }

  std::unique_ptr<const Document> run() {
    while (lexer_.peek().kind != TokenKind::EndOfFile) {
      if (!parse_item(document_->roots)) return nullptr;
    }
    return std::move(document_);
  }

 private:
  const Source& source() const { return *document_->source; }
  bool is_vrml1() const { return source().version() == Version::Vrml1; }
  bool fail(const Token& token, std::string_view expected) {
    diagnostics_.error(source().location(token.offset),
                       fmt::format("{}, expected {}", description(token), expected));
    return false;
  }
  bool fail(const Token& token, const std::string& name, std::string_view what) {
    diagnostics_.error(source().location(token.offset), fmt::format("'{}' {}", name, what));
    return false;
  }
  bool expect(char punctuation) {
    if (!lexer_.peek().is(punctuation)) return fail(lexer_.peek(), fmt::format("'{}'", punctuation));
    lexer_.next();
    return true;
  }
  bool count_item(const Token& token);

  bool parse_item(std::vector<const Node*>& nodes);
  bool parse_node_into(std::vector<const Node*>& nodes);
  const Node* parse_node();
  const Node* parse_node(std::string_view name, const Token& type);
  const Node* use_node();
  bool parse_body(Node& node);
  bool parse_field(Node& node, const Token& name);
  bool parse_value(Value& value);
  bool parse_list(Value& value);
  bool parse_words(Value& value);
  bool parse_bit_mask(Value& value);
  void take_numbers(std::vector<double>& numbers);
  void take_strings(Strings& strings);

  bool take_name(std::string_view& name);
  bool skip_route();
  bool skip_dotted_name();
  bool skip_prototype(bool is_external);
  bool skip_brackets(char opening, const Node* inside);

  Lexer lexer_;
  grf::Diagnostics& diagnostics_;
  std::unique_ptr<Document> document_;
  std::map<std::string_view, const Node*> by_name_;
  std::vector<std::string_view> open_names_;  // names of the ancestors of the current node
  unsigned depth_ = 0;
  std::size_t items_ = 0;
};

bool Parser::count_item(const Token& token) {
  if (++items_ <= MostItems) return true;
  diagnostics_.error(source().location(token.offset),
                     fmt::format("the file has more than {} nodes and fields", MostItems));
  return false;
}

/// Parses a node or a statement.
bool Parser::parse_item(std::vector<const Node*>& nodes) {
  const Token& token = lexer_.peek();
  if (!is_vrml1()) {
    if (token.is_word("ROUTE")) return skip_route();
    if (token.is_word("PROTO")) return skip_prototype(false);
    if (token.is_word("EXTERNPROTO")) return skip_prototype(true);
  }
  return parse_node_into(nodes);
}

bool Parser::parse_node_into(std::vector<const Node*>& nodes) {
  const Node* node = parse_node();
  if (node != nullptr) nodes.push_back(node);
  return node != nullptr;
}

const Node* Parser::parse_node() {
  Token token = lexer_.next();
  if (token.is_word("USE")) return use_node();
  std::string_view name;
  if (token.is_word("DEF")) {
    if (!take_name(name)) return nullptr;
    token = lexer_.next();
  }
  if (token.kind == TokenKind::Word) return parse_node(name, token);
  fail(token, "a node");
  return nullptr;
}

const Node* Parser::parse_node(std::string_view name, const Token& type) {
  if (!lexer_.peek().is('{')) {
    fail(lexer_.peek(), fmt::format("'{{' after the node type '{}'", type.text));
    return nullptr;
  }
  if (depth_ == DeepestNode) {
    diagnostics_.error(source().location(type.offset),
                       fmt::format("nodes are nested more than {} deep", DeepestNode));
    return nullptr;
  }
  if (!count_item(type)) return nullptr;
  Node& node = document_->nodes.emplace_back();
  node.type = type.text;
  node.name = name;
  node.source = document_->source.get();
  node.offset = type.offset;
  node.is_known = is_standard_type(type.text, source().version());
  ++depth_;
  open_names_.push_back(name);
  const bool parsed = node.is_known ? parse_body(node) : skip_brackets('{', &node);
  open_names_.pop_back();
  --depth_;
  if (!parsed) return nullptr;
  if (!name.empty()) by_name_[name] = &node;
  return &node;
}

const Node* Parser::use_node() {
  const Token token = lexer_.peek();
  std::string_view name;
  if (!take_name(name)) return nullptr;
  // The name refers to the last node that has it, which must be complete.
  if (const auto found = by_name_.find(name); found != by_name_.end()) return found->second;
  const bool is_open = std::find(open_names_.begin(), open_names_.end(), name) != open_names_.end();
  fail(token, std::string(name), is_open ? "is used inside itself" : "is used, but not defined before");
  return nullptr;
}

// Names that begin with a digit violate the standard, but exporters write them.
bool Parser::take_name(std::string_view& name) {
  const Token& token = lexer_.peek();
  const bool is_string = token.text.starts_with('"');
  if (token.kind != TokenKind::Word && token.kind != TokenKind::Number &&
      (token.kind != TokenKind::Invalid || is_string)) {
    return fail(token, "a name");
  }
  name = lexer_.next().text;
  return true;
}

bool Parser::parse_body(Node& node) {
  if (!expect('{')) return false;
  while (!lexer_.peek().is('}')) {
    const Token& token = lexer_.peek();
    if (token.kind != TokenKind::Word) return fail(token, fmt::format("a field of {} or '}}'", node.type));
    const bool is_statement =
        token.is_word("ROUTE") || token.is_word("PROTO") || token.is_word("EXTERNPROTO");
    const bool is_node = is_vrml1() ? token.is_word("DEF") || token.is_word("USE") : is_statement;
    if (is_node) {
      if (!parse_item(node.children)) return false;
      continue;
    }
    const Token name = lexer_.next();
    if (is_vrml1() && lexer_.peek().is('{')) {
      const Node* child = parse_node({}, name);
      if (child == nullptr) return false;
      node.children.push_back(child);
    } else if (!parse_field(node, name)) {
      return false;
    }
  }
  lexer_.next();
  return true;
}

bool Parser::parse_field(Node& node, const Token& name) {
  if (!count_item(name)) return false;
  Field field;
  field.name = name.text;
  field.offset = name.offset;
  field.value_offset = lexer_.peek().offset;
  if (!parse_value(field.value)) return false;
  node.fields.push_back(std::move(field));
  return true;
}

bool Parser::parse_value(Value& value) {
  const Token& token = lexer_.peek();
  if (token.kind == TokenKind::Number) {
    take_numbers(value.emplace<std::vector<double>>());
    return true;
  }
  if (token.kind == TokenKind::String) {
    take_strings(value.emplace<Strings>());
    return true;
  }
  if (token.is('[')) return parse_list(value);
  if (token.is('(')) return parse_bit_mask(value);
  if (token.kind != TokenKind::Word) return fail(token, "a value");
  if (token.is_word("NULL")) {
    lexer_.next();
    return true;
  }
  if (is_vrml1() || token.is_word("TRUE") || token.is_word("FALSE")) {
    value.emplace<Words>().words.push_back(lexer_.next().text);
    return true;
  }
  return parse_node_into(value.emplace<std::vector<const Node*>>());
}

bool Parser::parse_list(Value& value) {
  lexer_.next();
  const Token first = lexer_.peek();
  if (first.kind == TokenKind::Number) {
    take_numbers(value.emplace<std::vector<double>>());
  } else if (first.kind == TokenKind::String) {
    take_strings(value.emplace<Strings>());
  } else if (first.kind == TokenKind::Word) {
    if (!parse_words(value)) return false;
  } else if (first.kind == TokenKind::Invalid) {
    return fail(first, "a list of values");
  }
  return expect(']');
}

/// Parses a list of words (in VRML 1.0, or booleans), or of nodes.
bool Parser::parse_words(Value& value) {
  const Token& first = lexer_.peek();
  if (is_vrml1() || first.is_word("TRUE") || first.is_word("FALSE")) {
    auto& words = value.emplace<Words>().words;
    while (lexer_.peek().kind == TokenKind::Word) words.push_back(lexer_.next().text);
    return true;
  }
  auto& nodes = value.emplace<std::vector<const Node*>>();
  while (lexer_.peek().kind == TokenKind::Word) {
    if (!parse_item(nodes)) return false;
  }
  return true;
}

bool Parser::parse_bit_mask(Value& value) {
  lexer_.next();
  auto& words = value.emplace<Words>().words;
  while (lexer_.peek().kind == TokenKind::Word) {
    words.push_back(lexer_.next().text);
    if (!lexer_.peek().is('|')) break;
    lexer_.next();
  }
  return expect(')');
}

void Parser::take_numbers(std::vector<double>& numbers) {
  while (lexer_.peek().kind == TokenKind::Number) numbers.push_back(lexer_.next().number);
  numbers.shrink_to_fit();
}

void Parser::take_strings(Strings& strings) {
  while (lexer_.peek().kind == TokenKind::String) strings.texts.push_back(lexer_.next().text);
}

/// Parses `ROUTE node.event TO node.event`.
bool Parser::skip_route() {
  lexer_.next();
  ++document_->routes;
  if (!skip_dotted_name()) return false;
  if (!lexer_.peek().is_word("TO")) return fail(lexer_.peek(), "TO");
  lexer_.next();
  return skip_dotted_name();
}

// Parses `node.event`, which is one token unless there is space around the dot.
bool Parser::skip_dotted_name() {
  std::string_view name;
  if (!take_name(name)) return false;
  while (name.ends_with('.') || lexer_.peek().text.starts_with('.')) {
    if (!take_name(name)) return false;
  }
  return true;
}

/// Parses `PROTO name [ interface ] { body }`, or `EXTERNPROTO name [ interface ] URLs`. Definitions inside
/// are not visible outside.
bool Parser::skip_prototype(bool is_external) {
  lexer_.next();
  std::string_view name;
  if (!take_name(name)) return false;
  document_->prototypes.push_back(name);
  if (!skip_brackets('[', nullptr)) return false;
  if (!is_external) return skip_brackets('{', nullptr);
  if (lexer_.peek().is('[')) return skip_brackets('[', nullptr);
  if (lexer_.peek().kind != TokenKind::String) return fail(lexer_.peek(), "the address of the prototype");
  Strings addresses;
  take_strings(addresses);
  return true;
}

/// Skips a bracketed part. Names defined there become the node `inside`, if there is one: they may be used
/// later.
bool Parser::skip_brackets(char opening, const Node* inside) {
  std::vector<char> closing;
  if (!lexer_.peek().is(opening)) return fail(lexer_.peek(), fmt::format("'{}'", opening));
  do {
    const Token token = lexer_.next();
    const bool is_string_without_end = token.kind == TokenKind::Invalid && token.text == "\"";
    if (token.kind == TokenKind::EndOfFile || is_string_without_end) {
      return fail(token, fmt::format("'{}'", closing.back()));
    }
    if (token.is('{') || token.is('[')) {
      closing.push_back(token.is('{') ? '}' : ']');
    } else if (token.is('}') || token.is(']')) {
      if (!token.is(closing.back())) return fail(token, fmt::format("'{}'", closing.back()));
      closing.pop_back();
    } else if (inside != nullptr && token.is_word("DEF")) {
      std::string_view name;
      if (!take_name(name)) return false;
      by_name_[name] = inside;
    }
  } while (!closing.empty());
  return true;
}

}  // namespace

std::unique_ptr<const Document> parse(std::shared_ptr<const Source> source, grf::Diagnostics& diagnostics) {
  return Parser(std::move(source), diagnostics).run();
}

}  // namespace convert::vrml
