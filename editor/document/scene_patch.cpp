#include "editor/document/scene_patch.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <tuple>
#include <utility>

#include "editor/document/definitions.h"
#include "editor/document/scene_places.h"
#include "grf/relocate.h"

namespace editor {
namespace {

/// A block without what stands inside it.
grf::Block head_of(const grf::Block& block) {
  grf::Block head;
  head.comments = block.comments;
  head.location = block.location;
  if (const auto* transform = std::get_if<grf::Transform>(&block.content)) {
    head.content = grf::Transform{transform->steps, {}};
  } else if (const auto* include = std::get_if<grf::Include>(&block.content)) {
    head.content = grf::Include{include->file, {}, include->origin};
  }
  return head;
}

/// How many elements two lists begin and end with alike, where the second begins after the first ends.
struct Alike {
  std::size_t first = 0;
  std::size_t last = 0;
};

template <class T>
Alike alike(const std::vector<T>& a, const std::vector<T>& b) {
  const std::size_t least = std::min(a.size(), b.size());
  Alike alike;
  while (alike.first < least && a[alike.first] == b[alike.first]) ++alike.first;
  while (alike.last < least - alike.first && a[a.size() - 1 - alike.last] == b[b.size() - 1 - alike.last]) {
    ++alike.last;
  }
  return alike;
}

template <class T>
std::vector<T> between(const std::vector<T>& list, const Alike& alike) {
  return {list.begin() + static_cast<std::ptrdiff_t>(alike.first),
          list.end() - static_cast<std::ptrdiff_t>(alike.last)};
}

template <class T>
void splice(std::vector<T>& list, std::size_t first, std::size_t count, const std::vector<T>& replacement) {
  const auto place = list.begin() + static_cast<std::ptrdiff_t>(first);
  const std::size_t kept = std::min(count, replacement.size());
  const auto rest = std::copy_n(replacement.begin(), kept, place);
  if (count > kept) {
    list.erase(rest, place + static_cast<std::ptrdiff_t>(count));
  } else {
    list.insert(rest, replacement.begin() + static_cast<std::ptrdiff_t>(kept), replacement.end());
  }
}

grf::ScenePath path_in(grf::ScenePath path, std::size_t number) {
  path.push_back(static_cast<std::uint32_t>(number));
  return path;
}

}  // namespace

/// Walks two scenes at once and notes where they differ. Lists of one length are compared pair by pair.
class ScenePatch::Finder {
 public:
  void compare(const grf::BlockList& before, const grf::BlockList& after, const grf::ScenePath& path,
               std::size_t definitions = 0) {
    if (before.end_comments != after.end_comments) {
      add(EndCommentsPart{path, before.end_comments, after.end_comments});
    }
    const Alike same = alike(before.blocks, after.blocks);
    if (before.blocks.size() != after.blocks.size()) {
      add(BlocksPart{path, same.first, editor::between(before.blocks, same),
                     editor::between(after.blocks, same)});
      return;
    }
    for (std::size_t i = same.first; i + same.last < before.blocks.size(); ++i) {
      compare(before.blocks[i], after.blocks[i], path, i, definitions);
    }
  }

  ScenePatch take() { return std::move(patch_); }

 private:
  template <class Content>
  void add(Content content) {
    patch_.parts_.push_back({is_included_, std::move(content)});
  }

  void compare(const grf::Block& before, const grf::Block& after, const grf::ScenePath& list,
               std::size_t number, std::size_t definitions) {
    if (before == after) return;
    const bool is_of_a_kind = before.content.index() == after.content.index();
    const bool has_parts = !std::holds_alternative<grf::AreaLight>(before.content) &&
                           !std::holds_alternative<grf::Params>(before.content) &&
                           !std::holds_alternative<grf::Use>(before.content);
    if (!is_of_a_kind || !has_parts) {
      add(BlocksPart{list, number, {before}, {after}});
      return;
    }
    const grf::ScenePath path = path_in(list, definitions + number);
    grf::Block head = head_of(before);
    grf::Block head_after = head_of(after);
    if (!(head == head_after)) add(HeadPart{path, std::move(head), std::move(head_after)});
    std::visit(
        [&]<class Content>(const Content& content) {
          compare_inside(content, std::get<Content>(after.content), path);
        },
        before.content);
  }

