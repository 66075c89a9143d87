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
#include <optional>
#include <utility>

#include "converters/format.h"
#include "editor/brdf/background_job.h"
#include "editor/controls/text.h"
#include "editor/document/document.h"
#include "editor/document/model_import.h"
#include "editor/window/actions.h"
#include "editor/window/scene_loader.h"
#include "grf/read.h"
#include "grf/text_file.h"

namespace editor {
namespace {

constexpr int MostRecentFiles = 10;
/// Scenes of fewer bytes are read at once: it takes some milliseconds.
constexpr qint64 SmallScene = 500'000;

/// "Title (*.a *.b)" of each format that is written, GRF left out.
QString export_filter() {
  QStringList filters;
  for (const convert::Format& format : convert::formats()) {
    if (format.write == nullptr || format.name == "grf") continue;
    QStringList patterns;
    for (const std::string_view extension : format.extensions) patterns.append("*." + text_of(extension));
    filters.append(QString("%1 (%2)").arg(text_of(format.title), patterns.join(' ')));
  }
  return filters.join(";;");
}

QString name_for_export(const Document& document) {
  return QFileInfo(document.path().isEmpty() ? "scene" : document.path()).completeBaseName();
}

/// The same name with the extension of files that may have irradiance.
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

QString ask_for_scene_or_model(QWidget& window, const QString& title) {
  const QString readable =
      FileActions::tr("Scenes and models (%1);;All files (*)").arg(ModelImport::name_patterns().join(' '));
  QSettings settings;
  const QString folder = settings.value("last_folder").toString();
  QString file = QFileDialog::getOpenFileName(&window, title, folder, readable);
  if (!file.isEmpty()) settings.setValue("last_folder", QFileInfo(file).path());
  return file;
}

struct FileActions::ReadScene {
  std::optional<grf::Scene> scene;
  grf::Diagnostics diagnostics;

