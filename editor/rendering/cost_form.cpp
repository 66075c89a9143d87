#include "editor/rendering/cost_form.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QMap>
#include <QSet>
#include <QVBoxLayout>

#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/controls/text.h"

namespace editor {
namespace {

QListWidget* scheme_list(QWidget* parent) {
  auto* list = new QListWidget(parent);
  for (const auto word : std::get<options::WordOption>(options::find_option("BPT_Pdf_Name")->value).words) {
    auto* item = new QListWidgetItem(text_of(word), list);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(word == "Own" || word == "Diffuse" ? Qt::Checked : Qt::Unchecked);
  }
  list->setCurrentRow(0);
  return list;
}

template <class Field>
Field* described(Field* field, const QString& name, const QString& tip) {
  field->setAccessibleName(name);
  field->setToolTip(tip);
  return field;
}

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

}  // namespace

CostForm::CostForm(QWidget* parent)
    : QWidget(parent),
      schemes_(described(scheme_list(this), tr("Compared schemes"),
                         tr("Each checked sampling scheme becomes a curve; without any, the scheme of the "
                            "render settings is measured"))),
      path_(described(new QCheckBox("path", this), tr("Compare path"),
                      tr("Measure path tracing with light sampling"))),
      naive_(described(new QCheckBox("naive", this), tr("Compare naive"),
                       tr("Measure the thesis' estimator, which samples directions by the scheme alone"))),
      ways_(described(new QLineEdit(this), tr("Compared ways"),
                      tr("Each number of ways from the first hit becomes a curve, such as 1,2,4; while it is "
                         "empty, that of the render settings is measured"))),
      samples_(described(new QLineEdit("4,16,64", this), tr("Compared samples"),
                         tr("Each number of samples per pixel becomes a point of every curve; the numbers "
                            "ascend"))),
      region_(described(new QCheckBox(tr("Only the preview region"), this), tr("Only the preview region"),
                        tr("Measure only the region of the mode Rendered, as the 3D view frames it"))) {
  rounds_ = number_box({tr("Rounds"),
                        tr("Each point is rendered so many times with different seeds; intervals need two "
                           "rounds, and narrow with more"),
                        1, 100, 1},
                       this);
  rounds_->set_whole(true);
  rounds_->set_value(4);
  path_->setChecked(true);
  ways_->setPlaceholderText(tr("as in the settings"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(Grid, Grid, Grid, Grid);
  column->addWidget(heading(tr("Sampling schemes"), this));
  schemes_->setMinimumHeight(16 * Grid);
  column->addWidget(schemes_, 1);
  column->addWidget(heading(tr("Integrators"), this));
  column->addWidget(path_);
  column->addWidget(naive_);
  auto* rows = new QFormLayout;
  rows->addRow(tr("Ways"), ways_);
  rows->addRow(tr("Samples"), samples_);
  rows->addRow(tr("Rounds"), rounds_);
  column->addLayout(rows);
  column->addWidget(region_);
  setFixedWidth(30 * Grid);
}

CostSettings CostForm::settings() const {
  CostSettings settings;
  for (int row = 0; row < schemes_->count(); ++row) {
    const QListWidgetItem& item = *schemes_->item(row);
    if (item.checkState() == Qt::Checked) settings.schemes << item.text();
  }
  for (const QCheckBox* box : {path_, naive_}) {
    if (box->isChecked()) settings.integrators << box->text();
  }
  settings.ways = ways_->text().remove(' ');
  settings.samples = samples_->text().remove(' ');
  settings.rounds = static_cast<int>(rounds_->value());
  return settings;
}

void CostForm::show_settings_of(const CostStudy& study) {
  QSet<QString> lines;
  QStringList ways;
  QMap<int, QString> samples;
  for (const CostCurve& curve : study.curves) {
    for (const QString& line : curve.op) {
      lines << line;
      const QString number = line.section(' ', 1);
      if (line.startsWith("BPT_Branches ") && !ways.contains(number)) ways << number;
    }
    for (const CostMeasurement& row : curve.rows) samples[row.samples] = QString::number(row.samples);
  }
  for (int row = 0; row < schemes_->count(); ++row) {
    QListWidgetItem& item = *schemes_->item(row);
    item.setCheckState(lines.contains("BPT_Pdf_Name " + item.text()) ? Qt::Checked : Qt::Unchecked);
  }
  for (QCheckBox* box : {path_, naive_}) box->setChecked(lines.contains("BPT_Integrator " + box->text()));
  ways_->setText(ways.join(','));
  samples_->setText(samples.values().join(','));
}

bool CostForm::is_limited() const { return region_->isChecked(); }

}  // namespace editor
