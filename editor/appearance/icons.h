#pragma once

#include <QIcon>
#include <QString>

namespace editor {

/// The icon `editor/icons/NAME.svg` in the colours of the application's palette, at any resolution; strokes
/// of `currentColor` get the text colour, in selected rows that of highlighted text. Disabled icons are
/// fainter. The name must exist.
QIcon icon(const QString& name);

}  // namespace editor
