// What the image view says in numbers.
#pragma once

#include <QPoint>
#include <QString>

#include "editor/image/image_entry.h"

namespace editor {

/// Size, and how many pixels are no colour; against a reference, how far it is from it.
QString figures_text(const ImageAnalysis& analysis);

/// Coordinates from the upper left corner, linear values, and luminance.
QString pixel_text(const QPoint& pixel, const SharedImage& image, const SharedImage& reference);

/// Filters of file dialogs, for what can be read and written.
QString image_read_filter();
QString image_write_filter();

}  // namespace editor
