// The cameras of glTF files are those of OP files, and the other way round.
#pragma once

#include <string>
#include <vector>

#include "converters/gltf/gltf_document.h"
#include "converters/gltf/gltf_file.h"
#include "converters/gltf/gltf_nodes.h"
#include "converters/losses.h"
#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"

namespace convert {

/// Reads the cameras of the nodes of the default scene (glTF 2.0, section 3.10), with different names. Those
/// that are not perspective, or have impossible numbers, are losses. A camera looks at the point of its view
/// direction that is nearest to the middle of the scene, or one unit away if that is behind it.
std::vector<options::NamedCamera> read_cameras(const GltfFile& file, const GltfNodes& nodes,
                                               const grf::Box3d& bounds, Losses& losses);

/// Writes the cameras of an OP file as nodes, whose indices it appends to `nodes`: the one that renders
/// first, and those with names. Returns false after an error.
bool write_cameras(const std::string& op_file, const grf::Box3d& bounds, GltfDocument& document,
                   std::vector<int>& nodes, grf::Diagnostics& diagnostics);

}  // namespace convert
