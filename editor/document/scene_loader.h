#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>

#include "editor/document/editor_state.h"
#include "editor/document/model_import.h"
#include "editor/document/scene_objects.h"
#include "editor/jobs/background_job.h"
#include "grf/diagnostics.h"
#include "grf/source_location.h"

namespace editor {

/// A scene that was read or imported.
struct LoadedScene {
  QString path;         ///< of the file
  ImportedModel model;  ///< of a GRF file: its scene and diagnostics
  std::shared_ptr<const SceneObjects> objects;
  EditorState state;  ///< of the editor's file beside a GRF file
};

/// Why a file could not be loaded.
struct LoadFailure {
  QString path;     ///< of the file
  QString message;  ///< the first error, and the number of further ones
  grf::SourceLocation
      location;  ///< of that error, in this file or an included one; without a file if there is none
  grf::Diagnostics diagnostics;  ///< all errors
};

/// The warnings of a loaded scene, one per line.
QStringList warnings_of(const LoadedScene& scene);

/// Whether a file is GRF by its name, and not a model to import.
bool is_grf(const QString& file);

/// Reads scenes in a thread, and imports models of other formats in a child process. Only the last request
/// counts.
class SceneLoader : public QObject {
  Q_OBJECT

 public:
  explicit SceneLoader(QObject* parent = nullptr);

  void start(const QString& file);
  /// Cancels loading; no signal follows.
  void cancel();

 signals:
  void loaded(std::shared_ptr<const editor::LoadedScene> scene);
  void failed(const editor::LoadFailure& failure);
  /// Emitted with the files that were read, or would have been, on success and on failure.
  void files_known(const QStringList& files);

 private:
  struct Outcome {
    std::shared_ptr<const LoadedScene> scene;  ///< null after an error
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
