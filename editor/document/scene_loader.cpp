#include "editor/document/scene_loader.h"

#include <QFileInfo>
#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "converters/format.h"
#include "editor/document/reimport.h"
#include "grf/read.h"

namespace editor {
namespace {

/// Formats a message without the excerpt, which needs a fixed-width font.
QString line_of(const grf::Diagnostic& diagnostic) {
  return QString::fromStdString(grf::to_text(diagnostic)).section('\n', 0, 0);
}

QString with_more(const QString& message, std::size_t errors) {
  if (errors <= 1) return message;
  return errors == 2 ? SceneLoader::tr("%1 (and 1 more error)").arg(message)
                     : SceneLoader::tr("%1 (and %2 more errors)").arg(message).arg(errors - 1);
}

LoadFailure failure_of(const QString& file, grf::Diagnostics diagnostics) {
  const auto& entries = diagnostics.entries();
  const auto first = std::ranges::find_if(
      entries, [](const grf::Diagnostic& entry) { return entry.severity == grf::Severity::Error; });
  LoadFailure failure = {file, SceneLoader::tr("Cannot read %1").arg(file), {}, {}};
  if (first != entries.end()) {
    failure.message = with_more(line_of(*first), diagnostics.error_count());
    failure.location = first->location;
  }
  failure.diagnostics = std::move(diagnostics);
  return failure;
}

}  // namespace

QStringList warnings_of(const LoadedScene& scene) {
  if (!is_grf(scene.path)) return scene.model.losses;
  QStringList warnings;
  for (const grf::Diagnostic& entry : scene.model.diagnostics.entries()) warnings.append(line_of(entry));
  return warnings;
}

bool is_grf(const QString& file) {
  const convert::Format* format = convert::format_of_name(file.toStdString());
  return format != nullptr && format->name == "grf";
}

SceneLoader::SceneLoader(QObject* parent)
    : QObject(parent), import_(ModelImport::default_folder()), reading_(this) {
  connect(&import_, &ModelImport::done, this, &SceneLoader::take_model);
  connect(&import_, &ModelImport::failed, this, [this](const QString& message) {
    LoadFailure failure = {file_, message.section('\n', 0, 0), {}, {}};
    failure.diagnostics.error({}, message.toStdString());
    emit failed(failure);
  });
}

void SceneLoader::start(const QString& file) {
  file_ = QFileInfo(file).absoluteFilePath();
  cancel();
  if (is_grf(file_)) {
    reading_.start([file = file_](const StopFlag&) { return read(file); },
                   [this](const Outcome& outcome) { take(outcome); });
  } else {
    emit files_known({file_});
    import_.start(file_);
  }
}

void SceneLoader::cancel() {
  import_.cancel();
  reading_.stop();
}

SceneLoader::Outcome SceneLoader::outcome_of(const QString& file, ImportedModel model) {
  auto loaded = std::make_shared<LoadedScene>();
  loaded->path = file;
  loaded->objects = std::make_shared<const SceneObjects>(objects_of(model.scene, model.path.toStdString()));
  loaded->model = std::move(model);
  if (is_grf(file)) loaded->state = read_editor_state(file, *loaded->objects, loaded->model.diagnostics);
  Outcome outcome;
  outcome.scene = std::move(loaded);
  outcome.files.append(file);
  return outcome;
}

SceneLoader::Outcome SceneLoader::read(const QString& file) {
  Outcome outcome;
  ImportedModel model;
  model.path = file;
  auto scene = grf::read(file.toStdString(), model.diagnostics);
  const std::set<std::string> files = model.diagnostics.files();
  if (scene) {
    model.scene = std::move(*scene);
    outcome = outcome_of(file, std::move(model));
  } else {
    outcome.failure = failure_of(file, std::move(model.diagnostics));
    outcome.files.append(file);
  }
  for (const std::string& path : files) outcome.files.append(QString::fromStdString(path));
  return outcome;
}

void SceneLoader::take_model(const std::shared_ptr<const ImportedModel>& model) {
  reading_.start(
      [file = file_, model](const StopFlag&) {
        ImportedModel marked = *model;
        mark_imported(marked.scene, file);
        return outcome_of(file, std::move(marked));
      },
      [this](const Outcome& outcome) { take(outcome); });
}

void SceneLoader::take(const Outcome& outcome) {
  emit files_known(outcome.files);
  if (outcome.scene) {
    emit loaded(outcome.scene);
  } else {
    emit failed(outcome.failure);
  }
}

}  // namespace editor
