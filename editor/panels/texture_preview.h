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

/// A thumbnail, or the reason why there is none.
struct SmallImage {
  QImage image;
  QString problem;
};

/// A thumbnail of a texture with the UV outlines of faces. Images are decoded in child processes.
class TexturePreview : public QWidget {
  Q_OBJECT

 public:
  explicit TexturePreview(QWidget* parent = nullptr);
  ~TexturePreview() override;

  /// Shows an image file; an empty path shows none.
  void show_image(const QString& path);
  void show_outlines(QVector<QPolygonF> outlines);
  /// True once the requested image is loaded or has failed.
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
  std::stop_source stop_;  ///< stops the current decoding
  QThreadPool threads_;    ///< separate, since its threads wait for processes that may hang
};

/// The outlines of selected faces in texture coordinates, (0, 0) at the lower left; of very many faces only
/// the first ones. Faces without texture coordinates are left out.
QVector<QPolygonF> uv_outlines(const SceneObjects& objects, const FaceSelection& selection);

}  // namespace editor
