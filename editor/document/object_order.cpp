#include "editor/document/object_order.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "editor/document/definitions.h"
#include "editor/document/scene_places.h"

namespace editor {
namespace {

using Kind = grf::TransformStep::Kind;

/// The number of definitions in front of the blocks of a list in paths.
std::uint32_t definitions_of(const grf::Scene& scene, grf::ScenePathView list) {
  const grf::Block* owner = block_at(scene, list);
  const auto* scope = owner == nullptr ? nullptr : std::get_if<grf::DefinitionScope>(&owner->content);
  return scope == nullptr ? 0 : static_cast<std::uint32_t>(scope->definitions.size());
}

/// The blocks of a scene, a transform or a scope; null for other paths, also those in included files.
grf::BlockList* editable_blocks(grf::Scene& scene, grf::ScenePathView list) {
  return is_in_include(scene, list) ? nullptr : grf::find_blocks(scene, list);
}

void append(TransformSteps& steps, const TransformSteps& further) {
  for (const grf::TransformStep& step : further) {
    if (step.kind == Kind::Translation) {
      if (step.value != grf::Vec3f(0)) translate(steps, grf::Vec3d(step.value));
    } else {
      steps.push_back(step);
    }
  }
}

void append_inverse(TransformSteps& steps, const TransformSteps& further) {
  for (auto step = further.rbegin(); step != further.rend(); ++step) {
    if (step->kind == Kind::Translation) {
      if (step->value != grf::Vec3f(0)) translate(steps, -grf::Vec3d(step->value));
    } else {
      transform(steps, grf::matrix_of({*step}).inverse());
    }
  }
}

/// Extends the steps of a block so that it stays where it is when it moves from one list to another one.
void carry(TransformSteps& steps, const grf::Scene& scene, grf::ScenePathView from, grf::ScenePathView to) {
  const auto common = static_cast<std::size_t>(
      std::distance(from.begin(), std::mismatch(from.begin(), from.end(), to.begin(), to.end()).first));
  for (std::size_t depth = from.size(); depth > common; --depth)
    append(steps, block_steps(*block_at(scene, from.first(depth))));
  for (std::size_t depth = common + 1; depth <= to.size(); ++depth)
    append_inverse(steps, block_steps(*block_at(scene, to.first(depth))));
}

/// Updates a path after blocks were inserted at a place.
void follow_insertion(grf::ScenePath& path, const BlockPlace& place, std::uint32_t count) {
  const std::size_t depth = place.list.size();
  if (path.size() > depth && is_inside(path, place.list) && path[depth] >= place.before) path[depth] += count;
}

/// Updates a path after two siblings were exchanged.
void follow_exchange(grf::ScenePath& path, const grf::ScenePath& one, const grf::ScenePath& other) {
  const std::size_t depth = one.size() - 1;
  if (is_inside(path, one)) {
    path[depth] = other.back();
  } else if (is_inside(path, other)) {
    path[depth] = one.back();
  }
}

/// Whether the list of the scene shows a block as a group: a transform of one object is part of that object.
bool is_group(const grf::Block& block) {
  const auto* transform = std::get_if<grf::Transform>(&block.content);
  if (transform == nullptr) return false;
  if (transform->body.blocks.size() != 1) return true;
  const auto& content = transform->body.blocks.front().content;
  return std::holds_alternative<grf::Transform>(content) || std::holds_alternative<grf::Include>(content) ||
         std::holds_alternative<grf::DefinitionScope>(content);
}

/// Erases a block, and transforms that become empty. Paths of other blocks are updated.
void erase_and_follow(grf::Scene& scene, grf::ScenePath path, const std::vector<grf::ScenePath*>& others) {
  while (path.size() > 1) {
    const grf::ScenePathView around = grf::ScenePathView(path).first(path.size() - 1);
    const auto* transform = std::get_if<grf::Transform>(&block_at(scene, around)->content);
    if (transform == nullptr || transform->body.blocks.size() > 1) break;
    path.pop_back();
  }
  erase(scene, {path});
  const std::size_t depth = path.size() - 1;
  for (grf::ScenePath* other : others) {
    const bool is_beside = other->size() > depth && is_inside(*other, grf::ScenePathView(path).first(depth));
    if (is_beside && (*other)[depth] > path[depth]) --(*other)[depth];
  }
}

/// A block that is moved, and where.
struct MovedBlock {
  grf::ScenePath from;
  grf::ScenePath to;
};

/// Moves blocks, none of which is inside another one; the paths are those of objects inside them.
TransformedObjects move_blocks(const grf::Scene& scene, const std::vector<grf::ScenePath>& blocks,
                               const std::vector<grf::ScenePath>& paths, const BlockPlace& place) {
  TransformedObjects result{scene, paths};
  std::vector<MovedBlock> moved;
  std::vector<grf::Block> carried;
  BlockPlace next = place;
  std::vector<grf::ScenePath> inside(paths.size());  // of each object, below `to` of its block
  std::vector<std::size_t> block_of(paths.size());
  for (const grf::ScenePath& block : blocks) {
    grf::Block copy = *block_at(scene, block);
    TransformSteps steps = block_steps(copy);
    const TransformSteps before = steps;
    carry(steps, scene, grf::ScenePathView(block).first(block.size() - 1), place.list);
    const int levels = steps == before ? 0 : set_block_steps(copy, std::move(steps));
    for (std::size_t i = 0; i < paths.size(); ++i) {
      if (!is_inside(paths[i], block)) continue;
      inside[i].assign(paths[i].begin() + static_cast<std::ptrdiff_t>(block.size()), paths[i].end());
      follow_levels(inside[i], {}, levels);
      block_of[i] = moved.size();
    }
    moved.push_back({block, next.path()});
    carried.push_back(std::move(copy));
    ++next.before;
  }
  const auto count = static_cast<std::uint32_t>(carried.size());
  auto& list = grf::find_blocks(result.scene, place.list)->blocks;
  list.insert(list.begin() + (place.before - definitions_of(scene, place.list)),
              std::make_move_iterator(carried.begin()), std::make_move_iterator(carried.end()));
  std::vector<grf::ScenePath*> others;
  for (MovedBlock& each : moved) {
    follow_insertion(each.from, place, count);
    others.push_back(&each.to);
  }
  // Backwards, so that the paths of the others stay valid.
  for (auto each = moved.rbegin(); each != moved.rend(); ++each)
    erase_and_follow(result.scene, each->from, others);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    result.paths[i] = moved[block_of[i]].to;
    result.paths[i].insert(result.paths[i].end(), inside[i].begin(), inside[i].end());
  }
  return result;
}

bool may_move(const grf::Scene& scene, const std::vector<grf::ScenePath>& blocks, const BlockPlace& place,
              grf::Diagnostics& diagnostics) {
  for (const grf::ScenePath& block : blocks) {
    if (block_at(scene, block) == nullptr) {
      diagnostics.error({}, "only objects of the scene can be moved");
    } else if (is_inside(place.list, block)) {
      diagnostics.error(block_at(scene, block)->location, "an object cannot be moved into itself");
    }
  }
  grf::Scene probed = scene;
  if (editable_blocks(probed, place.list) == nullptr)
    diagnostics.error({}, "objects cannot be moved into an included file");
  return diagnostics.error_count() == 0 && keeps_references(scene, blocks, place.path(), diagnostics);
}

}  // namespace

