#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "editor/window/outside_changes.h"
#include "editor/window/scene_loader.h"
#include "grf/diagnostics.h"

class QAction;
class QMenu;
class QWidget;

namespace editor {

class Document;
class Job;
class JobList;
struct SaveRequest;
struct SaveResult;

/// All that one does with files: new, open, recent, import, merge, save, revert, export. What takes time are
/// jobs: files are read one after another, and written one after another.
class FileActions : public QObject {
  Q_OBJECT

 public:
  /// Dialogs belong to the window; document and jobs outlive it.
  FileActions(Document& document, JobList& jobs, QWidget& window);
  ~FileActions() override;

  /// The entries of the File menu, in order.
  void fill(QMenu& menu);

  /// Opens or imports a file; asks first if there is unsaved work.
  void open(const QString& file);
  void merge(const QString& file);
  /// Saves where the scene is, or asks where. `then` is called once it is saved, after a question if it was
  /// edited meanwhile.
  void save(const std::function<void()>& then = {});
  /// Asks first if that replaces what the document has not read, such as what another program has written.
  void save_as(const QString& file, const std::function<void()>& then = {});
  /// Reads the scene's file again; asks first if there is unsaved work, which goes then.
  void revert();
  void export_to(const QString& file);
  /// Calls `then` at once if nothing is unsaved or being written; else asks whether to save, discard or go on
  /// editing, once it is written.
  void leave(const std::function<void()>& then);

  /// Knows which of the scene's files other programs have changed.
  OutsideChanges& outside_changes() { return outside_; }

  /// Whether something is being opened or imported, or waits for that.
  bool is_importing() const;
  /// Whether something is being written, or waits for that.
  bool is_saving() const;

 signals:
  /// What came of it, for the status line.
  void done(const QString& message);
  void failed(const QString& message);
  /// What is to be said of a file that was not opened, or of one that was merged in or written.
  void reported(const grf::Diagnostics& diagnostics);
  /// Nothing is being opened or imported any more.
  void idle();

 private:
  void make_actions();
  void ask_where_to_save(const std::function<void()>& then);
  /// A file that is to be opened or imported.
  struct Import {
    QString file;
    bool merges = false;         ///< into the scene that is there
    std::uint64_t revision = 0;  ///< of the scene when it was asked for
  };

  void begin(const QString& file, bool merges);
  void read(Job& job, const Import& import);
  void ask_memory_limit();
  void take(const std::shared_ptr<const LoadedScene>& loaded);
  void fail(const LoadFailure& failure);
  void cancel_reading();
  void write(Job& job, const QString& file);
  void take_saved(const SaveResult& result);
  bool may_write(const SaveRequest& request);
  bool may_replace(const QStringList& files);
  /// Calls `then` once nothing is being written: at once, or in the order of the calls.
  void after_saving(const std::function<void()>& then);
  void update_recent();

  Document& document_;
  JobList& jobs_;
  QWidget& window_;
  OutsideChanges outside_;
  SceneLoader loader_;
  QPointer<Job> reading_;  ///< what it reads
  Import import_;
  std::vector<std::function<void()>> after_saving_;
  bool is_saved_ = false;  ///< by the last attempt
  QList<QAction*> actions_;
  QMenu* recent_ = nullptr;
};

/// Asks for a scene or a model, in the folder where one was chosen last. Empty: none was chosen.
QString ask_for_scene_or_model(QWidget& window, const QString& title);

/// The files that were opened last, the latest first, at most ten; kept in the settings.
QStringList recent_files();
void add_recent_file(const QString& file);

}  // namespace editor