  static ReadScene of(const QString& file) {
    ReadScene read;
    read.scene = grf::read(file.toStdString(), read.diagnostics);
    return read;
  }
};

FileActions::FileActions(Document& document, QWidget& window)
    : QObject(&window),
      document_(document),
      window_(window),
      outside_(document, this),
      import_(std::make_unique<ModelImport>(ModelImport::default_folder())),
      reading_(std::make_unique<BackgroundJob<ReadScene>>(this)) {
  connect(import_.get(), &ModelImport::done, this,
          [this](const std::shared_ptr<const ImportedModel>& model) { take_model(*model); });
  connect(import_.get(), &ModelImport::failed, this, [this](const QString& message) {
    imports_.pop_front();
    grf::Diagnostics diagnostics;
    diagnostics.error({}, message.toStdString());
    emit reported(diagnostics);
    emit failed(message);
    import_next();
  });
  make_actions();
}

FileActions::~FileActions() = default;

void FileActions::make_actions() {
  const auto add = [this](const QString& text, const QString& icon_name, const QKeySequence& keys,
                          const QString& tip, const std::function<void()>& action) {
    actions_.append(new_action(window_, {text, icon_name, keys, tip}, action));
  };
  add(tr("&New"), "new", QKeySequence::New, tr("Begin an empty scene"),
      [this] { leave([this] { document_.clear(); }); });
  add(tr("&Open..."), "open", QKeySequence::Open, tr("Open a scene, or import a model of another format"),
      [this] {
        const QString file = ask_for_scene_or_model(window_, tr("Open"));
        if (!file.isEmpty()) open(file);
      });
  add(tr("&Merge in..."), {}, QKeySequence("Ctrl+Shift+O"), tr("Add a scene or a model to this one"), [this] {
    const QString file = ask_for_scene_or_model(window_, tr("Merge in"));
    if (!file.isEmpty()) merge(file);
  });
  add(tr("&Save"), "save", QKeySequence::Save, tr("Save the scene"), [this] { save(); });
  add(tr("Save &as..."), {}, QKeySequence("Ctrl+Shift+S"), tr("Save the scene under another name"),
      [this] { ask_where_to_save({}); });
  add(tr("Re&vert"), {}, QKeySequence("Ctrl+Shift+R"),
      tr("Read the scene's file again, as it was saved last"), [this] { revert(); });
  add(tr("&Export..."), {}, QKeySequence("Ctrl+E"), tr("Write the scene in another format"), [this] {
    const QString file =
        QFileDialog::getSaveFileName(&window_, tr("Export"), name_for_export(document_), export_filter());
    if (!file.isEmpty()) export_to(file);
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
    if (i == 3 || i == 6) menu.addSeparator();
    menu.addAction(actions_[i]);
  }
  menu.addSeparator();
  menu.addAction(new_action(window_,
                            {tr("Import &memory limit..."),
                             {},
                             QKeySequence("Ctrl+Alt+M"),
                             tr("Sets how much memory the import of a model may take")},
                            [this] { ask_memory_limit(); }));
}

void FileActions::ask_memory_limit() {
  bool is_chosen = false;
  const double limit =
      QInputDialog::getDouble(&window_, tr("Import memory limit"),
                              tr("The import of a model is ended where it needs more memory than this (GB):"),
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
  if (recent_->isEmpty()) recent_->addAction(tr("No file was opened yet"))->setEnabled(false);
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
  if (!is_grf(file)) file += is_igrf ? ".igrf" : ".grf";
  save_as(file);
  if (then && !document_.is_modified()) then();
}

void FileActions::open(const QString& file) {
  leave([this, file] { begin(file, false); });
}

void FileActions::merge(const QString& file) { begin(file, true); }

void FileActions::begin(const QString& file, bool merges) {
  const Import import = {file, merges, document_.undo_stack().index()};
  if (imports_.empty() && is_grf(file) && QFileInfo(file).size() < SmallScene) {
    return take_scene(import, ReadScene::of(file));
  }
  imports_.push_back(import);
  if (imports_.size() == 1) import_next();
}

void FileActions::import_next() {
  if (imports_.empty()) return emit busy({});
  const QString file = imports_.front().file;
  emit busy((is_grf(file) ? tr("Opening %1") : tr("Importing %1")).arg(QFileInfo(file).fileName()));
  if (!is_grf(file)) return import_->start(file);
  reading_->start([file](const StopFlag&) { return ReadScene::of(file); },
                  [this](ReadScene read) {
                    const Import import = imports_.front();
                    imports_.pop_front();
                    take_scene(import, std::move(read));
                    import_next();
                  });
}

void FileActions::cancel_import() {
  if (imports_.empty()) return;
  import_->cancel();
  reading_->stop();
  imports_.clear();
  emit busy({});
  emit done(tr("The import was given up"));
}

void FileActions::take_model(const ImportedModel& model) {
  const Import import = imports_.front();
  imports_.pop_front();
  const QString name = QFileInfo(import.file).fileName();
  if (import.merges) {
    document_.merge_import(tr("Merge in %1").arg(name), model);
    emit reported(model.diagnostics);
  } else {
    put_in_place(import, [this, &model] { document_.take_import(model); });
  }
  add_recent_file(import.file);
  emit done(model.losses.isEmpty() ? tr("Imported %1").arg(name)
                                   : tr("Imported %1, not all of it: %2").arg(name, model.losses.join("; ")));
  import_next();
}

void FileActions::take_scene(const Import& import, ReadScene read) {
  if (!read.scene) {
    emit reported(read.diagnostics);
    return emit failed(failure_of(import.file, read.diagnostics).message);
  }
  const QString name = QFileInfo(import.file).fileName();
  add_recent_file(import.file);
  if (import.merges) {
    document_.merge(tr("Merge in %1").arg(name), *read.scene, import.file);
    emit reported(read.diagnostics);
    return emit done(tr("Merged in %1").arg(name));
  }
  put_in_place(import, [&] { document_.take(std::move(*read.scene), import.file, read.diagnostics); });
  emit done(tr("Opened %1").arg(document_.name()));
}

void FileActions::put_in_place(const Import& import, const std::function<void()>& take) {
  import.step == document_.undo_stack().index() ? take() : leave(take);
}

void FileActions::save(const std::function<void()>& then) {
  // A file that had no irradiance is kept: scenes with it go beside.
  const bool needs_igrf =
      grf::has_irradiance(document_.scene().contents) && !grf::is_igrf_name(document_.path().toStdString());
  if (document_.path().isEmpty() || needs_igrf) return ask_where_to_save(then);
  save_as(document_.path());
  if (then && !document_.is_modified()) then();
}

/// What is named as it was would be written over what the document has not read.
bool FileActions::may_overwrite() {
  const QStringList changed = outside_.files();
  if (changed.isEmpty()) return true;
  QMessageBox question(QMessageBox::Warning, tr("Changed by another program"),
                       tr("%1 was changed by another program since it was read.").arg(changed.join(", ")),
                       QMessageBox::Save | QMessageBox::Cancel, &window_);
  question.setInformativeText(tr("Saving replaces what that program has written."));
  question.button(QMessageBox::Save)->setText(tr("Replace it"));
  question.setDefaultButton(QMessageBox::Cancel);
  return question.exec() == QMessageBox::Save;
}

void FileActions::revert() {
  const QString file = document_.path();
  if (file.isEmpty()) return emit done(tr("The scene was never saved"));
  if (document_.is_modified()) {
    QMessageBox question(QMessageBox::Warning, tr("Revert"),
                         tr("%1 has changes that are not saved.").arg(document_.name()),
                         QMessageBox::Discard | QMessageBox::Cancel, &window_);
    question.setInformativeText(tr("They cannot be brought back once the file is read again."));
    question.button(QMessageBox::Discard)->setText(tr("Revert"));
    question.setDefaultButton(QMessageBox::Cancel);
    if (question.exec() != QMessageBox::Discard) return;
  }
  begin(file, false);
}

void FileActions::save_as(const QString& file) {
  if (file == document_.path() && !may_overwrite()) return;
  grf::Diagnostics diagnostics;
  if (!document_.save(file, diagnostics)) return emit failed(QString::fromStdString(diagnostics.to_text()));
  add_recent_file(file);
  emit done(tr("Saved %1").arg(document_.name()));
}

void FileActions::export_to(const QString& file) {
  const convert::Format* format = convert::format_of_name(file.toStdString());
  if (format == nullptr || format->write == nullptr) {
    return emit failed(tr("%1: no format that is written has this extension").arg(file));
  }
  grf::Diagnostics diagnostics;
  const grf::Scene scene = document_.scene_for(file);
  if (!format->write(scene, file.toStdString(), diagnostics)) {
    return emit failed(QString::fromStdString(diagnostics.to_text()));
  }
  emit reported(diagnostics);
  emit done(tr("Exported %1").arg(QFileInfo(file).fileName()));
}

void FileActions::leave(const std::function<void()>& then) {
  if (!document_.is_modified()) return then();
  QMessageBox question(QMessageBox::Question, tr("Unsaved changes"),
                       tr("%1 has changes that are not saved.").arg(document_.name()),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
  question.setInformativeText(tr("Discarded changes cannot be brought back."));
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
