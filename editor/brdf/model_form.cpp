#include "editor/brdf/model_form.h"

#include <QComboBox>
#include <QCompleter>
#include <QFocusEvent>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/appearance/theme.h"
#include "editor/brdf/data_file_row.h"
#include "editor/brdf/parameter_row.h"
#include "editor/brdf/terms_editor.h"
#include "editor/controls/tab_order.h"
#include "editor/controls/text.h"
#include "grf/keywords.h"
#include "renderer/reflectance/scheme.h"

namespace editor {
namespace {

QString title_of(const grf::ModelInfo& info) {
  return QString("%1 (%2)").arg(text_of(info.title), text_of(info.keyword));
}

QLabel* new_note(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setFocusPolicy(Qt::NoFocus);
  label->hide();
  return label;
}

}  // namespace

ModelForm::ModelForm(std::vector<grf::ModelInfo> infos, QString kind, QWidget* parent)
    : QWidget(parent), infos_(std::move(infos)), kind_(std::move(kind)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(Grid / 2);
  build_chooser();
  column->addWidget(chooser_);
  paper_ = new_note(this);
  column->addWidget(paper_);
  rows_holder_ = new QWidget(this);
  rows_layout_ = new QVBoxLayout(rows_holder_);
  rows_layout_->setContentsMargins(0, 0, 0, 0);
  rows_layout_->setSpacing(Grid / 2);
  column->addWidget(rows_holder_);
  hint_ = new_note(this);
  column->addWidget(hint_);
  message_ = new_note(this);
  message_->setAccessibleName("What is wrong with the " + kind_);
  column->addWidget(message_);
  column->addStretch(1);
  refresh();
  show_mistakes();  // there are none, without a model; to check is for what derives from this
}

void ModelForm::build_chooser() {
  chooser_ = new QComboBox(this);
  chooser_->setEditable(true);
  chooser_->setInsertPolicy(QComboBox::NoInsert);
  chooser_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  chooser_->setMinimumContentsLength(12);
  chooser_->setAccessibleName(kind_ + " model");
  for (const grf::ModelInfo& info : infos_) {
    chooser_->addItem(title_of(info));
    chooser_->setItemData(chooser_->count() - 1, text_of(info.about), Qt::ToolTipRole);
  }
  chooser_->completer()->setFilterMode(Qt::MatchContains);
  chooser_->completer()->setCompletionMode(QCompleter::PopupCompletion);
  connect(chooser_, &QComboBox::activated, this, &ModelForm::choose);
  connect(chooser_->lineEdit(), &QLineEdit::editingFinished, this, [this] {
    // What names no model goes back to the one that is there.
    if (chooser_->findText(chooser_->currentText(), Qt::MatchFixedString) < 0) refresh();
  });
}

std::string ModelForm::common_keyword() const {
  if (models_.empty()) return {};
  const std::string& keyword = models_.front().keyword;
  const bool is_common = std::all_of(models_.begin(), models_.end(), [&](const grf::BrdfModel& model) {
    return grf::same_keyword(model.keyword, keyword);
  });
  return is_common ? keyword : std::string();
}

const grf::ModelInfo* ModelForm::info() const { return grf::find_model(infos_, common_keyword()); }

void ModelForm::show_models(std::vector<grf::BrdfModel> models) {
  models_ = std::move(models);
  refresh();
  check_models();
}

void ModelForm::show_definitions(Definitions definitions) {
  definitions_ = std::move(definitions);
  refresh();
  check_models();
}

void ModelForm::choose(int index) {
  const auto& chosen = infos_[static_cast<std::size_t>(index)];
  for (grf::BrdfModel& model : models_) {
    if (grf::same_keyword(model.keyword, chosen.keyword)) continue;
    grf::BrdfModel fresh;
    fresh.keyword = chosen.keyword;
    fresh.location = model.location;
    model = fresh;
  }
  apply(true);
}

void ModelForm::rebuild() {
  shown_info_ = info();
  rows_.clear();
  terms_ = nullptr;
  data_file_ = nullptr;
  for (QObject* old : rows_holder_->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
    static_cast<QWidget*>(old)->hide();
    old->deleteLater();
  }
  if (shown_info_ != nullptr) add_rows();
}

void ModelForm::add_rows() {
  using Takes = grf::ModelInfo::Takes;
  if (shown_info_->takes == Takes::Terms) {
    terms_ = new TermsEditor(rows_holder_);
    rows_layout_->addWidget(terms_);
    terms_->show();
    const auto take = [this](const std::vector<grf::CombineTerm>& terms, bool is_done) {
      for (grf::BrdfModel& model : models_) model.terms = terms;
      apply(is_done);
    };
    connect(terms_, &TermsEditor::changing, this, [take](const auto& terms) { take(terms, false); });
    connect(terms_, &TermsEditor::edited, this, [take](const auto& terms) { take(terms, true); });
  }
  if (shown_info_->takes == Takes::DataFile) {
    data_file_ = new DataFileRow(rows_holder_);
    rows_layout_->addWidget(data_file_);
    data_file_->show();
    connect(data_file_, &DataFileRow::edited, this, [this](const QString& file) {
      for (grf::BrdfModel& model : models_) model.data_file = file.toStdString();
      apply(true);
    });
  }
  int name_width = 4 * Grid;
  for (const grf::ParameterInfo& parameter : shown_info_->parameters) {
    auto* row = new ParameterRow(parameter, rows_holder_);
    rows_.push_back(row);
    rows_layout_->addWidget(row);
    name_width = std::max(name_width, row->name_width());
    connect(row, &ParameterRow::changing, this,
            [this, row](const auto& v) { change(row->parameter(), v, false); });
    connect(row, &ParameterRow::edited, this,
            [this, row](const auto& v) { change(row->parameter(), v, true); });
    connect(row, &ParameterRow::reset, this, [this, row] {
      for (grf::BrdfModel& model : models_) reset_value(model, row->parameter());
      apply(true);
    });
  }
  for (ParameterRow* row : rows_) {
    row->set_name_width(name_width);
    row->show();
  }
  lead_tab_through({chooser_, rows_holder_});
}

void ModelForm::change(const grf::ParameterInfo& parameter, const grf::Value& value, bool is_done) {
  for (grf::BrdfModel& model : models_) set_value(model, parameter, value);
  apply(is_done);
}

void ModelForm::apply(bool is_done) {
  refresh();
  check_models();
  if (mistakes_.empty()) report(is_done);
}

void ModelForm::refresh() {
  if (info() != shown_info_ || models_.empty()) rebuild();
  chooser_->setEnabled(!models_.empty());
  chooser_->setToolTip(models_.empty() ? "There is nothing selected that has a " + kind_
                       : shown_info_ != nullptr
                           ? "<p>" + text_of(shown_info_->about).toHtmlEscaped() + "</p>"
                           : "The model of the " + kind_ + "; type a part of its name to search");
  if (shown_info_ != nullptr) {
    chooser_->setCurrentIndex(static_cast<int>(shown_info_ - infos_.data()));
  } else {
    chooser_->setCurrentIndex(-1);
  }
  const QString unknown = shown_info_ == nullptr ? QString::fromStdString(common_keyword()) : QString();
  chooser_->lineEdit()->setPlaceholderText(models_.empty()     ? "no " + kind_
                                           : unknown.isEmpty() ? "mixed"
                                                               : unknown + " (unknown)");
  const QString paper = shown_info_ != nullptr ? text_of(shown_info_->paper) : QString();
  paper_->setText(paper);
  paper_->setVisible(!paper.isEmpty());
  QString hint;
  if (models_.empty())
    hint = QString("Select faces to see and edit their %1.").arg(kind_);
  else if (!unknown.isEmpty())
    hint = "There is no such model. Choose one here.";
  else if (shown_info_ == nullptr)
    hint = "The models differ. Choose one here to give it to all.";
  else if (shown_info_->parameters.empty() && terms_ == nullptr && data_file_ == nullptr)
    hint = "It has no parameters.";
  hint_->setText(hint);
  hint_->setVisible(!hint.isEmpty());
  for (ParameterRow* row : rows_) {
    std::vector<grf::Value> values;
    bool all_default = true;
    for (const grf::BrdfModel& model : models_) {
      values.push_back(value_of(model, *shown_info_, row->parameter()));
      all_default = all_default && is_default(model, row->parameter());
    }
    row->show_values(values, all_default);
  }
  refresh_extras();
}

void ModelForm::refresh_extras() {
  if (terms_ != nullptr) {
    const auto& first = models_.front().terms;
    const bool is_common =
        std::all_of(models_.begin(), models_.end(), [&](const auto& model) { return model.terms == first; });
    terms_->set_names(brdf_names(definitions_));
    terms_->set_terms(is_common ? first : std::vector<grf::CombineTerm>(), !is_common);
    lead_tab_through({chooser_, rows_holder_});  // its rows are new
  }
  if (data_file_ != nullptr) {
    const auto& first = models_.front().data_file;
    const bool is_common = std::all_of(models_.begin(), models_.end(),
                                       [&](const auto& model) { return model.data_file == first; });
    data_file_->set_file(is_common ? QString::fromStdString(first) : QString(), !is_common);
  }
}

void ModelForm::check_models() {
  mistakes_.clear();
  for (const grf::BrdfModel& model : models_) {
    for (const QString& mistake : check(model)) {
      if (std::find(mistakes_.begin(), mistakes_.end(), mistake) == mistakes_.end())
        mistakes_.push_back(mistake);
    }
  }
  show_mistakes();
}

void ModelForm::show_mistakes() {
  QStringList lines;
  for (const QString& mistake : mistakes_) lines << mistake;
  for (ParameterRow* row : rows_) {
    const QString begin = QString("'%1' of ").arg(text_of(row->parameter().name));
    const auto found = std::find_if(mistakes_.begin(), mistakes_.end(),
                                    [&](const QString& mistake) { return mistake.startsWith(begin); });
    row->set_message(found == mistakes_.end() ? QString() : *found);
  }
  message_->setText(lines.join('\n'));
  message_->setVisible(!lines.isEmpty());
  const ThemeColours colours = colours_of(theme_of(palette()));
  const auto paint = [](QLabel* label, const QColor& colour) {
    QPalette look = label->palette();
    if (look.color(QPalette::WindowText) == colour) return;
    look.setColor(QPalette::WindowText, colour);
    label->setPalette(look);
  };
  paint(message_, colours.error);
  paint(paper_, colours.faint_text);
  paint(hint_, colours.faint_text);
  emit mistakes_changed();
}

void ModelForm::focusInEvent(QFocusEvent* event) { chooser_->setFocus(event->reason()); }

void ModelForm::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) show_mistakes();
  QWidget::changeEvent(event);
}

