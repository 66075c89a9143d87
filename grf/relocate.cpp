#include "grf/relocate.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>
#include <variant>

#include "grf/text_file.h"

namespace grf {
namespace {

/// Translates file names that are relative to one file into names relative to another.
class Names {
 public:
  Names(const std::string& from, const std::string& to,
        const std::map<std::string, std::string>& renamed = {})
      : from_(from), to_(to), to_folder_(folder_of(to)), renamed_(renamed) {
    moves_ = folder_of(from) != to_folder_;
  }
  /// Translates names in that file to absolute names.
  explicit Names(const std::string& from) : from_(from), moves_(true) {}

  /// Returns false if names are the same relative to both files.
  bool moves() const { return moves_ || !renamed_.empty(); }

  std::string moved(const std::string& name) const {
    const auto renamed = renamed_.find(name);
    if (renamed != renamed_.end()) return renamed->second;
    if (!moves_ || name.empty() || is_absolute(name)) return name;
    const std::filesystem::path target = canonical_path(path_beside(from_, name));
    if (to_folder_.empty()) return target.string();
    const std::filesystem::path relative = target.lexically_relative(to_folder_);
    return relative.empty() ? target.string() : relative.string();
  }

  /// Translates a name in a file that is itself named in the first one.
  std::string moved_from(const std::string& file, const std::string& name) const {
    const std::string beside = path_beside(from_, file);
    return to_folder_.empty() ? Names(beside).moved(name) : Names(beside, to_).moved(name);
  }

 private:
  static std::filesystem::path folder_of(const std::string& path) {
    return std::filesystem::path(canonical_path(path)).parent_path();
  }
  static bool is_absolute(const std::string& name) { return name.front() == '/' || name.front() == '\\'; }

  std::string from_;
  std::string to_;
  std::filesystem::path to_folder_;
  std::map<std::string, std::string> renamed_;
  bool moves_ = false;
};

/// Rewrites the file names in a scene. Shared meshes are edited, and thus copied, only if a name in them
/// changes.
class Mover {
 public:
  Mover(const Names& names, bool writes_brdfs_out) : names_(names), writes_brdfs_out_(writes_brdfs_out) {}

  void move(BlockList& list) const {
    for (Block& block : list.blocks) move(block);
  }
  void move(Block& block) const {
    std::visit([this](auto& content) { move(content); }, block.content);
  }
  void move(Definition& definition) const {
    std::visit([this](auto& body) { move(body); }, definition.body);
  }

  void move(Shared<Mesh>& mesh) const {
    const auto stays = [this](Surface surface) {
      const Surface before = surface;
      move(surface);
      return surface == before;
    };
    if (std::all_of(mesh->surfaces.begin(), mesh->surfaces.end(), stays)) return;
    for (Surface& surface : mesh.edit().surfaces) move(surface);
  }
  void move(Include& include) const { include.file = names_.moved(include.file); }
  void move(Transform& transform) const { move(transform.body); }
  void move(DefinitionScope& scope) const {
    for (Definition& definition : scope.definitions) move(definition);
    move(scope.body);
  }
  void move(Surface& surface) const {
    if (surface.brdf) std::visit([this](auto& brdf) { move(brdf); }, *surface.brdf);
    if (surface.texture) std::visit([this](auto& texture) { move(texture); }, *surface.texture);
  }

 private:
  // Blocks and attributes without file names.
  void move(MeshLight&) const {}
  void move(AreaLight&) const {}
  void move(Params&) const {}
  void move(Use&) const {}
  void move(Colour&) const {}
  void move(PdfModel&) const {}
  void move(Reference&) const {}

