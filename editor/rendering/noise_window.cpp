#include "editor/rendering/noise_window.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/controls/form_widgets.h"
#include "editor/document/document.h"
#include "editor/document/op_document.h"
#include "editor/rendering/noise_places.h"
#include "editor/rendering/noise_texts.h"
#include "editor/rendering/share_delegate.h"

namespace editor {
namespace {

constexpr int NumberRole = Qt::UserRole;

QTreeWidget* new_list(const QStringList& headers, const QString& name, const QString& tip, QWidget* parent) {
  auto* list = new QTreeWidget(parent);
  list->setHeaderLabels(headers);
  list->setAccessibleName(name);
  list->setToolTip(tip);
  list->setUniformRowHeights(true);
  list->header()->setStretchLastSection(false);
  list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  return list;
}

/// The first error of the renderer's messages, without its place in the snapshot; else the first message.
QString first_error(const QString& messages) {
  const QString mark = QStringLiteral("error: ");
  for (const QString& line : messages.split('\n')) {
    if (const qsizetype at = line.indexOf(mark); at >= 0) return line.mid(at + mark.size());
  }
  return messages.section('\n', 0, 0);
}

QString ratio_text(const NoiseTrial::Ratio& ratio) { return QString::number(ratio.value, 'f', 2); }

QString interval_text(const NoiseTrial::Ratio& ratio) {
  return NoiseWindow::tr("95 % interval: %1 to %2")
      .arg(QString::number(ratio.low, 'f', 2), QString::number(ratio.high, 'f', 2));
}

}  // namespace

NoiseWindow::NoiseWindow(Document& document, std::function<FinalRenderRequest()> request,
                         const QString& program, QWidget* parent)
    : QWidget(parent, Qt::Window), document_(document), request_(std::move(request)), run_(program) {
  setWindowTitle(tr("Where the noise is from - wannabe"));
  resize(112 * Grid, 96 * Grid);
  lay_out();
  connect(&run_, &SnapshotProcess::reported, this, &NoiseWindow::read);
  connect(&run_, &SnapshotProcess::finished, this, [this] { end({}); });
  connect(&run_, &SnapshotProcess::failed, this, &NoiseWindow::end);
  connect(&document_, &Document::changed, this, &NoiseWindow::outdate);
  connect(&document_.options(), &OpDocument::changed, this, &NoiseWindow::outdate);
  show_state();
}

void NoiseWindow::lay_out() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(Grid, Grid, Grid, Grid);
  column->setSpacing(Grid);
  state_ = new QLabel(this);
  state_->setAccessibleName(tr("State of the measurement"));
  state_->setWordWrap(true);
  progress_ = new QProgressBar(this);
  progress_->setAccessibleName(tr("Progress of the measurement"));
  progress_->setRange(0, 0);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(Grid / 2);
  advice_ = new QLabel(this);
  advice_->setAccessibleName(tr("Advice"));
  advice_->setWordWrap(true);
  advice_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* lists = new QSplitter(Qt::Vertical, this);
  lists->setChildrenCollapsible(false);
  lists->addWidget(make_shares());
  lists->addWidget(make_changes());
  lists->setSizes({48 * Grid, 28 * Grid});
  column->addWidget(state_);
  column->addWidget(progress_);
  column->addWidget(lists, 1);
  column->addWidget(advice_);
  column->addWidget(make_buttons());
}

QTreeWidget* NoiseWindow::make_shares() {
  shares_ = new_list({tr("Part of the light"), tr("Noise"), tr("Light")}, tr("Shares of the noise"),
                     tr("Shares of the image's variance and light. Select a row to select its lamp or faces"),
                     this);
  auto* bars = new ShareDelegate(shares_);
  for (const int column : {1, 2}) {
    shares_->setItemDelegateForColumn(column, bars);
    shares_->setColumnWidth(column, 22 * Grid);
  }
  connect(shares_, &QTreeWidget::itemSelectionChanged, this, &NoiseWindow::select_current);
  return shares_;
}

