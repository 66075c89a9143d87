#include "renderer/studies/tool_state.h"

#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/text_file.h"
#include "grf/write.h"
#include "renderer/studies/fit_samples.h"

namespace studies {
namespace {

constexpr std::string_view Blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(Blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(Blanks) - begin + 1);
}

/// A line of a state: its first word and the rest.
struct Statement {
  std::string_view keyword;
  std::string_view rest;
  std::uint32_t line = 0;
  std::size_t keyword_column = 0;  ///< bytes before the keyword
  std::size_t rest_column = 0;     ///< bytes before the rest
};

class Reader {
 public:
  Reader(const std::string& text, const std::string& path, grf::Diagnostics& diagnostics)
      : text_(std::make_shared<const std::string>(text)),
        file_(std::make_shared<grf::SourceFile>(grf::SourceFile{path, {}, text_})),
        path_(path),
        diagnostics_(diagnostics) {}

  std::optional<ToolState> read() {
    std::string_view rest = *text_;
    if (rest.starts_with(grf::ByteOrderMark)) rest.remove_prefix(grf::ByteOrderMark.size());
    bool is_valid = true;
    for (std::uint32_t line = 1; !rest.empty(); ++line) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      is_valid = read_line(rest.substr(0, end), line) && is_valid;
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (is_valid && !has_tool_) return fail(1, 0, "found no 'tool', which names the tool");
    return is_valid ? std::optional(std::move(state_)) : std::nullopt;
  }

 private:
  std::nullopt_t fail(std::uint32_t line, std::size_t column, const std::string& message) {
    diagnostics_.error({file_, line, static_cast<std::uint32_t>(column + 1)}, message);
    return std::nullopt;
  }

  bool read_line(std::string_view line, std::uint32_t number) {
    // No file's name has one, and functions of the system take it for the name's end.
    const std::size_t nul = line.find('\0');
    if (nul != std::string_view::npos) {
      fail(number, nul, "found a NUL character: the file is no text");
      return false;
    }
    const std::string_view words = trimmed(line);
    if (words.empty() || words.starts_with("//")) return true;
    const std::size_t length = std::min(words.find_first_of(Blanks), words.size());
    Statement statement;
    statement.keyword = words.substr(0, length);
    statement.rest = trimmed(words.substr(length));
    statement.line = number;
    statement.keyword_column = static_cast<std::size_t>(words.data() - line.data());
    statement.rest_column =
        statement.rest.empty() ? line.size() : static_cast<std::size_t>(statement.rest.data() - line.data());
    return take(statement);
  }

  bool take(const Statement& statement) {
    const bool is_tool = grf::same_keyword(statement.keyword, "tool");
    if (!has_tool_ && !is_tool) {
      fail(statement.line, statement.keyword_column,
           fmt::format("found '{}', expected 'tool' and the name of the tool first", statement.keyword));
      return false;
    }
    if (is_tool) return take_tool(statement);
    if (grf::same_keyword(statement.keyword, "distribution")) return take_distribution(statement);
    if (grf::same_keyword(statement.keyword, "def")) return take_definition(statement);
    if (grf::same_keyword(statement.keyword, "brdf")) return take_brdf(statement);
    if (grf::same_keyword(statement.keyword, "pdf"))
      return add(grf::read_pdf(padded(statement), path_, diagnostics_), state_.pdfs);
    if (grf::same_keyword(statement.keyword, "file")) return take_file(statement);
    fail(statement.line, statement.keyword_column,
         fmt::format("found '{}', expected 'brdf', 'pdf', 'def', 'distribution' or 'file'",
                     statement.keyword));
    return false;
  }

  bool take_tool(const Statement& statement) {
    if (has_tool_) {
      fail(statement.line, statement.keyword_column, "found a second 'tool'");
      return false;
    }
    has_tool_ = true;
    const auto settings = grf::read_pdf(padded(statement), path_, diagnostics_);
    if (settings) state_.settings = *settings;
    return settings.has_value();
  }

  bool take_distribution(const Statement& statement) {
    const auto distribution = grf::read_pdf(padded(statement), path_, diagnostics_);
    if (distribution) state_.distribution = *distribution;
    return distribution.has_value();
  }

  bool take_definition(const Statement& statement) {
    const std::string words = "def " + std::string(statement.rest);
    auto definition = read_definition({}, statement.keyword_column, words, statement);
    if (definition) state_.definitions.push_back(std::move(*definition));
    return definition.has_value();
  }

  bool take_brdf(const Statement& statement) {
    constexpr std::string_view Sum = "combine";
    if (!grf::same_keyword(statement.rest.substr(0, Sum.size()), Sum))
      return add(grf::read_brdf(padded(statement), path_, diagnostics_), state_.brdfs);
    const std::string words(statement.rest);
    const auto definition = read_definition("def sum = brdf", statement.rest_column, words, statement);
    if (definition) state_.brdfs.push_back(std::get<grf::BrdfModel>(definition->body));
    return definition.has_value();
  }

