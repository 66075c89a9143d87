#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>

#include "editor/document/import_folder.h"
#include "editor/programs/child_process.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace editor {

/// A model of another format as a scene. Images that stood inside it are files beside `path` now.
struct ImportedModel {
  grf::Scene scene;
  QString path;                                ///< from which the scene names other files; it is gone
  QStringList losses;                          ///< what the scene has not, a line a kind
  grf::Diagnostics diagnostics;                ///< all that was said, the losses among it
  std::shared_ptr<const ImportFolder> folder;  ///< where the images are; null: there are none
};

/// Reads a model in a process of its own, `grfconvert`, so that a file which crashes a reader, or wants all
/// memory, is no more than a message here.
class ModelImport : public QObject {
  Q_OBJECT

 public:
  /// Images that stood inside models get folders in `parent_folder`.
  explicit ModelImport(QString parent_folder, QObject* parent = nullptr);
  ~ModelImport() override;

  static QString default_folder();
  /// Patterns of all formats that are read, for a file dialog: "*.obj".
  static QStringList name_patterns();

  /// How much memory an import may take, in GB (2^30 bytes), which the settings keep; 4 until it is set.
  static double memory_limit();
  static void set_memory_limit(double gigabytes);

  /// How long the import of a file of so many bytes may take, in seconds: a damaged one can keep a reader
  /// busy for ever.
  static int time_limit(qint64 bytes);

  bool is_running() const { return process_ != nullptr || reading_.isRunning(); }
  /// `options` are those of `grfconvert`, such as {"--up", "z"}. One file at a time.
  void start(const QString& file, const QStringList& options = {});
  /// Ends it, without waiting for that, and nothing is left. No signal comes.
  void cancel();

 signals:
  void done(std::shared_ptr<const ImportedModel> model);
  /// What is wrong with the file, in words that name it.
  void failed(const QString& message);

 private:
  void run(const QString& program, const QStringList& arguments);
  void read_output(const ChildEnd& end);
  void fail(const QString& message);

  const QString parent_;
  QString file_;
  std::shared_ptr<const ImportFolder> folder_;  ///< null: none is being imported
  QString output_;
  QByteArray report_;
  QByteArray messages_;
  /// Imports what is wanted now; others of its kind are coming to their end.
  ChildProcess* process_ = nullptr;
  QFutureWatcher<std::shared_ptr<const ImportedModel>> reading_;
};

}  // namespace editor
