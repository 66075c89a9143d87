#include "editor/window/outside_changes.h"

#include <set>

#include "editor/document/document.h"
#include "editor/document/op_files.h"

namespace editor {
namespace {

void add_includes(const grf::BlockList& list, std::set<std::string>& files) {
  for (const grf::Block& block : list.blocks) {
    if (const auto* transform = std::get_if<grf::Transform>(&block.content)) {
      add_includes(transform->body, files);
    } else if (const auto* scope = std::get_if<grf::DefinitionScope>(&block.content)) {
      add_includes(scope->body, files);
    } else if (const auto* include = std::get_if<grf::Include>(&block.content)) {
      const std::string& path = include->origin.path;
      if (path.empty() || files.insert(path).second) add_includes(*include->contents, files);
    }
  }
}

}  // namespace

OutsideChanges::OutsideChanges(const Document& document, QObject* parent)
    : QObject(parent), document_(document), watch_(this) {
  connect(&document, &Document::taken, this, &OutsideChanges::follow);
  connect(&document, &Document::saved, this, &OutsideChanges::follow);
  connect(&watch_, &FileWatch::changed, this, &OutsideChanges::compare);
}

void OutsideChanges::follow() {
  known_.clear();
  if (document_.path().isEmpty()) return watch_.follow({});
  std::set<std::string> files;
  add_includes(document_.scene().contents, files);
  QStringList all = {document_.path(), op_file_beside(document_.path())};
  for (const std::string& file : files) all.append(QString::fromStdString(file));
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
  if (!changed.isEmpty()) emit found(changed);
}

}  // namespace editor
