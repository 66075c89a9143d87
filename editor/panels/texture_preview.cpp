#include "editor/panels/texture_preview.h"

#include <QFileInfo>
#include <QPainter>
#include <QtConcurrentRun>
#include <algorithm>

#include "editor/appearance/theme.h"
#include "editor/programs/image_process.h"
#include "renderer/transport/image/srgb.h"
#include "renderer/transport/scene/texture.h"

namespace editor {
namespace {

SmallImage read_small(const QString& path, const std::stop_token& stop) {
  grf::Diagnostics diagnostics;
  std::optional<transport::Image> image = ImageProcess().read(path.toStdString(), diagnostics, {}, stop);
  if (!image) {
    const bool has_error = diagnostics.error_count() > 0;
    return {{}, has_error ? QString::fromStdString(diagnostics.entries().front().message) : QString()};
  }
  constexpr int Largest = 512;
  while (std::max(image->width, image->height) > Largest) image = transport::halved(*image);
  SmallImage small = {QImage(image->width, image->height, QImage::Format_RGB32), {}};
  for (int y = 0; y < image->height; ++y) {
    for (int x = 0; x < image->width; ++x) {
      const reflectance::Rgb& pixel = image->at(x, y);
      small.image.setPixel(x, y,
                           qRgb(transport::to_srgb_byte(pixel.x), transport::to_srgb_byte(pixel.y),
                                transport::to_srgb_byte(pixel.z)));
    }
  }
  return small;
}

}  // namespace

TexturePreview::TexturePreview(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Texture"));
  setToolTip(tr("The texture, with the selected faces drawn at their texture coordinates (UVs)"));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(&reading_, &QFutureWatcher<SmallImage>::finished, this, [this] {
    shown_ = reading_.result();
    update();
  });
}

TexturePreview::~TexturePreview() { stop_.request_stop(); }

void TexturePreview::show_image(const QString& path) {
  if (path == path_) return;
  path_ = path;
  shown_ = {};
  stop_.request_stop();
  stop_ = {};
  if (!path.isEmpty()) reading_.setFuture(QtConcurrent::run(&threads_, read_small, path, stop_.get_token()));
  update();
}

void TexturePreview::show_outlines(QVector<QPolygonF> outlines) {
  outlines_ = std::move(outlines);
  update();
}

QSize TexturePreview::sizeHint() const {
  constexpr int Height = 18 * Grid;
  return {Height, Height};
}

void TexturePreview::paintEvent(QPaintEvent*) {
  const ThemeColours colours = colours_of(theme_of(palette()));
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  painter.setPen(colours.line);
  painter.setBrush(colours.base);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
  const QRectF inside = QRectF(rect()).adjusted(2, 2, -2, -2);
  if (!has_image()) {
    painter.setPen(colours.faint_text);
    const QString name = QFileInfo(path_).fileName();
    const QString text =
        reading_.isRunning() ? tr("reading %1 …").arg(name) : QString("%1: %2").arg(name, shown_.problem);
    painter.drawText(inside, Qt::AlignCenter | Qt::TextWordWrap, text);
    return;
  }
  const QSizeF size = QSizeF(shown_.image.size()).scaled(inside.size(), Qt::KeepAspectRatio);
  const QRectF place(inside.center() - QPointF(size.width(), size.height()) / 2, size);
  painter.drawImage(place, shown_.image);
  painter.setClipRect(place);
  painter.setBrush(Qt::NoBrush);
  // Dark lines under the accent make it visible on any image.
  for (const QPen& pen : {QPen(QColor(0, 0, 0, 160), 3), QPen(colours.accent, 1.25)}) {
    painter.setPen(pen);
    for (const QPolygonF& outline : outlines_) {
      QPolygonF placed;
      for (const QPointF& uv : outline) {
        placed << QPointF(place.left() + uv.x() * place.width(), place.bottom() - uv.y() * place.height());
      }
      painter.drawPolygon(placed);
    }
  }
}

QVector<QPolygonF> uv_outlines(const SceneObjects& objects, const FaceSelection& selection) {
  constexpr qsizetype Most = 4000;
  QVector<QPolygonF> outlines;
  for (std::uint32_t i = 0; i < selection.mesh_count(); ++i) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    const FaceSelection::Faces& faces = selection.of_mesh(i);
    if (mesh.geometry->uvs.empty()) continue;
    for (auto face = faces.find_first(); face != FaceSelection::Faces::npos && outlines.size() < Most;
         face = faces.find_next(face)) {
      QPolygonF outline;
      for (const std::uint32_t corner : mesh.face(face)) {
        if (mesh.geometry->uvs.has(corner))
          outline << QPointF(mesh.geometry->uvs[corner].x, mesh.geometry->uvs[corner].y);
      }
      if (outline.size() == static_cast<qsizetype>(mesh.face(face).size())) outlines << outline;
    }
  }
  return outlines;
}

}  // namespace editor
