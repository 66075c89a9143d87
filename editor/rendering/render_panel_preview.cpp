// The preview of the Render dock, and of a 3D view that shows it.
#include <QCheckBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <utility>

#include "editor/document/document.h"
#include "editor/document/geometry_edits.h"
#include "editor/jobs/job_list.h"
#include "editor/rendering/error_curve.h"
#include "editor/rendering/fitted_image.h"
#include "editor/rendering/render_panel.h"
#include "editor/rendering/render_settings_row.h"

namespace editor {

using job::PreviewState;
using options::RenderOptions;

namespace {

const QString PreviewQueue = QStringLiteral("preview");

std::optional<VisibleNoiseReport> report_of(const job::PreviewAccuracy& accuracy) {
  if (!accuracy.visible_noise) return std::nullopt;
  return VisibleNoiseReport{accuracy.visible_noise->difference.percentile_95,
                            accuracy.visible_noise->samples_needed};
}

}  // namespace

void RenderPanel::connect_preview() {
  connect(&preview_, &Preview::image_changed, this,
          [this](const auto& image, const transport::RenderProgress& progress) {
            if (final_.is_running()) return;
            if (preview_.accuracy()) show_visible_noise(report_of(*preview_.accuracy()));
            if (!preview_view_) {  // which shows it itself
              image_path_.clear();
              const auto& accuracy = preview_.accuracy();
              image_->set_image(image, accuracy
                                           ? std::shared_ptr<const image::Image>(accuracy, &accuracy->error)
                                           : nullptr);
            }
            if (progress.estimated_error && progress.done > 0) {
              curve_->add(progress.seconds, *progress.estimated_error);
            }
            show_progress(progress.done, progress.seconds_left, progress.estimated_error);
            if (preview_job_) preview_job_->show_progress(progress.done, progress.seconds_left);
          });
  connect(&preview_, &Preview::diagnosed, this, [this](const grf::Diagnostics& diagnostics) {
    if (final_.is_running()) return;
    log_->clear();
    log(QString::fromStdString(diagnostics.to_text()));
  });
  connect(&preview_, &Preview::state_changed, this, [this](PreviewState state) {
    update_actions();
    list_preview(state);
    if (final_.is_running()) return;
    if (state == PreviewState::Paused) show_status(tr("Preview paused"));
    if (state == PreviewState::Done)
      show_status(tr("Preview done") + status_->text().mid(status_->text().indexOf(" · ")));
    if (state == PreviewState::Failed) show_status(tr("Preview failed: see the log"));
  });
  connect(&preview_, &Preview::stopped, this, [this] {
    update_actions();
    list_preview(PreviewState::Done);
    show_status(tr("Preview stopped"));
  });
}

/// Lists the preview among the jobs while it renders. An edit restarts its progress.
void RenderPanel::list_preview(PreviewState state) {
  const bool is_running = state == PreviewState::Preparing || state == PreviewState::Rendering;
  if (!is_running) {
    if (const QPointer<Job> job = std::exchange(preview_job_, nullptr)) job->end();
  } else if (!preview_job_) {
    jobs_.add({tr("Preview"), PreviewQueue, [this](Job& job) { preview_job_ = &job; },
               [this] {
                 follows_ = false;
                 preview_.stop();
               },
               tr("Stop the preview")});
  } else if (state == PreviewState::Preparing) {
    preview_job_->show_progress(-1);
  }
}

void RenderPanel::toggle_preview() {
  settings_->commit();  // clicking a button does not take the focus
  if (!preview_.is_on()) return start_preview();
  if (preview_.is_paused()) {
    preview_.resume();
  } else {
    preview_.pause();
  }
}

void RenderPanel::set_threads(int threads) {
  if (threads == threads_) return;
  threads_ = threads;
  show_forecast_options();
  follow();
}

void RenderPanel::start_preview() {
  emit preview_starting();
  follows_ = preview_view_.has_value();
  restart_preview();
}

void RenderPanel::set_preview_view(const std::optional<PreviewView>& view) {
  if (view == preview_view_) return;
  const bool is_new = !preview_view_;
  preview_view_ = view;
  if (!view) {
    follows_ = false;
    return preview_.stop();
  }
  is_new ? start_preview() : follow();
}

/// Restarts a preview after a change. In a view, it is also tried again once it has failed.
void RenderPanel::follow() {
  if (preview_.is_on() || follows_) restart_preview();
}

/// The options of the preview. In a view, those that it replaces are left out, so that it does not restart
/// when only these change.
RenderOptions RenderPanel::preview_options() const {
  RenderOptions now = options_with_threads();
  if (!preview_view_) return now;
  now.size = {preview_view_->size.width(), preview_view_->size.height()};
  now.eye.reset();
  now.target.reset();
  now.up = RenderOptions().up;
  now.field_of_view = RenderOptions().field_of_view;
  now.camera.clear();
  return now;
}

void RenderPanel::restart_preview() {
  if (final_.is_running()) {  // the render has priority
    resumes_after_ = false;
    return preview_.stop();
  }
  curve_->clear();
  show_visible_noise({});
  show_status(tr("Preview"));
  previewed_options_ = preview_options();
  hiding_.stop();
  const FaceSelection& hidden = document_.editor_state().hidden;
  if (!without_hidden_->isChecked() || hidden.empty()) return show_in_preview(document_.scene());
  hiding_.start(
      [scene = document_.scene(), objects = document_.shared_objects(), hidden](const StopFlag&) {
        return without_faces({scene, *objects, hidden});
      },
      [this](const grf::Scene& scene) { show_in_preview(scene); });
}

void RenderPanel::show_in_preview(const grf::Scene& scene) {
  preview_.restart({scene, document_.path().toStdString(), previewed_options_,
                    preview_view_ ? std::optional(preview_view_->camera) : view_,
                    preview_view_ && preview_view_->denoises,
                    preview_view_ ? preview_view_->region : std::nullopt});
  update_actions();
}

}  // namespace editor
