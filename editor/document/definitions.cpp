#include "editor/document/definitions.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "editor/document/references.h"
#include "grf/keywords.h"
#include "grf/visit.h"

namespace editor {
namespace {

/// A reference: its owner, and the definition that its name resolves to there (null: none).
struct FoundReference {
  grf::ScenePath owner;
  std::string name;
  const grf::Definition* definition = nullptr;
  const grf::Definition* from = nullptr;  ///< the definition that contains it; null if a block does
  std::size_t place = 0;  ///< index of the definition's place: a file may be included at several
};

/// All references of a scene in order, and the paths of each definition.
struct References {
  std::vector<FoundReference> all;
  std::unordered_map<const grf::Definition*, std::vector<grf::ScenePath>> places;
};

References references_of(const grf::Scene& scene) {
  References found;
  const auto adder = [&found](const grf::Placement& placement, const grf::Definition* from = nullptr) {
    return [&found, &placement, from](const grf::Reference& reference) {
      const grf::Definition* definition = placement.scope.find(reference.name);
      const auto places = found.places.find(definition);  // the last place where the definition was visited
      found.all.push_back({{placement.path.begin(), placement.path.end()},
                           reference.name,
                           definition,
                           from,
                           places == found.places.end() ? 0 : places->second.size() - 1});
    };
  };
  const auto add_mesh = [&adder](const grf::Mesh& mesh, const grf::Placement& placement,
                                 const grf::Definition* from = nullptr) {
    for (const grf::Surface& surface : mesh.surfaces)
      for_each_reference_of_surface(surface, adder(placement, from));
  };
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    if (placement.instance_of == nullptr) add_mesh(mesh, placement);
  };
  visitor.mesh_light = [&](const grf::MeshLight& light, const grf::Placement& placement, const grf::Block&) {
    add_mesh(*light.mesh, placement);
  };
  visitor.use = [&](const grf::Use& use, const grf::Placement& placement, const grf::Block&) {
    adder(placement)(use.mesh);
  };
  visitor.definition = [&](const grf::Definition& definition, const grf::Placement& placement) {
    found.places[&definition].emplace_back(placement.path.begin(), placement.path.end());
    if (const auto* brdf = std::get_if<grf::BrdfModel>(&definition.body)) {
      for_each_term(*brdf, adder(placement, &definition));
    } else if (const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body)) {
      add_mesh(**mesh, placement, &definition);
    }
  };
  grf::visit(scene, visitor);
  return found;
}

/// The definitions that blocks refer to, and those that these refer to. Definitions refer to earlier ones, so
/// one pass backwards from the last reference finds them all, however long the chains are: a second pass is
/// for files that are included at several places.
std::set<const grf::Definition*> used_definitions(const References& references) {
  std::set<const grf::Definition*> used;
  std::size_t before = 0;
  do {
    before = used.size();
    for (auto reference = references.all.rbegin(); reference != references.all.rend(); ++reference) {
      const bool counts = reference->from == nullptr || used.contains(reference->from);
      if (counts && reference->definition != nullptr) used.insert(reference->definition);
    }
  } while (used.size() != before);
  return used;
}

/// Renames the references of one block or definition.
void rename_in(grf::Scene& scene, const grf::ScenePath& owner, const std::string& from,
               const std::string& to) {
  const auto rename = [&](grf::Reference& reference) {
    if (reference.name == from) reference.name = to;
  };
  if (grf::Shared<grf::Mesh>* mesh = grf::find_mesh(scene, owner)) {
    for (grf::Surface& surface : mesh->edit().surfaces) for_each_reference_of_surface(surface, rename);
    return;
  }
  const grf::ScenePlace place = grf::find(scene, owner);
  if (place.definition != nullptr) {
    if (auto* brdf = std::get_if<grf::BrdfModel>(&place.definition->body)) for_each_term(*brdf, rename);
  } else if (auto* use = std::get_if<grf::Use>(&place.block->content)) {
    rename(use->mesh);
  }
}

/// Whether references resolve to the same definitions as before, at the same paths.
bool mean_the_same(const References& before, const References& after) {
  const auto place = [](const References& references, const FoundReference& reference) {
    const auto found = references.places.find(reference.definition);
    return found == references.places.end() ? grf::ScenePath() : found->second[reference.place];
  };
  return std::equal(
      before.all.begin(), before.all.end(), after.all.begin(), after.all.end(),
      [&](const FoundReference& a, const FoundReference& b) { return place(before, a) == place(after, b); });
}

