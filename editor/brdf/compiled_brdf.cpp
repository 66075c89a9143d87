#include "editor/brdf/compiled_brdf.h"

#include <algorithm>
#include <set>

#include "grf/check.h"
#include "renderer/reflectance/brdf_maker.h"
#include "renderer/reflectance/scheme.h"

namespace editor {
namespace {

/// A catalogue without the models' albedos, which are slow to compute and are shown elsewhere.
const grf::Catalogue& catalogue() {
  static const grf::Catalogue all = [] {
    grf::Catalogue models = reflectance::catalogue();
    for (grf::ModelInfo& info : models.brdfs) info.largest_albedo = nullptr;
    return models;
  }();
  return all;
}

/// A scene that defines the BRDF where the names refer to BRDFs, for `grf::check`: errors of other
/// definitions are not this BRDF's.
grf::Scene scene_of(const grf::BrdfModel& model, const Definitions& definitions) {
  grf::DefinitionScope others;
  for (const QString& name : brdf_names(definitions)) {
    grf::BrdfModel harmless;
    harmless.keyword = "diffuse";
    others.definitions.push_back({name.toStdString(), harmless, {}, {}});
  }
  grf::DefinitionScope own;
  own.definitions.push_back({"brdf-in-the-editor", model, {}, {}});
  grf::Scene scene;
  if (others.definitions.empty()) {
    scene.contents.blocks.push_back({std::move(own), {}, {}});
  } else {
    others.body.blocks.push_back({std::move(own), {}, {}});
    scene.contents.blocks.push_back({std::move(others), {}, {}});
  }
  return scene;
}

void enter(grf::ScopeStack& stack, const Definitions& definitions) {
  for (const grf::Definition& one : definitions) stack.enter(one);
}

bool is_right(const grf::BrdfModel& model, const Definitions& definitions, grf::Diagnostics& diagnostics) {
  return grf::check(scene_of(model, definitions), catalogue(), diagnostics);
}

}  // namespace

std::vector<QString> error_messages(const grf::Diagnostics& diagnostics) {
  std::vector<QString> messages;
  for (const grf::Diagnostic& one : diagnostics.entries()) {
    if (one.severity == grf::Severity::Error) messages.push_back(QString::fromStdString(one.message));
  }
  return messages;
}

std::vector<QString> brdf_names(const Definitions& definitions) {
  std::vector<QString> names;
  std::set<QString> seen;
  for (auto one = definitions.rbegin(); one != definitions.rend(); ++one) {
    const QString name = QString::fromStdString(one->name);
    const bool is_new = seen.insert(name.toLower()).second;
    if (is_new && std::holds_alternative<grf::BrdfModel>(one->body)) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

CompiledBrdf compile_brdf(const grf::BrdfModel& model, const Definitions& definitions) {
  grf::Diagnostics diagnostics;
  CompiledBrdf made;
  if (is_right(model, definitions, diagnostics)) {
    grf::ScopeStack stack;
    enter(stack, definitions);
    auto brdf = reflectance::BrdfMaker(diagnostics).make(model, stack.scope());
    if (brdf) made.brdf = std::make_shared<const reflectance::Brdf>(*std::move(brdf));
  }
  made.errors = error_messages(diagnostics);
  return made;
}

bool reads_data(const grf::BrdfModel& model, const Definitions& definitions) {
  grf::Diagnostics ignored_diagnostics;
  reflectance::BrdfMaker maker(ignored_diagnostics);
  grf::ScopeStack stack;
  enter(stack, definitions);
  const auto leaves = maker.models_of(model, stack.scope());
  return std::ranges::any_of(leaves, [](const grf::BrdfModel* leaf) { return !leaf->data_file.empty(); });
}

std::vector<QString> errors_of(const grf::BrdfModel& model, const Definitions& definitions) {
  grf::Diagnostics diagnostics;
  is_right(model, definitions, diagnostics);
  return error_messages(diagnostics);
}

}  // namespace editor
