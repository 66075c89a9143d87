// Encodes the surfaces of a scene as tables for shaders.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <ImathVec.h>

#include "editor/document/scene_objects.h"
#include "renderer/reflectance/brdf.h"

namespace editor {

/// The surface of each face. Faces of all meshes are numbered consecutively, as are their surfaces.
struct FaceTables {
  std::vector<std::uint32_t> first_face;  ///< per mesh
  std::vector<std::uint32_t> surface_of_face;
  float irradiance_scale = 1;  ///< exposure that makes bright places of the scene white
};

/// Colours, textures, emission and BRDFs of the surfaces of all meshes.
struct SurfaceTables {
  /// The number of tabulated values of the specular part over the cosine of the view angle, from 0 to 1.
  static constexpr int SpecularValues = 32;

  /// Rows per surface: see shaders/g_buffer.glsl.
  static constexpr std::size_t Rows = 4;
  std::vector<Imath::V4f> surfaces;
  /// The terms of BRDFs: weight, number of the model, number of parameters and number of rows of what layers
  /// above transmit (0 without layers), followed by the parameters and by these rows.
  /// Values of specular parts are between.
  std::vector<Imath::V4f> terms;
  std::vector<std::size_t> ends;      ///< per mesh, the rows that surfaces up to its last one need
  std::vector<std::string> textures;  ///< image paths, by number
  bool has_cutouts = false;           ///< some surface is not opaque
  std::set<std::size_t> alphas;       ///< numbers of the textures whose alpha surfaces read
  std::set<std::size_t> models;       ///< numbers of the models in use: indices of FormulaBrdf
  std::set<std::string> not_shown;    ///< keywords of BRDFs that are previewed as diffuse
};

FaceTables face_tables_of(const SceneObjects& objects);

/// The parts of layered BRDFs, by their identity (reflectance::BrdfMaker); none for one that is not shown.
using LayeredBrdfs = std::map<std::string, reflectance::CombinedBrdfs>;

/// Makes the tables. `layered_brdfs` are those of the tables before, which are not made again, and become
/// those of these.
SurfaceTables surface_tables_of(const SceneObjects& objects, LayeredBrdfs& layered_brdfs);

/// Whether the face tables of both are equal because they share their data; faces are not compared.
bool have_same_faces(const SceneObjects& a, const SceneObjects& b);

}  // namespace editor
