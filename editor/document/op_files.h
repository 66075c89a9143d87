// Reads and writes the OP file beside a scene.
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"

namespace editor {

/// The path of the OP file beside a scene, SCENE.op.
QString op_file_beside(const QString& scene_path);

/// Makes all file names of the options absolute; relative ones are beside the scene.
options::RenderOptions with_absolute_paths(options::RenderOptions render_options, const QString& scene_path);

/// Updates the text of an OP file to these options. Comments, order, lines that are no options and options
/// with equal values are kept; a new file gets the options that differ from the defaults. File names in the
/// folder of the OP file are relative. Returns nothing if a name cannot be written.
std::optional<std::string> op_text_of(const options::RenderOptions& render_options, const QString& op_path,
                                      const std::string& before, grf::Diagnostics& diagnostics);

/// Updates or creates the file, likewise. Returns false after an error, which leaves the file unchanged.
bool write_op_file(const options::RenderOptions& render_options, const QString& op_path,
                   grf::Diagnostics& diagnostics);

}  // namespace editor
