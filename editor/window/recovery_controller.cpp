#include "editor/window/recovery_controller.h"

#include <QFileInfo>
#include <QLocale>
#include <QThreadPool>
#include <optional>
#include <utility>
#include <vector>

#include "editor/controls/notice_bar.h"
#include "editor/document/document.h"
#include "editor/document/import_folder.h"
#include "editor/document/model_import.h"
#include "editor/jobs/job_list.h"
#include "editor/window/file_actions.h"

namespace editor {

namespace {

/// Removes the import folders of crashed sessions, unless their work can be recovered.
void remove_imports_without(const std::vector<LostWork>& all) {
  QStringList kept;
  for (const LostWork& work : all) kept += work.imports;
  QThreadPool::globalInstance()->start(
      [kept] { ImportFolder::remove_abandoned(ModelImport::default_folder(), kept); });
}

}  // namespace

struct RecoveryController::ReadWork {
  std::optional<grf::Scene> scene;
  EditorState state;
  grf::Diagnostics diagnostics;
};

RecoveryController::RecoveryController(Document& document, JobList& jobs, const QString& sessions,
                                       FileActions& files, NoticeBar& notice, QObject* parent)
    : QObject(parent),
      document_(document),
      jobs_(jobs),
      files_(files),
      notice_(notice),
      recovery_(document, sessions) {
  connect(&recovery_, &Recovery::failed, this,
          [this](const QString& message) { emit failed(tr("Autosave failed: %1").arg(message)); });
}

void RecoveryController::offer_lost_work() {
  if (files_.is_importing()) {  // an opened scene would hide the notice
    connect(&files_, &FileActions::idle, this, &RecoveryController::offer_lost_work,
            Qt::SingleShotConnection);
    return;
  }
  const std::vector<LostWork> all = recovery_.lost_work();
  remove_imports_without(all);
  if (all.empty()) return;
  const LostWork& work = all.front();
  const QString name =
      work.path.isEmpty() ? tr("a scene that was never saved") : QFileInfo(work.path).fileName();
  const QString when = QLocale().toString(work.saved, QLocale::ShortFormat);
  notice_.show_notice(
      NoticeBar::Kind::Information,
      tr("The last session ended unexpectedly. Unsaved work on %1 was autosaved at %2.").arg(name, when),
      {{tr("Recover"), tr("Open the autosaved scene"), [this, work] { recover(work); }},
       {tr("Discard"), tr("Delete the autosaved scene; this cannot be undone"), [this, work] {
          Recovery::discard(work);
          offer_lost_work();
        }}});
}

void RecoveryController::recover(const LostWork& work) {
  const auto read = [work] {
    ReadWork result;
    result.scene = Recovery::read(work, result.diagnostics);
    if (result.scene) {
      const SceneObjects objects = objects_of(*result.scene, work.path.toStdString());
      result.state = Recovery::read_state(work, objects, result.diagnostics);
    }
    return result;
  };
  const auto begin = [this, work, read](Job& job) {
    job.run(read, [this, work](const ReadWork& result) {
      if (!result.scene) return emit failed(QString::fromStdString(result.diagnostics.to_text()));
      files_.leave([this, work, result] { take(work, result); });
    });
  };
  jobs_.add({tr("Recover unsaved work"),
             QStringLiteral("recovery"),
             begin,
             {},
             tr("Cancel: the work can be recovered later")});
}

void RecoveryController::take(const LostWork& work, ReadWork read) {
  document_.take(std::move(*read.scene), work.path, read.diagnostics, std::move(read.state), true);
  for (const QString& folder : work.imports) document_.add_import(ImportFolder::adopt(folder));
  // The old autosave is removed only once this session has its own.
  connect(
      &recovery_, &Recovery::kept, this, [work] { Recovery::discard(work); }, Qt::SingleShotConnection);
  recovery_.keep();
  emit status_message(tr("Recovered: save the scene to keep it"));
}

}  // namespace editor
