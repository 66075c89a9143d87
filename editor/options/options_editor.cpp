#include "editor/options/options_editor.h"

#include <QAction>
#include <QFileDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QSplitter>
#include <QToolBar>
#include <QVBoxLayout>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/options/op_text_view.h"
#include "editor/options/options_form.h"

namespace editor {
namespace {

QString op_filter() { return QObject::tr("Options (*.op);;All files (*)"); }

}  // namespace

OptionsEditor::OptionsEditor(OpDocument* project, QWidget* parent)
    : QWidget(parent),
      document_(project != nullptr ? *project : own_document_),
      form_(new OptionsForm(document_, this)),
      text_(new OpTextView(document_, this)),
      messages_(new QListWidget(this)) {
  make_actions();
  lay_out();
  for (QLineEdit* line : findChildren<QLineEdit*>()) line->installEventFilter(this);
  connect(&document_, &OpDocument::changed, this, [this] {
    file_problems_ = {};
    show_messages();
  });
  connect(messages_, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { follow_message(messages_->row(item)); });
  connect(messages_, &QListWidget::itemActivated, this,
          [this](QListWidgetItem* item) { follow_message(messages_->row(item)); });
  show_messages();
}

void OptionsEditor::make_actions() {
  const auto add = [this](const QString& icon_name, const QString& text, const QString& help) {
    auto* action = new QAction(icon(icon_name), text, this);
    action->setToolTip(text + "\n" + help);
    return action;
  };
  open_ = add("open", tr("Open options"), tr("Open an OP file."));
  save_ = add("save", tr("Save options"), tr("Save the OP file; comments are kept."));
  save_as_ = add("save_as", tr("Save options as"), tr("Save the OP file under another name."));
  undo_ = document_.undo_stack().createUndoAction(this, tr("Undo"));
  undo_->setIcon(icon("undo"));
  undo_->setToolTip(tr("Undo the last change of the options"));
  redo_ = document_.undo_stack().createRedoAction(this, tr("Redo"));
  redo_->setIcon(icon("redo"));
  redo_->setToolTip(tr("Redo the last undone change of the options"));
  connect(open_, &QAction::triggered, this, &OptionsEditor::ask_for_file);
  connect(save_, &QAction::triggered, this, qOverload<>(&OptionsEditor::save));
  connect(save_as_, &QAction::triggered, this, &OptionsEditor::save_as);
}

void OptionsEditor::lay_out() {
  auto* tools = new QToolBar(this);
  tools->setIconSize({2 * Grid, 2 * Grid});
  tools->addActions({open_, save_, save_as_});
  tools->addSeparator();
  tools->addActions({undo_, redo_});
  messages_->setAccessibleName(tr("Messages"));
  messages_->setToolTip(
      tr("Errors and warnings of bpt about these options. Select one to go to its option or line."));
  messages_->setWordWrap(true);
  messages_->setFrameShape(QFrame::NoFrame);
  text_->setFrameShape(QFrame::NoFrame);
  auto* right = new QSplitter(Qt::Vertical, this);
  right->addWidget(text_);
  right->addWidget(messages_);
  right->setStretchFactor(0, 3);
  right->setStretchFactor(1, 1);
  auto* both = new QSplitter(Qt::Horizontal, this);
  both->addWidget(form_);
  both->addWidget(right);
  both->setStretchFactor(0, 3);
  both->setStretchFactor(1, 2);
  both->setChildrenCollapsible(false);
  both->setSizes({75 * Grid, 50 * Grid});
  auto* column = tight_layout<QVBoxLayout>(this, 0);
  column->addWidget(tools);
  column->addWidget(both, 1);
}

// Files

bool OptionsEditor::report(const grf::Diagnostics& diagnostics, bool is_done) {
  file_problems_ = diagnostics;
  show_messages();
  if (!diagnostics.entries().empty()) emit reported(diagnostics);
  return is_done;
}

bool OptionsEditor::open(const QString& path) {
  grf::Diagnostics diagnostics;
  const bool is_read = document_.open(path, diagnostics);
  return report(diagnostics, is_read);
}

bool OptionsEditor::save(const QString& path) {
  // The shortcut may save while a number is being typed.
  for (NumberBox* box : form_->findChildren<NumberBox*>()) box->commit();
  grf::Diagnostics diagnostics;
  const bool is_written = document_.save(path, diagnostics);
  return report(diagnostics, is_written);
}

bool OptionsEditor::save() { return document_.path().isEmpty() ? save_as() : save(document_.path()); }

bool OptionsEditor::save_as() {
  const QString path = QFileDialog::getSaveFileName(this, tr("Save options"), document_.path(), op_filter());
  return !path.isEmpty() && save(path);
}

void OptionsEditor::ask_for_file() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Open options"), document_.path(), op_filter());
  if (!path.isEmpty()) open(path);
}

// Messages

void OptionsEditor::show_messages() {
  messages_->clear();
  for (const grf::Diagnostic& entry : file_problems_.entries()) add_message(entry);
  for (const grf::Diagnostic& entry : document_.diagnostics().entries()) add_message(entry);
  if (messages_->count() > 0) return;
  auto* item = new QListWidgetItem(tr("These options have no errors or warnings."), messages_);
  item->setForeground(colours_of(theme_of(palette())).faint_text);
}

void OptionsEditor::add_message(const grf::Diagnostic& entry) {
  const bool is_error = entry.severity == grf::Severity::Error;
  const QString place = entry.location.line > 0 ? tr("Line %1: ").arg(entry.location.line) : QString();
  auto* item = new QListWidgetItem(icon(is_error ? "error" : "warning"),
                                   place + QString::fromStdString(entry.message), messages_);
  const ThemeColours colours = colours_of(theme_of(palette()));
  item->setForeground(is_error ? colours.error : colours.warning);
  item->setData(Qt::AccessibleTextRole, (is_error ? tr("Error. ") : tr("Warning. ")) + item->text());
}

void OptionsEditor::follow_message(int row) {
  const auto first = int(file_problems_.entries().size());
  const auto& entries = document_.diagnostics().entries();
  if (row < first || row - first >= int(entries.size())) return;
  const grf::Diagnostic& entry = entries[std::size_t(row - first)];
  const options::OptionInfo* option = option_of(entry, document_.op_text());
  // A duplicate line, or one without effect, is not shown by a control.
  if (option != nullptr && form_->is_usable(*option)) return form_->go_to(*option);
  if (option != nullptr) form_->show_option(*option);
  if (entry.location.line > 0) text_->go_to(entry.location.line, entry.location.column);
}

/// Disables the undo steps of text fields, which would interfere with those of the document.
bool OptionsEditor::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) return true;
  }
  return QWidget::eventFilter(watched, event);
}

void OptionsEditor::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) show_messages();
  QWidget::changeEvent(event);
}

}  // namespace editor
