#pragma once

#include <QString>
#include <vector>

#include "grf/model.h"

namespace editor {

/// A BRDF file of the library.
struct LibraryFile {
  QString name;  ///< file name without its extension
  grf::BrdfModel brdf;
};

/// A folder with one BRDF per file, as GRF text, named `NAME.brdf`: scenes can refer to such files in place
/// of a BRDF. Functions return an error message, empty on success.
class LibraryFolder {
 public:
  LibraryFolder() = default;
  /// The folder is created when the first BRDF is added.
  explicit LibraryFolder(QString path) : path_(std::move(path)) {}

  const QString& path() const { return path_; }

  /// The files sorted by name. Unreadable files are left out and reported in `problems`.
  std::vector<LibraryFile> files(std::vector<QString>& problems) const;

  /// Returns an unused file name like the given one, without characters that file names cannot have.
  QString free_name(const QString& name) const;

  QString add(const QString& name, const grf::BrdfModel& brdf) const;
  QString rename(const QString& name, const QString& new_name) const;
  /// Moves the file to the desktop's trash.
  QString remove(const QString& name) const;

 private:
  QString file_of(const QString& name) const;

  QString path_;
};

}  // namespace editor
