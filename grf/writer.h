// The writer behind `write.h` has one function per production.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grf/scene.h"
#include "grf/visit.h"

namespace grf {

/// The text of one file of a scene.
struct FileText {
  std::string text;
  std::string_view problem = {};  ///< why the text cannot be read again; empty if it can
};

/// Returns the text of a file with these blocks that is read in the scope of those definitions.
FileText text_of_file(const BlockList& contents, const Scope& scope);

// writer_words.cpp: words and values.

// Numbers are written with the fewest digits that read back to the same float, independent of the locale.
void append(std::string& text, const Vec2f& v);
void append(std::string& text, const Vec3f& v);
void append(std::string& text, std::span<const std::uint32_t> corners);

/// Why a scene cannot be written, for messages.
inline constexpr std::string_view NotFinite = "it would have numbers that are infinite or not a number (nan)";
/// Why a word cannot be written as a value, for messages.
inline constexpr std::string_view NoValueWord =
    "it would have words as values of parameters that are not names, or that begin a definition (such as "
    "rgb)";
/// Why an image cannot be written, for messages.
inline constexpr std::string_view MapWithoutFactor =
    "it would have images of parameters whose factor is neither a number nor a colour";

bool is_finite(const Vec2f& v);  ///< Returns whether no component is infinite or NaN.
bool is_finite(const Vec3f& v);

/// Returns why the text of an instance cannot be read again; empty if it can.
std::string_view problem_of(const Model& model);
std::string_view problem_of(const BrdfModel& brdf);

// Text that the format cannot express is replaced, so that the rest of the file stays readable.
std::string comment_text(const std::string& comment);
std::string quoted(const std::string& string);

/// Respells a word by changing the case of its letters: the bits of each number give another spelling.
std::string respelled(std::string word, std::uint64_t number);

/// Writes blocks as GRF text in the standard style.
class Writer {
 public:
  /// Starts a text that will be read in a scope.
  explicit Writer(const Scope& scope) : scope_(scope) {}

  void blocks(const BlockList& list);  ///< Appends the text of blocks.
  /// Appends the attributes of a surface.
  void attributes(const Surface& surface) { put_attributes(surface, {}); }

  /// Takes the text; it is never empty, since readers reject an empty file.
  FileText take_text() { return {text_.empty() ? "\n" : std::move(text_), problem_}; }

 private:
  void put_block(const Shared<Mesh>& mesh) {
    begin_line("");
    put_mesh(*mesh);
  }
  void put_block(const MeshLight& light);
  void put_block(const AreaLight& light);
  void put_block(const Include& include) { begin_line("include " + quoted(include.file)); }
  void put_block(const Transform& transform);
  void put_block(const DefinitionScope& definitions);
  void put_block(const Params& params);
  void put_block(const Use& use) { begin_line("use " + use.mesh.name); }

  void put_definition(const Definition& definition, bool first);
  void put_definition_body(const Definition::Body& body);
  void put_body(const BlockList& body);
  void put_mesh(const Mesh& mesh);
  void put_lists(const Mesh& mesh);
  void put_vertices(const Mesh& mesh);
  void put_irradiance(const Irradiance& irradiance);
  void put_faces(const Mesh& mesh);
  void put_attributes(const Surface& surface, const MeshComments& comments);
  void put_changes(const Surface& before, const Surface& after);
  void put_attribute(const ColourAttribute& colour);
  void put_attribute(const BrdfAttribute& brdf);
  void put_attribute(const PdfAttribute& pdf);
  void put_attribute(const TextureAttribute& texture);
  void put_attribute(const Colour& emission);
  void put_attribute(const Opacity& opacity);
  template <class Attribute>
  void put_model(const char* keyword, const Attribute& attribute);
  template <class Attribute>
  void put_own(const std::optional<Attribute>& attribute, const Comments& comments);
  template <class Attribute>
  void put_change(const char* keyword, const std::optional<Attribute>& before,
                  const std::optional<Attribute>& after);
  template <class ModelOfKind>
  std::string unambiguous(const ModelOfKind& model);

  void add_problem(std::string_view problem) {
    if (problem_.empty()) problem_ = problem;
  }
  template <class Vector>
  void put(const Vector& v) {
    if (!is_finite(v)) add_problem(NotFinite);
    append(text_, v);
  }
  std::string text_or_file(const BrdfModel& brdf);
  std::string text_or_file(const PdfModel& pdf);

  void put_comments(const std::vector<std::string>& comments);
  void comments_before(const Comments& comments) { put_comments(comments.before); }
  void begin_line(std::string_view words) {
    // The indentation is limited: else a small, deeply nested file would be written a thousand times as
    // large.
    constexpr std::size_t Deepest = 32;
    text_.append(2 * std::min(indentation_, Deepest), ' ');
    text_ += words;
  }
  void end_line() { text_ += '\n'; }
  void end_line(const Comments& comments);
  void line(std::string_view words) {
    begin_line(words);
    end_line();
  }

  std::string text_;
  std::size_t indentation_ = 0;
  ScopeStack scope_;
  std::string_view problem_;
};

}  // namespace grf
