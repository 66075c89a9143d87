#include "editor/document/object_mime.h"

#include <QStringList>

namespace editor {

std::unique_ptr<QMimeData> mime_of(const std::vector<grf::ScenePath>& paths) {
  QStringList lines;
  for (const grf::ScenePath& path : paths) {
    QStringList indices;
    for (const std::uint32_t index : path) indices.append(QString::number(index));
    lines.append(indices.join('/'));
  }
  auto mime = std::make_unique<QMimeData>();
  mime->setData(ObjectsMimeType, lines.join('\n').toUtf8());
  return mime;
}

std::vector<grf::ScenePath> paths_of(const QMimeData& mime) {
  std::vector<grf::ScenePath> paths;
  for (const QString& line : QString::fromUtf8(mime.data(ObjectsMimeType)).split('\n', Qt::SkipEmptyParts)) {
    grf::ScenePath& path = paths.emplace_back();
    for (const QString& index : line.split('/')) path.push_back(index.toUInt());
  }
  return paths;
}

}  // namespace editor
