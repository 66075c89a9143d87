// What the faces of a scene look like, as tables that shaders read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <ImathVec.h>

#include "editor/document/scene_objects.h"

namespace editor {

/// The tables say which surface each face has. Faces of all meshes are numbered one after the other, as are
/// their surfaces.
struct FaceTables {
  std::vector<std::uint32_t> first_face;  ///< of each mesh
  std::vector<std::uint32_t> surface_of_face;
  float irradiance_scale = 1;  ///< makes bright places of the scene white
};

/// The tables hold the colours, textures, emission and BRDFs of the surfaces of all meshes.
struct SurfaceTables {
  /// So many values for the mirror part over the cosine of the angle of view, from 0 to 1.
  static constexpr int MirrorValues = 32;

  /// Three rows a surface: see shaders/g_buffer.glsl.
  std::vector<Imath::V4f> surfaces;
  /// Each term of a BRDF has its weight, its model's number and the number of its parameters, followed by
  /// these. Values of mirror parts are between.
  std::vector<Imath::V4f> terms;
  std::vector<std::size_t> ends;      ///< of each mesh, the rows that surfaces up to its last one need
  std::vector<std::string> textures;  ///< paths of images, by number
  std::set<std::size_t> models;       ///< numbers of those that occur: indices of FormulaBrdf
  std::set<std::string> not_shown;    ///< keywords of BRDFs that look matte instead
};

FaceTables face_tables_of(const SceneObjects& objects);
SurfaceTables surface_tables_of(const SceneObjects& objects);

/// Whether the face tables of both are the same, by what they share, without a look at each face.
bool have_same_faces(const SceneObjects& a, const SceneObjects& b);

}  // namespace editor
