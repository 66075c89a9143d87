#include "editor/image/image_texts.h"

#include <QStringList>
#include <algorithm>

#include "editor/controls/text.h"
#include "editor/image/image_browser.h"
#include "editor/image/screen_colours.h"
#include "renderer/image/image_file.h"
#include "renderer/reflectance/geometry.h"

namespace editor {
namespace {

QString number(double value) { return QString::number(value, 'g', 4); }

QString values_text(const grf::Colour& pixel, const ShownImage& shown) {
  if (shown.layer.isEmpty())
    return ImageBrowser::tr("R %1  G %2  B %3").arg(number(pixel.x), number(pixel.y), number(pixel.z));
  if (shown.channels.size() < 2) return shown.layer + ' ' + number(pixel.x);
  QStringList parts;
  for (int k = 0; k < std::min<qsizetype>(shown.channels.size(), 3); ++k) {
    parts << shown.channels.mid(k, 1) + ' ' + number(pixel[k]);
  }
  return parts.join(QStringLiteral("  "));
}

bool is_inside(const QPoint& pixel, const SharedImage& image) {
  return image && pixel.x() < image->width && pixel.y() < image->height;
}

QString error_text(const image::ImageError& error) {
  QStringList parts = {ImageBrowser::tr("RMSE %1").arg(number(error.rmse)),
                       ImageBrowser::tr("relMSE %1").arg(number(error.relmse))};
  if (error.average_relative_error) {
    parts << ImageBrowser::tr("average relative error %1 %").arg(number(100 * *error.average_relative_error));
  }
  parts << (error.psnr ? ImageBrowser::tr("PSNR %1 dB").arg(*error.psnr, 0, 'f', 1)
                       : ImageBrowser::tr("PSNR infinite"));
  return parts.join(QStringLiteral("   "));
}

}  // namespace

QString statistics_text(const ImageAnalysis& analysis, const ShownImage& shown, const ShownImage& reference) {
  if (!analysis.image) return {};
  const ImageStatistics& statistics = analysis.statistics;
  QStringList parts = {ImageBrowser::tr("%1 x %2").arg(analysis.image->width).arg(analysis.image->height)};
  if (statistics.nan_pixels > 0) parts << ImageBrowser::tr("%1 NaN (magenta)").arg(statistics.nan_pixels);
  if (statistics.infinite_pixels > 0)
    parts << ImageBrowser::tr("%1 infinite (cyan)").arg(statistics.infinite_pixels);
  if (statistics.negative_pixels > 0)
    parts << ImageBrowser::tr("%1 negative").arg(statistics.negative_pixels);
  if (!shown.layer.isEmpty()) {
    parts << ImageBrowser::tr("from %1 to %2")
                 .arg(number(double(statistics.least_value)), number(double(statistics.largest_value)));
  }
  if (analysis.error) {
    parts << error_text(*analysis.error);
  } else if (analysis.reference) {
    parts << ImageBrowser::tr("B is %1 x %2: a difference needs images of the same size")
                 .arg(analysis.reference->width)
                 .arg(analysis.reference->height);
  } else if (!reference.name.isEmpty() && !reference.image) {
    parts << ImageBrowser::tr("B has no layer %1").arg(shown.layer);
  }
  return parts.join(QStringLiteral("   "));
}

QString pixel_text(const QPoint& pixel, const ShownImage& shown, const SharedImage& reference) {
  if (!is_inside(pixel, shown.image)) return {};
  const grf::Colour& value = shown.image->at(pixel.x(), pixel.y());
  QString text =
      ImageBrowser::tr("x %1  y %2   %3").arg(pixel.x()).arg(pixel.y()).arg(values_text(value, shown));
  if (is_inside(pixel, reference)) {
    return text + ImageBrowser::tr("   B: %1").arg(values_text(reference->at(pixel.x(), pixel.y()), shown));
  }
  if (!shown.layer.isEmpty()) return text;
  return text + ImageBrowser::tr("   luminance %1 cd/m2")
                    .arg(number(CandelasPerWatt * reflectance::luminance(value)));
}

QString image_read_filter() {
  return ImageBrowser::tr("Images (%1);;All files (*)")
      .arg(QString::fromStdString(image::readable_name_patterns()));
}

QString image_write_filter() {
  QStringList filters;
  for (const image::ImageFormat& format : image::image_formats()) {
    filters << QStringLiteral("%1 (*.%2)").arg(text_of(format.title), text_of(format.extension));
  }
  return filters.join(QStringLiteral(";;"));
}

}  // namespace editor
