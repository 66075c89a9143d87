#include "editor/options/op_text_view.h"

#include <QFontDatabase>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QSyntaxHighlighter>
#include <QTextBlock>

#include "editor/appearance/theme.h"
#include "renderer/options/op_line.h"

namespace editor {
namespace {

/// Highlights keys, and dims comments.
class OpHighlighter : public QSyntaxHighlighter {
 public:
  OpHighlighter(QTextDocument* document, const QWidget* widget)
      : QSyntaxHighlighter(document), widget_(widget) {}

 protected:
  void highlightBlock(const QString& text) override {
    const ThemeColours colours = colours_of(theme_of(widget_->palette()));
    const std::string line = text.toStdString();
    const auto words = options::op_words(line);
    const auto characters = [&](std::size_t bytes) {
      return int(QString::fromUtf8(line.data(), qsizetype(bytes)).size());
    };
    const std::size_t end = words.empty() ? 0 : words.back().end;
    setFormat(characters(end), int(text.size()), colours.faint_text);
    const auto [option, count] = options::op_key(words);
    if (option == nullptr) return;
    QTextCharFormat key;
    key.setFontWeight(QFont::Bold);
    const int begin = characters(words.front().begin);
    setFormat(begin, characters(words[count - 1].end) - begin, key);
  }

 private:
  const QWidget* widget_;
};

}  // namespace

OpTextView::OpTextView(OpDocument& document, QWidget* parent)
    : QPlainTextEdit(parent), document_(document), highlighter_(new OpHighlighter(this->document(), this)) {
  setUndoRedoEnabled(false);  // undo steps are those of the form
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setTabChangesFocus(true);
  setAccessibleName(tr("Text of the OP file"));
  setToolTip(tr("Text of the OP file as it will be written. Edits here update the form."));
  setPlaceholderText(tr("Set options on the left, or type them here, one per line:\nBPT_Scene  scene.grf"));
  connect(this, &QPlainTextEdit::textChanged, this, [this] { document_.set_plain_text(toPlainText()); });
  connect(&document_, &OpDocument::changed, this, &OpTextView::show_text);
  show_text();
}

/// Replaces only what differs, so that cursor and scroll bar stay.
void OpTextView::show_text() {
  const QString plain = QString::fromStdString(document_.op_text().plain_text());
  const QString shown = toPlainText();
  if (plain != shown) {
    const QSignalBlocker block(this);
    const auto shorter = std::min(plain.size(), shown.size());
    qsizetype first = 0;
    while (first < shorter && plain[first] == shown[first]) ++first;
    qsizetype last = 0;
    while (last < shorter - first && plain[plain.size() - 1 - last] == shown[shown.size() - 1 - last]) ++last;
    QTextCursor cursor(document());
    cursor.setPosition(int(first));
    cursor.setPosition(int(shown.size() - last), QTextCursor::KeepAnchor);
    cursor.insertText(plain.mid(first, plain.size() - first - last));
  }
  mark_lines();
}

void OpTextView::mark_lines() {
  const ThemeColours colours = colours_of(theme_of(palette()));
  QList<QTextEdit::ExtraSelection> marks;
  for (const grf::Diagnostic& entry : document_.diagnostics().entries()) {
    if (entry.location.line == 0) continue;
    QTextEdit::ExtraSelection mark;
    QColor behind = entry.severity == grf::Severity::Error ? colours.error : colours.warning;
    behind.setAlpha(48);
    mark.format.setBackground(behind);
    mark.format.setProperty(QTextFormat::FullWidthSelection, true);
    mark.cursor = QTextCursor(document()->findBlockByNumber(int(entry.location.line) - 1));
    marks << mark;
  }
  setExtraSelections(marks);
}

void OpTextView::go_to(std::uint32_t line, std::uint32_t column) {
  QTextCursor cursor(document()->findBlockByNumber(int(line) - 1));
  cursor.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor, int(column) - 1);
  setTextCursor(cursor);
  setFocus();
}

bool OpTextView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) return false;
  }
  return QPlainTextEdit::event(event);
}

void OpTextView::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  highlighter_->rehighlight();
  mark_lines();
}

}  // namespace editor
