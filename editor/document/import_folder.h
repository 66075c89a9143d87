#pragma once

#include <QLockFile>
#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

namespace editor {

/// Locks a file, also if its former owner has crashed and its process number was reused. Returns false if the
/// lock is held.
bool take_lock(QLockFile& lock);

/// A folder for the images embedded in an imported model. It is removed with its last owner, and locked until
/// then, so that leftovers of a crash can be told from folders in use.
class ImportFolder {
 public:
  /// Creates a folder in `parent`; null on failure.
  static std::shared_ptr<const ImportFolder> make(const QString& parent);
  /// Takes over a leftover of a crash; null if it is gone, or in use by another session.
  static std::shared_ptr<const ImportFolder> adopt(const QString& path);
  /// Removes leftovers of crashes in `parent`, except for the folders `kept`.
  static void remove_abandoned(const QString& parent, const QStringList& kept);

  ~ImportFolder();
  ImportFolder(const ImportFolder&) = delete;
  ImportFolder& operator=(const ImportFolder&) = delete;

  const QString& path() const { return path_; }

 private:
  explicit ImportFolder(const QString& path);

  const QString path_;
  QLockFile lock_;  ///< beside the folder, and taken before the folder is created
};

using ImportFolders = std::vector<std::shared_ptr<const ImportFolder>>;

}  // namespace editor
