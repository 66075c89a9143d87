#include "editor/panels/texture_image.h"

#include <QFileInfo>
#include <QPainter>
#include <QtConcurrentRun>
#include <algorithm>

#include "editor/appearance/theme.h"
#include "editor/programs/image_process.h"
#include "renderer/image/srgb.h"
#include "renderer/transport/scene/texture.h"

namespace editor {
namespace {

SmallImage read_small(const QString& path, int largest, const std::stop_token& stop) {
  grf::Diagnostics diagnostics;
  std::optional<image::Image> image = ImageProcess().read(path.toStdString(), diagnostics, {}, stop);
  if (!image) {
    const bool has_error = diagnostics.error_count() > 0;
    return {{}, has_error ? QString::fromStdString(diagnostics.entries().front().message) : QString()};
  }
  while (std::max(image->width, image->height) > largest) image = transport::halved(*image);
  SmallImage small = {QImage(image->width, image->height, QImage::Format_RGB32), {}};
  for (int y = 0; y < image->height; ++y) {
    for (int x = 0; x < image->width; ++x) {
      const reflectance::Rgb& pixel = image->at(x, y);
      small.image.setPixel(
          x, y,
          qRgb(image::to_srgb_byte(pixel.x), image::to_srgb_byte(pixel.y), image::to_srgb_byte(pixel.z)));
    }
  }
  return small;
}

}  // namespace

TextureImage::TextureImage(int largest, QObject* parent) : QObject(parent), largest_(largest) {
  connect(&reading_, &QFutureWatcher<SmallImage>::finished, this, [this] {
    shown_ = reading_.result();
    emit changed();
  });
  connect(&watch_, &FileWatch::changed, this, &TextureImage::read);
}

TextureImage::~TextureImage() { stop_.request_stop(); }

void TextureImage::load(const QString& path) {
  if (path == path_) return;
  path_ = path;
  shown_ = {};
  watch_.follow(path.isEmpty() ? QStringList() : QStringList(path));
  read();
  emit changed();
}

void TextureImage::read() {
  stop_.request_stop();
  stop_ = {};
  if (!path_.isEmpty())
    reading_.setFuture(QtConcurrent::run(&threads_, read_small, path_, largest_, stop_.get_token()));
}

QString TextureImage::text() const {
  if (path_.isEmpty()) return {};
  const QString name = QFileInfo(path_).fileName();
  return reading_.isRunning() ? tr("reading %1 …").arg(name) : QString("%1: %2").arg(name, shown_.problem);
}

QString first_texture(const SceneObjects& objects, const FaceSelection& selection) {
  const std::vector<std::uint32_t> meshes = selection.meshes();
  if (meshes.empty()) return {};
  const MeshObject& object = objects.meshes[meshes.front()];
  const std::size_t first = selection.of_mesh(meshes.front()).find_first();
  return QString::fromStdString(object.flat_surfaces[(*object.mesh->surface_of_face)[first]].texture);
}

QVector<QPolygonF> uv_outlines(const SceneObjects& objects, const FaceSelection& selection) {
  constexpr std::size_t Most = 4000;
  const std::size_t step = std::max<std::size_t>(1, (selection.count() + Most - 1) / Most);
  std::size_t number = 0;
  QVector<QPolygonF> outlines;
  for (const std::uint32_t i : selection.meshes()) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    const auto& uvs = mesh.geometry->uvs;
    if (uvs.empty()) continue;
    selection.for_each_face(i, [&](std::size_t face) {
      if (number++ % step != 0) return;
      QPolygonF outline;
      for (const std::uint32_t corner : mesh.face(face)) {
        if (!uvs.has(corner)) return;
        outline << QPointF(uvs[corner].x, uvs[corner].y);
      }
      outlines << outline;
    });
  }
  return outlines;
}

void draw_outlines(QPainter& painter, const QVector<QPolygonF>& outlines, const QTransform& to_pixels,
                   const ThemeColours& colours) {
  // Wide lines of many faces would be slow and hide the image.
  constexpr qsizetype Many = 500;
  const bool is_many = outlines.size() > Many;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, !is_many);
  painter.setBrush(Qt::NoBrush);
  const QRectF visible = painter.hasClipping() ? painter.clipBoundingRect() : QRectF(painter.viewport());
  QVector<QPolygonF> placed;
  for (const QPolygonF& outline : outlines) {
    const QPolygonF polygon = to_pixels.map(outline);
    const QRectF bounds = polygon.boundingRect().adjusted(-1, -1, 1, 1);
    if (bounds.intersects(visible)) placed << polygon;
  }
  // Dark lines under the accent make it visible on any image.
  const QPen wide(QColor(0, 0, 0, 160), 3);
  const QPen narrow(colours.accent, is_many ? 0 : 1.25);
  for (const QPen& pen : is_many ? QVector<QPen>{narrow} : QVector<QPen>{wide, narrow}) {
    painter.setPen(pen);
    for (const QPolygonF& outline : placed) painter.drawPolygon(outline);
  }
  painter.restore();
}

}  // namespace editor
