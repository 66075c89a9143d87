#include "editor/document/scene_places.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "grf/visit.h"

namespace editor {
namespace {

/// The children of a block, or null.
const grf::BlockList* list_in(const grf::Block& block) {
  if (const auto* transform = std::get_if<grf::Transform>(&block.content)) return &transform->body;
  if (const auto* scope = std::get_if<grf::DefinitionScope>(&block.content)) return &scope->body;
  if (const auto* include = std::get_if<grf::Include>(&block.content)) return &*include->contents;
  return nullptr;
}

/// The number of definitions that precede the children of a block in paths.
std::size_t definitions_before(const grf::Block* block) {
  const auto* scope = block == nullptr ? nullptr : std::get_if<grf::DefinitionScope>(&block->content);
  return scope == nullptr ? 0 : scope->definitions.size();
}

/// The ancestors of a path, the outermost first, and the definition at its end.
struct Ancestors {
  std::vector<const grf::Block*> blocks;
  const grf::Definition* definition = nullptr;
  bool is_whole = true;  ///< false if the path is invalid
};

Ancestors ancestors_of(const grf::Scene& scene, grf::ScenePathView path) {
  Ancestors ancestors;
  const grf::BlockList* list = &scene.contents;
  for (const std::uint32_t number : path) {
    const grf::Block* around = ancestors.blocks.empty() ? nullptr : ancestors.blocks.back();
    const std::size_t before = definitions_before(around);
    ancestors.is_whole =
        list != nullptr && ancestors.definition == nullptr && number < before + list->blocks.size();
    if (!ancestors.is_whole) break;
    if (number < before) {
      ancestors.definition = &std::get<grf::DefinitionScope>(around->content).definitions[number];
      continue;
    }
    ancestors.blocks.push_back(&list->blocks[number - before]);
    list = list_in(*ancestors.blocks.back());
  }
  return ancestors;
}

/// Replaces a scope without definitions by its blocks, and keeps its comments.
void dissolve(grf::BlockList& list, std::size_t number) {
  const auto place = list.blocks.begin() + static_cast<std::ptrdiff_t>(number);
  auto& scope = std::get<grf::DefinitionScope>(place->content);
  std::vector<std::string> comments = std::move(place->comments.before);
  std::vector<std::string> end_comments = std::move(scope.body.end_comments);
  std::vector<grf::Block> body = std::move(scope.body.blocks);
  comments.insert(comments.end(), end_comments.begin(), end_comments.end());
  auto& kept = body.empty() ? list.end_comments : body.front().comments.before;
  kept.insert(kept.begin(), comments.begin(), comments.end());
  list.blocks.insert(list.blocks.erase(place), std::make_move_iterator(body.begin()),
                     std::make_move_iterator(body.end()));
}

void erase_definition(grf::Scene& scene, grf::ScenePath scope_path, std::uint32_t number) {
  auto& scope = std::get<grf::DefinitionScope>(grf::find(scene, scope_path).block->content);
  scope.definitions.erase(scope.definitions.begin() + number);
  if (!scope.definitions.empty()) return;
  const std::uint32_t place = scope_path.back();
  scope_path.pop_back();
  dissolve(*grf::find_blocks(scene, scope_path),
           place - definitions_before(grf::find(scene, scope_path).block));
}

void erase_block(grf::Scene& scene, grf::ScenePath path) {
  while (!path.empty()) {
    const std::uint32_t number = path.back();
    path.pop_back();
    const grf::Block* around = grf::find(scene, path).block;
    auto& blocks = grf::find_blocks(scene, path)->blocks;
    blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(number - definitions_before(around)));
    const auto* transform = around == nullptr ? nullptr : std::get_if<grf::Transform>(&around->content);
    if (transform == nullptr || !transform->body.blocks.empty()) return;
  }
}

/// Searches for what is nearest before a location in its file.
class NearestBefore {
 public:
  explicit NearestBefore(const grf::SourceLocation& location) : wanted_(location) {}

  void offer(const grf::SourceLocation& location, grf::ScenePathView path) {
    if (!location.file || !wanted_.file || location.file->path != wanted_.file->path) return;
    const auto place = std::tuple(location.line, location.column);
    if (place > std::tuple(wanted_.line, wanted_.column) || (best_ && place < best_place_)) return;
    best_ = grf::ScenePath(path.begin(), path.end());
    best_place_ = place;
  }
  void offer_surfaces(const grf::Mesh& mesh, grf::ScenePathView path) {
    for (const grf::Surface& surface : mesh.surfaces) offer(surface.location, path);
  }
  std::optional<grf::ScenePath> take() { return std::move(best_); }

