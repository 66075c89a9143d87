#pragma once

#include <QLockFile>
#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

namespace editor {

/// Locks a file also if the process that had it is no more, whatever its number is used for by now. False: it
/// is held.
bool take_lock(QLockFile& lock);

/// A folder for the images that stood inside an imported model. It is removed with the last who needs it, and
/// locked until then: what a crash leaves can be told from what another session needs.
class ImportFolder {
 public:
  /// Makes a folder in `parent`; null: it cannot be made.
  static std::shared_ptr<const ImportFolder> make(const QString& parent);
  /// Takes over one that a crash left; null: it is gone, or another session has it.
  static std::shared_ptr<const ImportFolder> adopt(const QString& path);
  /// Removes what crashes left in `parent`, but for the folders to be kept.
  static void remove_abandoned(const QString& parent, const QStringList& kept);

  ~ImportFolder();
  ImportFolder(const ImportFolder&) = delete;
  ImportFolder& operator=(const ImportFolder&) = delete;

  const QString& path() const { return path_; }

 private:
  explicit ImportFolder(const QString& path);

  const QString path_;
  QLockFile lock_;  ///< beside it: it is held before the folder is there
};

using ImportFolders = std::vector<std::shared_ptr<const ImportFolder>>;

}  // namespace editor
