#include "editor/document/scene_patch.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "editor/document/definitions.h"
#include "editor/document/scene_places.h"
#include "grf/relocate.h"

namespace editor {
namespace {

using namespace patch;

/// A block without its children.
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

/// The differing middle between the common beginning and end of two lists.
template <class Part, class Item>
Part list_part(const grf::ScenePath& path, const std::vector<Item>& before, const std::vector<Item>& after) {
  const auto [first, first_after] = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  const auto last = std::mismatch(before.rbegin(), std::make_reverse_iterator(first), after.rbegin(),
                                  std::make_reverse_iterator(first_after));
  Part part;
  part.path = path;
  part.first = static_cast<std::size_t>(first - before.begin());
  part.before.assign(first, last.first.base());
  part.after.assign(first_after, last.second.base());
  return part;
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

template <class Item>
void put_items(const ListPart<Item>& part, bool is_forward, std::vector<Item>& list) {
  const auto& [from, to] = is_forward ? std::tie(part.before, part.after) : std::tie(part.after, part.before);
  splice(list, part.first, from.size(), to);
}

grf::ScenePath path_in(grf::ScenePath path, std::size_t number) {
  path.push_back(static_cast<std::uint32_t>(number));
  return path;
}

std::variant<SurfacesPart, MeshPart> mesh_part(grf::ScenePath path, const grf::Mesh& before,
                                               const grf::Mesh& after) {
  const bool have_same_shape = before.name == after.name && before.comments == after.comments &&
                               before.geometry == after.geometry && before.irradiance == after.irradiance;
  if (!have_same_shape) return MeshPart{std::move(path), before, after};
  auto part = list_part<SurfacesPart>(path, before.surfaces, after.surfaces);
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

/// Traverses two scenes in parallel and records the differences. Lists of equal length are compared element
/// by element.
class Finder {
 public:
  void compare(const grf::BlockList& before, const grf::BlockList& after, const grf::ScenePath& path,
               std::size_t definitions = 0) {
    if (before.end_comments != after.end_comments) {
      add(list_part<ListPart<std::string>>(path, before.end_comments, after.end_comments));
    }
    compare_items(before.blocks, after.blocks, path, [&](std::size_t number) {
      compare(before.blocks[number], after.blocks[number], path, number, definitions);
    });
  }
  void compare(const grf::Mesh& before, const grf::Mesh& after, const grf::ScenePath& path) {
    std::visit([this](auto&& part) { add(std::forward<decltype(part)>(part)); },
               mesh_part(path, before, after));
  }

  std::vector<Part> take() { return std::move(parts_); }

 private:
  template <class Content>
  void add(Content content) {
    parts_.push_back({is_included_, std::move(content)});
  }

  template <class Item, class Compare>
  void compare_items(const std::vector<Item>& before, const std::vector<Item>& after,
                     const grf::ScenePath& path, const Compare& compare_pair) {
    if (before.size() != after.size()) return add(list_part<ListPart<Item>>(path, before, after));
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (!(before[i] == after[i])) compare_pair(i);
    }
  }

  void compare(const grf::Block& before, const grf::Block& after, const grf::ScenePath& list,
               std::size_t number, std::size_t definitions) {
    const bool is_of_a_kind = before.content.index() == after.content.index();
    const bool has_parts = !std::holds_alternative<grf::AreaLight>(before.content) &&
                           !std::holds_alternative<grf::Params>(before.content) &&
                           !std::holds_alternative<grf::Use>(before.content);
    if (!is_of_a_kind || !has_parts) return add(ListPart<grf::Block>{list, number, {before}, {after}});
    const grf::ScenePath path = path_in(list, definitions + number);
    grf::Block head = head_of(before);
    grf::Block head_after = head_of(after);
    if (!(head == head_after)) add(HeadPart{{path, 0, {std::move(head)}, {std::move(head_after)}}});
    std::visit(
        [&]<class Content>(const Content& content) {
          compare_inside(content, std::get<Content>(after.content), path);
        },
        before.content);
  }

  void compare_inside(const grf::Shared<grf::Mesh>& before, const grf::Shared<grf::Mesh>& after,
                      const grf::ScenePath& path) {
    if (!(before == after)) compare(*before, *after, path);
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
  // Definitions come first, since paths in the body count them.
  void compare_inside(const grf::DefinitionScope& before, const grf::DefinitionScope& after,
                      const grf::ScenePath& path) {
    compare_items(before.definitions, after.definitions, path, [&](std::size_t number) {
      compare(before.definitions[number], after.definitions[number], path, number);
    });
    compare(before.body, after.body, path, after.definitions.size());
  }
  template <class Content>
  void compare_inside(const Content&, const Content&, const grf::ScenePath&) {}

  void compare(const grf::Definition& before, const grf::Definition& after, const grf::ScenePath& scope,
               std::size_t number) {
    const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&before.body);
    const auto* mesh_after = std::get_if<grf::Shared<grf::Mesh>>(&after.body);
    const bool is_of_same_name = before.name == after.name && before.comments == after.comments;
    if (mesh != nullptr && mesh_after != nullptr && is_of_same_name) {
      compare_inside(*mesh, *mesh_after, path_in(scope, number));
    } else {
      add(ListPart<grf::Definition>{scope, number, {before}, {after}});
    }
  }

  std::vector<Part> parts_;
  bool is_included_ = false;
};

void put(const MeshPart& part, bool is_forward, grf::Scene& scene) {
  *grf::find_mesh(scene, part.path) = is_forward ? part.after : part.before;
}

void put(const SurfacesPart& part, bool is_forward, grf::Scene& scene) {
  grf::Mesh& mesh = grf::find_mesh(scene, part.path)->edit();
  put_items(part, is_forward, mesh.surfaces);
  if (part.runs.empty()) return;
  const auto begin = mesh.surface_of_face.edit().begin();
  for (const FaceRun& run : part.runs) {
    std::fill_n(begin + run.first, run.count, is_forward ? run.after : run.before);
  }
}

void put(const ListPart<grf::Block>& part, bool is_forward, grf::Scene& scene) {
  put_items(part, is_forward, grf::find_blocks(scene, part.path)->blocks);
}

void put(const ListPart<std::string>& part, bool is_forward, grf::Scene& scene) {
  put_items(part, is_forward, grf::find_blocks(scene, part.path)->end_comments);
}

void put(const ListPart<grf::Definition>& part, bool is_forward, grf::Scene& scene) {
  auto& scope = std::get<grf::DefinitionScope>(grf::find(scene, part.path).block->content);
  put_items(part, is_forward, scope.definitions);
}

void put(const HeadPart& part, bool is_forward, grf::Scene& scene) {
  grf::Block& block = *grf::find(scene, part.path).block;
  const grf::Block& head = is_forward ? part.after.front() : part.before.front();
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

bool name_anything(const std::vector<grf::Surface>& surfaces) {
  return std::ranges::any_of(surfaces, names_a_definition);
}

void add_to(Change& change, const MeshPart& part) {
  const bool have_same_surfaces = part.before->surfaces == part.after->surfaces &&
                                  part.before->surface_of_face == part.after->surface_of_face;
  change.is_structural = change.is_structural || !(part.before->geometry == part.after->geometry);
  change.names = change.names || part.before->name != part.after->name;
  change.references = change.references || !have_same_surfaces;
}

void add_to(Change& change, const SurfacesPart& part) {
  change.references =
      change.references || !part.runs.empty() || name_anything(part.before) || name_anything(part.after);
}

void add_to(Change& change, const ListPart<grf::Block>& part) {
  const auto is_light = [](const grf::Block& block) {
    return std::holds_alternative<grf::AreaLight>(block.content) ||
           std::holds_alternative<grf::Params>(block.content);
  };
  const bool are_lights = part.before.size() == part.after.size() &&
                          std::ranges::all_of(part.before, is_light) &&
                          std::ranges::all_of(part.after, is_light);
  (are_lights ? change.lights : change.is_structural) = true;
}

void add_to(Change& change, const ListPart<grf::Definition>& part) {
  const auto is_mesh = [](const grf::Definition& definition) {
    return std::holds_alternative<grf::Shared<grf::Mesh>>(definition.body);
  };
  const bool have_same_names = std::equal(
      part.before.begin(), part.before.end(), part.after.begin(), part.after.end(),
      [&](const auto& a, const auto& b) { return a.name == b.name && !is_mesh(a) && !is_mesh(b); });
  (have_same_names ? change.definitions : change.is_structural) = true;
}

void add_to(Change& change, const HeadPart& part) {
  const bool is_transform = std::holds_alternative<grf::Transform>(part.before.front().content);
  (is_transform ? change.transforms : change.is_structural) = true;
}

void add_to(Change&, const ListPart<std::string>&) {}

/// Merges a later change of the same thing, so that the steps of a slider are one change.
template <class Content>
bool continues(Content& part, const Content& later) {
  if (part.path != later.path) return false;
  if constexpr (std::is_same_v<Content, MeshPart>) {
    part.after = later.after;
    return true;
  } else {
    if (part.first != later.first || part.after.size() != later.before.size()) return false;
    if constexpr (std::is_same_v<Content, SurfacesPart>) {
      if (!later.runs.empty()) return false;
    }
    part.after = later.after;
    return true;
  }
}

}  // namespace

ScenePatch ScenePatch::between(const grf::Scene& before, const grf::Scene& after) {
  Finder finder;
  finder.compare(before.contents, after.contents, {});
  ScenePatch patch;
  patch.parts_ = finder.take();
  return patch;
}

ScenePatch ScenePatch::of_meshes(const grf::Scene& before, const std::vector<PlacedMesh>& after) {
  ScenePatch patch;
  for (const PlacedMesh& each : after) {
    const grf::Mesh* there = mesh_at(before, each.path);
    if (there == nullptr || *there == each.mesh) continue;
    const bool is_included = is_in_include(before, each.path);
    std::visit(
        [&](auto&& part) {
          patch.parts_.push_back({is_included, std::forward<decltype(part)>(part)});
        },
        mesh_part(each.path, *there, each.mesh));
  }
  return patch;
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
    if (const auto* surfaces = std::get_if<SurfacesPart>(&part.content)) paths.insert(surfaces->path);
    if (const auto* mesh = std::get_if<MeshPart>(&part.content)) paths.insert(mesh->path);
  }
  return paths;
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
    std::visit(
        [&]<class Content>(Content& content) {
          if constexpr (std::is_same_v<Content, MeshPart>) {
            relocate_all(content.before.edit().surfaces);
            relocate_all(content.after.edit().surfaces);
          } else if constexpr (!std::is_same_v<Content, ListPart<std::string>>) {
            relocate_all(content.before);
            relocate_all(content.after);
          }
        },
        part.content);
  }
}

}  // namespace editor
