#include "editor/tools/study_window.h"

#include <QApplication>
#include <QClipboard>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QPointer>
#include <QProgressBar>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "editor/appearance/theme.h"
#include "editor/controls/actions.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/notice_bar.h"
#include "editor/controls/text.h"
#include "editor/tools/figure_view.h"
#include "editor/tools/study_form.h"
#include "grf/text_file.h"

namespace editor {
namespace {

constexpr int FormWidth = 42 * Grid;
constexpr int SlowAfter = 300;   // milliseconds until work shows its progress
constexpr int FrameEvery = 120;  // milliseconds between steps of an animation
constexpr int Frames = 31;       // of an exported animation
constexpr const char* StateExtension = "study";

const grf::ParameterInfo* parameter_of(const studies::StudyTool& tool, std::string_view name) {
  return name.empty() ? nullptr : tool.settings.find(name);
}

/// Sets a number among the settings of a state, within its range.
void set_setting(const grf::ParameterInfo& parameter, double value, studies::ToolState& state) {
  const auto number = static_cast<float>(std::clamp<double>(value, parameter.minimum, parameter.maximum));
  studies::set_number(state.settings, parameter.name, number);
}

}  // namespace

StudyWindow::StudyWindow(const studies::StudyTool& tool, QWidget* parent)
    : QMainWindow(parent),
      tool_(tool),
      state_(tool.initial),
      steps_{state_},
      notice_(new NoticeBar),
      figure_(new FigureView),
      form_(new StudyForm(tool_)),
      pointed_(new QLabel),
      progress_(new QProgressBar),
      slow_(new QTimer(this)),
      playing_(new QTimer(this)) {
  setAcceptDrops(true);
  setWindowTitle(tr("%1 - wannabe").arg(text_of(tool_.settings.title)));
  lay_out();
  make_status_line();
  make_file_menu();
  make_edit_menu();
  make_view_menu();
  connect(form_, &StudyForm::edited, this, &StudyWindow::edit);
  connect(form_, &StudyForm::files_requested, this, &StudyWindow::ask_for_files);
  connect(figure_, &FigureView::turned, this, &StudyWindow::turn);
  connect(figure_, &FigureView::pointed, this, [this](const QPointF& at) {
    const bool has_description = study_ && study_->describe;
    pointed_->setText(has_description ? QString::fromStdString(study_->describe({at.x(), at.y()}))
                                      : QString());
  });
  connect(figure_, &FigureView::pointer_left, this, [this] { pointed_->clear(); });
  connect(figure_, &FigureView::rendered, this, [this] {
    if (!job_.is_busy()) emit updated();
  });
  slow_->setSingleShot(true);
  connect(slow_, &QTimer::timeout, this, [this] { progress_->show(); });
  connect(playing_, &QTimer::timeout, this, &StudyWindow::show_step);
  resize(150 * Grid, 88 * Grid);
  restoreGeometry(QSettings().value("tools/" + text_of(tool_.name()) + "/geometry").toByteArray());
  request();
}

StudyWindow::~StudyWindow() = default;

void StudyWindow::lay_out() {
  auto* splitter = new QSplitter(Qt::Horizontal);
  splitter->setChildrenCollapsible(false);
  splitter->setHandleWidth(Grid);
  splitter->addWidget(figure_);
  auto* scroll = new QScrollArea;
  scroll->setWidget(form_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(FormWidth);
  splitter->addWidget(scroll);
  splitter->setStretchFactor(0, 1);
  splitter->setSizes({width() - FormWidth, FormWidth});
  auto* middle = new QWidget;
  auto* layout = tight_layout<QVBoxLayout>(middle, 0);
  layout->addWidget(notice_);
  layout->addWidget(splitter, 1);
  setCentralWidget(middle);
}

void StudyWindow::make_status_line() {
  pointed_->setAccessibleName(tr("What is under the pointer"));
  pointed_->setContentsMargins(Grid, 0, 0, 0);
  pointed_->setTextFormat(Qt::PlainText);
  pointed_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  statusBar()->addWidget(pointed_, 1);
  progress_->setRange(0, 0);
  progress_->setFixedWidth(16 * Grid);
  progress_->setAccessibleName(tr("Progress"));
  progress_->hide();
  statusBar()->addPermanentWidget(progress_);
}

void StudyWindow::make_file_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  menu->setToolTipsVisible(true);
  menu->addAction(new_action(*this,
                             {tr("&Open..."), "open", QKeySequence::Open,
                              tr("Open the settings of a figure, or files that the tool shows")},
                             [this] { ask_for_files(); }));
  menu->addAction(new_action(*this,
                             {tr("&Save settings..."), "save", QKeySequence::Save,
                              tr("Save the settings as text, from which the figure can be made again")},
                             [this] { ask_to_save_state(); }));
  menu->addSeparator();
  menu->addAction(new_action(
      *this,
      {tr("&Export figure..."), "export", QKeySequence("Ctrl+E"), tr("Export the figure as SVG, PNG or PDF")},
      [this] {
        ask_to_export(tr("Export the figure"), ".svg", tr("SVG (*.svg);;PNG (*.png);;PDF (*.pdf)"),
                      [this](const QString& path) { export_figure(path); });
      }));
  export_data_ = new_action(*this,
                            {tr("Export &data..."),
                             {},
                             QKeySequence("Ctrl+Shift+E"),
                             tr("Export the values of the figure, or its images")},
                            [this] { ask_to_export_data(); });
  menu->addAction(export_data_);
  if (const grf::ParameterInfo* animated = parameter_of(tool_, tool_.animated)) {
    menu->addAction(new_action(
        *this,
        {tr("Export &animation..."),
         {},
         QKeySequence("Ctrl+Alt+E"),
         tr("Export a picture for each of %1 steps of %2").arg(Frames).arg(text_of(animated->name))},
        [this] {
          ask_to_export(tr("Export the animation"), ".png", tr("PNG (*.png);;SVG (*.svg);;PDF (*.pdf)"),
                        [this](const QString& path) { export_animation(path, Frames); });
        }));
  }
  menu->addSeparator();
  menu->addAction(new_action(*this, {tr("&Close"), "close", QKeySequence::Close, tr("Close this window")},
                             [this] { close(); }));
}

void StudyWindow::make_edit_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  menu->setToolTipsVisible(true);
  undo_ =
      new_action(*this, {tr("&Undo"), "undo", QKeySequence::Undo, tr("Undo the last change of the settings")},
                 [this] { go_to(step_ - 1); });
  redo_ = new_action(*this, {tr("&Redo"), "redo", QKeySequence::Redo, tr("Redo the change that was undone")},
                     [this] { go_to(step_ + 1); });
  menu->addAction(undo_);
  menu->addAction(redo_);
  menu->addSeparator();
  menu->addAction(
      new_action(*this, {tr("&Copy settings"), "copy", QKeySequence::Copy, tr("Copy the settings as text")},
                 [this] { QApplication::clipboard()->setText(QString::fromStdString(to_text(state_))); }));
  menu->addAction(new_action(*this,
                             {tr("&Paste settings"), {}, QKeySequence::Paste, tr("Paste settings from text")},
                             [this] { read(QApplication::clipboard()->text(), tr("clipboard")); }));
  menu->addAction(new_action(*this,
                             {tr("Reset &all settings"), "reset", QKeySequence("Ctrl+Shift+R"),
                              tr("Reset the tool to its first settings")},
                             [this] { set_state(tool_.initial); }));
  apply_ = new_action(*this,
                      {tr("Apply to the &faces"), "brdf", QKeySequence("Ctrl+Return"),
                       tr("Apply the BRDF to the faces that are selected in the editor")},
                      [this] { emit applied(state_.brdfs.front()); });
  menu->addAction(apply_);
  set_apply_target(false);
  remember();
}