  void move(BrdfModel& brdf) const {
    // Data files and images named in a BRDF's own file are relative to that file.
    if (brdf.instance_file.empty()) {
      move_data(brdf, [this](const std::string& name) { return names_.moved(name); });
    } else if (writes_brdfs_out_) {
      move_data(brdf, [&](const std::string& name) { return names_.moved_from(brdf.instance_file, name); });
      brdf.instance_file.clear();
    } else {
      brdf.instance_file = names_.moved(brdf.instance_file);
    }
  }
  void move(Texture& texture) const { texture.file = names_.moved(texture.file); }

  template <class Move>
  static void move_data(BrdfModel& brdf, Move moved) {
    brdf.data_file = moved(brdf.data_file);
    for (Argument& argument : brdf.arguments) {
      if (argument.map) argument.map->file = moved(argument.map->file);
    }
  }

  const Names& names_;
  bool writes_brdfs_out_;
};

template <class Part>
void move_all(std::span<Part> parts, const Names& names) {
  if (!names.moves()) return;
  const Mover mover(names, false);
  for (Part& part : parts) mover.move(part);
}

/// Collects the blocks of a file and of those that it includes.
class Flattener {
 public:
  explicit Flattener(const std::string& path) : path_(path) {}

  BlockList flat(const BlockList& list, const std::string& file) {
    BlockList result;
    std::vector<std::string> comments;  // comments of includes, for the next block
    add(list, file, result, comments);
    comments.insert(comments.end(), list.end_comments.begin(), list.end_comments.end());
    result.end_comments = std::move(comments);
    return result;
  }

 private:
  void add(const BlockList& list, const std::string& file, BlockList& result,
           std::vector<std::string>& comments) {
    const Names names(file, path_);
    for (const Block& block : list.blocks) {
      comments.insert(comments.end(), block.comments.before.begin(), block.comments.before.end());
      if (const auto* include = std::get_if<Include>(&block.content)) {
        if (!block.comments.behind.empty()) comments.push_back(block.comments.behind);
        add(*include->contents, path_beside(file, include->file), result, comments);
        comments.insert(comments.end(), include->contents->end_comments.begin(),
                        include->contents->end_comments.end());
        continue;
      }
      // Inner blocks are not copied before they are flattened: n nested ones would cost n^2.
      Block& copy = result.blocks.emplace_back();
      copy.comments = {std::exchange(comments, {}), block.comments.behind};
      copy.location = block.location;
      if (const auto* transform = std::get_if<Transform>(&block.content)) {
        copy.content = Transform{transform->steps, flat(transform->body, file)};
      } else if (const auto* scope = std::get_if<DefinitionScope>(&block.content)) {
        DefinitionScope moved{scope->definitions, {}};
        Mover(names, true).move(moved);
        moved.body = flat(scope->body, file);
        copy.content = std::move(moved);
      } else {
        copy.content = block.content;
        if (auto* mesh = std::get_if<Shared<Mesh>>(&copy.content)) Mover(names, true).move(*mesh);
      }
    }
  }

  const std::string& path_;
};

}  // namespace

void relocate(Scene& scene, const std::string& from, const std::string& to,
              const std::map<std::string, std::string>& moved) {
  relocate(scene.contents.blocks, from, to, moved);
}

void relocate(std::span<Block> blocks, const std::string& from, const std::string& to,
              const std::map<std::string, std::string>& moved) {
  move_all(blocks, Names(from, to, moved));
}

void relocate(std::span<Definition> definitions, const std::string& from, const std::string& to,
              const std::map<std::string, std::string>& moved) {
  move_all(definitions, Names(from, to, moved));
}

void relocate(std::span<Surface> surfaces, const std::string& from, const std::string& to,
              const std::map<std::string, std::string>& moved) {
  move_all(surfaces, Names(from, to, moved));
}

Scene with_absolute_names(const Scene& scene, const std::string& from) {
  Scene flat = flatten(scene, from);
  Mover(Names(from), true).move(flat.contents);
  return flat;
}

Scene flatten(const Scene& scene, const std::string& path) {
  return {Flattener(path).flat(scene.contents, path)};
}

}  // namespace grf
