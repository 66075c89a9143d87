// The part of a text file that is about a place.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>

namespace editor {

/// At most so many lines, and characters of each, are shown: a file may have millions.
inline constexpr qint64 ExcerptLines = 5000;
inline constexpr qint64 ExcerptColumns = 2000;

/// A place in a file; lines and columns count from 1, columns in characters. 0: it is not known.
struct SourcePlace {
  QString path;
  qint64 line = 0;
  qint64 column = 0;
};

struct SourceExcerpt {
  SourcePlace place;
  QString problem;        ///< why it cannot be read; empty: it was
  qint64 first_line = 1;  ///< number of the first of the lines that are here
  qint64 line_count = 0;  ///< of the whole file
  QStringList lines;      ///< without line ends; a part that was left out is an ellipsis
  qint64 shortened = 0;   ///< how many of them have one
  qint64 position = 0;    ///< of the place's column in its line here, in UTF-16 from 0
  bool is_whole() const { return lines.size() == line_count && shortened == 0; }
};

/// Reads a file once through, with no more in memory than is shown. It gives up, with whatever it has, as
/// soon as `is_stopped` says so.
SourceExcerpt read_excerpt(const SourcePlace& place, const std::function<bool()>& is_stopped = {});

}  // namespace editor