  void compare_inside(const grf::Shared<grf::Mesh>& before, const grf::Shared<grf::Mesh>& after,
                      const grf::ScenePath& path) {
    if (!(before == after)) add(mesh_part(path, *before, *after));
  }
  void compare_inside(const grf::MeshLight& before, const grf::MeshLight& after, const grf::ScenePath& path) {
    compare_inside(before.mesh, after.mesh, path);
  }
  void compare_inside(const grf::Transform& before, const grf::Transform& after, const grf::ScenePath& path) {
    compare(before.body, after.body, path);
  }
  void compare_inside(const grf::Include& before, const grf::Include& after, const grf::ScenePath& path) {
    if (before.contents.shares(after.contents)) return;
    const bool was_included = std::exchange(is_included_, true);
    compare(*before.contents, *after.contents, path);
    is_included_ = was_included;
  }
  // Definitions come first: paths in the body count them.
  void compare_inside(const grf::DefinitionScope& before, const grf::DefinitionScope& after,
                      const grf::ScenePath& path) {
    compare_definitions(before.definitions, after.definitions, path);
    compare(before.body, after.body, path, after.definitions.size());
  }
  template <class Content>
  void compare_inside(const Content&, const Content&, const grf::ScenePath&) {}

  void compare_definitions(const std::vector<grf::Definition>& before,
                           const std::vector<grf::Definition>& after, const grf::ScenePath& path) {
    const Alike same = alike(before, after);
    if (before.size() != after.size()) {
      add(DefinitionsPart{path, same.first, editor::between(before, same), editor::between(after, same)});
      return;
    }
    for (std::size_t i = same.first; i + same.last < before.size(); ++i) {
      const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&before[i].body);
      const auto* mesh_after = std::get_if<grf::Shared<grf::Mesh>>(&after[i].body);
      const bool is_of_same_name = before[i].name == after[i].name && before[i].comments == after[i].comments;
      if (mesh != nullptr && mesh_after != nullptr && is_of_same_name) {
        compare_inside(*mesh, *mesh_after, path_in(path, i));
      } else if (!(before[i] == after[i])) {
        add(DefinitionsPart{path, i, {before[i]}, {after[i]}});
      }
    }
  }

  ScenePatch patch_;
  bool is_included_ = false;
};

ScenePatch ScenePatch::between(const grf::Scene& before, const grf::Scene& after) {
  Finder finder;
  finder.compare(before.contents, after.contents, {});
  return finder.take();
}

ScenePatch ScenePatch::of_meshes(const grf::Scene& before, const std::vector<PlacedMesh>& after) {
  ScenePatch patch;
  for (const PlacedMesh& each : after) {
    const grf::Mesh* there = mesh_at(before, each.path);
    if (there == nullptr || *there == each.mesh) continue;
    patch.parts_.push_back({is_in_include(before, each.path), mesh_part(each.path, *there, each.mesh)});
  }
  return patch;
}

ScenePatch::MeshPart ScenePatch::mesh_part(grf::ScenePath path, const grf::Mesh& before,
                                           const grf::Mesh& after) {
  MeshPart part;
  part.path = std::move(path);
  const bool have_same_shape = before.name == after.name && before.comments == after.comments &&
                               before.geometry == after.geometry && before.irradiance == after.irradiance;
  if (!have_same_shape) {
    part.whole = WholeMeshes{before, after};
    return part;
  }
  const Alike same = alike(before.surfaces, after.surfaces);
  part.first = same.first;
  part.before = editor::between(before.surfaces, same);
  part.after = editor::between(after.surfaces, same);
  if (before.surface_of_face.shares(after.surface_of_face)) return part;
  for (std::uint32_t face = 0; face < before.face_count(); ++face) {
    const std::uint32_t from = (*before.surface_of_face)[face];
    const std::uint32_t to = (*after.surface_of_face)[face];
    if (from == to) continue;
    FaceRun* last = part.runs.empty() ? nullptr : &part.runs.back();
    if (last != nullptr && last->first + last->count == face && last->before == from && last->after == to) {
      ++last->count;
    } else {
      part.runs.push_back({face, 1, from, to});
    }
  }
  return part;
}

