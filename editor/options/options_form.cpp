#include "editor/options/options_form.h"

#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QVBoxLayout>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/text.h"
#include "editor/options/option_field.h"
#include "editor/options/option_row.h"

namespace editor {

using options::OptionInfo;

const OptionInfo* option_of(const grf::Diagnostic& diagnostic, const options::OpText& text) {
  if (const OptionInfo* option = text.option_at(diagnostic.location.line)) return option;
  if (diagnostic.location.line > 0) return nullptr;
  for (const OptionInfo& option : options::option_table()) {
    if (diagnostic.message.find(option.key) != std::string::npos) return &option;
  }
  return nullptr;
}

OptionsForm::OptionsForm(OpDocument& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      search_(new QLineEdit(this)),
      scroll_(new QScrollArea(this)),
      nothing_(new QLabel(tr("No option matches the search."), this)) {
  search_->setPlaceholderText(tr("Search options"));
  search_->setClearButtonEnabled(true);
  search_->addAction(icon("search"), QLineEdit::LeadingPosition);
  search_->setAccessibleName(tr("Search options"));
  search_->setToolTip(tr("Show only options with these words in their names, meanings or defaults."));
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setAccessibleName(tr("Options"));
  auto* page = new QWidget(scroll_);
  make_rows(page);
  scroll_->setWidget(page);
  auto* column = tight_layout<QVBoxLayout>(this, 0);
  auto* top = new QVBoxLayout;
  top->setContentsMargins(Grid, Grid, Grid, Grid);
  top->addWidget(search_);
  column->addLayout(top);
  column->addWidget(nothing_, 0, Qt::AlignHCenter);
  column->addWidget(scroll_, 1);
  nothing_->hide();
  connect(search_, &QLineEdit::textChanged, this, &OptionsForm::filter);
  connect(&document_, &OpDocument::changed, this, &OptionsForm::show_state);
  connect(&document_, &OpDocument::path_changed, this, &OptionsForm::show_state);
  show_state();
}

void OptionsForm::make_rows(QWidget* page) {
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 2 * Grid);
  column->setSpacing(0);
  for (const OptionInfo& option : options::option_table()) {
    const QString title = text_of(options::title_of(option.group));
    if (groups_.empty() || groups_.back().title->text() != title) {
      auto* label = new QLabel(title, page);
      QFont font = label->font();
      font.setBold(true);
      font.setPointSizeF(1.25 * font.pointSizeF());
      label->setFont(font);
      label->setContentsMargins(2 * Grid, 2 * Grid, Grid, Grid / 2);
      column->addWidget(label);
      groups_.push_back({label, {}});
    }
    auto* row = new OptionRow(option, document_, page);
    column->addWidget(row);
    groups_.back().rows.push_back(row);
  }
  column->addStretch(1);
}

OptionRow* OptionsForm::row_of(const OptionInfo& option) const {
  for (const Group& group : groups_) {
    for (OptionRow* row : group.rows) {
      if (&row->option() == &option) return row;
    }
  }
  return nullptr;
}

void OptionsForm::show_option(const OptionInfo& option) {
  OptionRow* row = row_of(option);
  if (row->isHidden()) search_->clear();
  scroll_->ensureWidgetVisible(row, 0, 4 * Grid);
}

bool OptionsForm::is_usable(const OptionInfo& option) const { return row_of(option)->field().isEnabled(); }

void OptionsForm::go_to(const OptionInfo& option) {
  show_option(option);
  row_of(option)->field().setFocus(Qt::OtherFocusReason);
}

void OptionsForm::show_state() {
  const QString folder = document_.path().isEmpty() ? QString() : QFileInfo(document_.path()).absolutePath();
  const options::RenderOptions partial = document_.partial_options();
  for (const Group& group : groups_) {
    for (OptionRow* row : group.rows) {
      row->field().set_folder(folder);
      row->show_state(partial);
    }
  }
  show_messages();
}

void OptionsForm::show_messages() {
  for (const grf::Diagnostic& entry : document_.diagnostics().entries()) {
    const OptionInfo* option = option_of(entry, document_.op_text());
    if (option == nullptr || entry.severity != grf::Severity::Error) continue;
    row_of(*option)->show_message(QString::fromStdString(entry.message), true);
  }
}

void OptionsForm::filter(const QString& text) {
  bool has_any = false;
  for (const Group& group : groups_) {
    bool has_some = false;
    for (OptionRow* row : group.rows) {
      row->setVisible(row->matches(text));
      has_some |= !row->isHidden();
    }
    group.title->setVisible(has_some);
    has_any |= has_some;
  }
  nothing_->setVisible(!has_any);
}

}  // namespace editor