grf::ScenePath BlockPlace::path() const {
  grf::ScenePath path = list;
  path.push_back(before);
  return path;
}

BlockPlace place_before(const grf::Scene& scene, grf::ScenePathView block) {
  BlockPlace place;
  place.list = moved_blocks(scene, {grf::ScenePath(block.begin(), block.end())}).front();
  place.before = place.list.back();
  place.list.pop_back();
  return place;
}

BlockPlace place_after(const grf::Scene& scene, grf::ScenePathView block) {
  BlockPlace place = place_before(scene, block);
  ++place.before;
  return place;
}

BlockPlace place_at_end(const grf::Scene& scene, grf::ScenePathView list) {
  BlockPlace place;
  place.list.assign(list.begin(), list.end());
  grf::Scene looked_at = scene;
  const bool is_scope = list.empty() && &outermost_blocks(looked_at) != &looked_at.contents;
  if (is_scope) place.list = {0};
  const grf::BlockList* blocks = grf::find_blocks(looked_at, place.list);
  if (blocks != nullptr)
    place.before = definitions_of(scene, place.list) + static_cast<std::uint32_t>(blocks->blocks.size());
  return place;
}

std::optional<TransformedObjects> move_objects(const grf::Scene& scene,
                                               const std::vector<grf::ScenePath>& paths,
                                               const BlockPlace& place, grf::Diagnostics& diagnostics) {
  const std::vector<grf::ScenePath> blocks = moved_blocks(scene, paths);
  if (!may_move(scene, blocks, place, diagnostics)) return std::nullopt;
  return move_blocks(scene, blocks, paths, place);
}

