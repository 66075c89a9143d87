#include "editor/rendering/render_history.h"

#include <QFileInfo>
#include <QPainter>

#include "editor/appearance/theme.h"
#include "editor/rendering/fitted_image.h"

namespace editor {
namespace {

constexpr QSize Thumbnail(10 * Grid, 8 * Grid);

QString summary_of(const FinalRenderResult& result) {
  const RenderSummary& summary = result.summary;
  QString samples = summary.samples == 1 ? RenderHistory::tr("1 sample")
                                         : RenderHistory::tr("%1 samples").arg(summary.samples, 0, 'g', 3);
  if (result.is_stopped) samples = RenderHistory::tr("stopped") + " · " + samples;
  QString course = duration_text(summary.seconds);
  if (summary.estimated_error) {
    course += " · " + RenderHistory::tr("error %1").arg(percent_text(*summary.estimated_error));
  }
  return QStringList{QFileInfo(result.image).fileName(), samples, course}.join('\n');
}

}  // namespace

RenderHistory::RenderHistory(QWidget* parent) : QListWidget(parent) {
  setAccessibleName(tr("Renders of this session"));
  setToolTip(
      tr("Renders of this session, with samples per pixel, time and estimated error. Click or press Return "
         "to open the image"));
  setIconSize(Thumbnail);
  setUniformItemSizes(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  connect(this, &QListWidget::itemActivated, this,
          [this](const QListWidgetItem* item) { emit image_chosen(item->data(Qt::UserRole).toString()); });
  connect(this, &QListWidget::itemClicked, this,
          [this](const QListWidgetItem* item) { emit image_chosen(item->data(Qt::UserRole).toString()); });
}

void RenderHistory::add(const FinalRenderResult& result, const image::Image& image) {
  const qreal ratio = devicePixelRatioF();
  QImage canvas(Thumbnail * ratio, QImage::Format_ARGB32_Premultiplied);
  canvas.fill(Qt::transparent);
  const QImage small = fitted(image, canvas.size());
  QPainter(&canvas).drawImage((canvas.width() - small.width()) / 2, (canvas.height() - small.height()) / 2,
                              small);
  canvas.setDevicePixelRatio(ratio);
  auto* item = new QListWidgetItem(QIcon(QPixmap::fromImage(canvas)), summary_of(result));
  item->setData(Qt::UserRole, result.copy);
  item->setToolTip(result.image);
  insertItem(0, item);
}

QSize RenderHistory::sizeHint() const { return {30 * Grid, 20 * Grid}; }

void RenderHistory::paintEvent(QPaintEvent* event) {
  QListWidget::paintEvent(event);
  if (count() > 0) return;
  QPainter painter(viewport());
  painter.setPen(colours_of(theme_of(palette())).faint_text);
  painter.drawText(viewport()->rect().adjusted(Grid, 0, -Grid, 0), Qt::AlignCenter | Qt::TextWordWrap,
                   tr("Press F6 to render. Finished renders are listed here until the editor is closed."));
}

}  // namespace editor
