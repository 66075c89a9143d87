#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "grf/parser.h"
#include "grf/text_file.h"

namespace grf {
namespace {

constexpr std::size_t DeepestInclude = 64;
// Limits on includes: a chain of small files that each include the next one twice would grow exponentially.
constexpr std::size_t MostIncludes = 100'000;
constexpr std::size_t MostBytesReadAgain = 128U << 20U;
constexpr std::size_t CostOfAFile = 4096;  // opening a file costs about as much as reading this many bytes

}  // namespace

FileInFolder file_in_folder(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return {canonical_path(path), canonical_path(folder.empty() ? "." : folder)};
}

bool Parser::parse_include(Include& include) {
  const SourceLocation location = lexer_.location(lexer_.peek());
  if (!parse_string(include.file, "the name of a file, in quotes")) return false;
  const std::string path = path_beside(file_->path, include.file);
  const OpenFile included{canonical_path(path), path};
  if (!may_include(included, location)) return true;
  if (auto contents = contents_of(included, location)) {
    include.contents = contents->contents;
    include.origin = *std::move(contents);
  }
  return true;  // the statement itself was parsed, so parsing continues after it
}

bool Parser::may_include(const OpenFile& included, const SourceLocation& location) {
  const std::vector<OpenFile>& open_files = context_.open_files;
  const auto same = std::find_if(open_files.begin(), open_files.end(), [&](const OpenFile& open) {
    return open.exact_path == included.exact_path;
  });
  if (same != open_files.end()) {
    std::string chain;
    for (auto open = same; open != open_files.end(); ++open) chain += open->path + " -> ";
    context_.diagnostics.error(
        location, fmt::format("'{}' includes itself: {}{}", included.path, chain, included.path));
    return false;
  }
  if (open_files.size() > DeepestInclude) {
    context_.diagnostics.error(location, fmt::format("includes are nested deeper than {}", DeepestInclude));
    return false;
  }
  if (++context_.include_count > MostIncludes) {
    context_.diagnostics.error(
        location, fmt::format("more than {} includes, each counted as often as its file is included itself",
                              MostIncludes));
    context_.gave_up = true;
  }
  return !context_.gave_up;
}

// Instances of an object are one file that is included many times, so its contents are cached and reused
// where they would parse alike. A file with includes of its own is read again, so that those are counted
// again too.
std::optional<IncludeOrigin> Parser::contents_of(const OpenFile& included, const SourceLocation& location) {
  const std::pair key(file_in_folder(included.path), context_.scope_number);
  const auto known = context_.contents_of_files.find(key);
  if (known != context_.contents_of_files.end()) {
    if (context_.nesting + known->second.nesting <= DeepestNesting) return known->second.file;
    fail_too_deep(location);
    return std::nullopt;
  }

  const auto text = read_file(included.path, context_.diagnostics, location);
  if (!text) return std::nullopt;
  if (is_read_too_often(included, text->size())) {
    context_.diagnostics.error(location, fmt::format("the same files are included too often with other "
                                                     "definitions in scope: more than {} MiB were read again",
                                                     MostBytesReadAgain >> 20U));
    context_.gave_up = true;
    return std::nullopt;
  }
  const auto file = source_file(included.path, text, location);
  if (!is_text(*text, "a GRF scene", {file, 0, 0}, context_.diagnostics)) return std::nullopt;
  const std::size_t includes_before = context_.include_count;
  context_.open_files.push_back(included);
  IncludeOrigin contents = {included.exact_path, Parser(text, file, context_).parse_file(),
                            std::hash<std::string>()(*text)};
  context_.open_files.pop_back();
  if (context_.include_count == includes_before) {
    context_.contents_of_files.insert({key, {contents, nesting_of(*contents.contents)}});
  }
  return contents;
}

bool Parser::is_read_too_often(const OpenFile& included, std::size_t bytes) {
  if (context_.included_paths.insert(included.exact_path).second) return false;
  context_.bytes_read_again += bytes + CostOfAFile;
  return context_.bytes_read_again > MostBytesReadAgain;
}

}  // namespace grf