TransformedObjects shift_objects(const grf::Scene& scene, const std::vector<grf::ScenePath>& paths,
                                 int step) {
  TransformedObjects result{scene, paths};
  std::vector<grf::ScenePath> blocks = moved_blocks(scene, paths);
  if (step > 0) std::ranges::reverse(blocks);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const grf::ScenePath from = blocks[i];
    const grf::ScenePathView list = grf::ScenePathView(from).first(from.size() - 1);
    auto& siblings = grf::find_blocks(result.scene, list)->blocks;
    const std::int64_t place = std::int64_t(from.back()) - definitions_of(result.scene, list);
    if (place + step < 0 || place + step >= std::int64_t(siblings.size())) continue;
    grf::ScenePath to = from;
    to.back() += static_cast<std::uint32_t>(step);
    if (std::ranges::find(blocks, to) != blocks.end()) continue;
    std::swap(siblings[static_cast<std::size_t>(place)], siblings[static_cast<std::size_t>(place + step)]);
    for (auto* list_of_paths : {&blocks, &result.paths}) {
      for (grf::ScenePath& path : *list_of_paths) follow_exchange(path, from, to);
    }
  }
  return result;
}

std::optional<TransformedObjects> move_out_of_group(const grf::Scene& scene,
                                                    const std::vector<grf::ScenePath>& paths,
                                                    grf::Diagnostics& diagnostics) {
  grf::ScenePath group = moved_blocks(scene, {paths.back()}).front();
  do group.pop_back();
  while (!group.empty() && !std::holds_alternative<grf::Transform>(block_at(scene, group)->content));
  if (!group.empty()) return move_objects(scene, paths, place_after(scene, group), diagnostics);
  diagnostics.error({}, "the object is in no group");
  return std::nullopt;
}

std::optional<TransformedObjects> move_into_group(const grf::Scene& scene,
                                                  const std::vector<grf::ScenePath>& paths,
                                                  grf::Diagnostics& diagnostics) {
  const std::vector<grf::ScenePath> blocks = moved_blocks(scene, paths);
  grf::ScenePath group = moved_blocks(scene, {paths.back()}).front();
  const std::uint32_t first = definitions_of(scene, grf::ScenePathView(group).first(group.size() - 1));
  while (group.back() > first && std::ranges::find(blocks, group) != blocks.end()) --group.back();
  if (std::ranges::find(blocks, group) == blocks.end() && is_group(*block_at(scene, group)))
    return move_objects(scene, paths, place_at_end(scene, group), diagnostics);
  diagnostics.error({}, "there is no group in front of the object");
  return std::nullopt;
}

