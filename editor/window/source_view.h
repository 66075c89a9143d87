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

/// Shows the text of a scene's file, or of an OP file, at the location of a message. The file is read in a
/// thread; of a long file some thousands of lines around the location are shown, with their line numbers.
class SourceView : public QWidget {
  Q_OBJECT

 public:
  explicit SourceView(QWidget* parent = nullptr);

  using QWidget::show;
  /// Shows a location; one without a file changes nothing.
  void show(const grf::SourceLocation& location);
  /// Line and column count from 1, columns in characters; 0 for none.
  void show_file(const QString& path, int line = 0, int column = 0);
  /// Reloads the file at the same location.
  void read_again();
  /// Opens the file in the default program of the desktop.
  void open_in_text_editor();

  /// Absolute path of the shown file; empty for none.
  const QString& path() const { return place_.path; }
  QPlainTextEdit* text() const;
  QSize sizeHint() const override;

 signals:
  /// Emitted when the requested file is shown, or the reason why it cannot be.
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
