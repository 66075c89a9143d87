#pragma once

#include "editor/panels/surface_row.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace editor {

class TexturePreview;

/// The image on the faces: a file, or a texture of the scene by its name.
class TextureRow : public SurfaceRow {
  Q_OBJECT

 public:
  explicit TextureRow(Document& document, QWidget* parent = nullptr);
  void show_facts(const SurfaceFacts& facts) override;

  /// Puts the image of a file on the selected faces.
  void assign_file(const QString& path);

 private:
  void take_text();
  void browse();
  void assign(const AttributeEdit<grf::TextureAttribute>& texture);

  QStringList names_;
  QString shown_;
  QComboBox* choice_;  ///< a file's name can be typed
  QToolButton* browse_;
  QToolButton* reset_;
  TexturePreview* preview_;
  QLabel* hint_;
};

}  // namespace editor
