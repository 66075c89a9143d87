#pragma once

#include <assimp/scene.h>

#include "converters/assimp/three_ds.h"
#include "converters/losses.h"

namespace convert {

/// Puts into Assimp's scene of a 3DS file what Assimp has lost of it: the names of the objects, objects in
/// one piece where Assimp made a node of each of their materials, and normals by smoothing groups. Faces that
/// share a group and a vertex, or two vertices at one place, as seams of textures have, are smooth there;
/// faces without a group get no normals. Where the scene is not the file's, its normals are lost.
void restore_three_ds(const ThreeDsFile& file, aiScene& scene, Losses& losses);

}  // namespace convert
