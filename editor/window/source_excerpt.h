// Reads the part of a text file around a location.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>

namespace editor {

/// The maximum number of lines, and of characters per line, since a file may have millions.
inline constexpr qint64 ExcerptLines = 5000;
inline constexpr qint64 ExcerptColumns = 2000;

/// A location in a file; lines and columns count from 1, columns in characters. 0 if unknown.
struct SourcePlace {
  QString path;
  qint64 line = 0;
  qint64 column = 0;
};

struct SourceExcerpt {
  SourcePlace place;
  QString problem;        ///< error message; empty if the file was read
  qint64 first_line = 1;  ///< number of the first line of the excerpt
  qint64 line_count = 0;  ///< of the whole file
  QStringList lines;      ///< without line ends; an ellipsis replaces the omitted part of a long line
  qint64 shortened = 0;   ///< number of shortened lines
  qint64 position = 0;    ///< of the location's column in its line of the excerpt, in UTF-16 units from 0
  bool is_whole() const { return lines.size() == line_count && shortened == 0; }
};

/// Reads an excerpt in one pass, with no more in memory than is shown. It stops early, with an incomplete
/// result, as soon as `is_stopped` returns true.
SourceExcerpt read_excerpt(const SourcePlace& place, const std::function<bool()>& is_stopped = {});

}  // namespace editor
