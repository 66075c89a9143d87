#include "editor/document/material_text.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "editor/document/definitions.h"
#include "editor/document/references.h"
#include "grf/read.h"
#include "grf/relocate.h"
#include "grf/visit.h"
#include "grf/write.h"

namespace editor {
namespace {

/// The file name of a material in messages.
constexpr const char* MaterialName = "material";

/// The definitions that a surface refers to, directly or through terms of others, in the order of the scene.
std::vector<grf::Definition> needed_definitions(const std::vector<PlacedDefinition>& in_scope,
                                                const grf::Surface& surface) {
  std::vector<std::string> names;
  for_each_reference_of_surface(
      surface, [&names](const grf::Reference& reference) { names.push_back(reference.name); });
  grf::ScopeStack stack;
  for (const PlacedDefinition& placed : in_scope) stack.enter(*placed.definition);
  return grf::definitions_needed(names, stack.scope());
}

grf::Shared<grf::Mesh> square_with(const grf::Surface& surface) {
  grf::MeshDraft draft;
  draft.positions = {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}};
  draft.surfaces = {surface};
  draft.add_face(std::array<std::uint32_t, 4>{0, 1, 2, 3}, 0);
  return grf::Shared<grf::Mesh>(grf::Mesh(std::move(draft)));
}

/// The first face's surface, and the definitions in scope there.
struct ReadMaterial {
  grf::Surface surface;
  std::vector<grf::Definition> definitions;
};

std::optional<ReadMaterial> read_material(const std::string& text, grf::Diagnostics& diagnostics) {
  const auto scene = grf::read_text(text, MaterialName, diagnostics);
  if (!scene) return std::nullopt;
  std::optional<ReadMaterial> material;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    if (material || mesh.face_count() == 0) return;
    material = ReadMaterial{mesh.surface(0), {}};
    const auto in_scope = definitions_at(*scene, placement.path);
    material->definitions = needed_definitions(in_scope, material->surface);
  };
  grf::visit(*scene, visitor);
  if (!material) diagnostics.error({}, "the text has no mesh with a face whose surface could be pasted");
  return material;
}

/// A copy of a definition's body in which the terms have these names.
grf::Definition::Body renamed(grf::Definition::Body body, const std::map<std::string, std::string>& names) {
  if (auto* brdf = std::get_if<grf::BrdfModel>(&body)) {
    for_each_term(*brdf, [&names](grf::Reference& reference) {
      if (const auto name = names.find(reference.name); name != names.end()) reference.name = name->second;
    });
  }
  return body;
}

}  // namespace

std::string material_text(const grf::Scene& scene, grf::ScenePathView mesh, const grf::Surface& surface,
                          const std::string& file) {
  grf::Block square;
  square.content = square_with(surface);
  grf::DefinitionScope scope;
  scope.definitions = needed_definitions(definitions_at(scene, mesh), surface);
  grf::Scene material;
  if (scope.definitions.empty()) {
    material.contents.blocks.push_back(std::move(square));
  } else {
    scope.body.blocks.push_back(std::move(square));
    material.contents.blocks.emplace_back().content = std::move(scope);
  }
  const grf::Block* block = block_at(scene, mesh);
  const bool is_included = is_in_include(scene, mesh) && block != nullptr && block->location.file;
  const std::string& from = is_included ? block->location.file->path : file;
  return grf::to_text(grf::with_absolute_names(material, from));
}

std::optional<PastedMaterial> paste_material(const grf::Scene& scene,
                                             const std::vector<PlacedDefinition>& in_scope,
                                             const std::string& text, grf::Diagnostics& diagnostics) {
  const auto material = read_material(text, diagnostics);
  if (!material) return std::nullopt;
  PastedMaterial pasted{scene, material->surface};
  std::map<std::string, std::string> names;
  for (const grf::Definition& definition : material->definitions) {
    grf::Definition::Body body = renamed(definition.body, names);
    const auto same = std::ranges::find_if(in_scope, [&](const PlacedDefinition& each) {
      return each.definition->name == definition.name && each.definition->body == body;
    });
    if (same != in_scope.end()) continue;
    auto defined = define(pasted.scene, definition.name, std::move(body), diagnostics);
    if (!defined) return std::nullopt;
    names[definition.name] = defined->name;
    pasted.scene = std::move(defined->scene);
  }
  for_each_reference_of_surface(pasted.surface, [&names](grf::Reference& reference) {
    if (const auto name = names.find(reference.name); name != names.end()) reference.name = name->second;
  });
  return pasted;
}

}  // namespace editor
