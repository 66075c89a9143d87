#include "editor/tools/study_window.h"

#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QPointer>
#include <QProgressBar>
#include <QStatusBar>
#include <QTimer>

#include "editor/appearance/theme.h"
#include "editor/controls/actions.h"
#include "editor/controls/notice_bar.h"
#include "editor/controls/text.h"
#include "editor/tools/figure_view.h"

namespace editor {
namespace {

constexpr int SlowAfter = 300;  // milliseconds until work shows its progress

}  // namespace

StudyWindow::StudyWindow(const studies::StudyTool& tool, QWidget* parent)
    : ToolWindow(tool, parent),
      figure_(new FigureView),
      progress_(new QProgressBar),
      slow_(new QTimer(this)) {
  begin(figure_);
  progress_->setRange(0, 0);
  progress_->setFixedWidth(16 * Grid);
  progress_->setAccessibleName(tr("Progress"));
  progress_->hide();
  statusBar()->addPermanentWidget(progress_);
  stop_ = new_action(
      *this, {tr("&Stop"), "stop", QKeySequence(Qt::Key_Escape), tr("Stop computing the figure")}, [this] {
        job_.stop();
        if (!model_) wanted_model_.clear();
        loader_.cancel();
        show_busy(false);
      });
  view_menu().addAction(stop_);
  show_busy(false);
  connect(figure_, &FigureView::turned, this, &StudyWindow::turn);
  connect(figure_, &FigureView::pointed, this, [this](const QPointF& at) {
    const bool has_description = study_ && study_->describe;
    pointed().setText(has_description ? QString::fromStdString(study_->describe({at.x(), at.y()}))
                                      : QString());
  });
  connect(figure_, &FigureView::pointer_left, this, [this] { pointed().clear(); });
  connect(figure_, &FigureView::rendered, this, [this] {
    if (!job_.is_busy()) emit updated();
  });
  slow_->setSingleShot(true);
  connect(slow_, &QTimer::timeout, this, [this] { progress_->show(); });
  connect(&loader_, &SceneLoader::loaded, this, [this](const std::shared_ptr<const LoadedScene>& scene) {
    model_ = scene;
    request();
  });
  connect(&loader_, &SceneLoader::failed, this, [this](const LoadFailure& failure) {
    wanted_model_.clear();
    show_outcome({{}, failure.message, true});
  });
}

StudyWindow::~StudyWindow() = default;

bool StudyWindow::has_picture() const { return study_ ? !figure_->image().isNull() : !is_busy(); }

bool StudyWindow::is_busy() const {
  return !has_followed() || is_loading() || job_.is_busy() || figure_->is_busy();
}

bool StudyWindow::is_loading() const { return !wanted_model_.isEmpty() && !model_; }

/// Has the model of the state loaded, unless it is.
void StudyWindow::request_model() {
  const studies::ToolState::File* file = tool().model != nullptr ? tool().model(state()) : nullptr;
  const QString path = file != nullptr ? QString::fromStdString(file->path) : QString();
  if (path == wanted_model_) return;
  wanted_model_ = path;
  model_.reset();
  loader_.cancel();
  if (!path.isEmpty()) loader_.start(path);
}

std::optional<studies::Study> StudyWindow::shown_study() const { return is_busy() ? std::nullopt : study_; }

std::vector<studies::DataFile> StudyWindow::data_files() const {
  return study_ ? studies::data_files_of(*study_) : std::vector<studies::DataFile>();
}

void StudyWindow::request() {
  const plot::Paper paper = theme_of(palette()) == Theme::Dark ? plot::Paper::Dark : plot::Paper::White;
  show_busy(true);
  request_model();
  if (is_loading()) return job_.stop();
  job_.start(
      [window = QPointer<StudyWindow>(this), state = state(), paper, cache = cache_,
       model = model_](const StopFlag& stop) {
        auto outcome = std::make_shared<Outcome>();
        grf::Diagnostics diagnostics;
        studies::StudyContext context;
        context.paper = paper;
        context.is_stopped = [stop] { return stop.is_set(); };
        context.cache = cache;
        if (model) context.read_scene = [model](const auto&, auto&) { return model->model.scene; };
        context.refined = [window, stop](const studies::Study& study) {
          QMetaObject::invokeMethod(
              qApp,
              [window, stop, study] {
                if (window && !stop.is_set()) window->show_study(study);
              },
              Qt::QueuedConnection);
        };
        outcome->study = study_of(state, context, diagnostics);
        outcome->messages = text_of(diagnostics);
        outcome->has_errors = diagnostics.has_errors();
        return outcome;
      },
      [this](const std::shared_ptr<Outcome>& outcome) { show_outcome(std::move(*outcome)); });
}

void StudyWindow::show_outcome(Outcome outcome) {
  show_busy(false);
  const bool has_no_files = tool().needs_file && state().files.empty();
  if (outcome.messages.isEmpty() || has_no_files) {
    notice().hide();
  } else {
    notice().show_notice(outcome.has_errors ? NoticeBar::Kind::Error : NoticeBar::Kind::Information,
                         outcome.messages);
  }
  if (!outcome.study) {
    study_.reset();
    figure_->show_hint(has_no_files ? tr("No file is open.\n\nOpen a file (Ctrl+O), or drop one here.")
                                    : tr("There is no figure for these settings: see the message above."));
    return emit updated();
  }
  show_study(std::move(*outcome.study));
}

void StudyWindow::show_study(studies::Study study) {
  study_ = std::move(study);
  export_data_action().setEnabled(!studies::data_files_of(*study_).empty());
  figure_->setAccessibleDescription(QString::fromStdString(study_->summary));
  statusBar()->showMessage({});
  figure_->show_figure(study_->figure.str(), {study_->figure.width(), study_->figure.height()});
}

void StudyWindow::show_busy(bool is_busy) {
  stop_->setEnabled(is_busy);
  if (is_busy && !progress_->isVisible()) {
    slow_->start(SlowAfter);
  } else if (!is_busy) {
    slow_->stop();
    progress_->hide();
  }
}

void StudyWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) follow();
  ToolWindow::changeEvent(event);
}

}  // namespace editor
