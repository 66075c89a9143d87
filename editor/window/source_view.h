#pragma once

#include <QWidget>

#include "editor/jobs/background_job.h"
#include "editor/window/source_excerpt.h"
#include "grf/source_location.h"

class QLabel;
class QPlainTextEdit;
class QStackedWidget;
class QToolButton;

namespace editor {

class SourceText;

/// Shows the text of a scene's file, or of an OP file, at a place of which a message speaks. It is read in a
/// thread; of a long file some thousands of lines around the place are shown, with their true numbers.
class SourceView : public QWidget {
  Q_OBJECT

 public:
  explicit SourceView(QWidget* parent = nullptr);

  using QWidget::show;
  /// A location without a file shows nothing else than before.
  void show(const grf::SourceLocation& location);
  /// Line and column count from 1, columns in characters; 0: there is none.
  void show_file(const QString& path, int line = 0, int column = 0);
  /// Reads the file once more, and shows the same place.
  void read_again();
  /// Opens the file in the program that the desktop has for it.
  void open_in_text_editor();

  /// Of the file that is shown, absolute; empty: none is.
  const QString& path() const { return place_.path; }
  QPlainTextEdit* text() const;
  QSize sizeHint() const override;

 signals:
  /// What was asked for is there, or why it is not.
  void shown();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void read();
  void show_excerpt(const SourceExcerpt& excerpt);
  void show_path();

  SourcePlace place_;
  QLabel* title_;
  QToolButton* open_;
  QToolButton* again_;
  QLabel* note_;
  QStackedWidget* pages_;
  QLabel* hint_;
  SourceText* text_;
  BackgroundJob<SourceExcerpt> reading_;
};

}  // namespace editor
