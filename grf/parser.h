// The recursive-descent parser behind `read.h`. One function a production; each returns false, or nothing,
// after it has reported an error.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/lexer.h"
#include "grf/scene.h"
#include "grf/visit.h"

namespace grf {

/// What a file and the files that it includes have in common.
struct ParserContext {
  Diagnostics& diagnostics;
  Scope scope;
  std::vector<std::string> open_files;  ///< canonical paths, the outermost first
  std::size_t nesting = 0;              ///< open blocks, those of including files among them
};

class Parser {
 public:
  Parser(std::shared_ptr<const std::string> text, std::shared_ptr<const SourceFile> file,
         ParserContext& context);

  BlockList parse_file();
  std::optional<BrdfModel> parse_lone_brdf();

 private:
  // parser.cpp: blocks
  BlockList parse_blocks(const Token* opening);
  bool parse_block(BlockList& list);
  bool parse_light(AreaLight& light);
  bool parse_include(Include& include);
  bool parse_included_file(const SourceLocation& location, Include& include);
  bool parse_transform(const Token& opening, Transform& transform);
  bool parse_body(const Token& opening, BlockList& body);
  void recover();
  bool starts_block(const Token& token);

  // parser_definitions.cpp
  bool parse_definitions(const Token& opening, DefinitionScope& scope);
  /// The name of a definition that stands behind the parameters of the one before it, without a `def`.
  struct NextDefinition {
    Token name;
    std::uint32_t line_before = 0;  ///< where the definition before it ends
  };
  bool parse_definition(const Token& name, DefinitionScope& scope, std::optional<NextDefinition>& next);
  bool parse_definition_body(Definition& definition, std::optional<NextDefinition>& next);
  bool check_new_name(const Token& name, const DefinitionScope& scope);
  bool parse_model(Model& model, std::optional<NextDefinition>* next);
  bool parse_value(const Token& name, Value& value);

  // parser_mesh.cpp
  bool parse_mesh(const Token& opening, Mesh& mesh);
  bool parse_vertices(Mesh& mesh);
  bool parse_vertex(Mesh& mesh);
  bool parse_faces(const Token& mesh_opening, Mesh& mesh, bool& mesh_closed);
  bool parse_face(const Mesh& mesh, std::vector<std::uint32_t>& corners);
  bool parse_corner(const Mesh& mesh, std::vector<std::uint32_t>& corners);
  bool end_faces(const Token& opening, bool& mesh_closed);
  bool end_mesh(const Token& opening);
  bool is_attribute(const Token& token) const;
  bool parse_attribute(Surface& surface, bool reset_allowed);
  bool parse_colour_attribute(Surface& surface);
  template <class ModelOfKind>
  bool parse_model_attribute(std::optional<std::variant<ModelOfKind, Reference>>& attribute);
  Comments* comments_of_attribute(Mesh& mesh, const Token& keyword) const;

  // parser_words.cpp: tokens and values
  bool accept(std::string_view keyword);
  bool accept(char punctuation);
  bool expect(std::string_view keyword, std::string_view where);
  bool expect(char punctuation, std::string_view where);
  bool at(std::string_view keyword) const;
  bool parse_number(float& number);
  bool parse_vector(Vec3f& vector);
  bool parse_string(std::string& string, std::string_view what);
  bool parse_index(std::uint32_t& index, std::string_view what);
  bool fail(const Token& token, std::string message);
  bool fail_expected(std::string_view expected);
  bool fail_unclosed(const Token& opening, std::string_view end);
  std::vector<std::string> take_comments();
  std::string take_comment_behind() { return take_comment_behind(lexer_.line_of_last()); }
  std::string take_comment_behind(std::uint32_t line);
  void drop_comments();

  Lexer lexer_;
  std::shared_ptr<const SourceFile> file_;
  ParserContext& context_;
  std::size_t dropped_comments_ = 0;
};

/// The three spellings of the keyword.
bool is_colour_keyword(std::string_view word);

}  // namespace grf
