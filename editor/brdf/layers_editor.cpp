#include "editor/brdf/layers_editor.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/appearance/theme.h"
#include "editor/brdf/brdf_list.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/text.h"

namespace editor {

LayersEditor::LayersEditor(const std::string& keyword, QWidget* parent) : QWidget(parent) {
  auto* column = tight_layout<QVBoxLayout>(this);
  for (const std::string_view layer : grf::layer_names(keyword)) {
    auto* row = new QWidget(this);
    auto* line = tight_layout<QHBoxLayout>(row);
    auto* name = new QLabel(text_of(layer), row);
    name->setMinimumWidth(6 * Grid);
    line->addWidget(name);
    QComboBox* list = new_brdf_list(tr("BRDF of the layer %1").arg(text_of(layer)), row);
    list->setPlaceholderText(tr("choose a BRDF"));
    name->setBuddy(list);
    line->addWidget(list, 1);
    column->addWidget(row);
    connect(list, &QComboBox::activated, this, &LayersEditor::report);
    lists_.push_back(list);
  }
  hint_ = new QLabel(tr("Define named BRDFs in the scene first: layers refer to those."), this);
  hint_->setWordWrap(true);
  column->addWidget(hint_);
  refresh();
}

void LayersEditor::set_names(const std::vector<QString>& names) {
  if (names == names_) return;
  names_ = names;
  refresh();
}

void LayersEditor::set_terms(const std::vector<grf::CombineTerm>& terms) {
  if (terms == terms_) return;
  terms_ = terms;
  if (terms.empty()) {
    for (QComboBox* list : lists_) list->setCurrentIndex(-1);
  }
  refresh();
}

void LayersEditor::refresh() {
  for (std::size_t i = 0; i < lists_.size(); ++i) {
    QComboBox* list = lists_[i];
    const QString before = list->currentText();
    const QString name = i < terms_.size() ? QString::fromStdString(terms_[i].brdf.name) : before;
    fill_brdf_list(*list, names_, name);
    list->setEnabled(!names_.empty());
  }
  hint_->setVisible(names_.empty());
}

void LayersEditor::report() {
  std::vector<grf::CombineTerm> terms;
  for (const QComboBox* list : lists_) {
    if (list->currentIndex() < 0) return;
    terms.push_back({1, {list->currentText().toStdString(), {}}});
  }
  terms_ = terms;
  emit edited(terms_);
}

}  // namespace editor
