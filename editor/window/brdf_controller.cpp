#include "editor/window/brdf_controller.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "editor/brdf/brdf_editor.h"
#include "editor/document/brdf_mime.h"
#include "editor/document/definitions.h"
#include "editor/document/scene_places.h"
#include "editor/panels/selection_summary.h"
#include "renderer/reflectance/brdf.h"

namespace editor {
namespace {

/// Merges the steps of one drag of a control into one undo step.
const QString GestureKey = QStringLiteral("brdf of the selection");

/// The definition that a name refers to, the innermost of which come last; null if there is none.
template <class Body>
const PlacedDefinition* named(const std::vector<PlacedDefinition>& definitions, const std::string& name) {
  const auto found =
      std::find_if(definitions.rbegin(), definitions.rend(), [&](const PlacedDefinition& each) {
        return each.definition->name == name && std::holds_alternative<Body>(each.definition->body);
      });
  return found == definitions.rend() ? nullptr : &*found;
}

/// The sampling scheme that all selected faces share, if any.
std::optional<grf::PdfModel> common_scheme(const Document& document,
                                           const std::vector<PlacedDefinition>& definitions) {
  const auto pdf = common_surface(document.objects(), document.selection()).pdf;
  if (pdf.is_mixed || !pdf.value) return std::nullopt;
  if (const auto* model = std::get_if<grf::PdfModel>(&*pdf.value)) return *model;
  const auto* definition = named<grf::PdfModel>(definitions, std::get<grf::Reference>(*pdf.value).name);
  return definition == nullptr ? std::nullopt
                               : std::optional(std::get<grf::PdfModel>(definition->definition->body));
}

}  // namespace

BrdfController::BrdfController(Document& document, BrdfEditor& editor, QObject* parent)
    : QObject(parent), document_(document), editor_(editor) {
  connect(&document_, &Document::selection_changed, this, &BrdfController::show_selection);
  connect(&document_, &Document::changed, this, &BrdfController::show_selection);
  connect(&editor_, &BrdfEditor::changing, this, &BrdfController::change);
  connect(&editor_, &BrdfEditor::edited, this, &BrdfController::finish);
  connect(&editor_, &BrdfEditor::definition_chosen, this, &BrdfController::share);
  show_selection();
}

std::vector<BrdfController::Subject> BrdfController::subjects_of_selection() const {
  std::vector<Subject> subjects;
  for (const MeshBrdf& each : selected_brdfs(document_.objects(), document_.selection())) {
    Subject subject;
    if (!each.brdf) {
      subject.model = reflectance::default_model();
      subject.is_default = true;
    } else if (const auto* model = std::get_if<grf::BrdfModel>(&*each.brdf)) {
      subject.model = *model;
    } else {
      const auto there = definitions_at(document_.scene(), document_.objects().meshes[each.mesh].path);
      const PlacedDefinition* definition =
          named<grf::BrdfModel>(there, std::get<grf::Reference>(*each.brdf).name);
      if (definition == nullptr) continue;
      subject.model = std::get<grf::BrdfModel>(definition->definition->body);
      subject.definition = definition->path;
    }
    if (std::ranges::find(subjects, subject) == subjects.end()) subjects.push_back(subject);
  }
  return subjects;
}

void BrdfController::show_selection() {
  if (is_changing_) return;
  subjects_ = subjects_of_selection();
  const auto placed = common_definitions(document_.scene(), selected_meshes(document_));
  Definitions definitions;
  for (const PlacedDefinition& each : placed) definitions.push_back(*each.definition);
  editor_.set_definitions(definitions);
  std::vector<grf::BrdfModel> models;
  models.reserve(subjects_.size());
  for (const Subject& subject : subjects_) models.push_back(subject.model);
  editor_.set_models(models);
  editor_.set_scheme(common_scheme(document_, placed));
}

SurfaceEdit BrdfController::edit_of(const grf::Surface& surface,
                                    const std::vector<grf::BrdfModel>& models) const {
  SurfaceEdit edit;
  for (std::size_t i = 0; i < subjects_.size(); ++i) {
    const Subject& subject = subjects_[i];
    if (subject.definition) continue;
    const auto* model = surface.brdf ? std::get_if<grf::BrdfModel>(&*surface.brdf) : nullptr;
    const bool is_it = surface.brdf ? model != nullptr && *model == subject.model : subject.is_default;
    if (is_it) edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(models[i]);
  }
  return edit;
}

void BrdfController::change(const std::vector<grf::BrdfModel>& models) {
  if (models.size() != subjects_.size() || models.empty()) return;
  is_changing_ = true;
  const SurfaceEdits edits = [&](const grf::Surface& surface) { return edit_of(surface, models); };
  const auto is_shared = [](const Subject& subject) { return subject.definition.has_value(); };
  if (std::ranges::any_of(subjects_, is_shared)) {
    change_definitions(edits, models);
  } else {
    document_.edit_surfaces(tr("Edit the BRDF"), edits, GestureKey);
  }
  is_changing_ = false;
  for (std::size_t i = 0; i < models.size(); ++i) {
    subjects_[i].model = models[i];
    subjects_[i].is_default = false;
  }
}

/// Edits definitions and inline BRDFs in one undo step.
void BrdfController::change_definitions(const SurfaceEdits& edits,
                                        const std::vector<grf::BrdfModel>& models) {
  grf::Diagnostics diagnostics;
  std::optional<grf::Scene> scene = document_.scene();
  for (PlacedMesh& placed : edited(document_.objects(), document_.selection(), edits)) {
    *grf::find_mesh(*scene, placed.path) = std::move(placed.mesh);
  }
  for (std::size_t i = 0; scene && i < models.size(); ++i) {
    if (!subjects_[i].definition) continue;
    scene = change_definition(*scene, *subjects_[i].definition, models[i], diagnostics);
  }
  if (!scene) return emit failed(QString::fromStdString(diagnostics.to_text()));
  document_.replace(tr("Edit the BRDF"), std::move(*scene), GestureKey);
}

void BrdfController::finish(const std::vector<grf::BrdfModel>& models) {
  change(models);
  document_.finish_gesture();
}

std::optional<grf::BrdfModel> BrdfController::common_brdf() const {
  if (subjects_.size() != 1) return std::nullopt;
  return self_contained(subjects_.front().model);
}

std::vector<grf::Definition> BrdfController::common_brdf_definitions() const {
  std::vector<grf::Definition> definitions;
  for (const PlacedDefinition& placed : common_definitions(document_.scene(), selected_meshes(document_))) {
    if (!std::holds_alternative<grf::BrdfModel>(placed.definition->body)) continue;
    definitions.push_back(*placed.definition);
    auto& brdf = std::get<grf::BrdfModel>(definitions.back().body);
    brdf = self_contained(std::move(brdf));
  }
  return definitions;
}

void BrdfController::assign(const grf::BrdfModel& brdf) {
  if (document_.selection().empty()) return emit failed(tr("No faces are selected to apply the BRDF to."));
  SurfaceEdit edit;
  edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(brdf);
  document_.edit_surfaces(tr("Apply the BRDF"), edit);
}

void BrdfController::share(const QString& name) {
  SurfaceEdit edit;
  edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(grf::Reference{name.toStdString(), {}});
  document_.edit_surfaces(tr("Assign %1").arg(name), edit);
}

}  // namespace editor