BrdfForm::BrdfForm(QWidget* parent) : ModelForm(reflectance::brdf_infos(), "BRDF", parent) {}

std::vector<QString> BrdfForm::check(const grf::BrdfModel& model) const {
  return mistakes_of(model, definitions());
}

void BrdfForm::report(bool is_done) { emit is_done ? edited(models()) : changing(models()); }

PdfForm::PdfForm(QWidget* parent) : ModelForm(reflectance::scheme_infos(), "PDF", parent) {}

void PdfForm::set_models(const std::vector<grf::PdfModel>& models) {
  std::vector<grf::BrdfModel> as_brdfs;
  for (const grf::PdfModel& model : models) as_brdfs.push_back({{model}, {}, {}, {}});
  show_models(std::move(as_brdfs));
}

std::vector<grf::PdfModel> PdfForm::models() const {
  std::vector<grf::PdfModel> models;
  for (const grf::BrdfModel& model : shown_models()) models.push_back({model});
  return models;
}

std::vector<QString> PdfForm::check(const grf::BrdfModel& model) const {
  static const std::vector<grf::ModelInfo> infos = reflectance::scheme_infos();
  grf::Diagnostics diagnostics;
  grf::check(model, infos, "PDF", diagnostics);
  return error_messages(diagnostics);
}

void PdfForm::report(bool is_done) { emit is_done ? edited(models()) : changing(models()); }

}  // namespace editor