std::optional<TransformedObjects> group_objects(const grf::Scene& scene,
                                                const std::vector<grf::ScenePath>& paths,
                                                grf::Diagnostics& diagnostics) {
  std::vector<grf::ScenePath> blocks = moved_blocks(scene, paths);
  if (blocks.size() < 2) {
    diagnostics.error({}, "a group needs two objects or more");
    return std::nullopt;
  }
  BlockPlace place = place_before(scene, paths.back());
  for (const grf::ScenePath& block : blocks) {
    if (block.size() == place.list.size() + 1 && is_inside(block, place.list))
      place.before = std::min(place.before, block.back());
  }
  if (!may_move(scene, blocks, place, diagnostics)) return std::nullopt;
  grf::Scene grouped = scene;
  auto& list = grf::find_blocks(grouped, place.list)->blocks;
  grf::Block group;
  group.content = grf::Transform{{{Kind::Translation, grf::Vec3f(0)}}, {}};
  list.insert(list.begin() + (place.before - definitions_of(scene, place.list)), std::move(group));
  for (grf::ScenePath& block : blocks) follow_insertion(block, place, 1);
  // Any path inside the group tells where it is once the blocks were moved.
  TransformedObjects result = move_blocks(grouped, blocks, {blocks.front()}, {place.path(), 0});
  result.paths.front().resize(place.path().size());
  return result;
}

std::optional<TransformedObjects> ungroup_objects(const grf::Scene& scene,
                                                  const std::vector<grf::ScenePath>& paths,
                                                  grf::Diagnostics& diagnostics) {
  TransformedObjects result{scene, {}};
  std::vector<grf::ScenePath> groups = moved_blocks(scene, paths);
  std::ranges::reverse(groups);  // so that the paths of those that follow stay valid
  for (const grf::ScenePath& group : groups) {
    const grf::Block* block = block_at(result.scene, group);
    const auto* transform = block == nullptr ? nullptr : std::get_if<grf::Transform>(&block->content);
    if (transform == nullptr || transform->body.blocks.empty()) {
      diagnostics.error(block == nullptr ? grf::SourceLocation() : block->location,
                        "only groups can be ungrouped");
      return std::nullopt;
    }
    const BlockPlace place = {{group.begin(), group.end() - 1}, group.back()};
    std::vector<grf::ScenePath> children;
    for (std::uint32_t i = 0; i < transform->body.blocks.size(); ++i) {
      children.push_back(group);
      children.back().push_back(i);
    }
    const auto added = static_cast<std::uint32_t>(children.size()) - 1;
    for (grf::ScenePath& path : result.paths) follow_insertion(path, {place.list, place.before + 1}, added);
    TransformedObjects freed = move_blocks(result.scene, children, children, place);
    result.scene = std::move(freed.scene);
    result.paths.insert(result.paths.end(), freed.paths.begin(), freed.paths.end());
  }
  return result;
}

std::optional<TransformedObjects> use_definition(const grf::Scene& scene, grf::ScenePathView definition,
                                                 const BlockPlace& place, grf::Diagnostics& diagnostics) {
  const grf::Definition* defined = definition_at(scene, definition);
  TransformedObjects result{scene, {place.path()}};
  grf::BlockList* list = editable_blocks(result.scene, place.list);
  if (defined == nullptr || !std::holds_alternative<grf::Shared<grf::Mesh>>(defined->body) ||
      list == nullptr) {
    diagnostics.error(
        {}, list == nullptr ? "objects cannot be added to an included file" : "only meshes have instances");
    return std::nullopt;
  }
  const bool is_in_scope = std::ranges::any_of(definitions_at(scene, place.path()),
                                               [&](const auto& each) { return each.definition == defined; });
  if (!is_in_scope) {
    diagnostics.error(defined->location, fmt::format("'{}' is not defined there", defined->name));
    return std::nullopt;
  }
  grf::Block block;
  block.content = grf::Use{grf::Reference{defined->name, {}}};
  list->blocks.insert(list->blocks.begin() + (place.before - definitions_of(scene, place.list)),
                      std::move(block));
  return result;
}

}  // namespace editor
