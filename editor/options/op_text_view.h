#pragma once

#include <QPlainTextEdit>

#include "editor/document/op_document.h"

class QSyntaxHighlighter;

namespace editor {

/// A text editor for an OP file, which is kept in sync with the form. Lines with errors and warnings are
/// marked.
class OpTextView : public QPlainTextEdit {
  Q_OBJECT

 public:
  OpTextView(OpDocument& document, QWidget* parent);

  void go_to(std::uint32_t line, std::uint32_t column);

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void show_text();
  void mark_lines();

  OpDocument& document_;
  QSyntaxHighlighter* highlighter_;
};

}  // namespace editor
