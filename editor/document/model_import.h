#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

#include "editor/document/import_folder.h"
#include "editor/programs/child_process.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/options/render_options.h"

namespace editor {

/// An imported model of another format as a scene. Its embedded images are files beside `path`.
struct ImportedModel {
  grf::Scene scene;
  QString path;        ///< path to which the scene's file names are relative; the file itself is gone
  QStringList losses;  ///< what the import lost, one line per kind
  grf::Diagnostics diagnostics;                ///< all messages, including the losses
  std::shared_ptr<const ImportFolder> folder;  ///< folder of the images; null if there are none
  std::vector<options::NamedCamera> cameras;
};

/// Imports a model in a child process, `grfconvert`, so that a file which crashes a reader, or exceeds the
/// memory limit, is only an error message.
class ModelImport : public QObject {
  Q_OBJECT

 public:
  /// Embedded images are stored in folders in `parent_folder`.
  explicit ModelImport(QString parent_folder, QObject* parent = nullptr);
  ~ModelImport() override;

  static QString default_folder();
  /// File name patterns of all readable formats, for a file dialog: "*.obj".
  static QStringList name_patterns();

  /// The memory limit of an import in GB (2^30 bytes), stored in the settings; 4 by default.
  static double memory_limit();
  static void set_memory_limit(double gigabytes);

  /// The time limit for importing a file of so many bytes, in seconds: a damaged file can keep a reader busy
  /// for ever.
  static int time_limit(qint64 bytes);

  bool is_running() const { return process_ != nullptr || reading_.isRunning(); }
  /// Starts an import; `options` are those of `grfconvert`, such as {"--up", "z"}. One file at a time.
  void start(const QString& file, const QStringList& options = {});
  /// Cancels the import without waiting, and removes its files. No signal follows.
  void cancel();

 signals:
  void done(std::shared_ptr<const ImportedModel> model);
  /// Emitted with the error, which names the file.
  void failed(const QString& message);

 private:
  void run(const QString& program, const QStringList& arguments);
  void read_output(const ChildEnd& end);
  void fail(const QString& message);

  const QString parent_;
  QString file_;
  std::shared_ptr<const ImportFolder> folder_;  ///< null while nothing is being imported
  QString output_;  ///< the converted file, with an OP file of the same name beside it
  QByteArray report_;
  QByteArray messages_;
  /// The process of the current import; cancelled ones are still ending.
  ChildProcess* process_ = nullptr;
  QFutureWatcher<std::shared_ptr<const ImportedModel>> reading_;
};

}  // namespace editor
