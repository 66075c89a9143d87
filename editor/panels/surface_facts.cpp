#include "editor/panels/surface_facts.h"

#include <QCoreApplication>
#include <algorithm>
#include <variant>

#include "editor/document/scene_places.h"

namespace editor {

std::vector<grf::ScenePath> selected_meshes(const Document& document) {
  std::vector<grf::ScenePath> paths;
  for (const std::uint32_t i : document.selection().meshes()) {
    paths.push_back(document.objects().meshes[i].path);
  }
  return paths;
}

SurfaceFacts facts_of(const Document& document) {
  const SceneObjects& objects = document.objects();
  const FaceSelection& selection = document.selection();
  SurfaceFacts facts;
  facts.faces = selection.count();
  if (facts.faces == 0) return facts;
  facts.meshes = selected_meshes(document);
  const std::vector<std::uint32_t> meshes = selection.meshes();
  facts.are_all_of_mesh_lights =
      std::ranges::all_of(meshes, [&objects](std::uint32_t i) { return objects.meshes[i].is_light; });
  facts.area = selected_area(objects, selection);
  facts.surface = common_surface(objects, selection);
  facts.vertices = common_vertices(objects, selection);
  for (const PlacedDefinition& each : common_definitions(document.scene(), facts.meshes)) {
    const QString name = QString::fromStdString(each.definition->name);
    const grf::Definition::Body& body = each.definition->body;
    if (std::holds_alternative<grf::BrdfModel>(body)) facts.brdfs << name;
    if (std::holds_alternative<grf::PdfModel>(body)) facts.pdfs << name;
    if (std::holds_alternative<grf::Colour>(body)) facts.colours << name;
    if (std::holds_alternative<grf::Texture>(body)) facts.textures << name;
  }
  return facts;
}

QString why_not_reflecting(const SurfaceFacts& facts) {
  if (!facts.are_all_of_mesh_lights) return {};
  return QCoreApplication::translate(
      "editor", "The faces belong to a mesh light, which has a radiance and does not reflect.");
}

}  // namespace editor