QTreeWidget* NoiseWindow::make_changes() {
  changes_ = new_list(
      {tr("Change"), tr("Variance"), tr("Time"), tr("Product"), tr("Verdict")}, tr("Changes of settings"),
      tr("What changes do, relative to now: a product of 0.8 means the same error in 0.8 of the "
         "time"),
      this);
  changes_->setRootIsDecorated(false);
  changes_->setItemDelegate(new ShareDelegate(changes_));
  for (const int column : {1, 2, 3}) changes_->setColumnWidth(column, 10 * Grid);
  changes_->setColumnWidth(4, 20 * Grid);
  connect(changes_, &QTreeWidget::itemSelectionChanged, this, &NoiseWindow::show_state);
  connect(changes_, &QTreeWidget::itemActivated, this, &NoiseWindow::try_current);
  return changes_;
}

QWidget* NoiseWindow::make_buttons() {
  auto* buttons = new QWidget(this);
  auto* row = tight_layout<QHBoxLayout>(buttons, Grid);
  const auto make = [&](const QString& text, const QString& tip, auto function) {
    auto* button = new QPushButton(text, buttons);
    button->setToolTip(tip);
    QString name = text;
    button->setAccessibleName(name.remove('&'));
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, function);
    row->addWidget(button);
    return button;
  };
  measure_button_ = make(tr("&Measure"), tr("Measure where the noise of the image comes from, as it is now"),
                         &NoiseWindow::measure);
  stop_button_ = make(tr("&Stop"), tr("Stop measuring and keep what is known"), [this] {
    run_.stop();
    running_ = Running::Nothing;
    show_state();
  });
  row->addStretch();
  try_button_ = make(tr("&Try"), tr("Measure what the selected change does"), &NoiseWindow::try_current);
  try_all_button_ = make(tr("Try &all"), tr("Measure what each change does"), &NoiseWindow::try_all);
  apply_button_ =
      make(tr("A&pply"), tr("Write the selected change to the options or the faces"), &NoiseWindow::apply);
  return buttons;
}

// Measuring

void NoiseWindow::measure() {
  is_outdated_ = false;
  applied_.clear();
  start(Running::Shares, {});
}

void NoiseWindow::try_current() {
  const auto change = current_change();
  if (change && !is_outdated_) start(Running::Trials, {"--change", result_->changes[*change].word});
}

void NoiseWindow::try_all() { start(Running::Trials, {"--try"}); }

void NoiseWindow::start(Running what, const QStringList& arguments) {
  problem_.clear();
  running_ = what;
  run_.start(request_(), "noise", QStringList{"--progress", "json"} + arguments);
  show_state();
}

void NoiseWindow::read(const QByteArray& line) {
  if (running_ == Running::Shares) {
    const auto result = noise_result_of(line);
    if (!result) return;
    result_ = *result;
    show_shares();
    show_changes();
  }
  const auto trial = noise_trial_of(line);
  if (!trial || !result_) return show_state();
  for (std::size_t i = 0; i < result_->changes.size(); ++i) {
    if (result_->changes[i].word != trial->word) continue;
    result_->changes[i] = *trial;
    show_change(*changes_->topLevelItem(static_cast<int>(i)), *trial);
  }
  show_state();
}

void NoiseWindow::end(const QString& problem) {
  problem_ = problem;
  running_ = Running::Nothing;
  show_state();
}

/// What was measured no longer holds for a changed document.
void NoiseWindow::outdate() {
  if (running_ != Running::Nothing) {
    run_.stop();
    running_ = Running::Nothing;
  }
  is_outdated_ = true;
  show_state();
}

// Display

