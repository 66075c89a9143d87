#include "grf/write_files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/write.h"

namespace grf {
namespace {

/// Does something with each mesh, light and include of one file, with the scope that is in force there.
template <class Action>
void for_each_in_file(const BlockList& list, Scope& scope, const Action& action) {
  for (const Block& block : list.blocks) {
    if (const auto* transform = std::get_if<Transform>(&block.content)) {
      for_each_in_file(transform->body, scope, action);
    } else if (const auto* definitions = std::get_if<DefinitionScope>(&block.content)) {
      for (const Definition& definition : definitions->definitions) scope.enter(definition);
      for_each_in_file(definitions->body, scope, action);
      scope.leave(definitions->definitions.size());
    } else {
      action(block);
    }
  }
}

template <class ModelOfKind>
bool reads_as_reference(const std::optional<std::variant<ModelOfKind, Reference>>& attribute,
                        const Scope& scope) {
  const auto* model = attribute ? std::get_if<ModelOfKind>(&*attribute) : nullptr;
  return model != nullptr && model->arguments.empty() && scope.find<ModelOfKind>(model->keyword) != nullptr;
}

/// Whether a file that was not changed would now be read in another way, since a definition around it has
/// taken the name of a model that it uses.
bool reads_otherwise(const BlockList& contents, Scope scope) {
  bool otherwise = false;
  for_each_in_file(contents, scope, [&](const Block& block) {
    const auto* mesh = std::get_if<Shared<Mesh>>(&block.content);
    if (mesh == nullptr) return;
    for (const Surface& surface : (*mesh)->surfaces) {
      otherwise =
          otherwise || reads_as_reference(surface.brdf, scope) || reads_as_reference(surface.pdf, scope);
    }
  });
  return otherwise;
}

/// Writes the files that a scene includes, where they are not what was read from there.
class IncludeWriter {
 public:
  IncludeWriter(const Scene& scene, const std::string& path, Diagnostics& diagnostics)
      : scene_(scene), path_(path), diagnostics_(diagnostics) {}

  /// Makes the texts; false if there can be no such files.
  bool prepare() {
    valid_ = true;
    for_each_include([this](const Include& include, const std::string& path) {
      const std::string exact_path = canonical_path(path);
      const IncludeOrigin& origin = include.origin;
      const bool is_as_read = origin.path == exact_path && origin.contents == include.contents;
      if (!is_as_read || reads_otherwise(*include.contents, scope_)) changed_.insert(exact_path);
    });
    for_each_include([this](const Include& include, const std::string& path) {
      const std::string exact_path = canonical_path(path);
      if (!changed_.contains(exact_path)) return;
      const std::string text = text_of_file(*include.contents, scope_);
      const auto [known, is_new] = texts_.emplace(exact_path, Text{path, text});
      if (is_new || known->second.text == text) return;
      fail(path, "it is included more than once, and was changed in one place only");
    });
    return valid_;
  }

  bool write() const {
    bool written = true;
    for (const auto& [exact_path, text] : texts_) {
      Diagnostics unheard;
      const auto old_text = read_file(exact_path, unheard);
      if (old_text && *old_text == text.text) continue;
      diagnostics_.note(whole_file(text.path), "the included file is written too");
      std::error_code ignored;  // what is wrong with the folder is said when the file cannot be made
      std::filesystem::create_directories(std::filesystem::path(exact_path).parent_path(), ignored);
      written = replace_file(text.path, text.text, diagnostics_) && written;
    }
    return written;
  }

 private:
  struct Text {
    std::string path;
    std::string text;
  };

  template <class Action>
  void for_each_include(const Action& action) {
    open_files_ = {canonical_path(path_)};
    for_each_include(scene_.contents, path_, action);
  }

  template <class Action>
  void for_each_include(const BlockList& list, const std::string& naming_file, const Action& action) {
    for_each_in_file(list, scope_, [&](const Block& block) {
      const auto* include = std::get_if<Include>(&block.content);
      if (include == nullptr || !valid_) return;
      const std::string path = path_beside(naming_file, include->file);
      const std::string exact_path = canonical_path(path);
      if (std::find(open_files_.begin(), open_files_.end(), exact_path) != open_files_.end()) {
        return fail(path, "it would include itself");
      }
      action(*include, path);
      open_files_.push_back(exact_path);
      for_each_include(*include->contents, path, action);
      open_files_.pop_back();
    });
  }

  void fail(const std::string& path, const char* why) {
    diagnostics_.error(whole_file(path), fmt::format("cannot write the file: {}", why));
    valid_ = false;
  }

  const Scene& scene_;
  const std::string& path_;
  Diagnostics& diagnostics_;
  Scope scope_;
  bool valid_ = true;
  std::vector<std::string> open_files_;
  std::set<std::string> changed_;
  std::map<std::string, Text> texts_;  // by canonical path
};

}  // namespace

bool write(const Scene& scene, const std::string& path, Diagnostics& diagnostics) {
  IncludeWriter includes(scene, path, diagnostics);
  return includes.prepare() && replace_file(path, to_text(scene), diagnostics) && includes.write();
}

}  // namespace grf
