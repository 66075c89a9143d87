#include "editor/window/source_text.h"

#include <QFontDatabase>
#include <QPainter>
#include <QSyntaxHighlighter>
#include <QTextBlock>
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "editor/appearance/theme.h"
#include "grf/keywords.h"
#include "renderer/options/op_line.h"

namespace editor {
namespace {

/// GRF keywords that are never names of models or parameters. Sorted.
constexpr std::array Keywords = std::to_array<std::string_view>(
    {"begin",     "brdf",        "color", "colour", "def",  "dependent", "end",      "faces",
     "false",     "include",     "irad",  "light",  "list", "mesh",      "none",     "normal",
     "opacity",   "params",      "pdf",   "ray",    "rgb",  "rotation",  "scale",    "texture",
     "transform", "translation", "true",  "use",    "uv",   "vertexs",   "vertices", "view"});

bool is_keyword(const std::string& word) {
  return std::ranges::binary_search(Keywords, std::string_view(grf::lower_case(word)));
}

}  // namespace

/// Highlights keywords of GRF and OP files, and dims comments.
class SourceText::Highlighter : public QSyntaxHighlighter {
 public:
  explicit Highlighter(SourceText& widget) : QSyntaxHighlighter(widget.document()), widget_(widget) {}

  /// Selects the language of the text.
  void set_is_op(bool is_op) { is_op_ = is_op; }

 protected:
  void highlightBlock(const QString& text) override { is_op_ ? highlight_op(text) : highlight_grf(text); }

 private:
  void highlight_op(const QString& text) {
    const std::string line = text.toStdString();
    const auto words = options::op_words(line);
    const std::size_t end = words.empty() ? 0 : words.back().end;
    highlight_comment(text, QString::fromUtf8(line.data(), qsizetype(end)).size());
  }

  void highlight_grf(const QString& text) {
    qsizetype at = 0;
    while (at < text.size()) {
      const QChar character = text[at];
      if (character == '"') {
        const qsizetype end = text.indexOf('"', at + 1);
        at = end < 0 ? text.size() : end + 1;
      } else if (QStringView(text).mid(at).startsWith(u"//")) {
        return highlight_comment(text, at);
      } else if (is_word_start(character)) {
        at = highlight_word(text, at);
      } else {
        ++at;
      }
    }
  }

  void highlight_comment(const QString& text, qsizetype begin) {
    setFormat(int(begin), int(text.size() - begin), colours_of(theme_of(widget_.palette())).faint_text);
  }

  static bool is_word_start(QChar c) { return c.unicode() < 128 && grf::is_word_start(c.toLatin1()); }
  static bool is_in_word(QChar c) { return c.unicode() < 128 && grf::is_word_character(c.toLatin1()); }

  /// Returns the end of the word.
  qsizetype highlight_word(const QString& text, qsizetype begin) {
    qsizetype end = begin;
    while (end < text.size() && is_in_word(text[end])) ++end;
    if (is_keyword(text.mid(begin, end - begin).toStdString())) {
      QTextCharFormat keyword;
      keyword.setFontWeight(QFont::Bold);
      setFormat(int(begin), int(end - begin), keyword);
    }
    return end;
  }

  const SourceText& widget_;
  bool is_op_ = false;
};

SourceText::SourceText(QWidget* parent)
    : QPlainTextEdit(parent), numbers_(new QWidget(this)), highlighter_(new Highlighter(*this)) {
  setReadOnly(true);
  setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  setUndoRedoEnabled(false);
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setTabStopDistance(4 * fontMetrics().horizontalAdvance(' '));
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setFrameShape(QFrame::NoFrame);
  setAccessibleName(tr("Text of the file"));
  setToolTip(tr("The file as it is on disk, read-only. Edit it in the text editor."));
  numbers_->installEventFilter(this);
  connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& area, int scrolled) {
    if (scrolled != 0) {
      numbers_->scroll(0, scrolled);
    } else {
      numbers_->update(0, area.y(), numbers_->width(), area.height());
    }
  });
}

