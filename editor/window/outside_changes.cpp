#include "editor/window/outside_changes.h"

#include "editor/document/document.h"
#include "editor/document/op_files.h"
#include "editor/document/save.h"

namespace editor {
OutsideChanges::OutsideChanges(const Document& document, QObject* parent)
    : QObject(parent), document_(document), watch_(this) {
  connect(&document, &Document::scene_replaced, this, &OutsideChanges::follow);
  connect(&document, &Document::saved, this, &OutsideChanges::follow);
  connect(&watch_, &FileWatch::changed, this, &OutsideChanges::compare);
}

void OutsideChanges::follow() {
  known_.clear();
  if (document_.path().isEmpty()) return watch_.follow({});
  const QString path = document_.path();
  const QStringList all = QStringList{path, op_file_beside(path)} +
                          included_paths(document_.scene().contents, path.toStdString(), false);
  for (const QString& file : all) known_.emplace(file, FileStamp::of(file));
  watch_.follow(all);
}

QStringList OutsideChanges::files() const {
  QStringList files;
  for (const auto& [file, stamp] : known_) {
    const FileStamp now = FileStamp::of(file);
    if (now != stamp && now != FileStamp()) files.append(file);
  }
  return files;
}

void OutsideChanges::ignore() {
  for (auto& [file, stamp] : known_) stamp = FileStamp::of(file);
}

void OutsideChanges::compare() {
  const QStringList changed = files();
  if (!is_paused_ && !changed.isEmpty()) emit found(changed);
}

}  // namespace editor