  /// Reads the definition of a BRDF as a scene that consists of it, after definitions of the names that the
  /// terms of a sum may have. These and `before` are in the line before, so that columns are those of the
  /// file.
  std::optional<grf::Definition> read_definition(std::string_view before, std::size_t column,
                                                 const std::string& words, const Statement& statement) {
    std::string text(statement.line - 2, '\n');
    for (const grf::Definition& definition : state_.definitions)
      text += fmt::format("def {} = brdf diffuse ", definition.name);
    text.append(before).append("\n").append(column, ' ').append(words).append(" begin end");
    const auto scene = grf::read_text(std::move(text), path_, diagnostics_);
    if (!scene) return std::nullopt;
    const auto* scope = scene->contents.blocks.size() == 1
                            ? std::get_if<grf::DefinitionScope>(&scene->contents.blocks.front().content)
                            : nullptr;
    const bool is_brdf = scope != nullptr && scope->definitions.size() == state_.definitions.size() + 1 &&
                         scope->body.blocks.empty() &&
                         std::holds_alternative<grf::BrdfModel>(scope->definitions.back().body);
    if (is_brdf) return scope->definitions.back();
    return fail(statement.line, statement.keyword_column,
                "expected one BRDF, and only BRDFs are defined in a state");
  }

  bool take_file(const Statement& statement) {
    if (statement.rest.empty()) {
      fail(statement.line, statement.rest_column, "found the end of the line, expected the name of a file");
      return false;
    }
    state_.files.push_back({grf::path_beside(path_, statement.rest),
                            {file_, statement.line, static_cast<std::uint32_t>(statement.rest_column + 1)}});
    return true;
  }

  template <class Model>
  static bool add(std::optional<Model> model, std::vector<Model>& models) {
    if (model) models.push_back(std::move(*model));
    return model.has_value();
  }

  /// Returns the text after a statement's keyword with blanks before it, so that the lines and columns of
  /// messages are those of the file.
  static std::string padded(const Statement& statement) {
    return std::string(statement.line - 1, '\n') + std::string(statement.rest_column, ' ') +
           std::string(statement.rest);
  }

  std::shared_ptr<const std::string> text_;
  std::shared_ptr<grf::SourceFile> file_;
  std::string path_;
  grf::Diagnostics& diagnostics_;
  ToolState state_;
  bool has_tool_ = false;  ///< even if it has a mistake
};

/// Returns a path as written in a file: relative to its folder if it was relative or is in that folder.
/// Without a file it is absolute.
std::string written(const std::string& path, const std::string& in_file) {
  std::error_code error;
  if (!in_file.empty()) {
    if (std::filesystem::path(path).is_relative()) return renamed(path, {}, in_file);
    const std::filesystem::path folder = std::filesystem::absolute(in_file, error).parent_path();
    const std::string relative = std::filesystem::path(path).lexically_relative(folder).generic_string();
    return relative.empty() || relative.starts_with("..") ? path : relative;
  }
  const std::filesystem::path absolute = std::filesystem::absolute(path, error);
  return error ? path : absolute.lexically_normal().generic_string();
}

std::string text_of(const grf::Model& model) { return grf::to_text(grf::PdfModel{model}); }

/// Formats a BRDF with the path of its data file as written in a file.
std::string text_of(grf::BrdfModel brdf, const std::string& in_file) {
  if (!brdf.data_file.empty()) {
    const std::string from = brdf.location.file ? brdf.location.file->path : std::string();
    brdf.data_file = written(grf::path_beside(from, brdf.data_file), in_file);
  }
  return grf::to_text(brdf);
}

}  // namespace

std::optional<ToolState> read_state(const std::string& text, const std::string& path,
                                    grf::Diagnostics& diagnostics) {
  return Reader(text, path, diagnostics).read();
}

void set_value(grf::Model& settings, std::string_view name, grf::Value value) {
  for (grf::Argument& argument : settings.arguments) {
    if (!grf::same_keyword(argument.name, name)) continue;
    argument.value = std::move(value);
    return;
  }
  settings.arguments.push_back({std::string(name), std::move(value), {}});
}

std::string to_text(const ToolState& state, const std::string& path) {
  std::string text = fmt::format("tool {}\n", text_of(state.settings));
  if (state.distribution) text += fmt::format("distribution {}\n", text_of(*state.distribution));
  for (const grf::Definition& definition : state.definitions) {
    const std::string body = text_of(std::get<grf::BrdfModel>(definition.body), path);
    text += fmt::format("def {} = brdf {}\n", definition.name, body);
  }
  for (const grf::BrdfModel& brdf : state.brdfs) text += fmt::format("brdf {}\n", text_of(brdf, path));
  for (const grf::PdfModel& pdf : state.pdfs) text += fmt::format("pdf {}\n", grf::to_text(pdf));
  for (const ToolState::File& file : state.files) text += fmt::format("file {}\n", written(file.path, path));
  return text;
}

}  // namespace studies
