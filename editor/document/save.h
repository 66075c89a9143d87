#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "editor/document/editor_state.h"
#include "editor/document/import_folder.h"
#include "editor/document/op_document.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace editor {

/// A snapshot of a document to be saved.
struct SaveRequest {
  grf::Scene scene;
  std::string from;                             ///< the file to which the scene's file names are relative
  QString path;                                 ///< of the file to be written
  ImportFolders imports;                        ///< images in these are copied beside that file
  std::optional<OpDocument::Snapshot> options;  ///< written, too
  EditorState state;                            ///< written, too
  std::shared_ptr<const SceneObjects> objects;  ///< those of the state
  std::uint64_t origin = 0;                     ///< the revision with which the document set the scene
  std::uint64_t revision = 0;                   ///< of the document in this state
};

/// The result of a save.
struct SaveResult {
  SaveRequest request;
  bool is_done = false;
  std::map<std::string, std::string> copied;  ///< new names of images by those in the scene
  std::string options;                        ///< text of the OP file, if it was written
  grf::Diagnostics diagnostics;               ///< errors
};

/// Writes the snapshot, in any thread.
SaveResult write(SaveRequest request);

/// The canonical paths of the files that blocks of the file `path` include, directly or indirectly;
/// `only_changed`: only those that differ from what was read.
QStringList included_paths(const grf::BlockList& blocks, const std::string& path, bool only_changed);

/// The files that saving overwrites besides the scene's own: its OP file, and edited includes.
QStringList files_beside(const SaveRequest& request);

}  // namespace editor
