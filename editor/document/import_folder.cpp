#include "editor/document/import_folder.h"

#include <QDir>
#include <QUuid>

namespace editor {

bool take_lock(QLockFile& lock) {
  lock.setStaleLockTime(0);  // never stale by age, since sessions may run long
  // The process number in the lock file may be reused, and the file may be empty after a power cut; but the
  // operating system knows whether it is held, and a held lock is not removed.
  return lock.tryLock() || (lock.removeStaleLockFile() && lock.tryLock());
}

ImportFolder::ImportFolder(const QString& path) : path_(path), lock_(path + ".lock") {}

ImportFolder::~ImportFolder() {
  if (lock_.isLocked()) QDir(path_).removeRecursively();
}

std::shared_ptr<const ImportFolder> ImportFolder::make(const QString& parent) {
  const QString path = parent + "/" + QUuid::createUuid().toString(QUuid::WithoutBraces);
  if (!QDir().mkpath(parent)) return nullptr;
  const std::shared_ptr<ImportFolder> folder(new ImportFolder(path));
  return take_lock(folder->lock_) && QDir().mkdir(path) ? folder : nullptr;
}

std::shared_ptr<const ImportFolder> ImportFolder::adopt(const QString& path) {
  if (!QDir(path).exists()) return nullptr;
  const std::shared_ptr<ImportFolder> folder(new ImportFolder(path));
  return take_lock(folder->lock_) ? folder : nullptr;
}

void ImportFolder::remove_abandoned(const QString& parent, const QStringList& kept) {
  for (const QString& name : QDir(parent).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString path = parent + "/" + name;
    if (!kept.contains(path)) adopt(path);
  }
}

}  // namespace editor
