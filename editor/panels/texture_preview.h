#pragma once

#include <QWidget>

#include "editor/panels/texture_image.h"

namespace editor {

/// A thumbnail of a texture with the UV outlines of faces.
class TexturePreview : public QWidget {
  Q_OBJECT

 public:
  explicit TexturePreview(QWidget* parent = nullptr);

  /// Shows an image file; an empty path shows none.
  void show_image(const QString& path) { image_.load(path); }
  void show_outlines(QVector<QPolygonF> outlines);
  bool has_image() const { return !image_.image().isNull(); }

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  TextureImage image_;
  QVector<QPolygonF> outlines_;
};

}  // namespace editor
