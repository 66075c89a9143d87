#include "editor/brdf/model_form.h"

#include <QComboBox>
#include <QCompleter>
#include <QFocusEvent>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>

#include "editor/appearance/theme.h"
#include "editor/brdf/data_file_row.h"
#include "editor/brdf/layers_editor.h"
#include "editor/brdf/parameter_rows.h"
#include "editor/brdf/terms_editor.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/tab_order.h"
#include "editor/controls/text.h"
#include "grf/keywords.h"
#include "renderer/reflectance/brdf.h"

namespace editor {
namespace {

QString title_of(const grf::ModelInfo& info) {
  return QString("%1 (%2)").arg(text_of(info.title), text_of(info.keyword));
}

ThemedLabel* new_note(QColor ThemeColours::*colour, QWidget* parent) {
  auto* label = new ThemedLabel(colour, parent);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setFocusPolicy(Qt::NoFocus);
  label->hide();
  return label;
}

}  // namespace

BrdfForm::BrdfForm(QWidget* parent)
    : QWidget(parent),
      infos_(reflectance::brdf_infos()),
      paper_(new_note(&ThemeColours::faint_text, this)),
      rows_(new QVBoxLayout),
      parameters_(new ParameterRows(this)),
      hint_(new_note(&ThemeColours::faint_text, this)),
      message_(new_note(&ThemeColours::error, this)) {
  auto* column = tight_layout<QVBoxLayout>(this);
  build_chooser();
  column->addWidget(chooser_);
  column->addWidget(paper_);
  rows_->setSpacing(Grid / 2);
  rows_->addWidget(parameters_);
  column->addLayout(rows_);
  column->addWidget(hint_);
  message_->setAccessibleName(tr("What is wrong with the BRDF"));
  column->addWidget(message_);
  column->addStretch(1);
  connect(parameters_, &ParameterRows::edited, this, [this](const auto& edit, bool is_done) {
    for (grf::BrdfModel& model : models_) edit(model);
    apply(is_done);
  });
  refresh();
  check_models();
}

void BrdfForm::build_chooser() {
  chooser_ = narrow_list(tr("BRDF model"), {}, 12, this);
  chooser_->setEditable(true);
  chooser_->setInsertPolicy(QComboBox::NoInsert);
  for (const grf::ModelInfo& info : infos_) {
    chooser_->addItem(title_of(info));
    chooser_->setItemData(chooser_->count() - 1, text_of(info.description), Qt::ToolTipRole);
  }
  chooser_->completer()->setFilterMode(Qt::MatchContains);
  chooser_->completer()->setCompletionMode(QCompleter::PopupCompletion);
  connect(chooser_, &QComboBox::activated, this, &BrdfForm::choose);
  connect(chooser_->lineEdit(), &QLineEdit::editingFinished, this, [this] {
    // Text that names no model reverts to the current model.
    if (chooser_->findText(chooser_->currentText(), Qt::MatchFixedString) < 0) refresh();
  });
}

void BrdfForm::leave_out_images() {
  for (grf::ModelInfo& info : infos_) info.takes_maps = false;
}

std::string BrdfForm::common_keyword() const {
  if (models_.empty()) return {};
  const std::string& keyword = models_.front().keyword;
  const bool is_common = std::ranges::all_of(
      models_, [&](const grf::BrdfModel& model) { return grf::same_keyword(model.keyword, keyword); });
  return is_common ? keyword : std::string();
}

void BrdfForm::set_models(std::vector<grf::BrdfModel> models) {
  models_ = std::move(models);
  refresh();
  check_models();
}

void BrdfForm::set_definitions(Definitions definitions) {
  definitions_ = std::move(definitions);
  refresh();
  check_models();
}

void BrdfForm::choose(int index) {
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

void BrdfForm::rebuild() {
  using ArgumentKind = grf::ModelInfo::ArgumentKind;
  for (QWidget* old : std::initializer_list<QWidget*>{terms_, layers_, data_file_}) {
    if (old == nullptr) continue;
    old->hide();
    old->deleteLater();
  }
  terms_ = nullptr;
  layers_ = nullptr;
  data_file_ = nullptr;
  if (info_ != nullptr && info_->argument_kind == ArgumentKind::Terms) {
    terms_ = new TermsEditor(this);
    rows_->insertWidget(0, terms_);
    const auto take = [this](const std::vector<grf::CombineTerm>& terms, bool is_done) {
      for (grf::BrdfModel& model : models_) model.terms = terms;
      apply(is_done);
    };
    connect(terms_, &TermsEditor::changing, this, [take](const auto& terms) { take(terms, false); });
    connect(terms_, &TermsEditor::edited, this, [take](const auto& terms) { take(terms, true); });
  }
  if (info_ != nullptr && info_->argument_kind == ArgumentKind::Layers) {
    layers_ = new LayersEditor(common_keyword(), this);
    rows_->insertWidget(0, layers_);
    connect(layers_, &LayersEditor::edited, this, [this](const std::vector<grf::CombineTerm>& terms) {
      for (grf::BrdfModel& model : models_) model.terms = terms;
      apply(true);
    });
  }
  if (info_ != nullptr && info_->argument_kind == ArgumentKind::DataFile) {
    data_file_ = new DataFileRow(this);
    rows_->insertWidget(0, data_file_);
    connect(data_file_, &DataFileRow::edited, this, [this](const QString& file) {
      for (grf::BrdfModel& model : models_) model.data_file = file.toStdString();
      apply(true);
    });
  }
}

void BrdfForm::apply(bool is_done) {
  refresh();
  check_models();
  if (errors_.empty()) emit is_done ? edited(models_) : changing(models_);
}

void BrdfForm::refresh() {
  const grf::ModelInfo* info = grf::find_model(infos_, common_keyword());
  if (info != info_) {
    info_ = info;
    rebuild();
  }
  refresh_chooser();
  refresh_rows();
  std::vector<QWidget*> parts = {chooser_, terms_, layers_, data_file_, parameters_};
  std::erase(parts, nullptr);
  lead_tab_through(parts);
}

void BrdfForm::refresh_chooser() {
  chooser_->setEnabled(!models_.empty());
  chooser_->setToolTip(models_.empty()    ? tr("No selected face has a BRDF")
                       : info_ != nullptr ? "<p>" + text_of(info_->description).toHtmlEscaped() + "</p>"
                                          : tr("The model of the BRDF; type a part of its name to search"));
  chooser_->setCurrentIndex(info_ != nullptr ? static_cast<int>(info_ - infos_.data()) : -1);
  const QString unknown = info_ == nullptr ? QString::fromStdString(common_keyword()) : QString();
  chooser_->lineEdit()->setPlaceholderText(models_.empty()     ? tr("no BRDF")
                                           : unknown.isEmpty() ? tr("mixed")
                                                               : tr("%1 (unknown)").arg(unknown));
  const QString paper = info_ != nullptr ? text_of(info_->paper) : QString();
  show_or_hide(paper_, paper);
  QString hint;
  if (models_.empty())
    hint = tr("Select faces to see and edit their BRDF.");
  else if (!unknown.isEmpty())
    hint = tr("Unknown BRDF model. Choose one here.");
  else if (info_ == nullptr)
    hint = tr("The faces have different models. Choose one here to assign it to all.");
  else if (info_->parameters.empty() && info_->argument_kind == grf::ModelInfo::ArgumentKind::Parameters)
    hint = tr("This model has no parameters.");
  show_or_hide(hint_, hint);
}

void BrdfForm::refresh_rows() {
  std::vector<const grf::Model*> models;
  for (const grf::BrdfModel& model : models_) models.push_back(&model);
  parameters_->show_models(info_, models);
  const auto have_one = [this](const auto& value) {
    return std::ranges::all_of(models_, [&](const grf::BrdfModel& model) {
      return std::invoke(value, model) == std::invoke(value, models_.front());
    });
  };
  if (terms_ != nullptr) {
    const bool is_common = have_one(&grf::BrdfModel::terms);
    terms_->set_names(brdf_names(definitions_));
    terms_->set_terms(is_common ? models_.front().terms : std::vector<grf::CombineTerm>(), !is_common);
  }
  if (layers_ != nullptr) {
    layers_->set_names(brdf_names(definitions_));
    layers_->set_terms(have_one(&grf::BrdfModel::terms) ? models_.front().terms
                                                        : std::vector<grf::CombineTerm>());
  }
  if (data_file_ != nullptr) {
    const bool is_common = have_one(&grf::BrdfModel::data_file);
    const std::string& file = models_.front().data_file;
    data_file_->set_file(is_common ? QString::fromStdString(file) : QString(), !is_common);
  }
}

void BrdfForm::check_models() {
  errors_.clear();
  for (const grf::BrdfModel& model : models_) {
    for (const QString& mistake : errors_of(model, definitions_)) {
      if (std::ranges::find(errors_, mistake) == errors_.end()) errors_.push_back(mistake);
    }
  }
  parameters_->show_errors(errors_);
  show_or_hide(message_, QStringList(errors_.begin(), errors_.end()).join('\n'));
}

void BrdfForm::focusInEvent(QFocusEvent* event) { chooser_->setFocus(event->reason()); }

}  // namespace editor