/// Reports a term that does not resolve to a BRDF at a path.
bool has_its_terms(const grf::Definition::Body& body, const std::vector<PlacedDefinition>& in_force,
                   const grf::SourceLocation& location, grf::Diagnostics& diagnostics) {
  const auto* brdf = std::get_if<grf::BrdfModel>(&body);
  if (brdf == nullptr) return true;
  for (const grf::CombineTerm& term : brdf->terms) {
    const bool is_there = std::ranges::any_of(in_force, [&term](const PlacedDefinition& each) {
      return each.definition->name == term.brdf.name &&
             std::holds_alternative<grf::BrdfModel>(each.definition->body);
    });
    if (is_there) continue;
    diagnostics.error(location, fmt::format("no BRDF '{}' is defined in that scope", term.brdf.name));
    return false;
  }
  return true;
}

std::set<std::string> taken_names(const grf::Scene& scene) {
  std::set<std::string> taken;
  const auto take_models = [&taken](const grf::Surface& surface) {
    const auto take = [&taken](const auto& attribute) {
      if (!attribute) return;
      if (const auto* model = std::get_if<0>(&*attribute)) taken.insert(model->keyword);
    };
    take(surface.brdf);
    take(surface.pdf);
  };
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    if (placement.instance_of != nullptr) return;
    for (const grf::Surface& surface : mesh.surfaces) take_models(surface);
  };
  visitor.definition = [&](const grf::Definition& definition, const grf::Placement&) {
    taken.insert(definition.name);
    if (const auto* brdf = std::get_if<grf::BrdfModel>(&definition.body)) taken.insert(brdf->keyword);
    if (const auto* pdf = std::get_if<grf::PdfModel>(&definition.body)) taken.insert(pdf->keyword);
    if (const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body)) {
      for (const grf::Surface& surface : (*mesh)->surfaces) take_models(surface);
    }
  };
  grf::visit(scene, visitor);
  return taken;
}

bool may_be_called(const std::string& name, const grf::Definition& definition,
                   grf::Diagnostics& diagnostics) {
  if (grf::is_identifier(name)) return true;
  diagnostics.error(definition.location,
                    fmt::format("'{}' is not a valid name: use only letters, digits, '_' and '$', no digit "
                                "first, and none of begin, end, def, none, use, true, false",
                                name));
  return false;
}

}  // namespace

std::unordered_map<const grf::Definition*, std::size_t> count_uses(
    const grf::Scene& scene, const std::vector<grf::ScenePath>& without) {
  const std::set<grf::ScenePath> left_out(without.begin(), without.end());
  const auto is_left_out = [&left_out](grf::ScenePath owner) {
    for (; !left_out.empty() && !owner.empty(); owner.pop_back()) {
      if (left_out.contains(owner)) return true;
    }
    return false;
  };
  std::unordered_map<const grf::Definition*, std::size_t> uses;
  for (const FoundReference& reference : references_of(scene).all) {
    if (reference.definition != nullptr && !is_left_out(reference.owner)) ++uses[reference.definition];
  }
  return uses;
}

bool names_a_definition(const grf::Surface& surface) {
  bool names = false;
  for_each_reference_of_surface(surface, [&names](const grf::Reference&) { names = true; });
  return names;
}

std::string fresh_name(const grf::Scene& scene, const std::string& wanted) {
  const std::set<std::string> taken = taken_names(scene);
  const std::string base = grf::is_identifier(wanted) ? wanted : grf::to_identifier(wanted);
  std::string name = base;
  for (int number = 2; taken.contains(name); ++number) name = fmt::format("{}_{}", base, number);
  return name;
}

bool keeps_references(const grf::Scene& scene, const std::vector<grf::ScenePath>& blocks,
                      grf::ScenePathView place, grf::Diagnostics& diagnostics) {
  std::unordered_map<std::string_view, const grf::Definition*> there;
  for (const PlacedDefinition& each : definitions_at(scene, place))
    there.emplace(each.definition->name, each.definition);
  const References references = references_of(scene);
  for (const FoundReference& reference : references.all) {
    if (reference.definition == nullptr) continue;
    const auto block = std::ranges::find_if(
        blocks, [&](const grf::ScenePath& each) { return is_inside(reference.owner, each); });
    if (block == blocks.end()) continue;
    const bool is_own = std::ranges::any_of(
        references.places.at(reference.definition),
        [&](const grf::ScenePath& each) { return each != *block && is_inside(each, *block); });
    const auto found = there.find(reference.name);
    if (is_own || (found != there.end() && found->second == reference.definition)) continue;
    diagnostics.error(reference.definition->location,
                      fmt::format("it uses '{}', which {} there", reference.name,
                                  found == there.end() ? "is not defined" : "is the name of something else"));
    return false;
  }
  return true;
}

