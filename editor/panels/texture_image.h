// The texture of the selected faces is drawn with the outlines of the faces on it.
#pragma once

#include <QFutureWatcher>
#include <QImage>
#include <QObject>
#include <QPolygonF>
#include <QThreadPool>
#include <QVector>
#include <stop_token>

#include "editor/document/face_selection.h"
#include "editor/document/file_watch.h"
#include "editor/document/scene_objects.h"

class QPainter;
class QTransform;

namespace editor {

struct ThemeColours;

/// A thumbnail, or the reason why there is none.
struct SmallImage {
  QImage image;
  QString problem;
};

/// Loads the thumbnail of an image file, and again when the file changes. Images are decoded in child
/// processes.
class TextureImage : public QObject {
  Q_OBJECT

 public:
  /// The thumbnail has at most so many pixels per side.
  explicit TextureImage(int largest, QObject* parent = nullptr);
  ~TextureImage() override;

  /// Loads an image file; an empty path loads none.
  void load(const QString& path);
  const QImage& image() const { return shown_.image; }
  /// The text to show in place of an image that is not there yet, or cannot be read.
  QString text() const;

 signals:
  /// Emitted when image or text differ.
  void changed();

 private:
  void read();

  int largest_;
  QString path_;
  SmallImage shown_;
  FileWatch watch_;
  QFutureWatcher<SmallImage> reading_;
  std::stop_source stop_;  ///< stops the current decoding
  QThreadPool threads_;    ///< separate, since its threads wait for processes that may hang
};

/// The image file of the first selected face; empty if it has none.
QString first_texture(const SceneObjects& objects, const FaceSelection& selection);

/// The outlines of selected faces in texture coordinates, (0, 0) at the lower left; of very many faces only
/// an evenly chosen part. Faces without texture coordinates are left out.
QVector<QPolygonF> uv_outlines(const SceneObjects& objects, const FaceSelection& selection);

/// Draws such outlines, so that they are visible on any image.
void draw_outlines(QPainter& painter, const QVector<QPolygonF>& outlines, const QTransform& to_pixels,
                   const ThemeColours& colours);

}  // namespace editor