void StudyWindow::make_view_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  menu->setToolTipsVisible(true);
  if (const grf::ParameterInfo* animated = parameter_of(tool_, tool_.animated)) {
    menu->addAction(
        new_switch(*this,
                   {tr("&Play"), "preview", QKeySequence("Ctrl+Space"),
                    tr("Show all values of %1 one after the other").arg(text_of(animated->name))},
                   false, [this](bool is_on) { is_on ? playing_->start(FrameEvery) : playing_->stop(); }));
  }
  stop_ = new_action(
      *this, {tr("&Stop"), "stop", QKeySequence(Qt::Key_Escape), tr("Stop computing the figure")}, [this] {
        job_.stop();
        show_busy(false);
      });
  menu->addAction(stop_);
  show_busy(false);
}

bool StudyWindow::has_picture() const { return study_ ? !figure_->image().isNull() : !is_busy(); }

bool StudyWindow::is_busy() const { return job_.is_busy() || figure_->is_busy(); }

void StudyWindow::set_brdf(const grf::BrdfModel& brdf, const std::vector<grf::Definition>& definitions) {
  if (tool_.brdfs == 0) return;
  studies::ToolState state = state_;
  state.definitions = definitions;
  state.brdfs.front() = brdf;
  set_state(state);
}

void StudyWindow::set_apply_target(bool has_target) {
  const QString why_not = tool_.brdfs == 0 ? tr("This tool has no BRDF of its own.")
                          : has_target     ? QString()
                                           : tr("Open this tool from the editor to apply its BRDF to faces.");
  apply_->setEnabled(why_not.isEmpty());
  apply_->setToolTip(why_not.isEmpty() ? tr("Apply the BRDF to the faces that are selected in the editor")
                                       : why_not);
}

