#include "editor/rendering/render_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/text.h"
#include "editor/document/document.h"
#include "editor/document/geometry_edits.h"
#include "editor/document/op_document.h"
#include "editor/document/op_files.h"
#include "editor/jobs/job_list.h"
#include "editor/rendering/effect_renders.h"
#include "editor/rendering/error_curve.h"
#include "editor/rendering/fitted_image.h"
#include "editor/rendering/forecast_row.h"
#include "editor/rendering/render_dialogs.h"
#include "editor/rendering/render_files.h"
#include "editor/rendering/render_history.h"
#include "editor/rendering/render_settings_row.h"
#include "renderer/options/op_file.h"

namespace editor {

using options::RenderOptions;

namespace {

const QString RenderQueue = QStringLiteral("renders");

}  // namespace

RenderPanel::RenderPanel(Document& document, JobList& jobs, const QString& program, QWidget* parent)
    : QWidget(parent),
      document_(document),
      jobs_(jobs),
      options_(document.options()),
      final_(program),
      forecast_(program),
      program_(program) {
  make_actions();
  lay_out();
  connect_preview();
  connect_final();
  connect_forecast();
  connect(&document_, &Document::changed, this, &RenderPanel::follow);
  connect(&document_, &Document::path_changed, this, &RenderPanel::follow);
  connect(&document_, &Document::editor_state_changed, this, [this] {
    if (without_hidden_->isChecked()) follow();
  });
  connect(&options_, &OpDocument::changed, this, &RenderPanel::show_options);
  connect(&options_, &OpDocument::path_changed, this,
          [this] { log(QString::fromStdString(options_.diagnostics().to_text())); });
  show_options();
  update_actions();
  show_status(tr("Ready"));
}

void RenderPanel::make_actions() {
  const auto make = [this](const QString& name, const QString& text, const QKeySequence& shortcut,
                           auto function) {
    auto* action = new QAction(icon(name), text, this);
    action->setShortcut(shortcut);
    connect(action, &QAction::triggered, this, function);
    addAction(action);
    return action;
  };
  preview_action_ = make("preview", tr("Preview"), Qt::Key_F5, &RenderPanel::toggle_preview);
  render_action_ = make("render", tr("Render"), Qt::Key_F6, &RenderPanel::render);
  cameras_action_ =
      make("camera", tr("Render &cameras…"), Qt::CTRL | Qt::Key_F6, &RenderPanel::render_cameras);
  cameras_action_->setToolTip(tr("Queue a render per camera that is chosen"));
  effects_action_ = make("render", tr("Render &effects separately…"), Qt::CTRL | Qt::SHIFT | Qt::Key_F6,
                         &RenderPanel::render_effects);
  effects_action_->setToolTip(tr("Queue a render per effect that the scene has, such as textures"));
  animation_action_ =
      make("render", tr("Render &animation…"), Qt::SHIFT | Qt::Key_F6, &RenderPanel::render_animation);
  animation_action_->setToolTip(tr("Queue a render of a turntable, or of a path through the cameras"));
  compare_action_ = make("swap", tr("Compare with the &last render"), QKeySequence("Ctrl+Alt+C"),
                         &RenderPanel::comparison_requested);
  stop_action_ = make("stop", tr("Stop"), Qt::SHIFT | Qt::Key_F5, &RenderPanel::stop);
  options_action_ = make("options", tr("Options…"), {}, &RenderPanel::options_requested);
  options_action_->setToolTip(tr("All render options, with their meanings"));
  make_accuracy_actions();
}

QWidget* RenderPanel::make_controls() {
  auto* controls = new QWidget(this);
  auto* column = tight_layout<QVBoxLayout>(controls, Grid);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(Grid);
  for (QAction* action : {preview_action_, render_action_, stop_action_, options_action_}) {
    auto* button = new QToolButton(controls);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setMinimumHeight(4 * Grid);
    button->setAccessibleName(action->text());
    buttons->addWidget(button);
  }
  settings_ = new RenderSettingsRow(controls);
  without_hidden_ = new QCheckBox(tr("Without &hidden faces"), controls);
  without_hidden_->setAccessibleName(tr("Without hidden faces"));
  without_hidden_->setToolTip(
      tr("Preview the scene without the faces that are hidden in the 3D view; final renders have all faces"));
  connect(without_hidden_, &QCheckBox::toggled, this, &RenderPanel::follow);
  auto* shows_error = new QCheckBox(tr("Error of &pixels"), controls);
  shows_error->setAccessibleName(tr("Error of pixels"));
  shows_error->setToolTip(error_action_->toolTip());
  connect(shows_error, &QCheckBox::toggled, error_action_, &QAction::setChecked);
  connect(error_action_, &QAction::toggled, shows_error, &QCheckBox::setChecked);
  auto* switches = new QHBoxLayout;
  switches->addWidget(without_hidden_);
  switches->addWidget(shows_error);
  switches->addWidget(make_machines(controls));
  progress_ = new QProgressBar(controls);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(Grid);
  progress_->setAccessibleName(tr("Progress"));
  progress_->setToolTip(tr("Progress of the render towards its samples, target error or time limit"));
  status_ = new QLabel(controls);
  status_->setAccessibleName(tr("State of the render"));
  status_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  column->addLayout(buttons);
  column->addWidget(settings_);
  column->addLayout(switches);
  forecast_row_ = new ForecastRow(controls);
  column->addWidget(forecast_row_);
  column->addStretch();
  column->addWidget(progress_);
  column->addWidget(status_);
  visible_noise_ = make_visible_noise(controls);
  column->addWidget(visible_noise_);
  return controls;
}

QPlainTextEdit* RenderPanel::make_log() {
  auto* log = new QPlainTextEdit(this);
  log->setReadOnly(true);
  log->setFrameStyle(QFrame::NoFrame);
  log->setFont(QFontDatabase::systemFont(
      QFontDatabase::FixedFont));  // fixed width, so that carets are under their words
  log->document()->setDocumentMargin(Grid);
  log->setMaximumBlockCount(2000);
  log->setLineWrapMode(QPlainTextEdit::NoWrap);
  log->setPlaceholderText(tr("Messages of the renderer appear here"));
  log->setAccessibleName(tr("Log"));
  log->setToolTip(tr("Messages of the renderer about the scene and its progress"));
  log->setMinimumSize(20 * Grid, 6 * Grid);
  return log;
}

void RenderPanel::lay_out() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(Grid, Grid, Grid, Grid);
  row->setSpacing(Grid);
  QWidget* controls = make_controls();
  controls->setFixedWidth(53 * Grid);
  auto* parts = new QSplitter(Qt::Horizontal, this);
  parts->setChildrenCollapsible(false);
  parts->setHandleWidth(Grid);
  parts->addWidget(make_picture());
  auto* course = new QSplitter(Qt::Vertical, parts);
  course->setChildrenCollapsible(false);
  course->setHandleWidth(Grid);
  curve_ = new ErrorCurve(course);
  log_ = make_log();
  course->addWidget(log_);
  course->setSizes({16 * Grid, 12 * Grid});
  history_ = new RenderHistory(parts);
  history_->setFrameStyle(QFrame::NoFrame);
  history_->setMinimumWidth(27 * Grid);
  parts->setSizes({48 * Grid, 46 * Grid, 36 * Grid});
  row->addWidget(controls);
  row->addWidget(parts, 1);
  connect(settings_, &RenderSettingsRow::edited, this,
          [this] { options_.set_options(tr("Change render options"), settings_->options()); });
  connect(image_, &FittedImage::activated, this, &RenderPanel::open_image);
  connect(history_, &RenderHistory::image_chosen, this, &RenderPanel::image_opened);
}

