#pragma once

#include <QString>
#include <vector>

#include "grf/model.h"

namespace editor {

/// A BRDF that a file of a library holds.
struct LibraryFile {
  QString name;  ///< of the file, without its ending
  grf::BrdfModel brdf;
};

/// A folder of files with one BRDF each, as GRF text, named `NAME.brdf`: scenes can name such files in place
/// of a BRDF. What fails is said in the answer, in a sentence; empty: it is done.
class LibraryFolder {
 public:
  LibraryFolder() = default;
  /// It is made when something is added.
  explicit LibraryFolder(QString path) : path_(std::move(path)) {}

  const QString& path() const { return path_; }

  /// By name. Files that cannot be read are left out, and `problems` says why.
  std::vector<LibraryFile> files(std::vector<QString>& problems) const;

  /// A name like that one that no file has, with nothing in it that a file's name cannot have.
  QString free_name(const QString& name) const;

  QString add(const QString& name, const grf::BrdfModel& brdf) const;
  QString rename(const QString& name, const QString& new_name) const;
  /// Into the desktop's trash.
  QString remove(const QString& name) const;

 private:
  QString file_of(const QString& name) const;

  QString path_;
};

}  // namespace editor