void StudyWindow::set_state(const studies::ToolState& state) {
  form_->set_state(state);
  edit(state, true);
}

void StudyWindow::edit(const studies::ToolState& state, bool is_done) {
  state_ = state;
  if (is_done) remember();
  request();
}

/// Makes the current state an undo step, unless it is one.
void StudyWindow::remember() {
  if (steps_[step_] != state_) {
    steps_.resize(step_ + 1);
    steps_.push_back(state_);
    ++step_;
  }
  undo_->setEnabled(step_ > 0);
  redo_->setEnabled(step_ + 1 < steps_.size());
}

void StudyWindow::go_to(std::size_t step) {
  if (step >= steps_.size()) return;
  step_ = step;
  state_ = steps_[step_];
  form_->set_state(state_);
  remember();
  request();
}

void StudyWindow::request() {
  const plot::Paper paper = theme_of(palette()) == Theme::Dark ? plot::Paper::Dark : plot::Paper::White;
  show_busy(true);
  job_.start(
      [window = QPointer<StudyWindow>(this), state = state_, paper, cache = cache_](const StopFlag& stop) {
        auto outcome = std::make_shared<Outcome>();
        grf::Diagnostics diagnostics;
        studies::StudyContext context{paper, [stop] { return stop.is_set(); }, {}, cache};
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
  const bool has_no_files = tool_.needs_file && state_.files.empty();
  if (outcome.messages.isEmpty() || has_no_files) {
    notice_->hide();
  } else {
    notice_->show_notice(outcome.has_errors ? NoticeBar::Kind::Error : NoticeBar::Kind::Information,
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
  export_data_->setEnabled(!studies::data_files_of(*study_).empty());
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

double StudyWindow::setting(std::string_view name) const {
  const grf::ParameterInfo* parameter = parameter_of(tool_, name);
  const grf::Argument* argument =
      parameter != nullptr ? grf::find_argument(state_.settings, *parameter) : nullptr;
  const auto* number = argument != nullptr ? std::get_if<float>(&argument->value) : nullptr;
  if (number != nullptr) return *number;
  return parameter != nullptr ? parameter->default_value : 0;
}

void StudyWindow::turn(const QPointF& by, bool is_done) {
  constexpr double DegreesPerPixel = 0.6;
  if (tool_.turn != nullptr) {
    studies::ToolState state = state_;
    tool_.turn(state, -DegreesPerPixel * by.x(), DegreesPerPixel * by.y());
    form_->set_state(state);
    return edit(state, is_done);
  }
  const grf::ParameterInfo* azimuth = parameter_of(tool_, tool_.azimuth);
  const grf::ParameterInfo* elevation = parameter_of(tool_, tool_.elevation);
  if (azimuth == nullptr || elevation == nullptr) return;
  studies::ToolState state = state_;
  set_setting(*azimuth, std::remainder(setting(azimuth->name) - DegreesPerPixel * by.x(), 360), state);
  set_setting(*elevation, setting(elevation->name) + DegreesPerPixel * by.y(), state);
  form_->set_state(state);
  edit(state, is_done);
}

/// Goes to the next value of the animated setting once the figure of the last one is shown.
void StudyWindow::show_step() {
  if (is_busy()) return;
  const grf::ParameterInfo* animated = parameter_of(tool_, tool_.animated);
  const double step = (animated->maximum - animated->minimum) / (2.0 * Frames);
  double value = setting(tool_.animated) + step;
  if (value > animated->maximum) value = animated->minimum;
  studies::ToolState state = state_;
  set_setting(*animated, value, state);
  form_->set_state(state);
  edit(state, false);
}

void StudyWindow::report(const QString& message) {
  if (!message.isEmpty()) notice_->show_notice(NoticeBar::Kind::Error, message);
}

bool StudyWindow::read(const QString& text, const QString& path) {
  grf::Diagnostics diagnostics;
  const auto state = studies::read_state(text.toStdString(), path.toStdString(), diagnostics);
  // Without checking the parts first, the form would have to show what it has no rows for.
  if (state && check(*state, tool_, diagnostics)) {
    set_state(*state);
    return true;
  }
  report(text_of(diagnostics));
  return false;
}

void StudyWindow::open(const QStringList& files) {
  studies::ToolState state = state_;
  bool has_files = false;
  for (const QString& path : files) {
    if (QFileInfo(path).suffix().toLower() == StateExtension || tool_.files.empty()) {
      grf::Diagnostics diagnostics;
      const auto text = grf::read_file(path.toStdString(), diagnostics);
      if (!text) return report(text_of(diagnostics));
      if (!read(QString::fromStdString(*text), path)) return;
      state = state_;
      continue;
    }
    if (!tool_.takes_many_files) state.files.clear();
    state.files.push_back({path.toStdString(), {}});
    has_files = true;
  }
  if (!has_files) return;
  grf::Diagnostics diagnostics;
  if (tool_.open != nullptr) tool_.open(state, diagnostics);
  set_state(state);
}

void StudyWindow::ask_for_files() {
  QStringList patterns = {QString("*.%1").arg(StateExtension)};
  for (const QString& extension : QString::fromStdString(tool_.files).split(' ', Qt::SkipEmptyParts))
    patterns.append("*." + extension);
  open(QFileDialog::getOpenFileNames(this, tr("Open"), {},
                                     tr("Files of this tool (%1)").arg(patterns.join(' '))));
}

void StudyWindow::ask_to_save_state() {
  ask_to_export(tr("Save the settings"), QString(".%1").arg(StateExtension),
                tr("Settings (*.%1)").arg(StateExtension), [this](const QString& path) { save_state(path); });
}

void StudyWindow::ask_to_export(const QString& title, const QString& name, const QString& filter,
                                const std::function<void(const QString&)>& write) {
  auto* dialog = new QFileDialog(this, title, text_of(tool_.name()) + name, filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(name.mid(1));
  connect(dialog, &QFileDialog::fileSelected, this, write);
  dialog->open();
}

void StudyWindow::write(const QString& path,
                        const std::function<void(grf::Diagnostics&, const StopFlag&)>& work) {
  writing_.start(
      [work](const StopFlag& stop) {
        grf::Diagnostics diagnostics;
        work(diagnostics, stop);
        return diagnostics.has_errors() ? text_of(diagnostics) : QString();
      },
      [this, path](const QString& message) {
        report(message);
        if (message.isEmpty()) statusBar()->showMessage(tr("Wrote %1").arg(path));
        emit written(path, message);
      });
}

void StudyWindow::save_state(const QString& path) {
  write(path, [file = path.toStdString(), state = state_](grf::Diagnostics& diagnostics, const StopFlag&) {
    grf::replace_file(file, to_text(state, file), diagnostics);
  });
}

void StudyWindow::export_figure(const QString& path) {
  write(path, [file = path.toStdString(), state = state_](grf::Diagnostics& diagnostics, const StopFlag&) {
    if (const auto study = study_of(state, {}, diagnostics)) write_picture(study->figure, file, diagnostics);
  });
}

void StudyWindow::export_data(const QString& path) {
  // What is shown is exported; to make it once more may take long.
  const auto shown = is_busy() ? std::nullopt : study_;
  write(path,
        [shown, file = path.toStdString(), state = state_](grf::Diagnostics& diagnostics, const StopFlag&) {
          const auto study = shown ? shown : study_of(state, {}, diagnostics);
          if (study) write_data(*study, file, diagnostics);
        });
}

void StudyWindow::ask_to_export_data() {
  if (!study_) return;
  QStringList filters;
  const std::vector<studies::DataFile> files = studies::data_files_of(*study_);
  for (const studies::DataFile& file : files)
    filters.append(QString("%1 (*.%2)").arg(text_of(file.title), text_of(file.extension)));
  if (files.empty()) return;
  ask_to_export(tr("Export the data"), '.' + text_of(files.front().extension), filters.join(";;"),
                [this](const QString& path) { export_data(path); });
}

void StudyWindow::export_animation(const QString& path, int count) {
  const grf::ParameterInfo* animated = parameter_of(tool_, tool_.animated);
  if (animated == nullptr) return;
  const QFileInfo file(path);
  const QString base = file.path() + '/' + file.completeBaseName();
  std::vector<std::pair<std::string, studies::ToolState>> frames;
  for (int i = 0; i < count; ++i) {
    const double part = count > 1 ? static_cast<double>(i) / (count - 1) : 0;
    frames.emplace_back(
        QString("%1_%2.%3").arg(base).arg(i, 3, 10, QChar('0')).arg(file.suffix()).toStdString(), state_);
    set_setting(*animated, animated->minimum + part * (animated->maximum - animated->minimum),
                frames.back().second);
  }
  write(path, [frames](grf::Diagnostics& diagnostics, const StopFlag& stop) {
    for (const auto& [frame, state] : frames) {
      if (stop.is_set()) return;
      const auto study = study_of(state, {}, diagnostics);
      if (!study || !write_picture(study->figure, frame, diagnostics)) return;
    }
  });
}

void StudyWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) request();
  QMainWindow::changeEvent(event);
}

void StudyWindow::closeEvent(QCloseEvent* event) {
  QSettings().setValue("tools/" + text_of(tool_.name()) + "/geometry", saveGeometry());
  QMainWindow::closeEvent(event);
}

void StudyWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!local_files(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void StudyWindow::dropEvent(QDropEvent* event) {
  open(local_files(*event->mimeData()));
  event->acceptProposedAction();
}

}  // namespace editor
