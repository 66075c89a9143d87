#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/lexer.h"
#include "grf/read.h"
#include "grf/text_file.h"
#include "grf/write.h"
#include "grf/writer.h"

namespace grf {
namespace {

/// Calls a function for each definition and each block without a body of one file, with the scope
/// there.
template <class Action>
void for_each_in_file(const BlockList& list, ScopeStack& scope, const Action& action) {
  for (const Block& block : list.blocks) {
    if (const auto* transform = std::get_if<Transform>(&block.content)) {
      for_each_in_file(transform->body, scope, action);
    } else if (const auto* definitions = std::get_if<DefinitionScope>(&block.content)) {
      for (const Definition& definition : definitions->definitions) {
        action(definition.body);
        scope.enter(definition);
      }
      for_each_in_file(definitions->body, scope, action);
      scope.leave(definitions->definitions.size());
    } else {
      action(block.content);
    }
  }
}

/// Returns the mesh of a block or a definition, or null.
template <class Variant>
const Mesh* mesh_in(const Variant& content) {
  const auto* mesh = std::get_if<Shared<Mesh>>(&content);
  return mesh == nullptr ? nullptr : &**mesh;
}

template <class ModelOfKind>
bool reads_as_reference(const std::optional<std::variant<ModelOfKind, Reference>>& attribute,
                        const Scope& scope) {
  const auto* model = attribute ? std::get_if<ModelOfKind>(&*attribute) : nullptr;
  return model != nullptr && is_bare_word(*model) && scope.find<ModelOfKind>(model->keyword) != nullptr;
}

/// Returns whether an unchanged file would now parse differently, since an outer definition has the name of a
/// model that it uses.
bool reads_otherwise(const BlockList& contents, const Scope& outside) {
  ScopeStack scope(outside);
  bool otherwise = false;
  for_each_in_file(contents, scope, [&](const auto& content) {
    const Mesh* mesh = mesh_in(content);
    if (mesh == nullptr) return;
    for (const Surface& surface : mesh->surfaces) {
      otherwise = otherwise || reads_as_reference(surface.brdf, scope.scope()) ||
                  reads_as_reference(surface.pdf, scope.scope());
    }
  });
  return otherwise;
}

/// Returns all comments of a text, as lines of their own.
std::string comments_of(const std::shared_ptr<const std::string>& text) {
  Lexer lexer(text, nullptr);
  while (lexer.peek().kind != TokenKind::EndOfFile) lexer.next();
  std::string comments;
  for (const CommentToken& comment : lexer.comments()) comments += fmt::format("//{}\n", comment.text);
  return comments;
}

/// Writes the files that a scene names, if their contents differ from the scene's.
class FilesWriter {
 public:
  FilesWriter(const Scene& scene, const std::string& path, Diagnostics& diagnostics)
      : scene_(scene), path_(path), diagnostics_(diagnostics) {}

  /// Generates the texts; returns false if the scene cannot be written as such files.
  bool prepare() {
    valid_ = true;
    if (nesting_of(scene_.contents) > DeepestNesting) {
      fail(path_, fmt::format("its blocks are nested deeper than {}", DeepestNesting));
      return false;
    }
    for_each_file([this](const Include& include, const std::string& path) {
      const std::string exact_path = canonical_path(path);
      const IncludeOrigin& origin = include.origin;
      const bool is_as_read =
          origin.path == exact_path && origin.contents == include.contents && is_on_disk(origin);
      if (!is_as_read || reads_otherwise(*include.contents, scope_.scope())) changed_.insert(exact_path);
    });
    prepare_own();
    for_each_file([this](const Include& include, const std::string& path) {
      const std::string exact_path = canonical_path(path);
      if (changed_.contains(exact_path)) prepare_file(path, *include.contents);
    });
    return valid_;
  }

  bool write() const {
    bool written = replace_file(path_, own_text_, diagnostics_);
    for (auto text = texts_.begin(); written && text != texts_.end(); ++text) written = write(*text);
    return written;
  }

 private:
  struct Text {
    std::string path;
    std::string text;
  };

  bool write(const std::pair<const std::string, Text>& entry) const {
    const auto& [exact_path, text] = entry;
    Diagnostics ignored_diagnostics;
    const auto old_text = read_file(exact_path, ignored_diagnostics);
    if (old_text && *old_text == text.text) return true;
    diagnostics_.note(whole_file(text.path), "this file, which the scene names, is written too");
    std::error_code ignored;  // an error of the folder is reported when the file cannot be created
    std::filesystem::create_directories(std::filesystem::path(exact_path).parent_path(), ignored);
    return replace_file(text.path, text.text, diagnostics_);
  }

  /// Returns whether the file still has the bytes that were read: it may have been overwritten since.
  bool is_on_disk(const IncludeOrigin& origin) {
    const auto [known, is_new] = hashes_on_disk_.try_emplace(origin.path);
    Diagnostics ignored_diagnostics;
    const auto text = is_new ? read_file(origin.path, ignored_diagnostics) : nullptr;
    if (text) known->second = std::hash<std::string>()(*text);
    return known->second == origin.hash;
  }