void RenderPanel::connect_final() {
  connect(&final_, &FinalRender::started, this, [this](const QString& output) {
    curve_->clear();
    log_->clear();
    log(tr("Rendering %1").arg(output));
    show_visible_noise({});
    show_progress(0, {}, {});
    update_actions();
  });
  connect(&final_, &FinalRender::progressed, this, [this](const RenderReport& report) {
    if (report.estimated_error && !report.farm) curve_->add(report.seconds, *report.estimated_error);
    show_progress(report.done, report.seconds_left, report.estimated_error, report.farm);
    if (job_) job_->show_progress(report.done, report.seconds_left);
  });
  connect(&final_, &FinalRender::image_changed, this, [this](const auto& image) {
    image_path_ = final_.output();
    image_->set_image(image);
  });
  connect(&final_, &FinalRender::logged, this, &RenderPanel::log);
  connect(&final_, &FinalRender::finished, this, &RenderPanel::finish);
  connect(&final_, &FinalRender::failed, this, [this](const QString& why) {
    log(why);
    show_status(tr("Render failed: %1").arg(why.section('\n', 0, 0)));
    update_actions();
    if (std::exchange(resumes_after_, false)) preview_.resume();
    if (!preview_.is_on()) follow();
    end_job();
    follow_forecast();
  });
}

