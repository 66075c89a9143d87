#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <memory>

#include "editor/brdf/background_job.h"
#include "editor/document/model_import.h"
#include "editor/document/scene_objects.h"
#include "grf/diagnostics.h"
#include "grf/source_location.h"

namespace editor {

/// What was made of a file.
struct LoadedScene {
  QString path;  ///< of that file
  SceneObjects objects;
  QStringList warnings;
};

/// What is wrong with a file.
struct LoadFailure {
  QString path;     ///< of that file
  QString message;  ///< the first error, and how many more there are
  grf::SourceLocation
      location;  ///< of that error, in this file or one that it includes; without a file: none
};

/// Whether a file is GRF by its name, and not a model that has to be imported.
bool is_grf(const QString& file);

/// What is said of a file that was not read.
LoadFailure failure_of(const QString& file, const grf::Diagnostics& diagnostics);

/// Reads scenes to be looked at, in a thread, and models of other formats in a process of their own. The file
/// asked for last counts.
class SceneLoader : public QObject {
  Q_OBJECT

 public:
  explicit SceneLoader(QObject* parent = nullptr);

  void start(const QString& file);

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
  void take(const Outcome& outcome);
  void take_model(const std::shared_ptr<const ImportedModel>& model);

  QString file_;
  QTemporaryDir folder_;  ///< for images that stood inside models
  ModelImport import_;
  BackgroundJob<Outcome> reading_;
};

}  // namespace editor
