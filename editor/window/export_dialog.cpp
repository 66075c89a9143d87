#include "editor/window/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "converters/format.h"
#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/counted.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/text.h"

namespace editor {
namespace {

const QString LastFormat = QStringLiteral("export/format");

bool has_extension(const convert::Format& format, const QString& file) {
  return std::ranges::any_of(format.extensions, [&file](std::string_view extension) {
    return QFileInfo(file).suffix().compare(text_of(extension), Qt::CaseInsensitive) == 0;
  });
}

}  // namespace

ExportDialog::ExportDialog(ExportRequest scene, const QString& file, QWidget* parent)
    : QDialog(parent), request_(std::move(scene)), trial_(this) {
  setWindowTitle(tr("Export"));
  auto* rows = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  format_ = narrow_list(tr("Format"), tr("Format of the exported file"), 30, this);
  for (const convert::Format* format : formats_)
    format_->addItem(text_of(format->title), text_of(format->name));
  is_2008_ = new QCheckBox(tr("Grammar of &2008, without extensions"), this);
  is_2008_->setToolTip(tr("For programs that read only the first version of GRF"));
  form->addRow(tr("F&ile"), file_row());
  form->addRow(tr("&Format"), format_);
  form->addRow(is_2008_);
  rows->addLayout(form);
  summary_ = new QLabel(this);
  summary_->setAccessibleName(tr("Summary of losses"));
  rows->addWidget(summary_);
  losses_ = new QListWidget(this);
  losses_->setAccessibleName(tr("Losses"));
  losses_->setToolTip(tr("What the file will not have of the scene"));
  losses_->setWordWrap(true);
  rows->addWidget(losses_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  export_ = buttons->button(QDialogButtonBox::Ok);
  export_->setText(tr("&Export"));
  rows->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &ExportDialog::reject);
  connect(format_, &QComboBox::activated, this, &ExportDialog::choose_format);
  connect(is_2008_, &QCheckBox::clicked, this, &ExportDialog::update_losses);
  file_->setText(file);
  format_->setCurrentIndex(std::max(0, format_->findData(QSettings().value(LastFormat, "obj"))));
  choose_format();
  connect(file_, &QLineEdit::textEdited, this, &ExportDialog::take_name);
  resize(80 * Grid, 48 * Grid);
  file_->setFocus();
}

QWidget* ExportDialog::file_row() {
  auto* row = new QWidget(this);
  auto* line = tight_layout<QHBoxLayout>(row, Grid / 4);
  file_ = new QLineEdit(row);
  file_->setAccessibleName(tr("File"));
  file_->setToolTip(tr("Name of the exported file; its extension selects the format"));
  line->addWidget(file_, 1);
  line->addWidget(tool_button(
      "browse", tr("Browse for a file"), tr("Choose the exported file"), [this] { browse(); }, row));
  return row;
}

void ExportDialog::browse() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Export"), file_->text(), {}, nullptr,
                                                    QFileDialog::DontConfirmOverwrite);
  if (file.isEmpty()) return;
  file_->setText(file);
  take_name();
}

/// Finds the format of a name's extension, or the end.
std::vector<const convert::Format*>::const_iterator ExportDialog::format_of(const QString& file) const {
  return std::ranges::find_if(
      formats_, [&file](const convert::Format* format) { return has_extension(*format, file); });
}

/// Gives the name the extension of the format.
void ExportDialog::choose_format() {
  const convert::Format& format = *formats_[static_cast<std::size_t>(format_->currentIndex())];
  QString name = file_->text();
  if (!has_extension(format, name)) {
    if (format_of(name) != formats_.end()) name.chop(QFileInfo(name).suffix().size() + 1);
    file_->setText(name + "." + text_of(format.extensions.front()));
  }
  update_losses();
}

/// Selects the format of the name's extension.
void ExportDialog::take_name() {
  export_->setEnabled(!file_->text().isEmpty());
  const convert::Format& now = *formats_[static_cast<std::size_t>(format_->currentIndex())];
  if (has_extension(now, file_->text())) return;
  const auto other = format_of(file_->text());
  if (other == formats_.end()) return;
  format_->setCurrentIndex(static_cast<int>(other - formats_.begin()));
  update_losses();
}

/// Writes to a temporary folder, in a thread.
void ExportDialog::update_losses() {
  request_.format = formats_[static_cast<std::size_t>(format_->currentIndex())];
  is_2008_->setEnabled(request_.format->name == "grf");
  request_.is_grf2008 = is_2008_->isEnabled() && is_2008_->isChecked();
  summary_->setText(tr("Finding out what will be lost..."));
  losses_->clear();
  trial_.start([request = request_](const StopFlag&) { return try_to_write(request); },
               [this](const grf::Diagnostics& diagnostics) { show_losses(diagnostics); });
}

void ExportDialog::show_losses(const grf::Diagnostics& diagnostics) {
  const auto& losses = diagnostics.losses();
  for (const grf::Diagnostic& entry : diagnostics.entries()) {
    if (entry.severity != grf::Severity::Error) continue;
    new QListWidgetItem(icon("error"), QString::fromStdString(entry.message), losses_);
  }
  for (const std::string& loss : losses) {
    new QListWidgetItem(icon("warning"), QString::fromStdString(loss), losses_);
  }
  summary_->setText(diagnostics.has_errors() ? tr("The scene cannot be written in this format:")
                    : losses.empty()         ? tr("Nothing will be lost.")
                                             : tr("This will be lost:"));
}

void ExportDialog::accept() {
  request_.path = file_->text();
  if (!has_extension(*request_.format, request_.path)) {
    request_.path += "." + text_of(request_.format->extensions.front());
  }
  if (QFileInfo::exists(request_.path)) {
    QMessageBox question(QMessageBox::Warning, tr("Replace file"),
                         tr("%1 exists.").arg(QFileInfo(request_.path).fileName()),
                         QMessageBox::Save | QMessageBox::Cancel, this);
    question.setInformativeText(tr("Exporting overwrites it."));
    question.button(QMessageBox::Save)->setText(tr("Replace"));
    question.setDefaultButton(QMessageBox::Cancel);
    if (question.exec() != QMessageBox::Save) return;
  }
  QSettings().setValue(LastFormat, text_of(request_.format->name));
  QDialog::accept();
}

}  // namespace editor
