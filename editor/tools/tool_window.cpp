#include "editor/tools/tool_window.h"

#include <QApplication>
#include <QClipboard>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
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
#include "editor/document/model_import.h"
#include "editor/tools/scene_reading.h"
#include "editor/tools/study_form.h"
#include "grf/text_file.h"

namespace editor {
namespace {

constexpr int FormWidth = 46 * Grid;
constexpr int FrameEvery = 120;  // milliseconds between steps of an animation
constexpr int Frames = 31;       // of an exported animation
constexpr const char* StateExtension = "study";

const grf::ParameterInfo* parameter_of(const studies::StudyTool& tool, std::string_view name) {
  return name.empty() ? nullptr : tool.settings.find(name);
}

/// Exports are on white.
studies::StudyContext export_context() {
  studies::StudyContext context;
  context.read_scene = read_any_scene;
  return context;
}

/// Sets a number among the settings of a state, within its range.
void set_number(const grf::ParameterInfo& parameter, double value, studies::ToolState& state) {
  const double inside = std::clamp<double>(value, parameter.minimum, parameter.maximum);
  const auto number = static_cast<float>(parameter.is_whole ? std::round(inside) : inside);
  studies::set_value(state.settings, parameter.name, number);
}

}  // namespace

ToolWindow::ToolWindow(const studies::StudyTool& tool, QWidget* parent)
    : QMainWindow(parent),
      tool_(tool),
      state_(tool.initial),
      steps_{state_},
      notice_(new NoticeBar(this)),
      form_(new StudyForm(tool_, this)),
      pointed_(new QLabel(this)),
      playing_(new QTimer(this)),
      played_steps_(2 * Frames) {
  playing_->setInterval(FrameEvery);
  setAcceptDrops(true);
  setWindowTitle(tr("%1 - wannabe").arg(text_of(tool_.settings.title)));
  connect(form_, &StudyForm::edited, this, &ToolWindow::edit);
  connect(form_, &StudyForm::files_requested, this, &ToolWindow::ask_for_files);
  connect(playing_, &QTimer::timeout, this, &ToolWindow::show_step);
}

ToolWindow::~ToolWindow() = default;

void ToolWindow::begin(QWidget* canvas) {
  lay_out(canvas);
  make_status_line();
  make_file_menu();
  make_edit_menu();
  make_view_menu();
  resize(150 * Grid, 88 * Grid);
  restoreGeometry(QSettings().value("tools/" + text_of(tool_.name()) + "/geometry").toByteArray());
  QTimer::singleShot(0, this, [this] {
    if (!has_followed_) follow();
  });
}

void ToolWindow::follow() {
  has_followed_ = true;
  request();
}

void ToolWindow::set_animation(int interval, int steps) {
  playing_->setInterval(interval);
  played_steps_ = steps;
}

void ToolWindow::lay_out(QWidget* canvas) {
  auto* splitter = new QSplitter(Qt::Horizontal);
  splitter->setChildrenCollapsible(false);
  splitter->setHandleWidth(Grid);
  splitter->addWidget(canvas);
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

void ToolWindow::make_status_line() {
  pointed_->setAccessibleName(tr("What is under the pointer"));
  pointed_->setContentsMargins(Grid, 0, 0, 0);
  pointed_->setTextFormat(Qt::PlainText);
  pointed_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  statusBar()->addWidget(pointed_, 1);
}

void ToolWindow::make_file_menu() {
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

void ToolWindow::make_edit_menu() {
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

void ToolWindow::make_view_menu() {
  view_menu_ = menuBar()->addMenu(tr("&View"));
  view_menu_->setToolTipsVisible(true);
  if (const grf::ParameterInfo* animated = parameter_of(tool_, tool_.animated)) {
    view_menu_->addAction(
        new_switch(*this,
                   {tr("&Play"), "preview", QKeySequence("Ctrl+Space"),
                    tr("Show all values of %1 one after the other").arg(text_of(animated->name))},
                   false, [this](bool is_on) { is_on ? playing_->start() : playing_->stop(); }));
  }
}

void ToolWindow::set_brdf(const grf::BrdfModel& brdf, const std::vector<grf::Definition>& definitions) {
  if (tool_.brdfs == 0) return;
  studies::ToolState state = state_;
  state.definitions = definitions;
  state.brdfs.front() = brdf;
  set_state(state);
}

void ToolWindow::set_apply_target(bool has_target) {
  const QString why_not = tool_.brdfs == 0 ? tr("This tool has no BRDF of its own.")
                          : has_target     ? QString()
                                           : tr("Open this tool from the editor to apply its BRDF to faces.");
  apply_->setEnabled(why_not.isEmpty());
  apply_->setToolTip(why_not.isEmpty() ? tr("Apply the BRDF to the faces that are selected in the editor")
                                       : why_not);
}

void ToolWindow::set_state(const studies::ToolState& state) { show_edited(state, true); }

void ToolWindow::edit(const studies::ToolState& state, bool is_done) {
  state_ = state;
  if (is_done) remember();
  follow();
}

/// Makes the current state an undo step, unless it is one.
void ToolWindow::remember() {
  if (steps_[step_] != state_) {
    steps_.resize(step_ + 1);
    steps_.push_back(state_);
    ++step_;
  }
  undo_->setEnabled(step_ > 0);
  redo_->setEnabled(step_ + 1 < steps_.size());
}

void ToolWindow::go_to(std::size_t step) {
  if (step >= steps_.size()) return;
  step_ = step;
  state_ = steps_[step_];
  form_->set_state(state_);
  remember();
  follow();
}

double ToolWindow::setting(std::string_view name) const {
  const grf::ParameterInfo* parameter = parameter_of(tool_, name);
  const grf::Argument* argument =
      parameter != nullptr ? grf::find_argument(state_.settings, *parameter) : nullptr;
  const auto* number = argument != nullptr ? std::get_if<float>(&argument->value) : nullptr;
  if (number != nullptr) return *number;
  return parameter != nullptr ? parameter->default_value : 0;
}

void ToolWindow::set_setting(std::string_view name, double value, studies::ToolState& state) const {
  if (const grf::ParameterInfo* parameter = parameter_of(tool_, name)) set_number(*parameter, value, state);
}

void ToolWindow::show_edited(const studies::ToolState& state, bool is_done) {
  form_->set_state(state);
  edit(state, is_done);
}

void ToolWindow::turn(const QPointF& by, bool is_done) {
  constexpr double DegreesPerPixel = 0.6;
  if (tool_.turn != nullptr) {
    studies::ToolState state = state_;
    tool_.turn(state, -DegreesPerPixel * by.x(), DegreesPerPixel * by.y());
    return show_edited(state, is_done);
  }
  const grf::ParameterInfo* azimuth = parameter_of(tool_, tool_.azimuth);
  const grf::ParameterInfo* elevation = parameter_of(tool_, tool_.elevation);
  if (azimuth == nullptr || elevation == nullptr) return;
  studies::ToolState state = state_;
  set_number(*azimuth, std::remainder(setting(azimuth->name) - DegreesPerPixel * by.x(), 360), state);
  set_number(*elevation, setting(elevation->name) + DegreesPerPixel * by.y(), state);
  show_edited(state, is_done);
}

/// Goes to the next value of the animated setting once the figure of the last one is shown.
void ToolWindow::show_step() {
  if (!is_frame_shown()) return;
  const grf::ParameterInfo* animated = parameter_of(tool_, tool_.animated);
  const double step = static_cast<double>(animated->maximum - animated->minimum) / played_steps_;
  double value = setting(tool_.animated) + step;
  if (value > animated->maximum) value = animated->minimum;
  studies::ToolState state = state_;
  set_number(*animated, value, state);
  show_edited(state, false);
}

void ToolWindow::report(const QString& message) {
  if (!message.isEmpty()) notice_->show_notice(NoticeBar::Kind::Error, message);
}

bool ToolWindow::read(const QString& text, const QString& path) {
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

void ToolWindow::open(const QStringList& files) {
  studies::ToolState state = state_;
  std::vector<std::string> shown;
  for (const QString& path : files) {
    if (QFileInfo(path).suffix().toLower() == StateExtension || tool_.files.empty()) {
      grf::Diagnostics diagnostics;
      const auto text = grf::read_file(path.toStdString(), diagnostics);
      if (!text) return report(text_of(diagnostics));
      if (!read(QString::fromStdString(*text), path)) return;
      state = state_;
      continue;
    }
    shown.push_back(path.toStdString());
  }
  if (shown.empty()) return;
  grf::Diagnostics diagnostics;
  open_files(tool_, shown, state, diagnostics);
  set_state(state);
}

void ToolWindow::ask_for_files() {
  QStringList patterns = {QString("*.%1").arg(StateExtension)};
  for (const QString& extension : QString::fromStdString(tool_.files).split(' ', Qt::SkipEmptyParts))
    patterns.append("*." + extension);
  if (tool_.model != nullptr) patterns += ModelImport::name_patterns();
  patterns.removeDuplicates();
  open(QFileDialog::getOpenFileNames(this, tr("Open"), {},
                                     tr("Files of this tool (%1)").arg(patterns.join(' '))));
}

void ToolWindow::ask_to_save_state() {
  ask_to_export(tr("Save the settings"), QString(".%1").arg(StateExtension),
                tr("Settings (*.%1)").arg(StateExtension), [this](const QString& path) { save_state(path); });
}

void ToolWindow::ask_to_export(const QString& title, const QString& name, const QString& filter,
                               const std::function<void(const QString&)>& write) {
  auto* dialog = new QFileDialog(this, title, text_of(tool_.name()) + name, filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(name.mid(1));
  connect(dialog, &QFileDialog::fileSelected, this, write);
  dialog->open();
}

void ToolWindow::write(const QString& path,
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

void ToolWindow::save_state(const QString& path) {
  write(path, [file = path.toStdString(), state = state_](grf::Diagnostics& diagnostics, const StopFlag&) {
    grf::replace_file(file, to_text(state, file), diagnostics);
  });
}

void ToolWindow::export_figure(const QString& path) {
  write(path, [file = path.toStdString(), state = state_](grf::Diagnostics& diagnostics, const StopFlag&) {
    if (const auto study = study_of(state, export_context(), diagnostics))
      write_picture(study->figure, file, diagnostics);
  });
}

void ToolWindow::export_data(const QString& path) {
  // What is shown is exported; to make it once more may take long.
  const auto shown = shown_study();
  write(path,
        [shown, file = path.toStdString(), state = state_](grf::Diagnostics& diagnostics, const StopFlag&) {
          const auto study = shown ? shown : study_of(state, export_context(), diagnostics);
          if (study) write_data(*study, file, diagnostics);
        });
}

void ToolWindow::ask_to_export_data() {
  QStringList filters;
  const std::vector<studies::DataFile> files = data_files();
  for (const studies::DataFile& file : files)
    filters.append(QString("%1 (*.%2)").arg(text_of(file.title), text_of(file.extension)));
  if (files.empty()) return;
  ask_to_export(tr("Export the data"), '.' + text_of(files.front().extension), filters.join(";;"),
                [this](const QString& path) { export_data(path); });
}

void ToolWindow::export_animation(const QString& path, int count) {
  const grf::ParameterInfo* animated = parameter_of(tool_, tool_.animated);
  if (animated == nullptr) return;
  const QFileInfo file(path);
  const QString base = file.path() + '/' + file.completeBaseName();
  std::vector<std::pair<std::string, studies::ToolState>> frames;
  for (int i = 0; i < count; ++i) {
    const double part = count > 1 ? static_cast<double>(i) / (count - 1) : 0;
    frames.emplace_back(
        QString("%1_%2.%3").arg(base).arg(i, 3, 10, QChar('0')).arg(file.suffix()).toStdString(), state_);
    set_number(*animated, animated->minimum + part * (animated->maximum - animated->minimum),
               frames.back().second);
  }
  write(path, [frames](grf::Diagnostics& diagnostics, const StopFlag& stop) {
    for (const auto& [frame, state] : frames) {
      if (stop.is_set()) return;
      const auto study = study_of(state, export_context(), diagnostics);
      if (!study || !write_picture(study->figure, frame, diagnostics)) return;
    }
  });
}

void ToolWindow::closeEvent(QCloseEvent* event) {
  QSettings().setValue("tools/" + text_of(tool_.name()) + "/geometry", saveGeometry());
  QMainWindow::closeEvent(event);
}

void ToolWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!local_files(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void ToolWindow::dropEvent(QDropEvent* event) {
  open(local_files(*event->mimeData()));
  event->acceptProposedAction();
}

}  // namespace editor
