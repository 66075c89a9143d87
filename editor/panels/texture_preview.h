#pragma once

#include <QFutureWatcher>
#include <QImage>
#include <QPolygonF>
#include <QThreadPool>
#include <QVector>
#include <QWidget>
#include <stop_token>

#include "editor/document/face_selection.h"
#include "editor/document/scene_objects.h"

namespace editor {

/// An image of few pixels, or why there is none.
struct SmallImage {
  QImage image;
  QString problem;
};

/// A small picture of an image, with the outlines of faces where their texture coordinates put them. Images
/// are read in processes of their own.
class TexturePreview : public QWidget {
  Q_OBJECT

 public:
  explicit TexturePreview(QWidget* parent = nullptr);
  ~TexturePreview() override;

  /// An empty path shows none.
  void show_image(const QString& path);
  void show_outlines(QVector<QPolygonF> outlines);
  /// True once the image that was asked for is there, or cannot be.
  bool is_settled() const { return !reading_.isRunning(); }
  bool has_image() const { return !shown_.image.isNull(); }

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString path_;
  SmallImage shown_;
  QVector<QPolygonF> outlines_;
  QFutureWatcher<SmallImage> reading_;
  std::stop_source stop_;  ///< of what is read
  QThreadPool threads_;    ///< of its own: they wait for processes, which may hang
};

/// The selected faces in texture coordinates, (0, 0) lower left; of very many, the first ones. Faces whose
/// corners have none are not there.
QVector<QPolygonF> uv_outlines(const SceneObjects& objects, const FaceSelection& selection);

}  // namespace editor
