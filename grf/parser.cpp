#include "grf/parser.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/text_file.h"

namespace grf {
namespace {

constexpr std::size_t DeepestNesting = 1000;
constexpr std::size_t DeepestInclude = 64;
constexpr std::string_view BlockWords = "a block ('begin mesh', 'light', 'include', 'transform' or 'def')";

bool looks_binary(std::string_view text) { return text.substr(0, 4096).find('\0') != std::string_view::npos; }

/// Says what is wrong with a text as a whole, before a token of it is looked at.
bool is_text(const std::string& text, const SourceLocation& location, Diagnostics& diagnostics) {
  if (text.empty()) {
    diagnostics.error(location, "the file is empty: a GRF scene was expected");
  } else if (looks_binary(text)) {
    diagnostics.error(location, "this is a binary file: a GRF scene, which is text, was expected");
  } else {
    return true;
  }
  return false;
}

std::shared_ptr<const SourceFile> source_file(const std::string& path,
                                              const std::shared_ptr<const std::string>& text,
                                              const SourceLocation& included_at) {
  return std::make_shared<SourceFile>(SourceFile{path, included_at, text});
}

std::optional<Scene> read_shared(const std::shared_ptr<const std::string>& text, const std::string& path,
                                 Diagnostics& diagnostics) {
  const auto file = source_file(path, text, {});
  if (!is_text(*text, {file, 0, 0}, diagnostics)) return std::nullopt;
  const std::size_t errors_before = diagnostics.error_count();
  ParserContext context{diagnostics, {}, {canonical_path(path)}, 0};
  Scene scene{Parser(text, file, context).parse_file()};
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return scene;
}

}  // namespace

std::optional<Scene> read(const std::string& path, Diagnostics& diagnostics) {
  const auto text = read_file(path, diagnostics);
  if (!text) return std::nullopt;
  return read_shared(text, path, diagnostics);
}

std::optional<Scene> read_text(std::string text, const std::string& path, Diagnostics& diagnostics) {
  return read_shared(std::make_shared<std::string>(std::move(text)), path, diagnostics);
}

std::optional<BrdfModel> read_brdf(std::string text, const std::string& name, Diagnostics& diagnostics) {
  const auto shared_text = std::make_shared<const std::string>(std::move(text));
  ParserContext context{diagnostics, {}, {}, 0};
  return Parser(shared_text, source_file(name, shared_text, {}), context).parse_lone_brdf();
}

Parser::Parser(std::shared_ptr<const std::string> text, std::shared_ptr<const SourceFile> file,
               ParserContext& context)
    : lexer_(std::move(text), file), file_(std::move(file)), context_(context) {}

BlockList Parser::parse_file() {
  BlockList contents = parse_blocks(nullptr);
  if (dropped_comments_ > 0) {
    context_.diagnostics.warning(
        {file_, 0, 0},
        fmt::format("{} {} inside lists of vertices or faces: the scene does not keep {}", dropped_comments_,
                    dropped_comments_ == 1 ? "comment" : "comments", dropped_comments_ == 1 ? "it" : "them"));
  }
  return contents;
}

std::optional<BrdfModel> Parser::parse_lone_brdf() {
  BrdfModel brdf;
  if (!parse_model(brdf, nullptr)) return std::nullopt;
  if (lexer_.peek().kind != TokenKind::EndOfFile) {
    fail_expected("the end of the BRDF");
    return std::nullopt;
  }
  return brdf;
}

// Blocks up to the `end` of the scope that the token opened, or, without one, to the end of the file.
BlockList Parser::parse_blocks(const Token* opening) {
  BlockList list;
  while (!context_.diagnostics.is_full()) {
    const Token& token = lexer_.peek();
    if (token.kind == TokenKind::EndOfFile) break;
    if (at("end")) {
      if (opening != nullptr) break;
      // After an error, an `end` too many is most likely its consequence.
      if (!context_.diagnostics.has_errors()) fail(token, "'end' without a block that it could close");
      lexer_.next();
      continue;
    }
    if (!parse_block(list)) recover();
  }
  list.end_comments = take_comments();
  return list;
}

bool Parser::parse_block(BlockList& list) {
  Block block;
  const Token opening = lexer_.peek();
  block.location = lexer_.location(opening);
  block.comments.before = take_comments();
  bool parsed = false;
  if (accept("begin")) {
    Mesh mesh;
    parsed = expect("mesh", "after 'begin'") && parse_mesh(opening, mesh);
    block.content = Shared<Mesh>(std::move(mesh));
  } else if (accept("light")) {
    parsed = parse_light(block.content.emplace<AreaLight>());
  } else if (accept("include")) {
    parsed = parse_include(block.content.emplace<Include>());
  } else if (accept("transform")) {
    parsed = parse_transform(opening, block.content.emplace<Transform>());
  } else if (accept("def")) {
    parsed = parse_definitions(opening, block.content.emplace<DefinitionScope>());
  } else {
    return fail_expected(BlockWords);
  }
  block.comments.behind = take_comment_behind();
  if (parsed) list.blocks.push_back(std::move(block));
  return parsed;
}

bool Parser::starts_block(const Token& token) {
  if (token.kind != TokenKind::Word) return false;
  if (same_keyword(token.text, "include") || same_keyword(token.text, "transform")) return true;
  if (same_keyword(token.text, "def")) return true;
  const bool begin = same_keyword(token.text, "begin");
  if (!begin && !same_keyword(token.text, "light")) return false;
  const Token second = lexer_.peek_second();
  return second.kind == TokenKind::Word && same_keyword(second.text, begin ? "mesh" : "begin");
}

// After an error: on to the next word that can only start a block, so that later errors are found too.
void Parser::recover() {
  lexer_.next();
  while (lexer_.peek().kind != TokenKind::EndOfFile && !starts_block(lexer_.peek())) lexer_.next();
  lexer_.comments().clear();
}

bool Parser::parse_light(AreaLight& light) {
  if (!expect("begin", "after 'light'")) return false;
  const auto parse_radiance = [&] {
    if (lexer_.peek().kind != TokenKind::Word || !is_colour_keyword(lexer_.peek().text)) return true;
    const Token keyword = lexer_.next();
    if (light.radiance) return fail(keyword, "a light has one 'rgb', before or after its region");
    return parse_vector(light.radiance.emplace());
  };
  if (!parse_radiance() || !parse_vector(light.corner) || !parse_vector(light.edge1) ||
      !parse_vector(light.edge2) || !parse_radiance()) {
    return false;
  }
  return expect("end", "after the corner and the two edges of a light");
}

bool Parser::parse_include(Include& include) {
  const SourceLocation location = lexer_.location(lexer_.peek());
  return parse_string(include.file, "the name of a file, in quotes") &&
         parse_included_file(location, include);
}

bool Parser::parse_included_file(const SourceLocation& location, Include& include) {
  const std::string path = path_beside(file_->path, include.file);
  const std::string exact_path = canonical_path(path);
  std::vector<std::string>& open_files = context_.open_files;
  Diagnostics& diagnostics = context_.diagnostics;
  if (std::find(open_files.begin(), open_files.end(), exact_path) != open_files.end()) {
    diagnostics.error(location, fmt::format("'{}' includes itself: {} -> {}", include.file,
                                            fmt::join(open_files, " -> "), exact_path));
    return true;  // the statement itself was read, so reading goes on behind it
  }
  if (open_files.size() > DeepestInclude) {
    diagnostics.error(location, fmt::format("includes are nested deeper than {}", DeepestInclude));
    return true;
  }
  const auto text = read_file(path, diagnostics, location);
  if (!text) return true;
  const auto file = source_file(path, text, location);
  if (!is_text(*text, {file, 0, 0}, diagnostics)) return true;
  open_files.push_back(exact_path);
  include.contents = Parser(text, file, context_).parse_file();
  open_files.pop_back();
  include.origin = {exact_path, include.contents};
  return true;
}

bool Parser::parse_transform(const Token& opening, Transform& transform) {
  while (!at("begin")) {
    TransformStep step;
    const Token keyword = lexer_.peek();
    if (accept("scale")) {
      step.kind = TransformStep::Kind::Scale;
    } else if (accept("rotation")) {
      step.kind = TransformStep::Kind::Rotation;
    } else if (accept("translation")) {
      step.kind = TransformStep::Kind::Translation;
    } else {
      return fail_expected(transform.steps.empty() ? "'scale', 'rotation' or 'translation'"
                                                   : "'scale', 'rotation', 'translation' or 'begin'");
    }
    if (!parse_vector(step.value)) return false;
    const Vec3f& value = step.value;
    if (step.kind == TransformStep::Kind::Scale && (value.x == 0 || value.y == 0 || value.z == 0)) {
      return fail(keyword, "a scale by zero flattens what it acts on: factors other than 0 were expected");
    }
    transform.steps.push_back(step);
  }
  if (transform.steps.empty()) return fail_expected("'scale', 'rotation' or 'translation'");
  return parse_body(opening, transform.body);
}

bool Parser::parse_body(const Token& opening, BlockList& body) {
  if (!expect("begin", "before the blocks inside")) return false;
  if (context_.nesting >= DeepestNesting) {
    return fail(opening, fmt::format("blocks are nested deeper than {}", DeepestNesting));
  }
  ++context_.nesting;
  body = parse_blocks(&opening);
  --context_.nesting;
  if (lexer_.peek().kind == TokenKind::EndOfFile) return fail_unclosed(opening, "end");
  return accept("end");
}

}  // namespace grf