void ScenePatch::apply(grf::Scene& before) const {
  for (const Part& part : parts_) {
    std::visit([&](const auto& each) { put(each, true, before); }, part.content);
  }
}

void ScenePatch::revert(grf::Scene& after) const {
  for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) {
    std::visit([&](const auto& each) { put(each, false, after); }, part->content);
  }
}

void ScenePatch::put(const MeshPart& part, bool is_forward, grf::Scene& scene) {
  grf::Shared<grf::Mesh>* shared = grf::find_mesh(scene, part.path);
  if (shared == nullptr) return;
  if (part.whole) {
    *shared = is_forward ? part.whole->after : part.whole->before;
    return;
  }
  grf::Mesh& mesh = shared->edit();
  const auto& [from, to] = is_forward ? std::tie(part.before, part.after) : std::tie(part.after, part.before);
  splice(mesh.surfaces, part.first, from.size(), to);
  if (part.runs.empty()) return;
  const auto begin = mesh.surface_of_face.edit().begin();
  for (const FaceRun& run : part.runs) {
    std::fill_n(begin + run.first, run.count, is_forward ? run.after : run.before);
  }
}

void ScenePatch::put(const BlocksPart& part, bool is_forward, grf::Scene& scene) {
  const auto& [from, to] = is_forward ? std::tie(part.before, part.after) : std::tie(part.after, part.before);
  splice(grf::find_blocks(scene, part.list)->blocks, part.first, from.size(), to);
}

void ScenePatch::put(const DefinitionsPart& part, bool is_forward, grf::Scene& scene) {
  auto& scope = std::get<grf::DefinitionScope>(grf::find(scene, part.list).block->content);
  const auto& [from, to] = is_forward ? std::tie(part.before, part.after) : std::tie(part.after, part.before);
  splice(scope.definitions, part.first, from.size(), to);
}

void ScenePatch::put(const HeadPart& part, bool is_forward, grf::Scene& scene) {
  grf::Block& block = *grf::find(scene, part.path).block;
  const grf::Block& head = is_forward ? part.after : part.before;
  block.comments = head.comments;
  block.location = head.location;
  if (const auto* transform = std::get_if<grf::Transform>(&head.content)) {
    std::get<grf::Transform>(block.content).steps = transform->steps;
  } else if (const auto* include = std::get_if<grf::Include>(&head.content)) {
    auto& changed = std::get<grf::Include>(block.content);
    changed.file = include->file;
    changed.origin = include->origin;
  }
}

void ScenePatch::put(const EndCommentsPart& part, bool is_forward, grf::Scene& scene) {
  grf::find_blocks(scene, part.list)->end_comments = is_forward ? part.after : part.before;
}

void ScenePatch::add_to(Change& change, const MeshPart& part) {
  if (part.whole) {
    const grf::Mesh& before = *part.whole->before;
    const grf::Mesh& after = *part.whole->after;
    change.is_structural = change.is_structural || !(before.geometry == after.geometry);
    change.names = change.names || before.name != after.name;
  }
  const auto name_anything = [](const std::vector<grf::Surface>& surfaces) {
    return std::any_of(surfaces.begin(), surfaces.end(), names_a_definition);
  };
  change.references = change.references || part.whole.has_value() || !part.runs.empty() ||
                      name_anything(part.before) || name_anything(part.after);
}

void ScenePatch::add_to(Change& change, const BlocksPart& part) {
  const auto is_light = [](const grf::Block& block) {
    return std::holds_alternative<grf::AreaLight>(block.content) ||
           std::holds_alternative<grf::Params>(block.content);
  };
  const bool are_lights = part.before.size() == part.after.size() &&
                          std::all_of(part.before.begin(), part.before.end(), is_light) &&
                          std::all_of(part.after.begin(), part.after.end(), is_light);
  (are_lights ? change.lights : change.is_structural) = true;
}

