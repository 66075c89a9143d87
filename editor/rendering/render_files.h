// Writes a scene for a final render by `bpt`.
#pragma once

#include <QString>
#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/options/render_options.h"

namespace editor {

/// The absolute path to which a scene's file names are relative; for an unsaved scene, in the current folder.
QString naming_path(const QString& scene_path);

/// Writes a snapshot of a scene to one file, with includes expanded and file names relative to that file.
/// Returns false after an error.
bool write_snapshot(const grf::Scene& scene, const QString& scene_path, const QString& path,
                    grf::Diagnostics& diagnostics);

/// Writes the snapshot of a scene as `base`.grf, and options, which must name that, as `base`.op. Returns the
/// problem; empty if both are written.
QString write_snapshot_files(const grf::Scene& scene, const QString& scene_path,
                             const options::RenderOptions& render_options, const QString& base);

/// The image of a camera: `scene_side.exr` for `scene.exr`; the same file for the camera without a name. A
/// camera may have any name, a file may not: other letters become underscores.
QString file_of_camera(const QString& file, const std::string& camera);
/// The image of an effect: `scene_effect_textures.exr` for `scene.exr`.
QString file_of_effect(const QString& file, const std::string& effect);

}  // namespace editor
