#pragma once

#include <QString>
#include <map>
#include <string>

#include "editor/document/import_folder.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace editor {

/// Copies the images of a scene that are in one of the folders beside the file `to`. Names in use by other
/// files get a number. Returns the new names by those in the scene, as `grf::relocate` takes them; failures
/// are errors.
std::map<std::string, std::string> copy_images(const grf::Scene& scene, const std::string& from,
                                               const ImportFolders& folders, const std::string& to,
                                               grf::Diagnostics& diagnostics);

/// Whether a file is an image by its name, and not a scene or model.
bool is_image(const QString& file);

/// Whether all images of a folder were copied, by their names in the file `from`.
bool is_copied(const ImportFolder& folder, const std::string& from,
               const std::map<std::string, std::string>& copied);

}  // namespace editor
