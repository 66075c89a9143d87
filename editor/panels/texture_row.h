#pragma once

#include "editor/panels/surface_row.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace editor {

class TexturePreview;

/// Assigns an image file to the selected faces, as one undo step. Faces without texture coordinates get
/// projected ones, unless the scene has too many faces to do it at once.
void assign_texture(Document& document, const QString& path);

/// Chooses the texture of the faces: an image file, or a named texture of the scene.
class TextureRow : public SurfaceRow {
  Q_OBJECT

 public:
  explicit TextureRow(Document& document, QWidget* parent = nullptr);
  void show_summary(const SelectionSummary& summary) override;

 private:
  void take_text();
  void browse();

  QStringList names_;
  QString shown_;
  QComboBox* choice_;  ///< editable, for file names
  QToolButton* browse_;
  QToolButton* reset_;
  TexturePreview* preview_;
  QLabel* hint_;
};

}  // namespace editor
