#pragma once

#include <QWidget>
#include <array>

#include "editor/tools/brdf_scene.h"

class QComboBox;
class QLabel;
class QPlainTextEdit;

namespace editor {

/// Shows the GLSL that shades a BRDF, with line numbers, and why the driver cannot compile it.
class ShaderTextView : public QWidget {
  Q_OBJECT

 public:
  explicit ShaderTextView(QWidget* parent = nullptr);

  void set_sources(const std::array<ShaderSource, 2>& sources);
  QPlainTextEdit& text() { return *text_; }
  QString message() const;

  QSize sizeHint() const override;

 private:
  void refresh();

  std::array<ShaderSource, 2> sources_;
  QComboBox* chooser_;
  QLabel* message_;
  QPlainTextEdit* text_;
};

}  // namespace editor