void ScenePatch::add_to(Change& change, const DefinitionsPart& part) {
  const auto is_mesh = [](const grf::Definition& definition) {
    return std::holds_alternative<grf::Shared<grf::Mesh>>(definition.body);
  };
  const bool have_same_names = std::equal(
      part.before.begin(), part.before.end(), part.after.begin(), part.after.end(),
      [&](const auto& a, const auto& b) { return a.name == b.name && !is_mesh(a) && !is_mesh(b); });
  (have_same_names ? change.definitions : change.is_structural) = true;
}

void ScenePatch::add_to(Change& change, const HeadPart&) { change.is_structural = true; }

void ScenePatch::add_to(Change&, const EndCommentsPart&) {}

Change ScenePatch::change() const {
  Change change;
  for (const Part& part : parts_) {
    std::visit([&change](const auto& content) { add_to(change, content); }, part.content);
  }
  return change;
}

std::set<grf::ScenePath> ScenePatch::meshes() const {
  std::set<grf::ScenePath> paths;
  for (const Part& part : parts_) {
    if (const auto* mesh = std::get_if<MeshPart>(&part.content)) paths.insert(mesh->path);
  }
  return paths;
}

/// A later change of the same thing is taken up, so that the ticks of a slider are one change.
bool ScenePatch::continues(MeshPart& part, const MeshPart& later) {
  const bool follows = part.path == later.path && !part.whole && !later.whole && later.runs.empty() &&
                       part.first == later.first && part.after.size() == later.before.size();
  if (!follows) return false;
  part.after = later.after;
  return true;
}

template <class Item>
bool ScenePatch::continues(ListPart<Item>& part, const ListPart<Item>& later) {
  if (part.list != later.list || part.first != later.first || part.after.size() != later.before.size()) {
    return false;
  }
  part.after = later.after;
  return true;
}

bool ScenePatch::continues(HeadPart& part, const HeadPart& later) {
  if (part.path != later.path) return false;
  part.after = later.after;
  return true;
}

bool ScenePatch::continues(EndCommentsPart& part, const EndCommentsPart& later) {
  if (part.list != later.list) return false;
  part.after = later.after;
  return true;
}

void ScenePatch::append(const ScenePatch& later) {
  const auto take_up = [](Part& part, const Part& next) {
    return std::visit(
        [&next]<class Content>(Content& content) {
          const auto* of_next = std::get_if<Content>(&next.content);
          return of_next != nullptr && continues(content, *of_next);
        },
        part.content);
  };
  std::vector<Part> continued = parts_;
  if (std::equal(continued.begin(), continued.end(), later.parts_.begin(), later.parts_.end(), take_up)) {
    parts_ = std::move(continued);
  } else {
    parts_.insert(parts_.end(), later.parts_.begin(), later.parts_.end());
  }
}

void ScenePatch::relocate(const std::string& from, const std::string& to,
                          const std::map<std::string, std::string>& moved) {
  const auto relocate_all = [&](auto& list) { grf::relocate(std::span(list), from, to, moved); };
  for (Part& part : parts_) {
    if (part.is_included) continue;
    if (auto* mesh = std::get_if<MeshPart>(&part.content)) {
      if (mesh->whole) {
        relocate_all(mesh->whole->before.edit().surfaces);
        relocate_all(mesh->whole->after.edit().surfaces);
      }
      relocate_all(mesh->before);
      relocate_all(mesh->after);
    } else if (auto* blocks = std::get_if<BlocksPart>(&part.content)) {
      relocate_all(blocks->before);
      relocate_all(blocks->after);
    } else if (auto* definitions = std::get_if<DefinitionsPart>(&part.content)) {
      relocate_all(definitions->before);
      relocate_all(definitions->after);
    } else if (auto* head = std::get_if<HeadPart>(&part.content)) {
      grf::relocate(std::span(&head->before, 1), from, to, moved);
      grf::relocate(std::span(&head->after, 1), from, to, moved);
    }
  }
}

}  // namespace editor
