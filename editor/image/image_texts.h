// The image view describes statistics and pixel values in these texts.
#pragma once

#include <QPoint>
#include <QString>

#include "editor/image/image_entry.h"

namespace editor {

/// Size, number of invalid pixels, and the error metrics against a reference.
QString statistics_text(const ImageAnalysis& analysis);

/// Coordinates from the upper left corner, linear values, and luminance.
QString pixel_text(const QPoint& pixel, const SharedImage& image, const SharedImage& reference);

/// File dialog filters of the readable and writable formats.
QString image_read_filter();
QString image_write_filter();

}  // namespace editor