void RenderPanel::finish(const FinalRenderResult& result) {
  if (image_->image()) history_->add(result, *image_->image());
  std::erase_if(replacements_, [&](const auto& former) { return former.image == result.image; });
  if (!result.former.isEmpty()) replacements_.push_back(result);
  if (!result.is_stopped) progress_->setValue(progress_->maximum());
  show_visible_noise(result.summary.visible_noise);
  QString text = result.is_stopped ? tr("Stopped, image kept") : tr("Done");
  const double samples = result.summary.samples;
  text += " · " + (samples == 1 ? tr("1 sample") : tr("%1 samples").arg(samples, 0, 'g', 4)) + " · " +
          duration_text(result.summary.seconds);
  if (result.summary.estimated_error)
    text += " · " + tr("error %1").arg(percent_text(*result.summary.estimated_error));
  show_status(text);
  log(text);
  update_actions();
  const bool was_paused = std::exchange(resumes_after_, false);
  if (preview_view_ && was_paused) {
    preview_.resume();
  } else if (!preview_.is_on()) {
    follow();  // in the dock, preview images would hide this one
  }
  end_job();
  follow_forecast();
}

void RenderPanel::show_options() {
  const RenderOptions& now = options_.valid_options();
  const bool is_from_there = view_ && now.eye == grf::Vec3f(view_->eye) &&
                             now.target == grf::Vec3f(view_->target) && now.up == view_->up &&
                             now.field_of_view == view_->field_of_view;
  if (!is_from_there) view_.reset();
  settings_->set_options(now);
  curve_->set_target(now.target_error);
  show_forecast_options();
  if (!preview_view_ || preview_options() != previewed_options_) follow();
}

RenderOptions RenderPanel::options_with_threads() const {
  RenderOptions result = options_.valid_options();
  if (result.threads == 0) result.threads = threads_;
  return result;
}

FinalRenderRequest RenderPanel::final_request() const {
  const bool is_on_farm = machines_->currentIndex() == OnFarm;
  return {document_.scene(),
          document_.path(),
          options_with_threads(),
          document_.imports(),
          false,
          is_on_farm ? std::optional(farm_) : std::nullopt};
}

void RenderPanel::render() {
  settings_->commit();
  queue({final_request()});
}

void RenderPanel::render_cameras() {
  settings_->commit();
  const auto names = ask_for_cameras(options_.valid_options(), this);
  if (!names) return;
  std::vector<FinalRenderRequest> requests;
  for (const std::string& name : *names) {
    FinalRenderRequest& request = requests.emplace_back(final_request());
    request.options.output = file_of_camera(final_.output_of(request), name).toStdString();
    request.options.camera = name;
  }
  queue(std::move(requests));
}

/// Planning takes long for a large scene.
void RenderPanel::render_effects() {
  settings_->commit();
  using Planned = std::pair<std::vector<EffectRender>, QString>;
  const auto plan = [request = final_request()] {
    grf::Diagnostics diagnostics;
    auto effects = effect_renders(request, diagnostics);
    return Planned(std::move(effects), text_of(diagnostics));
  };
  const auto take = [this, request = final_request()](const Planned& planned) {
    log(planned.second);
    choose_effects(request, planned.first);
  };
  jobs_.add({tr("Find the effects of the scene"),
             QStringLiteral("plans"),
             [plan, take](Job& job) { job.run(plan, take); },
             {},
             tr("Cancel: nothing is rendered")});
}

void RenderPanel::choose_effects(const FinalRenderRequest& request,
                                 const std::vector<EffectRender>& effects) {
  if (effects.empty()) return show_status(tr("The plan finds no effect to render"));
  const auto chosen = ask_for_effects(effects, this);
  if (!chosen) return;
  std::vector<FinalRenderRequest> requests;
  for (const EffectRender& effect : *chosen) requests.push_back(request_of(effect, request, final_));
  emit images_requested();
  queue(std::move(requests));
}

void RenderPanel::render_animation() {
  settings_->commit();
  const auto animation = ask_for_animation(options_.valid_options(), this);
  if (!animation) return;
  FinalRenderRequest request = final_request();
  request.options = *animation;
  queue({std::move(request)});
}

/// Renders the scene and its options as they are now, also if a render is queued.
void RenderPanel::queue(std::vector<FinalRenderRequest> requests) {
  QStringList others;
  for (FinalRenderRequest& request : requests) {
    for (const QString& image : final_.images_of(request)) {
      if (!final_.is_from_other_session(image)) continue;
      request.may_overwrite = true;
      others << image;
    }
  }
  if (!others.isEmpty() && !may_overwrite(others)) return;
  keep_op_file();
  for (const FinalRenderRequest& request : requests) {
    const QStringList images = final_.images_of(request);
    const QString name = QFileInfo(images.front()).fileName();
    const auto more = images.size() - 1;
    jobs_.add({more > 0 ? tr("Render %1 and %2 more").arg(name).arg(more) : tr("Render %1").arg(name),
               RenderQueue, [this, request](Job& job) { begin(job, request); }, [this] { stop(); },
               tr("Stop this render and keep its image")});
  }
}

void RenderPanel::begin(Job& job, const FinalRenderRequest& request) {
  job_ = &job;
  resumes_after_ = preview_.is_on() && !preview_.is_paused();
  if (resumes_after_) preview_.pause();
  final_.start(request);
}

