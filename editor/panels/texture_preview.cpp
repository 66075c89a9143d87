#include "editor/panels/texture_preview.h"

#include <QPainter>
#include <QTransform>

#include "editor/appearance/theme.h"

namespace editor {

TexturePreview::TexturePreview(QWidget* parent) : QWidget(parent), image_(512) {
  setAccessibleName(tr("Texture"));
  setToolTip(tr("The texture, with the selected faces drawn at their texture coordinates (UVs)"));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(&image_, &TextureImage::changed, this, qOverload<>(&QWidget::update));
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
    painter.drawText(inside, Qt::AlignCenter | Qt::TextWordWrap, image_.text());
    return;
  }
  const QSizeF size = QSizeF(image_.image().size()).scaled(inside.size(), Qt::KeepAspectRatio);
  const QRectF place(inside.center() - QPointF(size.width(), size.height()) / 2, size);
  painter.drawImage(place, image_.image());
  painter.setClipRect(place);
  draw_outlines(painter, outlines_,
                QTransform(place.width(), 0, 0, -place.height(), place.left(), place.bottom()), colours);
}

}  // namespace editor
