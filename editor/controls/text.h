#pragma once

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

}  // namespace editor
