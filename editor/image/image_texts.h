// The image view describes statistics and pixel values in these texts.
#pragma once

#include <QPoint>
#include <QString>

#include "editor/image/shown_image.h"

namespace editor {

/// Size, number of invalid pixels, the range of a layer's values, and the error metrics against a reference.
QString statistics_text(const ImageAnalysis& analysis, const ShownImage& shown, const ShownImage& reference);

/// Coordinates from the upper left corner, linear values, and the luminance of a radiance. The reference
/// shows the same layer, or nothing.
QString pixel_text(const QPoint& pixel, const ShownImage& shown, const SharedImage& reference);

/// File dialog filters of the readable and writable formats.
QString image_read_filter();
QString image_write_filter();

}  // namespace editor
