#pragma once

#include <QDir>
#include <QString>
#include <string_view>

#include "grf/diagnostics.h"

namespace editor {

/// Converts UTF-8 to Qt's text.
inline QString text_of(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// Formats the messages, one per line, without a trailing line end.
inline QString text_of(const grf::Diagnostics& diagnostics) {
  return QString::fromStdString(diagnostics.to_text()).trimmed();
}

/// Formats a path for reading, with the user's home folder as `~`.
inline QString path_text(const QString& path) {
  const QString home = QDir::homePath();
  const bool is_below = path == home || path.startsWith(home + '/');
  return QDir::toNativeSeparators(is_below ? '~' + path.mid(home.size()) : path);
}

}  // namespace editor
