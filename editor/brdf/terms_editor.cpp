#include "editor/brdf/terms_editor.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/brdf/brdf_list.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/controls/tab_order.h"

namespace editor {

TermsEditor::TermsEditor(QWidget* parent) : QWidget(parent) {
  auto* column = tight_layout<QVBoxLayout>(this);
  holder_ = new QWidget(this);
  rows_ = tight_layout<QVBoxLayout>(holder_);
  column->addWidget(holder_);
  hint_ = new QLabel(this);
  hint_->setWordWrap(true);
  column->addWidget(hint_);
  add_ = new QToolButton(this);
  add_->setText(tr("Add a BRDF"));
  add_->setIcon(icon("plus"));
  add_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  add_->setAccessibleName(tr("Add a BRDF to the sum"));
  column->addWidget(add_);
  connect(add_, &QToolButton::clicked, this, &TermsEditor::add_term);
  rebuild();
}

void TermsEditor::set_names(const std::vector<QString>& names) {
  if (names == names_) return;
  names_ = names;
  rebuild();
}

void TermsEditor::set_terms(const std::vector<grf::CombineTerm>& terms, bool are_mixed) {
  if (terms == terms_ && are_mixed == are_mixed_) return;
  terms_ = terms;
  are_mixed_ = are_mixed;
  rebuild();
}

void TermsEditor::rebuild() {
  for (QObject* old : holder_->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
    static_cast<QWidget*>(old)->hide();
    old->deleteLater();
  }
  for (std::size_t i = 0; i < terms_.size(); ++i) add_row(i);
  lead_tab_through({holder_, add_});
  if (names_.empty()) {
    hint_->setText(tr("Define named BRDFs in the scene first: a sum refers to those."));
  } else if (are_mixed_) {
    hint_->setText(tr("The faces have different sums. Adding a BRDF here replaces them."));
  } else {
    hint_->setText(tr("Add the BRDFs of the sum."));
  }
  hint_->setVisible(terms_.empty());
  add_->setEnabled(!names_.empty());
  add_->setToolTip(names_.empty() ? tr("The scene has no named BRDFs")
                                  : tr("Add a BRDF of the scene, with a weight"));
}

void TermsEditor::add_row(std::size_t index) {
  auto* row = new QWidget(holder_);
  auto* line = tight_layout<QHBoxLayout>(row);
  const QString name = QString::fromStdString(terms_[index].brdf.name);
  auto* weight = new NumberBox(row);
  weight->set_range(0, 10);
  weight->set_help(tr("The weight of this BRDF in the sum"));
  weight->setAccessibleName(tr("weight of %1").arg(name));
  weight->setFixedWidth(10 * Grid);
  weight->set_value(terms_[index].weight);
  line->addWidget(weight);
  QComboBox* choice = new_brdf_list(tr("BRDF of the term"), row);
  fill_brdf_list(*choice, names_, name);
  line->addWidget(choice, 1);
  const auto take_out = [this, index] {
    terms_.erase(terms_.begin() + static_cast<std::ptrdiff_t>(index));
    rebuild();
    emit edited(terms_);
  };
  line->addWidget(
      tool_button("remove", tr("remove %1").arg(name), tr("Remove this BRDF from the sum"), take_out, row));
  rows_->addWidget(row);
  row->show();
  connect(weight, &NumberBox::changing, this, [this, index](double value) {
    terms_[index].weight = static_cast<float>(value);
    emit changing(terms_);
  });
  connect(weight, &NumberBox::edited, this, [this, index](double value) {
    terms_[index].weight = static_cast<float>(value);
    emit edited(terms_);
  });
  connect(choice, &QComboBox::activated, this, [this, index, choice] {
    terms_[index].brdf.name = choice->currentText().toStdString();
    emit edited(terms_);
  });
}

void TermsEditor::add_term() {
  // Prefers a BRDF that is not in the sum yet.
  const auto is_new = [this](const QString& name) {
    return std::ranges::none_of(
        terms_, [&](const grf::CombineTerm& term) { return QString::fromStdString(term.brdf.name) == name; });
  };
  const auto found = std::ranges::find_if(names_, is_new);
  const QString name = found == names_.end() ? names_.front() : *found;
  terms_.push_back({terms_.empty() ? 1.0F : 0.5F, {name.toStdString(), {}}});
  are_mixed_ = false;
  rebuild();
  emit edited(terms_);
}

}  // namespace editor
