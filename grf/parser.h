// The recursive-descent parser behind `read.h` has one function per production. Each returns false, or
// nothing, after an error that leaves the end of the production unclear. After other errors parsing
// continues, so that one run finds as many as possible.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/lexer.h"
#include "grf/scene.h"
#include "grf/visit.h"

namespace grf {

/// A file that is being parsed, to find files that include themselves.
struct OpenFile {
  std::string exact_path;  ///< canonical
  std::string path;        ///< as it was named
};

/// A file and the folder that its relative names start at: links can give one file several. Both are
/// canonical.
using FileInFolder = std::pair<std::string, std::string>;

/// The parser state shared by a file and the files that it includes.
struct ParserContext {
  explicit ParserContext(Diagnostics& where) : diagnostics(where), errors_before(where.error_count()) {}

  /// Returns whether parsing added errors.
  bool has_errors() const { return diagnostics.error_count() > errors_before; }
  /// Returns true when parsing should stop: the parser gave up, or the number of errors reached its limit.
  bool is_over() const {
    return gave_up || diagnostics.error_count() - errors_before >= Diagnostics::MaximumErrors;
  }

  Diagnostics& diagnostics;
  std::size_t errors_before = 0;
  bool gave_up = false;

  ScopeStack scope;
  bool lacks_names = false;              ///< a definition could not be read, so its name is not in the scope
  std::set<std::string> reported_names;  ///< undefined names, each reported once however often it is used
  /// Parameters in lists of definitions whose value is a word: `b = phong` may lack the keyword `brdf`.
  std::map<std::string, std::string> word_parameters;
  std::size_t nesting = 0;               ///< open blocks, including those of including files
  std::vector<OpenFile> open_files;      ///< the outermost first
  std::size_t include_count = 0;         ///< a file counts as often as it is included
  std::size_t bytes_read_again = 0;      ///< of files that were read before
  std::set<std::string> included_paths;  ///< canonical
  /// Numbers of scopes: scopes in which the same names are definitions of the same kinds share a number,
  /// since text parses alike in them. 0 is outside of all `def`; others follow from the outer number and the
  /// names.
  std::map<std::pair<std::size_t, std::string>, std::size_t> scope_numbers;
  std::size_t scope_number = 0;
  struct Contents {
    IncludeOrigin file;
    std::size_t nesting = 0;  ///< see nesting_of
  };
  /// Cached contents of files that include no others, by file and number of the scope.
  std::map<std::pair<FileInFolder, std::size_t>, Contents> contents_of_files;
  std::map<FileInFolder, BrdfModel> brdf_files;  ///< cached contents of BRDF files
};

/// A recursive-descent parser of one file.
class Parser {
 public:
  Parser(std::shared_ptr<const std::string> text, std::shared_ptr<const SourceFile> file,
         ParserContext& context);

  BlockList parse_file();  ///< Parses the whole file; what has errors is left out.
  /// Parses a whole text as one BRDF or one sampling scheme.
  std::optional<BrdfModel> parse_lone_brdf();
  std::optional<PdfModel> parse_lone_pdf();

 private:
  // parser.cpp: blocks
  BlockList parse_blocks(const Token* opening);
  bool parse_block(BlockList& list);
  bool parse_content(const Token& opening, Block& block);
  bool parse_light(AreaLight& light);
  bool parse_params(const Token& opening, Params& params);
  bool parse_use(Use& use);
  bool parse_transform(const Token& opening, Transform& transform);
  bool parse_steps(std::vector<TransformStep>& steps);
  bool parse_body(const Token& opening, BlockList& body);
  bool fail_too_deep(const SourceLocation& location);
  void report_end_too_many();
  void recover(std::size_t open_before, bool is_mesh);
  bool skip_to_body();
  bool at_block();

  // parser_includes.cpp
  bool parse_include(Include& include);
  bool may_include(const OpenFile& included, const SourceLocation& location);
  std::optional<IncludeOrigin> contents_of(const OpenFile& included, const SourceLocation& location);
  bool is_read_too_often(const OpenFile& included, std::size_t bytes);

  // parser_definitions.cpp
  bool parse_definitions(const Token& opening, DefinitionScope& scope);
  /// The name of a definition that follows the parameters of the previous one without a `def`.
  struct NextDefinition {
    Token name;
    std::uint32_t line_before = 0;  ///< the last line of the previous definition
  };
  /// The line of each name in a list of definitions.
  using Names = std::unordered_map<std::string_view, std::uint32_t>;
  bool parse_name(std::optional<NextDefinition>& next);
  void check_name(const Token& name, Names& names);
  using Definitions = std::deque<Definition>;  ///< with stable addresses when one more is read
  bool parse_definition_list(Definitions& definitions);
  bool parse_definition(const Token& name, Definitions& definitions, std::optional<NextDefinition>& next);
  bool parse_definition_body(Definition& definition, std::optional<NextDefinition>& next);
  std::size_t number_of_scope(const Definitions& definitions);
  bool skip_to_definition(std::size_t open_before);

