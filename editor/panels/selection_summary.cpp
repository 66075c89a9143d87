#include "editor/panels/selection_summary.h"

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

SelectionSummary summary_of(const Document& document) {
  const SceneObjects& objects = document.objects();
  const FaceSelection& selection = document.selection();
  SelectionSummary summary;
  summary.faces = selection.count();
  if (summary.faces == 0) return summary;
  summary.meshes = selected_meshes(document);
  const std::vector<std::uint32_t> meshes = selection.meshes();
  summary.are_all_of_mesh_lights =
      std::ranges::all_of(meshes, [&objects](std::uint32_t i) { return objects.meshes[i].is_light; });
  summary.area = selected_area(objects, selection);
  summary.surface = common_surface(objects, selection);
  summary.vertices = common_vertices(objects, selection);
  for (const PlacedDefinition& each : common_definitions(document.scene(), summary.meshes)) {
    const QString name = QString::fromStdString(each.definition->name);
    const grf::Definition::Body& body = each.definition->body;
    if (std::holds_alternative<grf::BrdfModel>(body)) summary.brdfs << name;
    if (std::holds_alternative<grf::PdfModel>(body)) summary.pdfs << name;
    if (std::holds_alternative<grf::Colour>(body)) summary.colours << name;
    if (std::holds_alternative<grf::Texture>(body)) summary.textures << name;
  }
  return summary;
}

QString why_not_reflecting(const SelectionSummary& summary) {
  if (!summary.are_all_of_mesh_lights) return {};
  return QCoreApplication::translate(
      "editor", "The faces belong to a mesh light, which has a radiance and does not reflect.");
}

}  // namespace editor