 private:
  const grf::SourceLocation& wanted_;
  std::optional<grf::ScenePath> best_;
  std::tuple<std::uint32_t, std::uint32_t> best_place_;
};

}  // namespace

std::vector<PlacedDefinition> definitions_at(const grf::Scene& scene, grf::ScenePathView path) {
  std::vector<PlacedDefinition> found;
  std::unordered_map<std::string_view, std::size_t> place_of_name;
  const Ancestors ancestors = ancestors_of(scene, path);
  for (std::size_t depth = 0; depth < ancestors.blocks.size(); ++depth) {
    const auto* scope = std::get_if<grf::DefinitionScope>(&ancestors.blocks[depth]->content);
    if (scope == nullptr || depth + 1 >= path.size()) continue;
    const std::size_t in_force = std::min<std::size_t>(path[depth + 1], scope->definitions.size());
    for (std::uint32_t i = 0; i < in_force; ++i) {
      const grf::Definition& definition = scope->definitions[i];
      grf::ScenePath place(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(depth) + 1);
      place.push_back(i);
      const auto [known, is_new] = place_of_name.emplace(definition.name, found.size());
      if (!is_new) found[known->second].definition = nullptr;
      known->second = found.size();
      found.push_back({std::move(place), &definition});
    }
  }
  std::erase_if(found, [](const PlacedDefinition& each) { return each.definition == nullptr; });
  return found;
}

std::vector<PlacedDefinition> common_definitions(const grf::Scene& scene,
                                                 const std::vector<grf::ScenePath>& paths) {
  std::vector<PlacedDefinition> common;
  std::map<grf::ScenePath, bool> seen;  // lists: children of the same list have the same names in scope
  bool is_first = true;
  for (const grf::ScenePath& path : paths) {
    const bool is_definition = definition_at(scene, path) != nullptr;
    const grf::ScenePath around(path.begin(), path.empty() || is_definition ? path.end() : path.end() - 1);
    if (!seen.emplace(around, true).second) continue;
    std::vector<PlacedDefinition> here = definitions_at(scene, path);
    if (std::exchange(is_first, false)) {
      common = std::move(here);
      continue;
    }
    std::erase_if(common, [&here](const PlacedDefinition& each) {
      return std::ranges::none_of(
          here, [&each](const PlacedDefinition& other) { return other.definition == each.definition; });
    });
  }
  return common;
}

const grf::Definition* definition_at(const grf::Scene& scene, grf::ScenePathView path) {
  const Ancestors ancestors = ancestors_of(scene, path);
  return ancestors.is_whole ? ancestors.definition : nullptr;
}

const grf::Block* block_at(const grf::Scene& scene, grf::ScenePathView path) {
  const Ancestors ancestors = ancestors_of(scene, path);
  return ancestors.is_whole && ancestors.definition == nullptr && !ancestors.blocks.empty()
             ? ancestors.blocks.back()
             : nullptr;
}

const grf::Mesh* mesh_at(const grf::Scene& scene, grf::ScenePathView path) {
  const Ancestors ancestors = ancestors_of(scene, path);
  if (!ancestors.is_whole || ancestors.blocks.empty()) return nullptr;
  const grf::Shared<grf::Mesh>* mesh = nullptr;
  if (ancestors.definition != nullptr) {
    mesh = std::get_if<grf::Shared<grf::Mesh>>(&ancestors.definition->body);
  } else if (const auto* light = std::get_if<grf::MeshLight>(&ancestors.blocks.back()->content)) {
    mesh = &light->mesh;
  } else {
    mesh = std::get_if<grf::Shared<grf::Mesh>>(&ancestors.blocks.back()->content);
  }
  return mesh == nullptr ? nullptr : &**mesh;
}

bool is_inside(grf::ScenePathView path, grf::ScenePathView outer) {
  return path.size() >= outer.size() && std::equal(outer.begin(), outer.end(), path.begin());
}

bool is_in_include(const grf::Scene& scene, grf::ScenePathView path) {
  const Ancestors ancestors = ancestors_of(scene, path);
  return std::ranges::any_of(ancestors.blocks, [](const grf::Block* block) {
    return std::holds_alternative<grf::Include>(block->content);
  });
}

grf::Matrix44d to_world_at(const grf::Scene& scene, grf::ScenePathView path) {
  grf::Matrix44d to_world;
  const Ancestors ancestors = ancestors_of(scene, path);
  for (std::size_t depth = 0; depth < ancestors.blocks.size() && depth + 1 < path.size(); ++depth) {
    const auto* transform = std::get_if<grf::Transform>(&ancestors.blocks[depth]->content);
    if (transform != nullptr) to_world = grf::matrix_of(transform->steps) * to_world;
  }
  return to_world;
}

