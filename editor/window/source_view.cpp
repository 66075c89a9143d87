#include "editor/window/source_view.h"

#include <QAction>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QStackedWidget>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/text.h"
#include "editor/window/source_text.h"

namespace editor {
namespace {

/// A note about omitted text; empty if the file is shown in full.
QString note_of(const SourceExcerpt& excerpt) {
  if (excerpt.is_whole()) return {};
  const auto number = [](qint64 value) { return QLocale().toString(value); };
  QStringList parts;
  if (excerpt.lines.size() < excerpt.line_count) {
    const qint64 last = excerpt.first_line + excerpt.lines.size() - 1;
    parts.append(SourceView::tr("Lines %1 to %2 of %3: the file is too long to be shown whole.")
                     .arg(number(excerpt.first_line), number(last), number(excerpt.line_count)));
  }
  if (excerpt.shortened > 0) {
    parts.append(
        SourceView::tr("Lines with more than %1 characters are shown in part.").arg(number(ExcerptColumns)));
  }
  return parts.join(' ');
}

QLabel* make_hint() {
  auto* hint = new QLabel;
  hint->setAlignment(Qt::AlignCenter);
  hint->setWordWrap(true);
  hint->setMargin(2 * Grid);
  hint->setTextFormat(Qt::PlainText);
  hint->setTextInteractionFlags(Qt::TextSelectableByMouse);
  hint->setText(SourceView::tr("No file is shown.\n\nSelect a message to see the line that it refers to."));
  return hint;
}

}  // namespace

SourceView::SourceView(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel),
      open_(tool_button(
          "edit", tr("Open in text editor"), {}, [this] { open_in_text_editor(); }, this)),
      again_(tool_button(
          "reset", tr("Reload"), {}, [this] { read_again(); }, this)),
      note_(new QLabel),
      pages_(new QStackedWidget),
      hint_(make_hint()),
      text_(new SourceText),
      reading_(this) {
  setAccessibleName(tr("Source text"));
  title_->setAccessibleName(tr("Path of the file"));
  title_->setTextFormat(Qt::PlainText);
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  note_->setWordWrap(true);
  note_->setContentsMargins(Grid, 0, Grid, Grid / 2);
  note_->hide();
  pages_->addWidget(hint_);
  pages_->addWidget(text_);
  auto* header = new QHBoxLayout;
  header->setContentsMargins(Grid, Grid / 2, Grid / 2, Grid / 2);
  header->setSpacing(Grid / 2);
  header->addWidget(title_, 1);
  header->addWidget(open_);
  header->addWidget(again_);
  auto* layout = tight_layout<QVBoxLayout>(this, 0);
  layout->addLayout(header);
  layout->addWidget(note_);
  layout->addWidget(pages_, 1);
  for (QToolButton* button : {open_, again_}) button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  auto* refresh = new QAction(tr("Reload"), this);
  refresh->setShortcut(QKeySequence::Refresh);
  refresh->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  connect(refresh, &QAction::triggered, this, &SourceView::read_again);
  addAction(refresh);
  show_path();
}

QPlainTextEdit* SourceView::text() const { return text_; }

QSize SourceView::sizeHint() const { return {720, 480}; }

void SourceView::show(const grf::SourceLocation& location) {
  if (!location.file) return;
  show_file(QString::fromStdString(location.file->path), int(location.line), int(location.column));
}

void SourceView::show_file(const QString& path, int line, int column) {
  if (path.isEmpty()) return;
  place_ = {QFileInfo(path).absoluteFilePath(), line, column};
  show_path();
  read();
}

void SourceView::read_again() {
  if (!place_.path.isEmpty()) read();
}

void SourceView::open_in_text_editor() {
  if (!place_.path.isEmpty()) QDesktopServices::openUrl(QUrl::fromLocalFile(place_.path));
}

void SourceView::read() {
  reading_.start([place = place_](
                     const StopFlag& stop) { return read_excerpt(place, [stop] { return stop.is_set(); }); },
                 [this](const SourceExcerpt& excerpt) { show_excerpt(excerpt); });
}

void SourceView::show_excerpt(const SourceExcerpt& excerpt) {
  const bool is_read = excerpt.problem.isEmpty();
  const QString note = note_of(excerpt);
  show_or_hide(note_, note);
  if (is_read) {
    text_->show_excerpt(excerpt);
  } else {
    hint_->setText(excerpt.problem);
  }
  pages_->setCurrentIndex(is_read ? 1 : 0);
  emit shown();
}

void SourceView::show_path() {
  const bool is_there = !place_.path.isEmpty();
  const QString path = is_there ? path_text(place_.path) : tr("No file");
  title_->setText(title_->fontMetrics().elidedText(path, Qt::ElideMiddle, title_->width()));
  title_->setToolTip(is_there ? QDir::toNativeSeparators(place_.path) : QString());
  const QString why_not = is_there ? QString() : tr("No file is shown yet: select a message first");
  enable(open_, tr("Open the file in the default program of the desktop"), why_not);
  enable(again_, tr("Reload the file from disk (F5)"), why_not);
}

void SourceView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layout()->activate();  // updates the width of the label
  show_path();
}

}  // namespace editor
