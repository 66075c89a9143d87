#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>

#include "editor/document/model_import.h"
#include "editor/document/scene_objects.h"
#include "editor/jobs/background_job.h"
#include "grf/diagnostics.h"
#include "grf/source_location.h"

namespace editor {

/// What was made of a file.
struct LoadedScene {
  QString path;         ///< of that file
  ImportedModel model;  ///< of a GRF file: its scene, and what was said of it
  std::shared_ptr<const SceneObjects> objects;
};

/// What is wrong with a file.
struct LoadFailure {
  QString path;     ///< of that file
  QString message;  ///< the first error, and how many more there are
  grf::SourceLocation
      location;  ///< of that error, in this file or one that it includes; without a file: none
  grf::Diagnostics diagnostics;  ///< all errors
};

/// What is to be known of a scene that was read, a line each.
QStringList warnings_of(const LoadedScene& scene);

/// Whether a file is GRF by its name, and not a model that has to be imported.
bool is_grf(const QString& file);

/// Reads scenes in a thread, and models of other formats in a process of their own. The file asked for last
/// counts.
class SceneLoader : public QObject {
  Q_OBJECT

 public:
  explicit SceneLoader(QObject* parent = nullptr);

  void start(const QString& file);
  /// No signal comes any more.
  void cancel();

 signals:
  void loaded(std::shared_ptr<const editor::LoadedScene> scene);
  void failed(const editor::LoadFailure& failure);
  /// Whether it came to a scene or not: these were read, or would have been.
  void files_known(const QStringList& files);

 private:
  struct Outcome {
    std::shared_ptr<const LoadedScene> scene;  ///< null: there is none
    LoadFailure failure;
    QStringList files;
  };

  static Outcome read(const QString& file);
  static Outcome outcome_of(const QString& file, ImportedModel model);
  void take(const Outcome& outcome);
  void take_model(const std::shared_ptr<const ImportedModel>& model);

  QString file_;
  ModelImport import_;
  BackgroundJob<Outcome> reading_;
};

}  // namespace editor