void SourceText::show_excerpt(const SourceExcerpt& excerpt) {
  first_line_ = excerpt.first_line;
  last_line_ = excerpt.first_line + std::max<qint64>(1, excerpt.lines.size()) - 1;
  const bool is_here = excerpt.place.line >= first_line_ && excerpt.place.line <= last_line_;
  marked_line_ = is_here ? excerpt.place.line : 0;
  highlighter_->set_is_op(excerpt.place.path.endsWith(".op", Qt::CaseInsensitive));
  setPlainText(excerpt.lines.join('\n'));
  place_numbers();
  mark_line();
  if (marked_line_ == 0) return;
  QTextCursor cursor(document()->findBlockByNumber(int(marked_line_ - first_line_)));
  if (excerpt.place.column > 0) {
    const QTextBlock line = cursor.block();
    cursor.setPosition(line.position() + int(std::min<qint64>(excerpt.position, line.length() - 1)));
    const int place = cursor.position();
    cursor.movePosition(QTextCursor::EndOfWord, QTextCursor::KeepAnchor);
    // Punctuation is not selected as a word.
    if (cursor.position() == place && place < line.position() + line.length() - 1) {
      cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor);
    }
  }
  setTextCursor(cursor);
  centre();
}

void SourceText::centre() {
  if (marked_line_ == 0) return;
  ensureCursorVisible();
  centerCursor();
}

void SourceText::mark_line() {
  if (marked_line_ == 0) return setExtraSelections({});
  QTextEdit::ExtraSelection mark;
  QColor behind = colours_of(theme_of(palette())).accent;
  behind.setAlpha(48);
  mark.format.setBackground(behind);
  mark.format.setProperty(QTextFormat::FullWidthSelection, true);
  mark.cursor = QTextCursor(document()->findBlockByNumber(int(marked_line_ - first_line_)));
  setExtraSelections({mark});
}

int SourceText::numbers_width() const {
  const auto digits = int(QString::number(last_line_).size());
  return fontMetrics().horizontalAdvance('0') * std::max(3, digits) + 2 * Grid;
}

void SourceText::place_numbers() {
  setViewportMargins(numbers_width(), 0, 0, 0);
  const QRect inside = contentsRect();
  numbers_->setGeometry(inside.left(), inside.top(), numbers_width(), viewport()->height());
  numbers_->update();
}

void SourceText::paint_numbers() {
  const ThemeColours colours = colours_of(theme_of(palette()));
  QPainter painter(numbers_);
  painter.fillRect(numbers_->rect(), colours.window);
  painter.setFont(font());
  if (last_line_ == 0) return;
  for (QTextBlock block = firstVisibleBlock(); block.isValid(); block = block.next()) {
    const QRectF line = blockBoundingGeometry(block).translated(contentOffset());
    if (line.top() > numbers_->height()) break;
    const qint64 number = first_line_ + block.blockNumber();
    painter.setPen(number == marked_line_ ? colours.accent : colours.faint_text);
    painter.drawText(QRectF(0, line.top(), numbers_->width() - Grid, line.height()),
                     Qt::AlignRight | Qt::AlignTop, QString::number(number));
  }
}

bool SourceText::eventFilter(QObject* watched, QEvent* event) {
  if (watched != numbers_ || event->type() != QEvent::Paint) {
    return QPlainTextEdit::eventFilter(watched, event);
  }
  paint_numbers();
  return true;
}

void SourceText::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  place_numbers();
}

// The number of visible lines is known only now.
void SourceText::showEvent(QShowEvent* event) {
  QPlainTextEdit::showEvent(event);
  centre();
}

void SourceText::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() == QEvent::FontChange) place_numbers();
  if (event->type() != QEvent::PaletteChange) return;
  highlighter_->rehighlight();
  mark_line();
  numbers_->update();
}

}  // namespace editor