DefinitionInsertion DefinitionInsertion::around(const grf::Scene& scene, grf::ScenePathView path) {
  DefinitionInsertion insertion;
  const Ancestors ancestors = ancestors_of(scene, path);
  for (std::size_t depth = ancestors.blocks.size(); depth-- > 0;) {
    const auto place = path.begin() + static_cast<std::ptrdiff_t>(depth) + 1;
    if (place == path.end()) continue;  // the object itself is not its own ancestor
    if (std::holds_alternative<grf::Include>(ancestors.blocks[depth]->content)) {
      insertion.list_.assign(path.begin(), place);
      insertion.is_new_ = true;
      return insertion;
    }
    const auto* scope = std::get_if<grf::DefinitionScope>(&ancestors.blocks[depth]->content);
    if (scope == nullptr) continue;
    insertion.scope_.assign(path.begin(), place);
    insertion.definitions_ = static_cast<std::uint32_t>(scope->definitions.size());
    return insertion;
  }
  return outermost(scene);
}

DefinitionInsertion DefinitionInsertion::outermost(const grf::Scene& scene) {
  DefinitionInsertion insertion;
  const auto& blocks = scene.contents.blocks;
  const auto* scope =
      blocks.size() == 1 ? std::get_if<grf::DefinitionScope>(&blocks.front().content) : nullptr;
  insertion.is_new_ = scope == nullptr;
  if (scope == nullptr) return insertion;
  insertion.scope_ = {0};
  insertion.definitions_ = static_cast<std::uint32_t>(scope->definitions.size());
  return insertion;
}

void DefinitionInsertion::apply(grf::Scene& scene, grf::Definition definition) const {
  if (!is_new_) {
    auto& scope = std::get<grf::DefinitionScope>(grf::find(scene, scope_).block->content);
    scope.definitions.push_back(std::move(definition));
    return;
  }
  grf::BlockList& list = *grf::find_blocks(scene, list_);
  grf::DefinitionScope scope;
  scope.definitions.push_back(std::move(definition));
  scope.body.blocks = std::move(list.blocks);
  list.blocks.clear();
  list.blocks.emplace_back().content = std::move(scope);
}

grf::ScenePath DefinitionInsertion::shifted(grf::ScenePath path) const {
  const grf::ScenePath& prefix = is_new_ ? list_ : scope_;
  if (path.size() <= prefix.size() || !std::equal(prefix.begin(), prefix.end(), path.begin())) return path;
  const auto next = path.begin() + static_cast<std::ptrdiff_t>(prefix.size());
  if (*next >= definitions_) ++*next;
  if (is_new_) path.insert(next, 0);
  return path;
}

grf::ScenePath DefinitionInsertion::definition_path() const {
  grf::ScenePath path = is_new_ ? list_ : scope_;
  if (is_new_) path.push_back(0);
  path.push_back(definitions_);
  return path;
}

void erase(grf::Scene& scene, std::vector<grf::ScenePath> paths) {
  std::ranges::sort(paths);
  // Descendants of a removed object follow it, and are removed with it.
  paths.erase(std::unique(paths.begin(), paths.end(),
                          [](const auto& first, const auto& later) { return is_inside(later, first); }),
              paths.end());
  // Backwards, so that the remaining paths stay valid.
  for (auto path = paths.rbegin(); path != paths.rend(); ++path) {
    if (definition_at(scene, *path) != nullptr) {
      const std::uint32_t number = path->back();
      path->pop_back();
      erase_definition(scene, *path, number);
    } else if (block_at(scene, *path) != nullptr) {
      erase_block(scene, *path);
    }
  }
}

grf::BlockList& outermost_blocks(grf::Scene& scene) {
  auto& blocks = scene.contents.blocks;
  auto* scope = blocks.size() == 1 ? std::get_if<grf::DefinitionScope>(&blocks.front().content) : nullptr;
  return scope == nullptr ? scene.contents : scope->body;
}

