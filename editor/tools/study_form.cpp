#include "editor/tools/study_form.h"

#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/appearance/theme.h"
#include "editor/brdf/model_form.h"
#include "editor/brdf/parameter_rows.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/tab_order.h"
#include "editor/tools/chooser_form.h"
#include "renderer/reflectance/scheme.h"

namespace editor {
namespace {

/// A list that says what to do while it is empty.
class FileList : public QListWidget {
 public:
  using QListWidget::QListWidget;

 protected:
  void paintEvent(QPaintEvent* event) override {
    QListWidget::paintEvent(event);
    if (count() > 0) return;
    QPainter painter(viewport());
    painter.setPen(colours_of(theme_of(palette())).faint_text);
    painter.drawText(viewport()->rect(), Qt::AlignCenter | Qt::TextWordWrap,
                     StudyForm::tr("Open a file, or drop it here"));
  }
};

/// `BRDF`, or `BRDF A` and `BRDF B` if there are two.
QString numbered(const QString& name, std::size_t index, std::size_t count) {
  return count == 1 ? name : QString("%1 %2").arg(name, QChar('A' + static_cast<char>(index)));
}

}  // namespace

StudyForm::StudyForm(const studies::StudyTool& tool, QWidget* parent)
    : QWidget(parent), tool_(tool), state_(tool.initial), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(Grid, Grid, Grid, Grid);
  column_->setSpacing(Grid / 2);
  if (!tool_.files.empty()) add_files();
  add_models();
  add_settings();
  column_->addStretch(1);
  refresh();
}

QVBoxLayout* StudyForm::add_section(const QString& title) {
  auto* label = new QLabel(title, this);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  if (column_->count() > 0) column_->addSpacing(Grid);
  column_->addWidget(label);
  return column_;
}

void StudyForm::add_settings() {
  if (tool_.settings.parameters.empty()) return;
  settings_ = new ParameterRows(this);
  add_section(tr("Settings"))->addWidget(settings_);
  connect(settings_, &ParameterRows::edited, this, [this](const auto& edit, bool is_done) {
    edit(state_.settings);
    refresh();
    emit edited(state_, is_done);
  });
}

void StudyForm::add_models() {
  if (!tool_.distributions.empty()) {
    distribution_ = new ChooserForm(tr("Distribution"), "distribution", tool_.distributions, this);
    add_section(tr("Distribution"))->addWidget(distribution_);
    connect(distribution_, &ChooserForm::edited, this, [this](const grf::Model& model, bool is_done) {
      state_.distribution = model;
      emit edited(state_, is_done);
    });
  }
  for (std::size_t i = 0; i < tool_.brdfs; ++i) {
    auto* form = new BrdfForm(this);
    form->leave_out_images();
    brdfs_.push_back(form);
    add_section(numbered(tr("BRDF"), i, tool_.brdfs))->addWidget(form);
    const auto take = [this, i](const std::vector<grf::BrdfModel>& models, bool is_done) {
      state_.brdfs[i] = models.front();
      emit edited(state_, is_done);
    };
    connect(form, &BrdfForm::changing, this, [take](const auto& models) { take(models, false); });
    connect(form, &BrdfForm::edited, this, [take](const auto& models) { take(models, true); });
  }
  for (std::size_t i = 0; i < tool_.pdfs; ++i) {
    auto* form = new ChooserForm(tr("Sampling scheme"), "PDF", reflectance::scheme_infos(), this);
    pdfs_.push_back(form);
    add_section(numbered(tr("Sampling scheme"), i, tool_.pdfs))->addWidget(form);
    connect(form, &ChooserForm::edited, this, [this, i](const grf::Model& model, bool is_done) {
      state_.pdfs[i] = grf::PdfModel{model};
      emit edited(state_, is_done);
    });
  }
}

void StudyForm::add_files() {
  files_ = new FileList(this);
  files_->setAccessibleName(tr("Files"));
  files_->setToolTip(tr("The files that are shown; drop others here or on the figure"));
  files_->setFixedHeight((tool_.takes_many_files ? 10 : 4) * Grid);
  auto* line = new QHBoxLayout;
  line->setSpacing(Grid / 4);
  line->addWidget(files_, 1);
  auto* buttons = new QVBoxLayout;
  buttons->addWidget(tool_button(
      "open", tr("Add a file"), tr("Open a file of the kinds that the tool shows"),
      [this] { emit files_requested(); }, this));
  remove_ = tool_button(
      "remove", tr("Remove the file"), {}, [this] { remove_file(); }, this);
  buttons->addWidget(remove_);
  buttons->addStretch(1);
  line->addLayout(buttons);
  add_section(tool_.takes_many_files ? tr("Files") : tr("File"))->addLayout(line);
  connect(files_, &QListWidget::currentRowChanged, this, [this](int row) {
    enable(remove_, tr("Remove the selected file from the figure"),
           row < 0 ? tr("No file is selected.") : QString());
  });
}

void StudyForm::remove_file() {
  const int row = files_->currentRow();
  if (row < 0) return;
  state_.files.erase(state_.files.begin() + row);
  refresh_files();
  emit edited(state_, true);
}

void StudyForm::set_state(const studies::ToolState& state) {
  state_ = state;
  refresh();
}

void StudyForm::refresh_files() {
  if (files_ == nullptr) return;
  files_->clear();
  for (const studies::ToolState::File& file : state_.files) {
    const QString path = QString::fromStdString(file.path);
    auto* item = new QListWidgetItem(QFileInfo(path).fileName(), files_);
    item->setToolTip(path);
  }
  files_->setCurrentRow(state_.files.empty() ? -1 : 0);
  enable(remove_, tr("Remove the selected file from the figure"),
         state_.files.empty() ? tr("No file is selected.") : QString());
}

void StudyForm::refresh() {
  if (settings_ != nullptr) settings_->show_models(&tool_.settings, {&state_.settings});
  if (distribution_ != nullptr && state_.distribution) distribution_->set_model(*state_.distribution);
  for (std::size_t i = 0; i < brdfs_.size(); ++i) {
    brdfs_[i]->set_definitions(state_.definitions);
    if (brdfs_[i]->models() != std::vector{state_.brdfs[i]}) brdfs_[i]->set_models({state_.brdfs[i]});
  }
  for (std::size_t i = 0; i < pdfs_.size(); ++i) pdfs_[i]->set_model(state_.pdfs[i]);
  refresh_files();
}

}  // namespace editor