std::optional<Defined> define(const grf::Scene& scene, const std::string& wanted_name,
                              grf::Definition::Body body, grf::Diagnostics& diagnostics) {
  const DefinitionInsertion insertion = DefinitionInsertion::outermost(scene);
  Defined defined = {scene, fresh_name(scene, wanted_name), insertion.definition_path()};
  grf::Definition definition;
  definition.name = defined.name;
  definition.body = std::move(body);
  insertion.apply(defined.scene, definition);
  if (!has_its_terms(definition.body, definitions_at(defined.scene, defined.path), {}, diagnostics)) {
    return std::nullopt;
  }
  return defined;
}

std::optional<grf::Scene> change_definition(const grf::Scene& scene, grf::ScenePathView path,
                                            const grf::Definition::Body& body,
                                            grf::Diagnostics& diagnostics) {
  const grf::Definition* definition = definition_at(scene, path);
  if (definition == nullptr || definition->body.index() != body.index()) {
    diagnostics.error({}, fmt::format("there is no {} definition at that place", grf::kind_of(body)));
    return std::nullopt;
  }
  if (!has_its_terms(body, definitions_at(scene, path), definition->location, diagnostics))
    return std::nullopt;
  const References references = references_of(scene);
  grf::Scene changed = scene;
  for (const grf::ScenePath& place : references.places.at(definition)) {
    grf::find(changed, place).definition->body = body;
  }
  return changed;
}

std::optional<grf::Scene> rename_definition(const grf::Scene& scene, grf::ScenePathView path,
                                            const std::string& name, grf::Diagnostics& diagnostics) {
  const grf::Definition* definition = definition_at(scene, path);
  if (definition == nullptr) {
    diagnostics.error({}, "there is no definition at that place");
    return std::nullopt;
  }
  if (!may_be_called(name, *definition, diagnostics)) return std::nullopt;
  if (definition->name == name) return scene;
  const References before = references_of(scene);
  const auto& around = std::get<grf::DefinitionScope>(block_at(scene, path.first(path.size() - 1))->content);
  const bool is_taken = std::ranges::any_of(
      around.definitions, [&name](const grf::Definition& other) { return other.name == name; });
  grf::Scene changed = scene;
  for (const grf::ScenePath& place : before.places.at(definition)) {
    grf::find(changed, place).definition->name = name;
  }
  for (const FoundReference& reference : before.all) {
    if (reference.definition == definition) rename_in(changed, reference.owner, definition->name, name);
  }
  if (is_taken || !mean_the_same(before, references_of(changed))) {
    diagnostics.error(definition->location, fmt::format("'{}' is the name of another definition", name));
    return std::nullopt;
  }
  return changed;
}

grf::Scene remove_unused_definitions(const grf::Scene& scene) {
  const References references = references_of(scene);
  const std::set<const grf::Definition*> used = used_definitions(references);
  std::vector<grf::ScenePath> unused;
  for (const auto& [definition, places] : references.places) {
    if (!used.contains(definition)) unused.insert(unused.end(), places.begin(), places.end());
  }
  grf::Scene changed = scene;
  erase(changed, std::move(unused));
  return changed;
}

FaceSelection faces_with(const grf::Scene& scene, const SceneObjects& objects, grf::ScenePathView path) {
  FaceSelection faces(objects);
  const grf::Definition* definition = definition_at(scene, path);
  if (const auto mesh = objects.mesh_at(path)) faces.set_mesh(*mesh);
  if (definition == nullptr) return faces;
  std::map<grf::ScenePath, std::uint32_t> meshes;
  for (std::uint32_t i = 0; i < objects.meshes.size(); ++i) meshes.emplace(objects.meshes[i].path, i);
  const auto add = [&](const grf::Mesh& mesh, const grf::Placement& placement) {
    std::vector<bool> has(mesh.surfaces.size());
    for (std::size_t i = 0; i < has.size(); ++i) {
      for_each_reference_of_surface(mesh.surfaces[i], [&](const grf::Reference& reference) {
        if (placement.scope.find(reference.name) == definition) has[i] = true;
      });
    }
    const auto number = meshes.find({placement.path.begin(), placement.path.end()});
    if (number != meshes.end()) select_surfaces(mesh, number->second, has, faces);
  };
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    if (placement.instance_of == nullptr) add(mesh, placement);
  };
  visitor.mesh_light = [&](const grf::MeshLight& light, const grf::Placement& placement, const grf::Block&) {
    add(*light.mesh, placement);
  };
  visitor.definition = [&](const grf::Definition& each, const grf::Placement& placement) {
    if (const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&each.body)) add(**mesh, placement);
  };
  grf::visit(scene, visitor);
  return faces;
}

}  // namespace editor