namespace {

using Texts = std::map<std::string, grf::Shared<grf::BlockList>>;

/// Visits each include, and descends into those for which the action returns true.
template <class Action>
void for_each_nested_include(const grf::BlockList& list, const Action& action) {
  for_each_include(list, [&action](const grf::Include& include) {
    if (action(include)) for_each_nested_include(*include.contents, action);
  });
}

/// The texts of included files as they were read; if included at several places, the first.
Texts texts_of(const grf::Scene& scene) {
  Texts texts;
  for_each_nested_include(scene.contents, [&texts](const grf::Include& include) {
    return include.origin.path.empty() || texts.emplace(include.origin.path, include.contents).second;
  });
  return texts;
}

/// The texts of edited files; reports an error if a file would have two.
Texts changed_texts(const grf::Scene& scene, const Texts& before, grf::Diagnostics& diagnostics) {
  Texts changed;
  for_each_nested_include(scene.contents, [&](const grf::Include& include) {
    const auto known = before.find(include.origin.path);
    if (known == before.end()) return true;
    if (include.contents == known->second) return false;
    const auto [other, is_new] = changed.emplace(known->first, include.contents);
    if (!is_new && !(other->second == include.contents)) {
      diagnostics.error(grf::whole_file(known->first),
                        fmt::format("'{}' is included at several places, which would differ: edit one of "
                                    "them, or include a file of its own there",
                                    known->first));
    }
    return true;
  });
  return changed;
}

/// Replaces the contents of all includes of edited files; returns the number of those that differed.
std::size_t put_texts(grf::BlockList& list, const Texts& changed) {
  std::size_t places = 0;
  for_each_include(list, [&](grf::Include& include) {
    const auto text = changed.find(include.origin.path);
    if (text != changed.end() && !(include.contents == text->second)) {
      include.contents = text->second;
      ++places;
    }
    grf::BlockList inside = *include.contents;
    const std::size_t places_inside = put_texts(inside, changed);
    if (places_inside > 0) include.contents = std::move(inside);
    places += places_inside;
  });
  return places;
}

/// A location in a file: an included file, and the path inside it.
struct WrittenPlace {
  std::string file;
  grf::ScenePath path;

  auto operator<=>(const WrittenPlace&) const = default;
};

/// Empty for a path outside of included files.
std::optional<WrittenPlace> written_place(const grf::Scene& scene, grf::ScenePathView path) {
  const Ancestors ancestors = ancestors_of(scene, path);
  for (std::size_t depth = ancestors.blocks.size(); depth-- > 0;) {
    const auto* include = std::get_if<grf::Include>(&ancestors.blocks[depth]->content);
    if (include == nullptr || include->origin.path.empty()) continue;
    return WrittenPlace{include->origin.path, {path.begin() + std::ptrdiff_t(depth) + 1, path.end()}};
  }
  return std::nullopt;
}

}  // namespace

std::map<std::string, std::size_t> included_files(const grf::Scene& scene) {
  std::map<std::string, std::size_t> counts;
  for_each_nested_include(scene.contents, [&counts](const grf::Include& include) {
    if (!include.origin.path.empty()) ++counts[include.origin.path];
    return true;
  });
  return counts;
}

std::size_t edit_all_places(const grf::Scene& before, grf::Scene& after, grf::Diagnostics& diagnostics) {
  const Texts texts = texts_of(before);
  if (texts.empty()) return 0;
  const Texts changed = changed_texts(after, texts, diagnostics);
  if (changed.empty() || diagnostics.error_count() > 0) return 0;
  return put_texts(after.contents, changed);
}

FaceSelection at_all_places(const grf::Scene& scene, const SceneObjects& objects,
                            const FaceSelection& selection) {
  FaceSelection faces = selection;
  // Grouped first: a file that is included thousands of times may be selected at each place.
  std::map<WrittenPlace, FaceSelection::Faces> selected;
  for (const std::uint32_t mesh : selection.meshes()) {
    const auto place = written_place(scene, objects.meshes[mesh].path);
    if (!place) continue;
    FaceSelection::Faces& of_place = selected[*place];
    of_place.resize(selection.of_mesh(mesh).size());
    of_place |= selection.of_mesh(mesh);
  }
  if (selected.empty()) return faces;
  for (std::uint32_t i = 0; i < objects.meshes.size(); ++i) {
    const auto place = written_place(scene, objects.meshes[i].path);
    const auto same = place ? selected.find(*place) : selected.end();
    if (same == selected.end()) continue;
    faces.set_faces(i, same->second);
  }
  return faces;
}

std::optional<grf::ScenePath> written_at(const grf::Scene& scene, const grf::SourceLocation& location) {
  NearestBefore nearest(location);
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block& block) {
    nearest.offer(block.location, placement.path);
    if (placement.instance_of == nullptr) nearest.offer_surfaces(mesh, placement.path);
  };
  const auto offer_block = [&](const auto&, const grf::Placement& placement, const grf::Block& block) {
    nearest.offer(block.location, placement.path);
  };
  visitor.mesh_light = offer_block;
  visitor.light = offer_block;
  visitor.transform = offer_block;
  visitor.params = offer_block;
  visitor.use = offer_block;
  visitor.definition = [&](const grf::Definition& definition, const grf::Placement& placement) {
    nearest.offer(definition.location, placement.path);
    const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body);
    if (mesh != nullptr) nearest.offer_surfaces(**mesh, placement.path);
  };
  grf::visit(scene, visitor);
  return nearest.take();
}

}  // namespace editor
