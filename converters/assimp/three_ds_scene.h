#pragma once

#include <assimp/scene.h>

#include "converters/assimp/three_ds.h"
#include "converters/losses.h"

namespace convert {

/// Restores what Assimp lost of a 3DS file in its scene: names of objects, whole objects where Assimp made a
/// node per material, and normals from smoothing groups. Faces that share a group and a vertex, or two
/// vertices at one position as at texture seams, are smooth there; faces without a group get no normals. If
/// the scene does not match the file, its normals are lost.
void restore_three_ds(const ThreeDsFile& file, aiScene& scene, Losses& losses);

}  // namespace convert
