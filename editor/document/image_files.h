#pragma once

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace editor {

/// Copies the images of a scene that are in one of the folders to that of the file `to`. Names that are taken
/// there by other files get a number. Gives the new names by those in the scene, as `grf::relocate` takes
/// them; what cannot be copied is an error.
std::map<std::string, std::string> copy_images(const grf::Scene& scene, const std::string& from,
                                               const std::vector<QString>& folders, const std::string& to,
                                               grf::Diagnostics& diagnostics);

}  // namespace editor
