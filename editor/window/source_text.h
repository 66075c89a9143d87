#pragma once

#include <QPlainTextEdit>

#include "editor/window/source_excerpt.h"

namespace editor {

/// Shows the lines of an excerpt with line numbers. The line of the location is highlighted, and the word at
/// its column is selected.
class SourceText : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit SourceText(QWidget* parent = nullptr);

  void show_excerpt(const SourceExcerpt& excerpt);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  class Highlighter;

  int numbers_width() const;
  void place_numbers();
  void paint_numbers();
  void mark_line();
  void centre();

  qint64 first_line_ = 1;
  qint64 marked_line_ = 0;
  qint64 last_line_ = 0;
  QWidget* numbers_;
  Highlighter* highlighter_;
};

}  // namespace editor
