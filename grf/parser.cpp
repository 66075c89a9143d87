#include "grf/parser.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/text_file.h"

namespace grf {
namespace {

constexpr std::string_view BlockWords =
    "a block: 'begin mesh', 'mesh light', 'light', 'include', 'transform', 'def', 'params' or 'use'";

/// Returns whether the word after an `end` shows that it closes a mesh or a list, not a block of blocks.
bool is_word_of_end(const Token& token) {
  return token.kind == TokenKind::Word &&
         (same_keyword(token.text, "mesh") || same_keyword(token.text, "faces") ||
          same_keyword(token.text, "vertexs") || same_keyword(token.text, "vertices") ||
          same_keyword(token.text, "list"));
}

std::optional<Scene> read_shared(const std::shared_ptr<const std::string>& text, const std::string& path,
                                 Diagnostics& diagnostics) {
  const auto file = source_file(path, text, {});
  if (!is_text(*text, "a GRF scene", {file, 0, 0}, diagnostics)) return std::nullopt;
  ParserContext context(diagnostics);
  context.open_files.push_back({canonical_path(path), path});
  Scene scene{Parser(text, file, context).parse_file()};
  if (context.has_errors()) return std::nullopt;
  return scene;
}

}  // namespace

bool is_text(const std::string& text, std::string_view expected, const SourceLocation& location,
             Diagnostics& diagnostics) {
  if (text.empty()) {
    diagnostics.error(location, fmt::format("the file is empty, expected {}", expected));
  } else if (text.find('\0') != std::string::npos) {
    diagnostics.error(location, fmt::format("this is a binary file, expected {}, which is text", expected));
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
  ParserContext context(diagnostics);
  return Parser(shared_text, source_file(name, shared_text, {}), context).parse_lone_brdf();
}

std::optional<PdfModel> read_pdf(std::string text, const std::string& name, Diagnostics& diagnostics) {
  const auto shared_text = std::make_shared<const std::string>(std::move(text));
  ParserContext context(diagnostics);
  return Parser(shared_text, source_file(name, shared_text, {}), context).parse_lone_pdf();
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

// Parses blocks up to the `end` of the scope that the token opened, or, without one, to the end of the file.
BlockList Parser::parse_blocks(const Token* opening) {
  BlockList list;
  while (!context_.is_over() && lexer_.peek().kind != TokenKind::EndOfFile) {
    const std::size_t open_before = open_;
    const bool is_mesh = at("begin", "mesh");
    if (!at("end")) {
      if (!parse_block(list)) recover(open_before, is_mesh);
    } else if (opening == nullptr) {
      report_end_too_many();
    } else {
      break;
    }
  }
  list.end_comments = take_comments();
  return list;
}

bool Parser::parse_block(BlockList& list) {
  Block block;
  const Token opening = lexer_.peek();
  block.location = lexer_.location(opening);
  block.comments.before = take_comments();
  const bool parsed = parse_content(opening, block);
  if (!parsed) return false;
  take_comments_of(block.comments);
  list.blocks.push_back(std::move(block));
  return true;
}

bool Parser::parse_content(const Token& opening, Block& block) {
  const auto parse_mesh_of = [&](MeshKind kind, Shared<Mesh>& shared) {
    MeshDraft mesh;
    if (!parse_mesh(opening, kind, mesh)) return false;
    shared = Mesh(std::move(mesh));
    return true;
  };
  // After an error in a list of definitions this is most likely its body.
  if (context_.lacks_names && at("begin") && !at("begin", "mesh")) {
    return parse_body(opening, block.content.emplace<DefinitionScope>().body);
  }
  if (accept("begin")) {
    return expect("mesh", "after this 'begin'") &&
           parse_mesh_of(MeshKind::Mesh, block.content.emplace<Shared<Mesh>>());
  }
  if (accept("mesh")) {
    return expect("light", "after 'mesh' (a mesh starts with 'begin mesh')") &&
           expect("begin", "after 'mesh light'") &&
           parse_mesh_of(MeshKind::Light, block.content.emplace<MeshLight>().mesh);
  }
  if (accept("light")) return parse_light(block.content.emplace<AreaLight>());
  if (accept("include")) return parse_include(block.content.emplace<Include>());
  if (accept("transform")) return parse_transform(opening, block.content.emplace<Transform>());
  if (accept("def")) return parse_definitions(opening, block.content.emplace<DefinitionScope>());
  if (accept("params")) return parse_params(opening, block.content.emplace<Params>());
  if (accept("use")) return parse_use(block.content.emplace<Use>());
  if (opening.kind == TokenKind::Word && lexer_.peek_second().is('=')) {
    context_.lacks_names = true;
    return fail_expected("'def' before the name of a definition");
  }
  return fail_expected(BlockWords);
}

// Returns whether the next tokens can only begin a block.
bool Parser::at_block() {
  return at("include") || at("transform") || at("def") || at("use") || at("begin", "mesh") ||
         at("mesh", "light") || at("light", "begin") || at("params", "begin");
}

void Parser::report_end_too_many() {
  // After an error, a superfluous `end` is most likely its consequence.
  if (!context_.has_errors()) error(lexer_.peek(), "'end' without a block that it could close");
  lexer_.next();
  if (is_word_of_end(lexer_.peek())) lexer_.next();
}

// Error recovery after a block: skips past its end, or to what can only be the next block or the end of the
// enclosing block, so that later errors are found too.
void Parser::recover(std::size_t open_before, bool is_mesh) {
  // Only meshes have lists of vertices and faces, so what looks like one belongs to the block that failed.
  const auto at_list = [this] { return (at("begin") || at("end")) && is_word_of_end(lexer_.peek_second()); };
  while (lexer_.peek().kind != TokenKind::EndOfFile && !at_block()) {
    const bool ends_something = at("end");
    if (ends_something && open_ == open_before && !at_list()) break;
    take();
    if (!ends_something) continue;
    if (is_word_of_end(lexer_.peek()) && (is_mesh || !at("mesh", "light"))) lexer_.next();
    if (open_ == open_before && !at_list()) break;
  }
  open_ = open_before;
  lexer_.comments().clear();
}

// Error recovery before a body: skips to its `begin`, so that the blocks inside are parsed too.
bool Parser::skip_to_body() {
  while (lexer_.peek().kind != TokenKind::EndOfFile && !at("end") && !at_block()) {
    if (at("begin")) return true;
    lexer_.next();
  }
  return false;
}

bool Parser::parse_light(AreaLight& light) {
  if (!expect("begin", "after 'light'")) return false;
  const auto parse_radiance = [&] {
    if (!at_colour()) return true;
    const Token keyword = lexer_.next();
    if (light.radiance) error(keyword, "a light has one 'rgb', before or after its corner and edges");
    return parse_vector(light.radiance.emplace(0.0F));
  };
  if (!parse_radiance() || !parse_vector(light.corner) || !parse_vector(light.edge1) ||
      !parse_vector(light.edge2) || !parse_radiance()) {
    return false;
  }
  return expect("end", "after the corner and the two edges of a light");
}

bool Parser::parse_params(const Token& opening, Params& params) {
  if (!expect("begin", "after 'params'")) return false;
  while (accept("dependent")) {
    if (!expect("view", "after 'dependent'") || !parse_vector(params.views.emplace_back(0.0F))) return false;
  }
  if (lexer_.peek().kind == TokenKind::EndOfFile) return fail_unclosed(opening, "end");
  return expect("end", "or 'dependent view' and a position");
}

bool Parser::parse_use(Use& use) {
  const bool is_mesh = context_.scope.scope().find<Shared<Mesh>>(lexer_.peek().text) != nullptr;
  if (!at_identifier() || (!is_mesh && at_block())) return fail_expected("the name of a mesh");
  parse_reference<Shared<Mesh>>(use.mesh);
  return true;
}

bool Parser::parse_transform(const Token& opening, Transform& transform) {
  const bool steps_parsed = parse_steps(transform.steps);
  if (!steps_parsed && !skip_to_body()) return false;
  return parse_body(opening, transform.body);
}

bool Parser::parse_steps(std::vector<TransformStep>& steps) {
  do {
    TransformStep step;
    const Token keyword = lexer_.peek();
    if (accept("scale")) {
      step.kind = TransformStep::Kind::Scale;
    } else if (accept("rotation")) {
      step.kind = TransformStep::Kind::Rotation;
    } else if (accept("translation")) {
      step.kind = TransformStep::Kind::Translation;
    } else {
      return fail_expected(steps.empty() ? "'scale', 'rotation' or 'translation'"
                                         : "'scale', 'rotation', 'translation' or 'begin'");
    }
    if (!parse_vector(step.value)) return false;
    const Vec3f& value = step.value;
    if (step.kind == TransformStep::Kind::Scale && (value.x == 0 || value.y == 0 || value.z == 0)) {
      error(keyword, "a scale by zero flattens what it acts on, expected factors other than 0");
    }
    steps.push_back(step);
  } while (!at("begin"));
  return true;
}

bool Parser::fail_too_deep(const SourceLocation& location) {
  context_.gave_up = true;
  context_.diagnostics.error(location, fmt::format("blocks are nested deeper than {}", DeepestNesting));
  return false;
}

bool Parser::parse_body(const Token& opening, BlockList& body) {
  if (!expect("begin", "and the blocks inside")) return false;
  if (at("mesh") && !at("mesh", "light")) {
    error(lexer_.peek(), fmt::format("the 'begin' before this 'mesh' opens the block of '{}': write 'begin' "
                                     "once more, for the mesh",
                                     opening.text));
    return false;
  }
  if (context_.nesting >= DeepestNesting) return fail_too_deep(lexer_.location(opening));
  ++context_.nesting;
  body = parse_blocks(&opening);
  --context_.nesting;
  if (lexer_.peek().kind == TokenKind::EndOfFile) return fail_unclosed(opening, "end");
  return accept("end");
}

}  // namespace grf
