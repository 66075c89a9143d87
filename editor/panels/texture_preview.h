#pragma once

#include <QFutureWatcher>
#include <QImage>
#include <QPolygonF>
#include <QVector>
#include <QWidget>

#include "editor/document/face_selection.h"
#include "editor/document/scene_objects.h"

namespace editor {

/// A small picture of an image, with the outlines of faces where their texture coordinates put them. Images
/// are read in a thread of their own.
class TexturePreview : public QWidget {
  Q_OBJECT

 public:
  explicit TexturePreview(QWidget* parent = nullptr);

  /// An empty path shows none.
  void show_image(const QString& path);
  void show_outlines(QVector<QPolygonF> outlines);
  /// True once the image that was asked for is there, or cannot be.
  bool is_settled() const { return !reading_.isRunning(); }
  bool has_image() const { return !image_.isNull(); }

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString path_;
  QImage image_;
  QVector<QPolygonF> outlines_;
  QFutureWatcher<QImage> reading_;
};

/// The selected faces in texture coordinates, (0, 0) lower left; of very many, the first ones. Faces whose
/// corners have none are not there.
QVector<QPolygonF> uv_outlines(const SceneObjects& objects, const FaceSelection& selection);

}  // namespace editor