void NoiseWindow::show_state() {
  const bool is_running = running_ != Running::Nothing;
  QString text;
  if (is_running) {
    text = running_ == Running::Shares ? tr("Measuring where the noise is from…")
                                       : tr("Measuring what changes do…");
  } else if (!problem_.isEmpty()) {
    text = tr("Not measured: %1").arg(first_error(problem_));
  } else if (!applied_.isEmpty()) {
    text = tr("Applied: %1. Measure again to see what is left").arg(applied_);
  } else if (is_outdated_) {
    text = tr("The scene, its options or the camera have changed: measure again");
  } else if (result_) {
    text = tr("The error is %1 % with %2 samples per pixel, in %3 x %4 pixels")
               .arg(QString::number(100 * result_->error, 'g', 3))
               .arg(result_->samples)
               .arg(result_->width)
               .arg(result_->height);
  }
  state_->setText(text);
  state_->setToolTip(problem_);
  progress_->setVisible(is_running);
  show_or_hide(advice_, result_ ? advice_of(*result_) : QString());
  const bool is_valid = result_ && !is_outdated_;
  shares_->setEnabled(is_valid);
  changes_->setEnabled(is_valid);
  const auto current = current_change();
  measure_button_->setEnabled(!is_running);
  stop_button_->setEnabled(is_running);
  try_button_->setEnabled(is_valid && !is_running && current);
  try_all_button_->setEnabled(is_valid && !is_running);
  apply_button_->setEnabled(is_valid && !is_running && current && result_->changes[*current].is_tried);
}

void NoiseWindow::show_shares() {
  shares_->clear();
  rows_.clear();
  add_group(tr("Light from"), result_->lamps);
  add_group(tr("Bounces between lamp and eye"), result_->bounces);
  add_group(tr("Reflected first by"), result_->brdfs);
  shares_->expandAll();
}

void NoiseWindow::add_group(const QString& title, const std::vector<NoiseShareRow>& rows) {
  auto* group = new QTreeWidgetItem(shares_, {title});
  group->setFlags(Qt::ItemIsEnabled);
  for (const NoiseShareRow& row : rows) {
    const auto percent = [](double fraction) { return tr("%1 %").arg(std::lround(100 * fraction)); };
    auto* item = new QTreeWidgetItem(group, {name_of(row), percent(row.noise), percent(row.light)});
    item->setData(0, NumberRole, static_cast<int>(rows_.size()));
    item->setData(1, ShareDelegate::FractionRole, row.noise);
    item->setData(2, ShareDelegate::FractionRole, row.light);
    item->setToolTip(0, row.brdf.isEmpty() ? name_of(row) : row.brdf);
    rows_.push_back(&row);
  }
}

void NoiseWindow::show_changes() {
  changes_->clear();
  for (const NoiseTrial& change : result_->changes) show_change(*new QTreeWidgetItem(changes_), change);
}

void NoiseWindow::show_change(QTreeWidgetItem& item, const NoiseTrial& change) const {
  item.setText(0, name_of(change));
  item.setToolTip(0, change.is_tried ? sentence_of(change) : name_of(change));
  for (const int column : {1, 2, 3}) item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  if (!change.is_tried) return;
  int column = 1;
  for (const NoiseTrial::Ratio& ratio : {change.variance, change.time, change.cost}) {
    item.setText(column, ratio_text(ratio));
    item.setToolTip(column++, interval_text(ratio));
  }
  item.setText(4, verdict_of(change));
}

// Selecting and applying

void NoiseWindow::select_current() {
  const QList<QTreeWidgetItem*> items = shares_->selectedItems();
  if (items.isEmpty() || is_outdated_) return;
  const QVariant number = items.front()->data(0, NumberRole);
  if (number.isValid()) select_part(document_, *rows_[static_cast<std::size_t>(number.toInt())]);
}

std::optional<std::size_t> NoiseWindow::current_change() const {
  const QList<QTreeWidgetItem*> items = changes_->selectedItems();
  if (items.isEmpty() || !result_) return std::nullopt;
  return static_cast<std::size_t>(changes_->indexOfTopLevelItem(items.front()));
}

void NoiseWindow::apply() {
  const auto current = current_change();
  if (!current || is_outdated_) return;
  const NoiseTrial change = result_->changes[*current];
  const QString title = tr("Apply: %1").arg(name_of(change));
  apply_change(document_, change, title);
  applied_ = name_of(change);
  show_state();
}

}  // namespace editor
