#pragma once

#include <QString>
#include <cstddef>

namespace editor {

/// Formats a count: 9999, and 10 000 with a non-breaking space.
QString count_text(std::size_t number);

/// Returns `one` for 1, else `many` with %1 replaced by the number: "1 face", "2 faces".
QString counted(std::size_t number, const QString& one, const QString& many);

}  // namespace editor
