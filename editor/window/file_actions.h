#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "editor/document/scene_loader.h"
#include "editor/jobs/background_job.h"
#include "editor/window/outside_changes.h"
#include "grf/diagnostics.h"

class QAction;
class QMenu;
class QWidget;

namespace editor {

class Document;
class Job;
class JobList;
struct ExportRequest;
struct SaveRequest;
struct SaveResult;

/// When the options of an import are asked for.
enum class AskOptions {
  Never,         ///< those remembered for the type of the file are used
  UnlessHidden,  ///< not if the user has hidden them for the type
  Always
};

/// The file commands: new, open, recent, import, append, save, revert, export. Slow ones are jobs: reading
/// has one queue, writing another.
class FileActions : public QObject {
  Q_OBJECT

 public:
  /// Dialogs belong to the window; document and jobs outlive it.
  FileActions(Document& document, JobList& jobs, QWidget& window);
  ~FileActions() override;

  /// Adds the entries of the File menu, in order.
  void fill(QMenu& menu);

  /// Starts an empty scene; asks first if there are unsaved changes.
  void start_new();
  /// Asks for files, and opens them.
  void ask_and_open();
  /// Opens or imports the first file, and appends the others in one undo step; asks first if there are
  /// unsaved changes. Of several models of one type the options are asked for once.
  void open(const QStringList& files, AskOptions asks = AskOptions::Never);
  void open(const QString& file) { open(QStringList(file)); }
  /// Appends files in one undo step.
  void merge(const QStringList& files, AskOptions asks = AskOptions::Never);
  void merge(const QString& file) { merge(QStringList(file)); }
  /// Reads the file again from which the active object was imported, or another one if it is gone. Its faces
  /// keep what was assigned to them.
  void reimport();
  /// Saves to the scene's file, or asks for one. `then` is called once it is saved, after a question if it
  /// was edited meanwhile.
  void save(const std::function<void()>& then = {});
  /// Asks before it overwrites what the document has not read, such as changes by another program.
  void save_as(const QString& file, const std::function<void()>& then = {});
  /// Reloads the scene's file; asks first if that discards unsaved changes.
  void revert();
  void export_to(const QString& file);
  /// Calls `then` at once if nothing is unsaved or being written; else, when writing is done, asks whether to
  /// save, discard or keep editing.
  void leave(const std::function<void()>& then);

  /// Detects which of the scene's files other programs have changed.
  OutsideChanges& outside_changes() { return outside_; }

  /// Whether an open or import is running or queued.
  bool is_importing() const;
  /// Whether a save or export is running or queued.
  bool is_saving() const;

 signals:
  /// Emitted with the outcome, for the status line.
  void done(const QString& message);
  void failed(const QString& message);
  /// Emitted with the diagnostics of a file that could not be opened, or that was appended or written.
  void reported(const grf::Diagnostics& diagnostics);
  /// Emitted when no open or import is running any more.
  void idle();

 private:
  void make_actions();
  void ask_where_to_save(const std::function<void()>& then);
  /// Files to open, import or append, and what was read of them so far.
  struct Import {
    QStringList files;    ///< that are still to be read; the first one is being read
    bool merges = false;  ///< whether to append them to the current scene
    AskOptions asks = AskOptions::Never;
    std::uint64_t revision = 0;  ///< of the scene at the time of the request
    QString reimported =
        {};  ///< the file from which the meshes came that are read again; empty for other imports
    QString title = {};
    QStringList asked_types = {};
    std::vector<std::shared_ptr<const LoadedScene>> loaded = {};
  };

  void begin(Import import);
  void begin(const ExportRequest& request);
  void read(Job& job, const Import& import);
  void ask_memory_limit();
  void take(const std::shared_ptr<const LoadedScene>& loaded);
  void take_with_options(const std::shared_ptr<const LoadedScene>& loaded);
  void keep(const std::shared_ptr<const LoadedScene>& loaded);
  void read_next();
  void show_loaded();
  void use_loaded();
  void append_loaded();
  void take_reimported();
  void fail(const LoadFailure& failure);
  void cancel_reading();
  void write(Job& job, const QString& file);
  void take_saved(const SaveResult& result);
  bool may_write(const SaveRequest& request);
  bool may_replace(const QStringList& files);
  /// Calls `then` when no file is being written: at once, or in the order of the calls.
  void after_saving(const std::function<void()>& then);
  void update_recent();

  Document& document_;
  JobList& jobs_;
  QWidget& window_;
  OutsideChanges outside_;
  SceneLoader loader_;
  QPointer<Job> reading_;  ///< the job that reads
  Import import_;
  BackgroundJob<std::shared_ptr<const LoadedScene>> applying_;  ///< options of an import
  std::vector<std::function<void()>> after_saving_;
  bool is_saved_ = false;  ///< whether the last attempt succeeded
  QList<QAction*> actions_;
  QMenu* recent_ = nullptr;
};

/// Asks for scene or model files, in the last used folder. Empty if cancelled.
QStringList ask_for_scenes_or_models(QWidget& window, const QString& title);

/// The recent files, the latest first, at most ten; stored in the settings.
QStringList recent_files();
void add_recent_file(const QString& file);

}  // namespace editor