  // parser_models.cpp
  template <class ModelOfKind>
  std::optional<ModelOfKind> if_alone(const ModelOfKind& model, std::string_view kind);
  bool parse_model(BrdfModel& brdf, std::optional<NextDefinition>* next);
  bool parse_model(PdfModel& pdf, std::optional<NextDefinition>* next);
  bool parse_keyword(Model& model);
  bool parse_arguments(Model& model, std::optional<NextDefinition>* next);
  bool at_definition_body(bool may_be_name);
  bool at_map();
  bool parse_map(Argument& argument);
  bool parse_value(std::string_view name, Value& value);
  bool parse_terms(std::vector<CombineTerm>& terms);
  bool parse_layered(BrdfModel& brdf, std::optional<NextDefinition>* next);
  bool parse_brdf_file(BrdfModel& brdf);

  // parser_mesh.cpp
  /// The kind of mesh: a mesh light has other attributes and another `end`.
  enum class MeshKind { Mesh, Light };
  bool parse_mesh(const Token& opening, MeshKind kind, MeshDraft& mesh);
  bool parse_vertices(MeshDraft& mesh);
  bool parse_vertex(MeshDraft& mesh);
  bool parse_irradiance_list(std::vector<DirectionalIrradiance>& list);
  bool parse_faces(const Token& mesh_opening, MeshKind kind, MeshDraft& mesh, bool& mesh_closed);
  bool parse_face(const MeshDraft& mesh, std::vector<std::uint32_t>& corners);
  bool parse_corner_list(const MeshDraft& mesh, std::vector<std::uint32_t>& corners);
  bool parse_corners(const MeshDraft& mesh, std::uint32_t count, std::vector<std::uint32_t>& corners);
  bool parse_corner(const MeshDraft& mesh, std::vector<std::uint32_t>& corners);
  bool end_faces(const Token& opening, MeshKind kind, bool& mesh_closed);
  bool end_mesh(const Token& opening, MeshKind kind);

  // parser_attributes.cpp
  bool is_attribute(const Token& token) const;
  bool parse_attribute(Surface& surface, MeshKind kind, bool reset_allowed);
  bool parse_emission(std::optional<Colour>& emission);
  bool parse_opacity(std::optional<Opacity>& opacity);
  bool parse_colour_attribute(std::optional<ColourAttribute>& attribute);
  bool parse_texture_attribute(std::optional<TextureAttribute>& attribute);
  template <class Body>
  void parse_reference(Reference& reference);
  template <class ModelOfKind>
  bool parse_model_attribute(std::optional<std::variant<ModelOfKind, Reference>>& attribute);
  Comments* comments_of_attribute(MeshDraft& mesh, const Token& keyword) const;

  // parser_words.cpp: tokens and values
  Token take();
  bool accept(std::string_view keyword);
  bool accept(char punctuation);
  bool expect(std::string_view keyword, std::string_view where);
  bool expect(char punctuation, std::string_view where);
  bool at(std::string_view keyword) const;
  bool at(std::string_view first, std::string_view second);
  bool at_identifier() const;
  bool at_colour() const;
  bool accept_colour();
  bool parse_number(float& number);
  bool parse_vector(Vec3f& vector);
  bool parse_vector(Vec2f& vector);
  bool parse_string(std::string& string, std::string_view what);
  bool parse_index(std::uint32_t& index, std::string_view what);
  void error(const Token& token, std::string_view message);
  bool fail(const Token& token, std::string_view message);
  bool fail_expected(std::string_view expected);
  bool fail_unclosed(const Token& opening, std::string_view end);
  std::vector<std::string> take_comments();
  void take_comments_of(Comments& comments) { take_comments_of(comments, lexer_.line_of_last()); }
  void take_comments_of(Comments& comments, std::uint32_t last_line);
  void drop_comments();

  Lexer lexer_;
  std::shared_ptr<const SourceFile> file_;
  ParserContext& context_;
  std::size_t open_ = 0;  ///< number of `begin` without an `end` so far
  std::size_t dropped_comments_ = 0;
  bool index_reported_ = false;  ///< an index out of range was reported in the current list of faces
};

/// Describes a file for locations, with its text for excerpts.
std::shared_ptr<const SourceFile> source_file(const std::string& path,
                                              const std::shared_ptr<const std::string>& text,
                                              const SourceLocation& included_at);

/// Returns the canonical path of a file and of its folder.
FileInFolder file_in_folder(const std::string& path);

/// Reports an empty or binary file, before its first token is read; returns false then.
bool is_text(const std::string& text, std::string_view expected, const SourceLocation& location,
             Diagnostics& diagnostics);

/// Returns whether a token can begin the body of a definition, after its `=`.
bool starts_definition_body(const Token& token);

}  // namespace grf
