#pragma once

#include <QIcon>
#include <QString>

namespace editor {

/// The drawing `editor/icons/NAME.svg` in the colours of the application's palette, at any resolution;
/// strokes of `currentColor` take that of text, of rows that are selected that of highlighted text. Disabled
/// icons are fainter. The name has to be there.
QIcon icon(const QString& name);

}  // namespace editor
