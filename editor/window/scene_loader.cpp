#include "editor/window/scene_loader.h"

#include <QFileInfo>
#include <algorithm>

#include "converters/format.h"
#include "grf/read.h"

namespace editor {
namespace {

/// Without the excerpt, which wants a fixed font.
QString line_of(const grf::Diagnostic& diagnostic) {
  return QString::fromStdString(grf::to_text(diagnostic)).section('\n', 0, 0);
}

QString with_more(const QString& message, std::size_t errors) {
  if (errors <= 1) return message;
  return errors == 2 ? SceneLoader::tr("%1 (and 1 more error)").arg(message)
                     : SceneLoader::tr("%1 (and %2 more errors)").arg(message).arg(errors - 1);
}

QStringList warnings_of(const grf::Diagnostics& diagnostics) {
  QStringList warnings;
  for (const grf::Diagnostic& entry : diagnostics.entries()) warnings.append(line_of(entry));
  return warnings;
}

}  // namespace

bool is_grf(const QString& file) {
  const convert::Format* format = convert::format_of_name(file.toStdString());
  return format != nullptr && format->name == "grf";
}

LoadFailure failure_of(const QString& file, const grf::Diagnostics& diagnostics) {
  const auto& entries = diagnostics.entries();
  const auto first = std::find_if(entries.begin(), entries.end(), [](const grf::Diagnostic& entry) {
    return entry.severity == grf::Severity::Error;
  });
  if (first == entries.end()) return {file, SceneLoader::tr("%1 cannot be read").arg(file), {}};
  return {file, with_more(line_of(*first), diagnostics.error_count()), first->location};
}

SceneLoader::SceneLoader(QObject* parent) : QObject(parent), import_(folder_.path()), reading_(this) {
  connect(&import_, &ModelImport::done, this, &SceneLoader::take_model);
  connect(&import_, &ModelImport::failed, this, [this](const QString& message) {
    emit failed({file_, message.section('\n', 0, 0), {}});
  });
}

void SceneLoader::start(const QString& file) {
  file_ = QFileInfo(file).absoluteFilePath();
  import_.cancel();
  reading_.stop();
  if (is_grf(file_)) {
    reading_.start([file = file_](const StopFlag&) { return read(file); },
                   [this](const Outcome& outcome) { take(outcome); });
  } else {
    emit files_known({file_});
    import_.start(file_);
  }
}

SceneLoader::Outcome SceneLoader::read(const QString& file) {
  Outcome outcome;
  grf::Diagnostics diagnostics;
  const auto scene = grf::read(file.toStdString(), diagnostics);
  if (scene) {
    outcome.scene = std::make_shared<const LoadedScene>(
        LoadedScene{file, objects_of(*scene, file.toStdString()), warnings_of(diagnostics)});
  } else {
    outcome.failure = failure_of(file, diagnostics);
  }
  outcome.files.append(file);
  for (const std::string& path : diagnostics.files()) outcome.files.append(QString::fromStdString(path));
  return outcome;
}

void SceneLoader::take_model(const std::shared_ptr<const ImportedModel>& model) {
  reading_.start(
      [file = file_, model](const StopFlag&) {
        Outcome outcome;
        outcome.scene = std::make_shared<const LoadedScene>(
            LoadedScene{file, objects_of(model->scene, model->path.toStdString()), model->losses});
        outcome.files.append(file);
        return outcome;
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
