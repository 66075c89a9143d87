#include "editor/options/path_field.h"

#include <QCompleter>
#include <QDir>
#include <QFileDialog>
#include <QFileSystemModel>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QToolButton>

#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/text.h"

namespace editor {
namespace {

/// Completes file names relative to a folder.
class RelativeCompleter : public QCompleter {
 public:
  RelativeCompleter(const PathField* field, QString folder, QObject* parent)
      : QCompleter(parent), field_(field), folder_(std::move(folder)) {}

  QStringList splitPath(const QString& path) const override {
    return QCompleter::splitPath(QDir(folder_).absoluteFilePath(path) + (path.endsWith('/') ? "/" : ""));
  }
  QString pathFromIndex(const QModelIndex& index) const override {
    return field_->relative(QCompleter::pathFromIndex(index));
  }

 private:
  const PathField* field_;
  QString folder_;
};

}  // namespace

PathField::PathField(const options::OptionInfo& option, options::PathOption value, QWidget* parent)
    : OptionField(parent), value_(std::move(value)), text_(new QLineEdit(this)) {
  auto* row = tight_layout<QHBoxLayout>(this);
  text_->setPlaceholderText(text_of(option.default_value));
  text_->setAccessibleName(text_of(option.key));
  row->addWidget(text_, 1);
  row->addWidget(tool_button(
      "open", tr("Choose %1").arg(text_of(option.key)),
      value_.is_written ? tr("Choose the output file") : tr("Choose the file"), [this] { browse(); }, this));
  setFocusProxy(text_);
  connect(text_, &QLineEdit::textEdited, this, [this](const QString& text) {
    complete();
    emit edited(text.isEmpty() ? QStringList() : QStringList(text));
  });
  connect(text_, &QLineEdit::editingFinished, this, &OptionField::finished);
}

void PathField::show_words(const std::optional<QStringList>& words) {
  const QString text = words ? words->join(' ') : QString();
  if (text != text_->text()) text_->setText(text);
}

void PathField::set_folder(const QString& folder) {
  if (folder == folder_) return;
  folder_ = folder;
  delete completer_;
  completer_ = nullptr;
}

/// Lists folders once the user types.
void PathField::complete() {
  if (completer_ != nullptr) return;
  completer_ = new RelativeCompleter(this, folder_.isEmpty() ? QDir::currentPath() : folder_, this);
  auto* files = new QFileSystemModel(completer_);
  files->setRootPath(QString());
  files->setFilter(QDir::AllDirs | QDir::Files | QDir::NoDotAndDotDot);
  completer_->setModel(files);
  connect(completer_, qOverload<const QString&>(&QCompleter::activated), this, &PathField::take);
  text_->setCompleter(completer_);
}

QString PathField::relative(const QString& path) const {
  if (folder_.isEmpty()) return path;
  const QString relative = QDir(folder_).relativeFilePath(path);
  // A path that climbs far is more readable as an absolute one.
  return relative.startsWith(QStringLiteral("../../../")) ? path : relative;
}

void PathField::take(const QString& text) {
  text_->setText(text);
  emit edited({text});
  emit finished();
}

void PathField::browse() {
  QStringList patterns;
  for (const std::string_view extension : value_.extensions) patterns << "*." + text_of(extension);
  const QString filter =
      (patterns.isEmpty() ? QString() : tr("Files (%1);;").arg(patterns.join(' '))) + tr("All files (*)");
  const QString start = QDir(folder_).absoluteFilePath(text_->text());
  QString path = value_.is_written ? QFileDialog::getSaveFileName(this, tr("Write to"), start, filter)
                                   : QFileDialog::getOpenFileName(this, tr("Choose a file"), start, filter);
  if (path.isEmpty()) return;
  if (value_.is_stem) path = QFileInfo(path).dir().filePath(QFileInfo(path).completeBaseName());
  take(relative(path));
}

}  // namespace editor
