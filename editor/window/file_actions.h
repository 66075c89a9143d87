#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <deque>
#include <functional>
#include <memory>

#include "editor/window/outside_changes.h"
#include "grf/diagnostics.h"

class QAction;
class QMenu;
class QWidget;

namespace editor {

class Document;
class ModelImport;
struct ImportedModel;
template <class Result>
class BackgroundJob;

/// All that one does with files: new, open, recent, import, merge, save, revert, export. One place decides
/// what a file is, whether it comes from a menu, a drop or the command line: GRF is read here, what is large
/// in a thread; all else is imported in a process of its own.
class FileActions : public QObject {
  Q_OBJECT

 public:
  /// Dialogs belong to the window.
  FileActions(Document& document, QWidget& window);
  ~FileActions() override;

  /// The entries of the File menu, in order.
  void fill(QMenu& menu);

  /// Opens or imports a file; asks first if there is unsaved work.
  void open(const QString& file);
  void merge(const QString& file);
  /// Saves where the scene is, or asks where. `then` is called once it is saved.
  void save(const std::function<void()>& then = {});
  /// Asks first if another program has changed one of the scene's files since it was read.
  void save_as(const QString& file);
  /// Reads the scene's file again; asks first if there is unsaved work, which goes then.
  void revert();
  void export_to(const QString& file);
  /// Calls `then` at once if nothing is unsaved; else asks whether to save, discard or go on editing.
  void leave(const std::function<void()>& then);

  /// Knows which of the scene's files other programs have changed.
  OutsideChanges& outside_changes() { return outside_; }

  /// Whether something is being opened or imported, or waits for that.
  bool is_importing() const { return !imports_.empty(); }
  /// Gives up what is being opened or imported, and what waits for it.
  void cancel_import();

 signals:
  /// What came of it, for the status line.
  void done(const QString& message);
  void failed(const QString& message);
  /// What is to be said of a file that was not opened, or of one that was merged in or written.
  void reported(const grf::Diagnostics& diagnostics);
  /// Something takes its time; an empty text: no more.
  void busy(const QString& what);

 private:
  void make_actions();
  void ask_where_to_save(const std::function<void()>& then);
  /// A file that is to be opened or imported.
  struct Import {
    QString file;
    bool merges = false;  ///< into the scene that is there
    int step = 0;         ///< of undo at which the scene was when it was asked for
  };
  struct ReadScene;

  void begin(const QString& file, bool merges);
  void import_next();
  void ask_memory_limit();
  void take_model(const ImportedModel& model);
  void take_scene(const Import& import, ReadScene read);
  /// Unless the scene was edited since then, or after a question.
  void put_in_place(const Import& import, const std::function<void()>& take);
  void update_recent();

  bool may_overwrite();

  Document& document_;
  QWidget& window_;
  OutsideChanges outside_;
  std::unique_ptr<ModelImport> import_;
  std::unique_ptr<BackgroundJob<ReadScene>> reading_;
  std::deque<Import> imports_;  ///< the first one is running
  QList<QAction*> actions_;
  QMenu* recent_ = nullptr;
};

/// Asks for a scene or a model, in the folder where one was chosen last. Empty: none was chosen.
QString ask_for_scene_or_model(QWidget& window, const QString& title);

/// The files that were opened last, the latest first, at most ten; kept in the settings.
QStringList recent_files();
void add_recent_file(const QString& file);

}  // namespace editor
