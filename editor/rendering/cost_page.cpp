#include "editor/rendering/cost_page.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <qcustomplot.h>

#include "editor/charts/chart_painter.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/notice_bar.h"
#include "editor/document/render_camera.h"
#include "editor/rendering/cost_files.h"
#include "editor/rendering/cost_form.h"
#include "renderer/plot/chart.h"

namespace editor {
namespace {

/// Formats a number with three digits, without an exponent where that is short.
QString digits(const std::optional<double>& number) {
  if (!number) return QString("\u2013");
  const bool is_large = *number >= 1000 && *number < 1e6;
  return is_large ? QString::number(*number, 'f', 0) : QString::number(*number, 'g', 3);
}

QString file_name_of(const QString& title) {
  QString name;
  for (const QChar letter : title) name += QString("/\\:*?\"<>|").contains(letter) ? QChar('_') : letter;
  return name + ".exr";
}

plot::Chart chart_of(const CostStudy& study, const QString& x, const QString& y) {
  plot::Chart chart;
  chart.x = {x.toStdString(), true, {}, {}, 0};
  chart.y = {y.toStdString(), true, {}, {}, 0};
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  double least = low;
  double most = 0;
  for (const CostCurve& curve : study.curves) {
    plot::Series series{curve.name.toStdString(), {}, {}, {}, true};
    for (const CostMeasurement& row : curve.rows) {
      if (!(row.seconds > 0 && row.error > 0)) continue;
      series.points.emplace_back(row.seconds, 100 * row.error);
      low = std::min(low, row.seconds);
      high = std::max(high, row.seconds);
      least = std::min(least, 100 * row.error);
      most = std::max(most, 100 * row.error);
    }
    chart.series.push_back(std::move(series));
  }
  if (high > 0) {
    chart.x.minimum = low / 1.3;
    chart.x.maximum = high * 1.3;
    chart.y.minimum = least / 1.5;
    chart.y.maximum = most * 2.5;  // below the legend
  }
  return chart;
}

bool has_points(const CostStudy& study) {
  return std::ranges::any_of(study.curves, [](const CostCurve& curve) { return !curve.rows.empty(); });
}

}  // namespace

CostPage::CostPage(Document& document, RegionSource region, QWidget* parent)
    : QWidget(parent),
      document_(document),
      region_source_(std::move(region)),
      form_(new CostForm(this)),
      notice_(new NoticeBar),
      plot_(new QCustomPlot(this)),
      table_(new QTableWidget(0, 4, this)),
      progress_(new QProgressBar(this)),
      verdict_(new QLabel(this)),
      op_(new QPlainTextEdit(this)) {
  describe_views();
  lay_out();
  connect_runs();
  show_study();
}

void CostPage::describe_views() {
  plot_->setAccessibleName(tr("Error over render time"));
  plot_->setToolTip(tr("Error (square root of relMSE, in percent) over render time; both are logarithmic"));
  table_->setAccessibleName(tr("Efficiencies"));
  table_->setToolTip(
      tr("Efficiency 1 / (relMSE x render seconds) with its 95 % interval over the rounds, and "
         "the time to an error of 1 % with building tables, in seconds"));
  table_->setHorizontalHeaderLabels(
      {tr("Curve"), tr("Efficiency"), tr("95 % interval"), tr("Seconds to 1 %")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->setFixedHeight(18 * Grid);
  progress_->setAccessibleName(tr("Progress of the study"));
  progress_->setRange(0, 1000);
  QSizePolicy keeps_its_place = progress_->sizePolicy();
  keeps_its_place.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(keeps_its_place);
  op_->setAccessibleName(tr("Settings of the winner"));
  op_->setToolTip(tr("The lines of an OP file, and the PDF of a scene, that take the winner"));
  op_->setReadOnly(true);
  op_->setTabChangesFocus(true);
  op_->setFixedHeight(13 * Grid);
  verdict_->setAccessibleName(tr("Verdict"));
  verdict_->setWordWrap(true);
  QFont bold = verdict_->font();
  bold.setBold(true);
  verdict_->setFont(bold);
}

void CostPage::lay_out() {
  auto* left = new QVBoxLayout;
  left->addWidget(form_, 1);
  auto* right = new QVBoxLayout;
  right->setContentsMargins(0, Grid, Grid, Grid);
  right->setSpacing(Grid);
  right->addLayout(make_run_row());
  right->addWidget(plot_, 1);
  right->addWidget(table_);
  right->addWidget(verdict_);
  right->addLayout(make_winner_row());
  right->addLayout(make_picture_row());
  auto* columns = new QHBoxLayout;
  columns->addLayout(left);
  columns->addLayout(right, 1);
  auto* rows = tight_layout<QVBoxLayout>(this, 0);
  rows->addWidget(notice_);
  rows->addLayout(columns, 1);
  notice_->hide();
}

void CostPage::connect_runs() {
  connect(&run_, &CostRun::measured, this, [this](const CostStudy& study) {
    study_ = study;
    show_study();
  });
  connect(&run_, &CostRun::progressed, this,
          [this](double done) { progress_->setValue(static_cast<int>(1000 * done)); });
  connect(&run_, &CostRun::ended, this, &CostPage::take_end);
  connect(&pictures_, &FinalRender::finished, this, [this](const FinalRenderResult& result) {
    if (waiting_.empty()) {
      enable_buttons();
      emit comparison_requested(result.image, first_picture_, first_title_);
      return;
    }
    first_picture_ = result.image;
    render_next();
  });
  connect(&pictures_, &FinalRender::failed, this, [this](const QString& why) {
    waiting_.clear();
    fail(why);
    enable_buttons();
  });
}

CostPage::~CostPage() = default;

QPushButton* CostPage::button(const QString& text, const std::function<void()>& pressed) {
  auto* result = new QPushButton(text, this);
  result->setAccessibleName(text);
  connect(result, &QPushButton::clicked, this, pressed);
  return result;
}

QHBoxLayout* CostPage::make_run_row() {
  auto* row = new QHBoxLayout;
  row->setSpacing(Grid);
  start_ = button(tr("Start the study"), [this] { start({}); });
  continue_ = button(tr("Continue the study"), [this] { start(file_); });
  stop_ = button(tr("Stop the study"), [this] { run_.stop(); });
  open_ = button(tr("Open a study"), [this] { ask_to_open(); });
  save_ = button(tr("Save the study"), [this] { ask_to_save(); });
  for (QPushButton* one : {start_, continue_, stop_}) row->addWidget(one);
  row->addWidget(progress_, 1);
  for (QPushButton* one : {open_, save_}) row->addWidget(one);
  // The row's place tells what they are about; assistive technology has the whole names.
  const std::pair<QPushButton*, QString> shown[] = {{start_, tr("Start")},
                                                    {continue_, tr("Continue")},
                                                    {stop_, tr("Stop")},
                                                    {open_, tr("Open...")},
                                                    {save_, tr("Save...")}};
  for (const auto& [one, text] : shown) one->setText(text);
  return row;
}

QHBoxLayout* CostPage::make_winner_row() {
  auto* row = new QHBoxLayout;
  row->setSpacing(Grid);
  row->addWidget(op_, 1);
  auto* buttons = new QVBoxLayout;
  take_ = button(tr("Take the winner"), [this] { take_winner(); });
  copy_ = button(tr("Copy the settings"), [this] { QApplication::clipboard()->setText(op_->toPlainText()); });
  buttons->addWidget(take_);
  buttons->addWidget(copy_);
  buttons->addStretch(1);
  row->addLayout(buttons);
  return row;
}

QHBoxLayout* CostPage::make_picture_row() {
  auto* row = new QHBoxLayout;
  row->setSpacing(Grid);
  a_ = narrow_list(tr("Picture A"), tr("The curve whose largest sample count sets the time or the error"), 8,
                   this);
  b_ = narrow_list(tr("Picture B"), tr("The curve that gets the same time or error"), 8, this);
  for (QComboBox* list : {a_, b_}) {
    row->addWidget(new QLabel(list == a_ ? tr("Pictures of") : tr("and"), this));
    row->addWidget(list, 1);
    connect(list, &QComboBox::currentIndexChanged, this, &CostPage::enable_buttons);
  }
  equal_time_ = button(tr("At equal time"), [this] { render_pair(&samples_at_equal_time); });
  equal_error_ = button(tr("At equal error"), [this] { render_pair(&samples_at_equal_error); });
  row->addWidget(equal_time_);
  row->addWidget(equal_error_);
  return row;
}

void CostPage::start(const QString& continued) {
  CostSettings settings = form_->settings();
  FinalRenderRequest of_study = request();
  if (form_->is_limited()) {
    const auto region = region_source_();
    if (!region) return fail(tr("no region is framed: drag one by the action Preview region"));
    place_render_camera(of_study.options, region->camera);
    of_study.options.size = region->size;
    settings.crop = region->crop;
  }
  notice_->hide();
  if (continued.isEmpty()) {
    study_ = {};
    file_.clear();
  }
  progress_->setValue(0);
  run_.start(of_study, settings, continued);
  show_study();
}

void CostPage::take_end(const QString& problem) {
  if (!problem.isEmpty()) fail(problem);
  if (problem.isEmpty() && has_points(study_)) file_ = run_.file();
  show_study();
}

FinalRenderRequest CostPage::request() const {
  return {document_.scene(), document_.path(), document_.options().valid_options(), document_.imports(),
          true};
}

void CostPage::show_study() {
  show_chart();
  show_table();
  show_winner();
  for (QComboBox* list : {a_, b_}) {
    QStringList names;
    for (const CostCurve& curve : study_.curves) names << curve.name;
    QStringList shown;
    for (int i = 0; i < list->count(); ++i) shown << list->itemText(i);
    if (names == shown) continue;
    list->clear();
    list->addItems(names);
    list->setCurrentIndex(list == a_ || names.size() < 2 ? 0 : 1);
  }
  enable_buttons();
}

void CostPage::show_chart() {
  draw(*plot_, chart_of(study_, tr("render time, s"), tr("error, %")));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void CostPage::show_table() {
  table_->setRowCount(static_cast<int>(study_.curves.size()));
  for (std::size_t i = 0; i < study_.curves.size(); ++i) {
    const CostCurve& curve = study_.curves[i];
    const auto& efficiency = curve.efficiency;
    const QStringList cells = {
        curve.name, digits(efficiency ? std::optional(efficiency->value) : std::nullopt),
        efficiency ? tr("%1 to %2").arg(digits(efficiency->low), digits(efficiency->high)) : digits({}),
        digits(curve.seconds_for_1_percent)};
    for (int column = 0; column < cells.size(); ++column) {
      table_->setItem(static_cast<int>(i), column, new QTableWidgetItem(cells[column]));
    }
  }
}

void CostPage::show_winner() {
  op_->clear();
  if (study_.winner) {
    const CostCurve& winner = study_.curves[*study_.winner];
    verdict_->setText(tr("%1 wins: its interval is above those of all others.").arg(winner.name));
    QStringList lines = winner.op;
    if (!winner.grf.isEmpty()) lines << "# GRF: pdf " + winner.grf;
    op_->setPlainText(lines.join('\n'));
  } else if (!has_points(study_)) {
    verdict_->setText(tr("A study compares the error of renders over their time."));
  } else if (study_.curves.size() < 2) {
    verdict_->setText(tr("One curve has nothing to win against: compare two or more."));
  } else {
    verdict_->setText(tr("No clear winner: the intervals overlap, or are not known yet."));
  }
}

/// Enables the buttons, whose tool tips say what they do or why they cannot.
void CostPage::enable_buttons() {
  const bool is_running = run_.is_running();
  progress_->setVisible(is_running);
  const QString busy = is_running ? tr("A study is running.") : QString();
  QString none = has_points(study_) ? busy : tr("There is no study.");
  enable(start_, tr("Measure all curves afresh"), busy);
  enable(continue_, tr("Measure what the shown study lacks"),
         is_running || !file_.isEmpty() ? busy : tr("There is no study."));
  enable(stop_, tr("End the study, and keep what was measured"),
         is_running ? QString() : tr("No study is running."));
  enable(open_, tr("Open the JSON file of a study of bpt cost, to show or continue it"), busy);
  enable(save_, tr("Save the figure, the table or the study"),
         is_running || !file_.isEmpty() ? busy : tr("There is no study."));
  const bool is_taken = study_.winner && !study_.curves[*study_.winner].op.isEmpty();
  const QString no_winner =
      study_.winner ? tr("Only a PDF of the scene has these settings.") : tr("There is no clear winner.");
  enable(take_, tr("Set the winner's settings in the render settings"), is_taken ? QString() : no_winner);
  enable(copy_, tr("Copy the settings of the winner as text"), study_.winner ? QString() : no_winner);
  const bool is_pair = a_->currentIndex() >= 0 && b_->currentIndex() >= 0;
  const auto why_not = [&](Pairing pairing) {
    if (!none.isEmpty() || !is_pair) return none;
    if (pictures_.is_running() || !waiting_.empty()) return tr("The pictures are being rendered.");
    const CostCurve& a = study_.curves[static_cast<std::size_t>(a_->currentIndex())];
    const CostCurve& b = study_.curves[static_cast<std::size_t>(b_->currentIndex())];
    if (a.op.isEmpty() || b.op.isEmpty()) return tr("Only a PDF of the scene has these settings.");
    return pairing(a, b) ? QString() : tr("The curves do not reach it within a million samples.");
  };
  enable(equal_time_, tr("Render both in the same time, and compare them in Images"),
         why_not(&samples_at_equal_time));
  enable(equal_error_, tr("Render both with the same error, and compare them in Images"),
         why_not(&samples_at_equal_error));
}

void CostPage::fail(const QString& problem) { notice_->show_notice(NoticeBar::Kind::Error, problem); }

void CostPage::open(const QString& path) {
  QString problem;
  const auto study = read_cost_file(path, problem);
  if (!study) return fail(problem);
  notice_->hide();
  study_ = *study;
  file_ = path;
  form_->show_settings_of(study_);
  show_study();
}

void CostPage::save(const QString& path) {
  if (const QString problem = save_cost_file(file_, path); !problem.isEmpty()) fail(problem);
}

void CostPage::ask_to_open() {
  auto* dialog = new QFileDialog(this, tr("Open a study"), {}, tr("Studies (*.json)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QFileDialog::fileSelected, this, &CostPage::open);
  dialog->open();
}

void CostPage::ask_to_save() {
  auto* dialog = new QFileDialog(this, tr("Save the study"), "cost.svg",
                                 tr("Figure (*.svg *.png *.pdf);;Table (*.csv);;Study (*.json)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  connect(dialog, &QFileDialog::fileSelected, this, &CostPage::save);
  dialog->open();
}

void CostPage::take_winner() {
  if (!study_.winner) return;
  const CostCurve& winner = study_.curves[*study_.winner];
  OpDocument& options = document_.options();
  options.set_options(tr("Take the winner"), with_settings(options.valid_options(), winner.op));
}

void CostPage::render_pair(Pairing pairing) {
  const CostCurve& a = study_.curves[static_cast<std::size_t>(a_->currentIndex())];
  const CostCurve& b = study_.curves[static_cast<std::size_t>(b_->currentIndex())];
  const auto samples = pairing(a, b);
  if (!samples) return;
  const auto picture = [this](const CostCurve& curve, int wanted) {
    Picture made{{}, request()};
    made.request.options = with_settings(made.request.options, curve.op);
    const int count = set_samples(made.request.options, wanted);
    made.title = tr("%1, %2 samples").arg(curve.name).arg(count);
    const QDir folder = QFileInfo(run_.file()).dir();
    made.request.options.output = folder.filePath(file_name_of(made.title)).toStdString();
    return made;
  };
  waiting_ = {picture(a, samples->a), picture(b, samples->b)};
  render_next();
}

void CostPage::render_next() {
  const Picture picture = waiting_.back();
  waiting_.pop_back();
  if (!waiting_.empty()) first_title_ = picture.title;
  pictures_.start(picture.request);
  enable_buttons();
}

void CostPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) show_chart();
  QWidget::changeEvent(event);
}

}  // namespace editor
