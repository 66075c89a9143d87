#include "editor/window/source_excerpt.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cstring>
#include <string_view>

#include "grf/text_file.h"

namespace editor {
namespace {

constexpr qint64 PartBytes = 1 << 20;

/// Calls visit(bytes) for consecutive blocks of the file until it returns false.
template <class Visit>
void for_each_part(QFile& file, const std::function<bool()>& is_stopped, const Visit& visit) {
  QByteArray part(PartBytes, Qt::Uninitialized);
  file.seek(0);
  while (!is_stopped || !is_stopped()) {
    const qint64 size = file.read(part.data(), PartBytes);
    if (size <= 0 || !visit(std::string_view(part.constData(), static_cast<std::size_t>(size)))) return;
  }
}

/// Counts lines: a final line end does not start another line; an empty file has none.
qint64 count_lines(QFile& file, const std::function<bool()>& is_stopped) {
  qint64 lines = 0;
  char last = '\n';
  for_each_part(file, is_stopped, [&](std::string_view part) {
    lines += std::ranges::count(part, '\n');
    last = part.back();
    return true;
  });
  return last == '\n' ? lines : lines + 1;
}

bool is_character_start(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

/// Replaces unprintable characters, and those that would break the line, by a placeholder.
QString shown(const QByteArray& bytes) {
  QString line = QString::fromUtf8(bytes);
  for (QChar& character : line) {
    const char16_t code = character.unicode();
    const bool is_control = code < 0x20 && code != '\t';
    const bool is_break = code == 0x2028 || code == 0x2029 || code == 0xFDD0 || code == 0xFDD1;
    if (is_control || is_break) character = QChar::ReplacementCharacter;
  }
  return line;
}

/// Collects the lines of an excerpt from the blocks of its file.
class LineCollector {
 public:
  explicit LineCollector(SourceExcerpt& excerpt) : excerpt_(excerpt) { begin_line(); }

  /// Returns false when it is complete.
  bool add(std::string_view part) {
    while (!part.empty() && !has_all()) {
      const std::size_t end = part.find('\n');
      if (number_ >= excerpt_.first_line) add_to_line(part.substr(0, end));
      if (end == std::string_view::npos) return true;
      end_line();
      part.remove_prefix(end + 1);
    }
    return !has_all();
  }
  /// The last line may have no line end.
  void finish() {
    if (number_ <= excerpt_.line_count && !has_all()) end_line();
  }

 private:
  bool has_all() const { return excerpt_.lines.size() >= ExcerptLines; }
  bool is_at_place() const { return number_ == excerpt_.place.line; }

  void begin_line() {
    line_.clear();
    character_ = 0;
    const qint64 column = excerpt_.place.column;
    first_ = is_at_place() && column > ExcerptColumns / 2 ? column - ExcerptColumns / 2 : 0;
  }

  void add_to_line(std::string_view bytes) {
    for (const char byte : bytes) {
      if (is_character_start(byte)) ++character_;
      if (character_ > first_ && character_ <= first_ + ExcerptColumns) line_.append(byte);
    }
  }

  void end_line() {
    if (number_ >= excerpt_.first_line) take_line();
    ++number_;
    begin_line();
  }

  void take_line() {
    const bool is_cut_behind = character_ > first_ + ExcerptColumns;
    const bool is_cut_before = first_ > 0 && character_ > first_;
    if (number_ == 1 &&
        line_.startsWith(QByteArrayView(grf::ByteOrderMark.data(), grf::ByteOrderMark.size()))) {
      line_.remove(0, static_cast<qsizetype>(grf::ByteOrderMark.size()));
    }
    if (!is_cut_behind && line_.endsWith('\r')) line_.chop(1);
    QString line = shown(line_);
    if (is_cut_before) line.prepend(QChar(0x2026));
    if (is_at_place()) excerpt_.position = position_in(line, is_cut_before);
    if (is_cut_behind) line.append(QChar(0x2026));
    if (is_cut_before || is_cut_behind) ++excerpt_.shortened;
    excerpt_.lines.append(line);
  }

  /// The index of the location's column, which counts surrogate pairs as one.
  qint64 position_in(const QString& line, bool is_cut_before) const {
    qint64 characters = excerpt_.place.column - 1 - first_ + (is_cut_before ? 1 : 0);
    qint64 position = 0;
    for (; characters > 0 && position < line.size(); --characters) {
      position += line[position].isHighSurrogate() && position + 1 < line.size() ? 2 : 1;
    }
    return position;
  }

  SourceExcerpt& excerpt_;
  qint64 number_ = 1;
  QByteArray line_;
  qint64 character_ = 0;  // number in the line, so far
  qint64 first_ = 0;      // characters of the line that are omitted before the excerpt
};

}  // namespace

SourceExcerpt read_excerpt(const SourcePlace& place, const std::function<bool()>& is_stopped) {
  SourceExcerpt excerpt;
  excerpt.place = place;
  const QFileInfo info(place.path);
  QFile file(place.path);
  // Reading a pipe would never end.
  if (info.exists() && !info.isFile()) {
    excerpt.problem = QCoreApplication::translate("editor::SourceView", "%1 is not a file").arg(place.path);
  } else if (!file.open(QIODevice::ReadOnly | QIODevice::Unbuffered)) {
    excerpt.problem = QCoreApplication::translate("editor::SourceView", "Cannot read %1: %2")
                          .arg(place.path, file.errorString());
  }
  if (!excerpt.problem.isEmpty()) return excerpt;
  excerpt.line_count = count_lines(file, is_stopped);
  const qint64 latest = std::max<qint64>(1, excerpt.line_count - ExcerptLines + 1);
  excerpt.first_line = std::clamp<qint64>(place.line - ExcerptLines / 2, 1, latest);
  LineCollector collector(excerpt);
  for_each_part(file, is_stopped, [&](std::string_view part) { return collector.add(part); });
  collector.finish();
  return excerpt;
}

}  // namespace editor