/// Ends the current job, so that the next render starts.
void RenderPanel::end_job() {
  if (job_) job_->end();
}

const FinalRenderResult* RenderPanel::last_render_of(const QString& image) const {
  if (replacements_.empty()) return nullptr;
  const auto found = std::ranges::find_if(
      replacements_, [&](const auto& result) { return result.image == image || result.copy == image; });
  return found == replacements_.end() ? &replacements_.back() : &*found;
}

bool RenderPanel::may_overwrite(const QStringList& images) {
  const auto more = images.size() - 1;
  const QString what = more == 0 ? tr("%1 exists.").arg(images.front())
                                 : tr("%1 and %2 more images exist.").arg(images.front()).arg(more);
  QMessageBox question(QMessageBox::Warning, tr("Replace the image"), what,
                       QMessageBox::Save | QMessageBox::Cancel, this);
  question.setInformativeText(more == 0
                                  ? tr("It was not rendered in this session. Rendering overwrites it.")
                                  : tr("They were not rendered in this session. Rendering overwrites them."));
  question.button(QMessageBox::Save)->setText(tr("Replace"));
  question.setDefaultButton(QMessageBox::Cancel);
  return question.exec() == QMessageBox::Save;
}

void RenderPanel::stop() {
  if (final_.is_running()) {
    show_status(tr("Stopping: the image is kept"));
    return final_.stop();
  }
  follows_ = false;
  hiding_.stop();
  preview_.stop();
}

/// Changes an existing OP file only if its author agrees.
void RenderPanel::keep_op_file() {
  if (document_.path().isEmpty()) return;
  const QString op_file = op_file_beside(document_.path());
  grf::Diagnostics diagnostics;
  if (!QFileInfo::exists(op_file)) {
    options_.save_beside(document_.path(), diagnostics);
    return log(QString::fromStdString(diagnostics.to_text()));
  }
  // Its errors were reported when the scene was opened.
  auto there = options::read_op_file(QFileInfo(op_file).absoluteFilePath().toStdString(), diagnostics);
  RenderOptions now = options_.valid_options();
  if (there) now.scene = there->scene;
  if (!there || !(*there == now)) emit op_file_differs(op_file);
}

void RenderPanel::show_progress(double done, std::optional<double> seconds_left, std::optional<double> error,
                                const std::optional<FarmReport>& farm) {
  progress_->setValue(static_cast<int>(done * progress_->maximum()));
  QString text = final_.is_running() ? tr("Rendering") : tr("Preview");
  text += " · " + tr("%1 %").arg(100 * done, 0, 'f', 0);
  if (seconds_left && done < 1) text += " · " + tr("%1 left").arg(duration_text(*seconds_left));
  if (error) text += " · " + tr("error %1").arg(percent_text(*error));
  if (farm) {
    text += " · " + tr("%1 of %2 parts").arg(farm->parts_done).arg(farm->parts) + " · " +
            (farm->workers == 0 ? tr("no workers: `bpt farm work` starts one")
                                : tr("%n worker(s)", nullptr, farm->workers));
  }
  show_status(text);
}

void RenderPanel::show_status(const QString& text) {
  status_->setText(text);
  status_->setToolTip(text);
}

void RenderPanel::log(const QString& text) {
  const QString trimmed = text.trimmed();
  if (!trimmed.isEmpty()) log_->appendPlainText(trimmed);
}

void RenderPanel::open_image() {
  if (image_path_.isEmpty()) return emit preview_opened();
  if (QFileInfo::exists(image_path_)) emit image_opened(image_path_);
}

void RenderPanel::update_actions() {
  const bool renders = final_.is_running();
  const bool is_paused = preview_.is_paused();
  const auto set = [](QAction* action, bool is_enabled, const QString& tip) {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    action->setEnabled(is_enabled);
    action->setToolTip(tr("%1 (%2)").arg(tip, key));
  };
  preview_action_->setText(!preview_.is_on() ? tr("Preview") : is_paused ? tr("Resume") : tr("Pause"));
  preview_action_->setIcon(icon(preview_.is_on() && !is_paused ? "pause" : "preview"));
  set(preview_action_, !renders,
      renders ? tr("A render is already running: its image is shown until it is done")
              : tr("Render a progressive preview that follows your edits"));
  set(render_action_, true,
      renders ? tr("Queue a render of the scene as it is now")
              : tr("Render the scene as it is now to the image file"));
  set(compare_action_, !replacements_.empty(),
      replacements_.empty() ? tr("No render of this session has replaced an image yet: render once more")
                            : tr("Compare the image of the last render with the one that it replaced"));
  set(stop_action_, renders || preview_.is_on(),
      renders            ? tr("Stop the render and keep its image")
      : preview_.is_on() ? tr("Stop the preview")
                         : tr("No render is running"));
}

}  // namespace editor
