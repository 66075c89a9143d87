#include "editor/window/bake_controller.h"

#include "editor/document/document.h"
#include "editor/jobs/job_list.h"
#include "editor/rendering/render_files.h"

namespace editor {
namespace {

const QString BakeQueue = QStringLiteral("bakes");

}  // namespace

BakeController::BakeController(Document& document, JobList& jobs, QObject* parent)
    : QObject(parent), document_(document), jobs_(jobs), bake_(bundled_program("bpt"), this) {
  connect(&bake_, &IrradianceBake::progressed, this, [this](double done, std::optional<double> seconds_left) {
    if (job_) job_->show_progress(done, seconds_left);
  });
  connect(&bake_, &IrradianceBake::finished, this, &BakeController::take);
  connect(&bake_, &IrradianceBake::failed, this, [this](const QString& why) {
    if (job_) job_->end();
    emit failed(why);
  });
}

void BakeController::bake() {
  if (jobs_.is_busy(BakeQueue)) return;
  jobs_.add({tr("Bake irradiance"), BakeQueue, [this](Job& job) { begin(job); }, [this] { bake_.stop(); },
             tr("Stop and keep the irradiance computed so far")});
}

void BakeController::begin(Job& job) {
  job_ = &job;
  imports_ = document_.imports();
  options::RenderOptions bake_options = document_.options().valid_options();
  bake_options.samples.reset();  // samples per pixel are not samples per vertex
  bake_.start(document_.scene(), document_.path(), bake_options);
}

void BakeController::take(const BakedIrradiance& irradiance, const IrradianceBakeResult& result) {
  if (job_) job_->end();
  IrradiatedScene irradiated =
      irradiance.applied_to(document_.scene(), naming_path(document_.path()).toStdString());
  if (irradiated.meshes == 0)
    return emit failed(tr("The baked irradiance was discarded: all its meshes were edited meanwhile"));
  document_.replace(tr("Bake irradiance"), std::move(irradiated.scene));
  QStringList messages = {tr("Irradiance baked. Save the scene as IGRF to keep it.")};
  if (!result.messages.isEmpty()) messages << result.messages.trimmed();
  if (irradiated.skipped > 0) {
    messages << tr("%n mesh(es) were edited meanwhile and keep their old irradiance.", nullptr,
                   static_cast<int>(irradiated.skipped));
  }
  if (irradiated.expanded_includes > 0) {
    messages << tr(
        "Files that are included several times receive different light at each place, and are part of the "
        "scene now.");
  }
  emit status_message(messages.join('\n'));
}

}  // namespace editor
