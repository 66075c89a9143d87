#include "editor/brdf/data_file_row.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include "editor/controls/form_widgets.h"

namespace editor {

DataFileRow::DataFileRow(QWidget* parent) : QWidget(parent) {
  auto* row = tight_layout<QHBoxLayout>(this);
  auto* name = new QLabel(tr("Data"), this);
  line_ = new QLineEdit(this);
  line_->setAccessibleName(tr("File of measured data"));
  line_->setToolTip(tr(
      "A .bsdf file of the RGL material database for rgl; for measured a file of the MERL (.binary) or UTIA "
      "(.bin) database, of Zemax or LightTools (.bsdf), ASTM E1392 or CSV; by its path or relative to the "
      "scene"));
  name->setBuddy(line_);
  const QString choose_file = tr("Choose the file of measured data");
  row->addWidget(name);
  row->addWidget(line_, 1);
  row->addWidget(tool_button(
      "open", choose_file, choose_file, [this] { choose(); }, this));
  connect(line_, &QLineEdit::editingFinished, this, [this] { take(line_->text()); });
}

void DataFileRow::set_file(const QString& file, bool is_mixed) {
  file_ = file;
  if (line_->text() != file) line_->setText(file);
  line_->setPlaceholderText(is_mixed ? tr("mixed") : tr("choose a measured BRDF"));
}

void DataFileRow::choose() {
  auto* dialog = new QFileDialog(window(), tr("Measured data"), file_,
                                 tr("Measured data (*.binary *.bsdf *.bin *.astm *.csv);;All files (*)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &DataFileRow::take);
  dialog->open();
}

void DataFileRow::take(const QString& file) {
  if (file == file_) return;
  file_ = file;
  line_->setText(file);
  emit edited(file);
}

}  // namespace editor
