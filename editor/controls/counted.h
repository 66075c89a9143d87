#pragma once

#include <QString>
#include <cstddef>

namespace editor {

/// A number of things, as it is shown everywhere: 9999, and 10 000 with a space that keeps it on one line.
QString count_text(std::size_t number);

/// `one` for 1, else `many` with the number in place of its %1: "1 face", "2 faces".
QString counted(std::size_t number, const QString& one, const QString& many);

}  // namespace editor
