#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "editor/document/import_folder.h"
#include "editor/document/op_document.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace editor {

/// The state of a document that is to be saved.
struct SaveRequest {
  grf::Scene scene;
  std::string from;                             ///< the file from which the scene names others
  QString path;                                 ///< of the file to be written
  ImportFolders imports;                        ///< images in these are copied beside that file
  std::optional<OpDocument::Snapshot> options;  ///< to be written too
  std::uint64_t origin = 0;                     ///< the revision with which the document took the scene
  std::uint64_t revision = 0;                   ///< of the document in this state
};

/// A save result says what was written.
struct SaveResult {
  SaveRequest request;
  bool is_done = false;
  std::map<std::string, std::string> copied;  ///< new names of images by those in the scene
  std::string options;                        ///< text of the OP file, if that was written
  grf::Diagnostics diagnostics;               ///< why it is not done
};

/// Writes what is asked for, in any thread.
SaveResult write(SaveRequest request);

/// The files that blocks of the file `path` include, also by others; `only_changed`: those that are not as
/// they were read. Their paths are canonical.
QStringList included_paths(const grf::BlockList& blocks, const std::string& path, bool only_changed);

/// The files besides the scene's own that writing replaces: its OP file, and included files that are not as
/// they were read.
QStringList files_beside(const SaveRequest& request);

}  // namespace editor
