// The OP file beside a scene, as the editor and `bpt` read it.
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"

namespace editor {

/// The OP file beside a scene, SCENE.op.
QString op_file_beside(const QString& scene_path);

/// The options with all files that they name by absolute paths; relative ones are beside the scene.
options::RenderOptions with_absolute_paths(options::RenderOptions render_options, const QString& scene_path);

/// The text of an OP file with these options: that before, of which comments, order, lines that are no
/// options and options with the same values stay as they are; a new file gets those that are not as by
/// default. Files in the folder of the OP file are named without it. Nothing if a name cannot be written.
std::optional<std::string> op_text_of(const options::RenderOptions& render_options, const QString& op_path,
                                      const std::string& before, grf::Diagnostics& diagnostics);

/// Changes the file, likewise, or makes it. False after an error, which leaves it as it was.
bool write_op_file(const options::RenderOptions& render_options, const QString& op_path,
                   grf::Diagnostics& diagnostics);

}  // namespace editor
