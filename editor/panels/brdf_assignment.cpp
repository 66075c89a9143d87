#include "editor/panels/brdf_assignment.h"

#include <QCoreApplication>
#include <algorithm>
#include <string>
#include <variant>

#include "editor/document/brdf_mime.h"
#include "editor/document/scene_places.h"
#include "editor/panels/selection_summary.h"
#include "grf/write.h"

namespace editor {
namespace {

/// Whether the name refers to the dragged BRDF at all these paths. A name from another scene, or from a scope
/// that the faces are not in, may refer to something else there.
bool means_it(const std::string& name, const QMimeData& mime, const std::vector<PlacedDefinition>& in_scope) {
  return std::ranges::any_of(in_scope, [&](const PlacedDefinition& each) {
    const auto* brdf = std::get_if<grf::BrdfModel>(&each.definition->body);
    return brdf != nullptr && each.definition->name == name &&
           grf::to_text(self_contained(*brdf)) == mime.data(BrdfMimeType).toStdString();
  });
}

}  // namespace

bool assign_brdf(Document& document, const grf::Catalogue& catalogue, const QMimeData& mime,
                 grf::Diagnostics& diagnostics) {
  const std::vector<grf::ScenePath> meshes = selected_meshes(document);
  if (meshes.empty()) {
    diagnostics.error({}, "no selected face can be assigned a BRDF");
    return false;
  }
  QString name = QString::fromUtf8(mime.data(BrdfNameMimeType));
  SurfaceEdit edit;
  if (means_it(name.toStdString(), mime, common_definitions(document.scene(), meshes))) {
    edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(grf::Reference{name.toStdString(), {}});
  } else {
    const auto brdf = brdf_of(mime, catalogue.brdfs, diagnostics);
    if (!brdf || !grf::check(*brdf, catalogue.brdfs, "BRDF", diagnostics)) return false;
    if (name.isEmpty()) name = QString::fromStdString(brdf->keyword);
    edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(*brdf);
  }
  document.edit_surfaces(QCoreApplication::translate("editor::BrdfAssignment", "Assign %1").arg(name), edit);
  return true;
}

}  // namespace editor