  void prepare_own() {
    own_text_ = checked_text(path_, scene_.contents, {});
    prepare_brdf_files(scene_.contents, path_, {});
  }

  void prepare_file(const std::string& path, const BlockList& contents) {
    add(path, checked_text(path, contents, scope_.scope()),
        "it is included more than once, and was changed in one place only");
    prepare_brdf_files(contents, path, scope_.scope());
  }

  std::string checked_text(const std::string& path, const BlockList& contents, const Scope& scope) {
    FileText text = text_of_file(contents, scope);
    if (!text.problem.empty()) fail(path, text.problem);
    if (has_irradiance(contents) && !is_igrf_name(path)) {
      fail(path, fmt::format("it has irradiance, expected the name of an IGRF file, such as '{}'",
                             std::filesystem::path(path).replace_extension("igrf").string()));
    }
    return std::move(text.text);
  }

  void add(const std::string& path, const std::string& text, const char* conflict) {
    const auto [known, is_new] = texts_.emplace(canonical_path(path), Text{path, text});
    if (!is_new && known->second.text != text) fail(path, conflict);
  }

  // Adds the BRDF files that a scene file names.
  void prepare_brdf_files(const BlockList& contents, const std::string& naming_file, const Scope& outside) {
    ScopeStack scope(outside);
    for_each_in_file(contents, scope, [&](const auto& content) {
      if constexpr (std::is_same_v<std::decay_t<decltype(content)>, Definition::Body>) {
        if (const auto* brdf = std::get_if<BrdfModel>(&content)) prepare_brdf_file(*brdf, naming_file);
      }
      const Mesh* mesh = mesh_in(content);
      if (mesh == nullptr) return;
      std::vector<bool> is_written = used_surfaces(*mesh);
      is_written[0] = true;
      for (std::size_t i = 0; i < mesh->surfaces.size(); ++i) {
        const auto& attribute = mesh->surfaces[i].brdf;
        const auto* brdf = is_written[i] && attribute ? std::get_if<BrdfModel>(&*attribute) : nullptr;
        if (brdf != nullptr) prepare_brdf_file(*brdf, naming_file);
      }
    });
  }

  void prepare_brdf_file(const BrdfModel& brdf, const std::string& naming_file) {
    if (brdf.instance_file.empty()) return;
    const std::string path = path_beside(naming_file, brdf.instance_file);
    const std::string_view problem = problem_of(brdf);
    if (!problem.empty()) return fail(path, problem);
    BrdfModel instance = brdf;
    instance.instance_file.clear();
    const auto [known, is_new] = instances_.emplace(canonical_path(path), instance);
    if (!is_new) {
      if (!(known->second == instance)) fail(path, "it would have to hold several BRDFs");
      return;
    }
    Diagnostics ignored_diagnostics;
    const auto old_text = read_file(path, ignored_diagnostics);
    const auto old = old_text ? read_brdf(*old_text, path, ignored_diagnostics) : std::nullopt;
    if (old && *old == instance) return;
    add(path, (old_text ? comments_of(old_text) : "") + to_text(instance) + "\n",
        "it would have to hold a BRDF and blocks");
  }

  template <class Action>
  void for_each_file(const Action& action) {
    open_files_ = {canonical_path(path_)};
    for_each_file(scene_.contents, path_, action);
  }

  template <class Action>
  void for_each_file(const BlockList& list, const std::string& naming_file, const Action& action) {
    for_each_in_file(list, scope_, [&](const auto& content) {
      if constexpr (!std::is_same_v<std::decay_t<decltype(content)>, Definition::Body>) {
        if (const auto* include = std::get_if<Include>(&content)) enter(*include, naming_file, action);
      }
    });
  }

  template <class Action>
  void enter(const Include& include, const std::string& naming_file, const Action& action) {
    if (!valid_) return;
    const std::string path = path_beside(naming_file, include.file);
    const std::string exact_path = canonical_path(path);
    if (std::find(open_files_.begin(), open_files_.end(), exact_path) != open_files_.end()) {
      return fail(path, "it would include itself");
    }
    action(include, path);
    open_files_.push_back(exact_path);
    for_each_file(*include.contents, path, action);
    open_files_.pop_back();
  }

  void fail(const std::string& path, std::string_view why) {
    diagnostics_.error(whole_file(path), fmt::format("cannot write the file: {}", why));
    valid_ = false;
  }

  const Scene& scene_;
  const std::string& path_;
  Diagnostics& diagnostics_;
  ScopeStack scope_;
  bool valid_ = true;
  std::vector<std::string> open_files_;
  std::set<std::string> changed_;
  std::map<std::string, std::size_t> hashes_on_disk_;
  std::string own_text_;
  std::map<std::string, Text> texts_;           // by canonical path
  std::map<std::string, BrdfModel> instances_;  // by canonical path
};

}  // namespace

bool write(const Scene& scene, const std::string& path, Diagnostics& diagnostics) {
  FilesWriter files(scene, path, diagnostics);
  return files.prepare() && files.write();
}

}  // namespace grf
