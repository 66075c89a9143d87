#include "editor/tools/chooser_form.h"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

#include "editor/brdf/parameter_rows.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/tab_order.h"
#include "editor/controls/text.h"

namespace editor {

ChooserForm::ChooserForm(const QString& kind, const std::string& check_kind,
                         std::vector<grf::ModelInfo> infos, QWidget* parent)
    : QWidget(parent),
      check_kind_(check_kind),
      infos_(std::move(infos)),
      chooser_(narrow_list(kind, {}, 12, this)),
      parameters_(new ParameterRows(this)),
      problem_(problem_label(this)) {
  auto* column = tight_layout<QVBoxLayout>(this);
  for (const grf::ModelInfo& info : infos_) {
    chooser_->addItem(QString("%1 (%2)").arg(text_of(info.title), text_of(info.keyword)));
    chooser_->setItemData(chooser_->count() - 1, text_of(info.description), Qt::ToolTipRole);
  }
  column->addWidget(chooser_);
  column->addWidget(parameters_);
  column->addWidget(problem_);
  connect(chooser_, &QComboBox::activated, this, &ChooserForm::choose);
  connect(parameters_, &ParameterRows::edited, this, [this](const auto& edit, bool is_done) {
    edit(model_);
    apply(is_done);
  });
}

void ChooserForm::set_model(const grf::Model& model) {
  model_ = model;
  refresh();
}

void ChooserForm::choose(int index) {
  const grf::ModelInfo& chosen = infos_[static_cast<std::size_t>(index)];
  if (grf::find_model(infos_, model_.keyword) == &chosen) return;
  model_ = {};
  model_.keyword = chosen.keyword;
  apply(true);
}

void ChooserForm::refresh() {
  const grf::ModelInfo* info = grf::find_model(infos_, model_.keyword);
  chooser_->setCurrentIndex(info != nullptr ? static_cast<int>(info - infos_.data()) : -1);
  if (info != nullptr) chooser_->setToolTip("<p>" + text_of(info->description).toHtmlEscaped() + "</p>");
  parameters_->show_models(info, {&model_});
  parameters_->setVisible(info != nullptr && !info->parameters.empty());
  lead_tab_through({chooser_, parameters_});
}

void ChooserForm::apply(bool is_done) {
  refresh();
  grf::Diagnostics diagnostics;
  const bool is_valid = grf::check(model_, infos_, check_kind_, diagnostics);
  show_or_hide(problem_, is_valid ? QString() : text_of(diagnostics.entries().front().message));
  if (is_valid) emit edited(model_, is_done);
}

}  // namespace editor
