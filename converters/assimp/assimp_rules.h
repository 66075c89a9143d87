#pragma once

#include <string_view>

namespace convert {

/// What is to be known of a file format beyond what a scene of Assimp's says: which parts of the scene come
/// from the file, and in which units they are.
struct AssimpRules {
  std::string_view source;  ///< the format's name in comments
  /// The root's transform turns the file's axes to Assimp's and its units to metres. It is left out, so that
  /// a scene has the numbers of the file.
  bool root_is_conversion = false;
  /// Objects that no node names stand where their vertices are (3DS: a file may have no nodes for them).
  bool places_all_meshes = false;
  /// What is amiss in a file of this format is an error where others get a warning.
  bool errors_are_fatal = false;

  // What of it is in the file, and not made up by Assimp.
  bool has_materials = true;
  bool has_normals = true;
  bool has_colours = true;

  bool map_replaces_diffuse = false;     ///< a texture stands in the place of the diffuse colour
  bool emission_is_of_diffuse = false;   ///< emission is a factor of the diffuse colour
  bool shininess_is_percentage = false;  ///< and not an exponent
  /// Highlights are those of Direct3D or OpenGL, powers of the cosine of the half vector, whatever Assimp
  /// calls them. Blinn's always are.
  bool exponent_is_of_half_vector = false;
  bool unlit_has_no_reflection = false;  ///< unlit materials have an emission alone
};

inline constexpr AssimpRules ThreeDsRules = {.source = "3DS",
                                             .root_is_conversion = true,
                                             .places_all_meshes = true,
                                             .map_replaces_diffuse = true,
                                             .emission_is_of_diffuse = true,
                                             .shininess_is_percentage = true};
// A facet's normal says what its corners say.
inline constexpr AssimpRules StlRules = {
    .source = "STL", .errors_are_fatal = true, .has_materials = false, .has_normals = false};
// Assimp's table of colours is not AutoCAD's, and all numbers over 15 wrap around in it.
inline constexpr AssimpRules DxfRules = {
    .source = "DXF", .root_is_conversion = true, .has_materials = false, .has_colours = false};
inline constexpr AssimpRules ColladaRules = {.source = "COLLADA",
                                             .root_is_conversion = true,
                                             .map_replaces_diffuse = true,
                                             .unlit_has_no_reflection = true};
inline constexpr AssimpRules FbxRules = {
    .source = "FBX", .root_is_conversion = true, .map_replaces_diffuse = true};
inline constexpr AssimpRules LwoRules = {.source = "LWO"};
inline constexpr AssimpRules Ac3dRules = {.source = "AC3D", .exponent_is_of_half_vector = true};
inline constexpr AssimpRules XRules = {.source = "X", .exponent_is_of_half_vector = true};
inline constexpr AssimpRules OtherRules = {.source = "Assimp"};

}  // namespace convert
