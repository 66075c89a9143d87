#include "editor/window/file_actions.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QKeySequence>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QWidget>
#include <utility>

#include "converters/format.h"
#include "editor/controls/actions.h"
#include "editor/controls/text.h"
#include "editor/document/document.h"
#include "editor/document/import_options.h"
#include "editor/document/model_import.h"
#include "editor/document/reimport.h"
#include "editor/document/save.h"
#include "editor/document/scene_export.h"
#include "editor/jobs/job_list.h"
#include "editor/window/export_dialog.h"
#include "editor/window/import_dialog.h"
#include "grf/text_file.h"

namespace editor {
namespace {

constexpr int MostRecentFiles = 10;
const QString Reading = QStringLiteral("reading");
const QString Writing = QStringLiteral("writing");

/// The name of the scene without extension, in its folder, or for an unsaved one in the last used folder.
QString name_for_export(const Document& document) {
  if (document.path().isEmpty()) return QDir(QSettings().value("last_folder").toString()).filePath("scene");
  const QFileInfo info(document.path());
  return info.dir().filePath(info.completeBaseName());
}

/// Replaces the extension by that of files that may have irradiance.
QString igrf_name(const QString& file) {
  const QFileInfo info(file);
  return info.dir().filePath(info.completeBaseName() + ".igrf");
}

}  // namespace

QStringList recent_files() { return QSettings().value("recent_files").toStringList(); }

void add_recent_file(const QString& file) {
  QStringList files = recent_files();
  const QString path = QFileInfo(file).absoluteFilePath();
  files.removeAll(path);
  files.prepend(path);
  QSettings().setValue("recent_files", QStringList(files.mid(0, MostRecentFiles)));
}

QStringList ask_for_scenes_or_models(QWidget& window, const QString& title) {
  const QString readable =
      FileActions::tr("Scenes and models (%1);;All files (*)").arg(ModelImport::name_patterns().join(' '));
  QSettings settings;
  const QString folder = settings.value("last_folder").toString();
  QStringList files = QFileDialog::getOpenFileNames(&window, title, folder, readable);
  if (!files.isEmpty()) settings.setValue("last_folder", QFileInfo(files.front()).path());
  return files;
}

FileActions::FileActions(Document& document, JobList& jobs, QWidget& window)
    : QObject(&window),
      document_(document),
      jobs_(jobs),
      window_(window),
      outside_(document, this),
      applying_(this) {
  connect(&loader_, &SceneLoader::loaded, this, &FileActions::take);
  connect(&loader_, &SceneLoader::failed, this, &FileActions::fail);
  connect(&jobs_, &JobList::queue_emptied, this, [this](const QString& queue) {
    if (queue == Reading) emit idle();
    if (queue != Writing) return;
    outside_.set_paused(false);
    for (const auto& then : std::exchange(after_saving_, {})) after_saving(then);
  });
  make_actions();
}

FileActions::~FileActions() = default;

void FileActions::make_actions() {
  const auto add = [this](const QString& text, const QString& icon_name, const QKeySequence& keys,
                          const QString& tip, const std::function<void()>& action) {
    actions_.append(new_action(window_, {text, icon_name, keys, tip}, action));
  };
  add(tr("&New"), "new", QKeySequence::New, tr("Start an empty scene"), [this] { start_new(); });
  add(tr("&Open..."), "open", QKeySequence::Open, tr("Open scenes, or import models of other formats"),
      [this] { ask_and_open(); });
  add(tr("A&ppend..."), {}, QKeySequence("Ctrl+Shift+O"), tr("Append scenes or models to this one"),
      [this] { merge(ask_for_scenes_or_models(window_, tr("Append")), AskOptions::UnlessHidden); });
  add(tr("Append with op&tions..."), {}, QKeySequence("Ctrl+Alt+I"),
      tr("Append models, and show the import options, also if they are hidden for their type"),
      [this] { merge(ask_for_scenes_or_models(window_, tr("Append")), AskOptions::Always); });
  add(tr("Re&import"), {}, QKeySequence("Ctrl+Alt+J"),
      tr("Read the file of the selected imported object again; its faces keep what was assigned to them"),
      [this] { reimport(); });
  add(tr("&Save"), "save", QKeySequence::Save, tr("Save the scene"), [this] { save(); });
  add(tr("Save &as..."), {}, QKeySequence("Ctrl+Shift+S"), tr("Save the scene under another name"),
      [this] { ask_where_to_save({}); });
  add(tr("Re&vert"), {}, QKeySequence("Ctrl+Shift+R"), tr("Revert to the saved file of the scene"),
      [this] { revert(); });
  add(tr("&Export..."), {}, QKeySequence("Ctrl+E"), tr("Export the scene to another format"), [this] {
    ExportDialog dialog(export_request(document_), name_for_export(document_), &window_);
    if (dialog.exec() == QDialog::Accepted) begin(dialog.request());
  });
}

void FileActions::fill(QMenu& menu) {
  menu.addAction(actions_[0]);
  menu.addAction(actions_[1]);
  recent_ = menu.addMenu(tr("Open &recent"));
  recent_->setToolTipsVisible(true);
  connect(recent_, &QMenu::aboutToShow, this, &FileActions::update_recent);
  update_recent();
  for (int i = 2; i < actions_.size(); ++i) {
    if (i == 5 || i == 8) menu.addSeparator();
    menu.addAction(actions_[i]);
  }
  menu.addSeparator();
  menu.addAction(new_action(window_,
                            {tr("Import &memory limit..."),
                             {},
                             QKeySequence("Ctrl+Alt+M"),
                             tr("Set how much memory the import of a model may use")},
                            [this] { ask_memory_limit(); }));
}

void FileActions::start_new() {
  leave([this] { document_.clear(); });
}

void FileActions::ask_and_open() {
  open(ask_for_scenes_or_models(window_, tr("Open")), AskOptions::UnlessHidden);
}

void FileActions::ask_memory_limit() {
  bool is_chosen = false;
  const double limit =
      QInputDialog::getDouble(&window_, tr("Import memory limit"),
                              tr("Cancel the import of a model if it needs more memory than this (GB):"),
                              ModelImport::memory_limit(), 0.1, 4096, 1, &is_chosen);
  if (is_chosen) ModelImport::set_memory_limit(limit);
}

void FileActions::update_recent() {
  recent_->clear();
  for (const QString& file : recent_files()) {
    QAction* entry = recent_->addAction(QFileInfo(file).fileName(), this, [this, file] { open(file); });
    entry->setToolTip(QDir::toNativeSeparators(file));
    entry->setEnabled(QFile::exists(file));
  }
  if (recent_->isEmpty()) recent_->addAction(tr("No recent files"))->setEnabled(false);
}

void FileActions::ask_where_to_save(const std::function<void()>& then) {
  const QString proposal = document_.path().isEmpty() ? QString("scene.grf") : document_.path();
  const bool is_igrf = grf::has_irradiance(document_.scene().contents);
  QString file =
      is_igrf
          ? QFileDialog::getSaveFileName(&window_, tr("Save as: irradiance needs an IGRF file"),
                                         igrf_name(proposal), tr("IGRF scenes (*.igrf)"))
          : QFileDialog::getSaveFileName(&window_, tr("Save as"), proposal, tr("GRF scenes (*.grf *.igrf)"));
  if (file.isEmpty()) return;
  if (!is_grf(file)) {  // the dialog has asked about the name without the extension
    file += is_igrf ? ".igrf" : ".grf";
    if (QFileInfo::exists(file) && !may_replace({file})) return;
  }
  save_as(file, then);
}

void FileActions::open(const QStringList& files, AskOptions asks) {
  if (files.isEmpty()) return;
  leave([this, files, asks] {
    begin({{files.front()}, false, asks, document_.revision()});
    if (files.size() == 1) return;
    Import others = {files.mid(1), true, asks, document_.revision()};
    others.asked_types = {import_type(files.front())};
    begin(std::move(others));
  });
}

void FileActions::merge(const QStringList& files, AskOptions asks) {
  if (files.isEmpty()) return;
  after_saving([this, files, asks] { begin({files, true, asks, document_.revision()}); });
}

void FileActions::reimport() {
  const std::vector<grf::ScenePath>& selected = document_.selected_objects();
  const QString source = selected.empty() ? QString() : import_source(document_.scene(), selected.back());
  if (source.isEmpty()) {
    return emit failed(
        tr("Select an object that was imported from a file of another format, to read that file again."));
  }
  QString file = source;
  if (!QFileInfo::exists(file)) {
    file = QFileDialog::getOpenFileName(&window_,
                                        tr("%1 is gone: choose the file").arg(QFileInfo(source).fileName()),
                                        QFileInfo(source).path());
    if (file.isEmpty()) return;
  }
  Import import = {{file}, true, AskOptions::Never, document_.revision()};
  import.reimported = source;
  begin(std::move(import));
}

bool FileActions::is_importing() const { return jobs_.is_busy(Reading); }

bool FileActions::is_saving() const { return jobs_.is_busy(Writing); }

void FileActions::begin(Import import) {
  const QString name = QFileInfo(import.files.front()).fileName();
  import.title = !import.reimported.isEmpty()   ? tr("Reimport %1").arg(name)
                 : import.files.size() > 1      ? tr("Append %1 files").arg(import.files.size())
                 : import.merges                ? tr("Append %1").arg(name)
                 : is_grf(import.files.front()) ? tr("Open %1").arg(name)
                                                : tr("Import %1").arg(name);
  jobs_.add({import.title, Reading, [this, import](Job& job) { read(job, import); },
             [this] { cancel_reading(); }, tr("Cancel: the scene stays as it is")});
}

void FileActions::read(Job& job, const Import& import) {
  reading_ = &job;
  import_ = import;
  loader_.start(import_.files.front());
}

void FileActions::cancel_reading() {
  loader_.cancel();
  applying_.stop();
  emit done(tr("Cancelled"));
  reading_->end();
}

/// Applies the options of an import, which are remembered or asked for.
void FileActions::take(const std::shared_ptr<const LoadedScene>& loaded) {
  const QString& file = import_.files.front();
  add_recent_file(file);
  if (is_grf(file)) return keep(loaded);
  const QString type = import_type(file);
  const bool asks = !import_.asked_types.contains(type) &&
                    (import_.asks == AskOptions::Always ||
                     (import_.asks == AskOptions::UnlessHidden && asks_for_import_options(type)));
  if (!asks) return take_with_options(loaded);
  import_.asked_types.append(type);
  const QPointer<Job> job = reading_;
  ImportDialog dialog(loaded, &window_);
  const bool is_accepted = dialog.exec() == QDialog::Accepted;
  if (!job || job->state() != Job::State::Running) return;  // it was cancelled meanwhile
  is_accepted ? keep(dialog.result_scene()) : cancel_reading();
}

void FileActions::take_with_options(const std::shared_ptr<const LoadedScene>& loaded) {
  const ImportOptions options = remembered_import_options(import_type(import_.files.front()));
  if (options.are_default()) return keep(loaded);
  applying_.start([loaded, options](const StopFlag&) { return with_options(*loaded, options); },
                  [this](const std::shared_ptr<const LoadedScene>& scene) { keep(scene); });
}

void FileActions::keep(const std::shared_ptr<const LoadedScene>& loaded) {
  import_.loaded.push_back(loaded);
  read_next();
}

void FileActions::read_next() {
  const QPointer<Job> job = reading_;
  import_.files.removeFirst();
  if (!import_.files.isEmpty()) return loader_.start(import_.files.front());
  if (!import_.loaded.empty()) use_loaded();
  if (job) job->end();  // a question may have taken so long that the job was cancelled
}

void FileActions::use_loaded() {
  if (!import_.reimported.isEmpty()) return take_reimported();
  import_.merges ? append_loaded() : show_loaded();
}

void FileActions::append_loaded() {
  const QString path = import_.loaded.front()->path;
  std::vector<ImportedModel> models;
  QStringList losses;
  for (const auto& loaded : std::exchange(import_.loaded, {})) {
    models.push_back(loaded->model);
    losses += loaded->model.losses;
    const QString name = QFileInfo(loaded->path).fileName();
    const std::size_t cameras = loaded->model.cameras.size();
    if (cameras == 1) losses.append(tr("1 camera of %1").arg(name));
    if (cameras > 1) losses.append(tr("%1 cameras of %2").arg(cameras).arg(name));
  }
  document_.merge_imports(import_.title, models);
  for (const ImportedModel& model : models) emit reported(model.diagnostics);
  const QString did = models.size() == 1 ? tr("Appended %1").arg(QFileInfo(path).fileName())
                                         : tr("Appended %1 files").arg(models.size());
  emit done(losses.isEmpty() ? did : tr("%1, with losses: %2").arg(did, losses.join("; ")));
}

void FileActions::take_reimported() {
  const std::shared_ptr<const LoadedScene> loaded = std::exchange(import_.loaded, {}).front();
  Reimported now = editor::reimported(document_.scene(), import_.reimported, loaded->model.scene);
  if (now.meshes > 0) document_.replace(import_.title, std::move(now.scene));
  const QString name = QFileInfo(loaded->path).fileName();
  const QString did = now.meshes == 0   ? tr("Reimported %1: its objects are the same").arg(name)
                      : now.meshes == 1 ? tr("Reimported %1: 1 object changed").arg(name)
                                        : tr("Reimported %1: %2 objects changed").arg(name).arg(now.meshes);
  if (now.problems.isEmpty()) return emit done(did);
  grf::Diagnostics diagnostics;
  for (const QString& problem : now.problems)
    diagnostics.warning(grf::whole_file(loaded->path.toStdString()), problem.toStdString());
  emit reported(diagnostics);
  emit done(tr("%1. %2").arg(did, now.problems.join("; ")));
}

void FileActions::show_loaded() {
  const std::shared_ptr<const LoadedScene> loaded = std::exchange(import_.loaded, {}).front();
  const QStringList& losses = loaded->model.losses;
  const bool is_scene = is_grf(loaded->path);
  const QString did =
      (is_scene ? tr("Opened %1") : tr("Imported %1")).arg(QFileInfo(loaded->path).fileName());
  const auto take_it = [this, loaded, is_scene] {
    const ImportedModel& taken = loaded->model;
    is_scene ? document_.take(taken.scene, taken.path, taken.diagnostics, loaded->state)
             : document_.take_import(taken);
  };
  import_.revision == document_.revision() ? take_it() : leave(take_it);
  emit done(losses.isEmpty() ? did : tr("%1, with losses: %2").arg(did, losses.join("; ")));
}

void FileActions::fail(const LoadFailure& failure) {
  emit reported(failure.diagnostics);
  emit failed(failure.message);
  read_next();
}

void FileActions::save(const std::function<void()>& then) {
  if (is_saving()) return after_saving([this, then] { save(then); });
  // A file without irradiance is not overwritten: scenes with irradiance get a file beside it.
  const bool needs_igrf =
      grf::has_irradiance(document_.scene().contents) && !grf::is_igrf_name(document_.path().toStdString());
  if (document_.path().isEmpty() || needs_igrf) return ask_where_to_save(then);
  save_as(document_.path(), then);
}

void FileActions::save_as(const QString& file, const std::function<void()>& then) {
  jobs_.add(
      {tr("Save %1").arg(QFileInfo(file).fileName()), Writing, [this, file](Job& job) { write(job, file); }});
  if (!then) return;
  after_saving([this, then] {
    if (is_saved_) leave(then);
  });
}

/// Saves the document as it is when the preceding jobs of the queue have ended.
void FileActions::write(Job& job, const QString& file) {
  is_saved_ = false;
  const SaveRequest request = document_.save_request(file);
  if (!may_write(request)) return job.end();
  outside_.set_paused(true);
  job.run([request] { return editor::write(request); },
          [this](const SaveResult& result) { take_saved(result); });
}

void FileActions::take_saved(const SaveResult& result) {
  document_.take_saved(result);
  is_saved_ = result.is_done;
  if (!is_saved_) return emit failed(QString::fromStdString(result.diagnostics.to_text()));
  add_recent_file(result.request.path);
  emit done(tr("Saved %1").arg(QFileInfo(result.request.path).fileName()));
}

void FileActions::after_saving(const std::function<void()>& then) {
  if (!is_saving()) return then();
  after_saving_.push_back(then);
}

/// Overwrites changes by other programs only if the user agrees.
bool FileActions::may_write(const SaveRequest& request) {
  QStringList replaced = outside_.files();
  if (request.path != document_.path()) replaced.removeAll(document_.path());
  for (const QString& file : files_beside(request)) {
    if (QFileInfo::exists(file) && !outside_.knows(file)) replaced.append(file);
  }
  return replaced.isEmpty() || may_replace(replaced);
}

bool FileActions::may_replace(const QStringList& files) {
  QMessageBox question(
      QMessageBox::Warning, tr("Replace files"),
      tr("%1 was changed by another program, or belongs to another scene.").arg(files.join(", ")),
      QMessageBox::Save | QMessageBox::Cancel, &window_);
  question.setInformativeText(tr("Saving overwrites them."));
  question.button(QMessageBox::Save)->setText(tr("Replace"));
  question.setDefaultButton(QMessageBox::Cancel);
  return question.exec() == QMessageBox::Save;
}

void FileActions::revert() {
  const QString file = document_.path();
  if (file.isEmpty()) return emit done(tr("Cannot revert: the scene was never saved"));
  if (document_.is_modified()) {
    QMessageBox question(QMessageBox::Warning, tr("Revert"),
                         tr("%1 has unsaved changes.").arg(document_.name()),
                         QMessageBox::Discard | QMessageBox::Cancel, &window_);
    question.setInformativeText(tr("Reverting discards them. This cannot be undone."));
    question.button(QMessageBox::Discard)->setText(tr("Revert"));
    question.setDefaultButton(QMessageBox::Cancel);
    if (question.exec() != QMessageBox::Discard) return;
  }
  after_saving([this, file] { begin({{file}, false, AskOptions::Never, document_.revision()}); });
}

void FileActions::export_to(const QString& file) {
  const convert::Format* format = convert::format_of_name(file.toStdString());
  if (format == nullptr || format->write == nullptr) {
    return emit failed(tr("Cannot export %1: no format with this extension can be written").arg(file));
  }
  ExportRequest request = export_request(document_);
  request.path = file;
  request.format = format;
  begin(request);
}

void FileActions::begin(const ExportRequest& request) {
  const QString name = QFileInfo(request.path).fileName();
  const auto take = [this, name](const grf::Diagnostics& diagnostics) {
    if (diagnostics.has_errors()) return emit failed(QString::fromStdString(diagnostics.to_text()));
    emit reported(diagnostics);
    emit done(tr("Exported %1").arg(name));
  };
  const auto work = [request] { return editor::write(request); };
  jobs_.add({tr("Export %1").arg(name), Writing, [work, take](Job& job) { job.run(work, take); }});
}

void FileActions::leave(const std::function<void()>& then) {
  if (is_saving()) return after_saving([this, then] { leave(then); });
  if (!document_.is_modified()) return then();
  QMessageBox question(QMessageBox::Question, tr("Unsaved changes"),
                       tr("%1 has unsaved changes.").arg(document_.name()),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
  question.setInformativeText(tr("Discarding them cannot be undone."));
  question.setDefaultButton(QMessageBox::Save);
  question.button(QMessageBox::Cancel)->setText(tr("Keep editing"));
  switch (question.exec()) {
    case QMessageBox::Save:
      return save(then);
    case QMessageBox::Discard:
      return then();
    default:
      return;
  }
}

}  // namespace editor
