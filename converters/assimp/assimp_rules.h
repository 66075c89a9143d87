#pragma once

#include <string_view>

namespace convert {

/// The properties of a file format that Assimp's scene does not tell: which parts of the scene come from the
/// file, and in which units they are.
struct AssimpRules {
  std::string_view source;  ///< the format's name in comments
  /// The root's transform converts the file's axes and units to Assimp's (y up, metres). It is removed, so
  /// that the scene keeps the coordinates of the file.
  bool root_is_conversion = false;
  /// Objects without a node are placed without a transform (3DS: a file may have no nodes for them).
  bool places_all_meshes = false;
  /// Problems that are warnings in other formats are errors in this one.
  bool errors_are_fatal = false;

  // Parts of the scene that come from the file, and are not invented by Assimp.
  bool has_materials = true;
  bool has_normals = true;
  bool has_colours = true;

  bool map_replaces_diffuse = false;     ///< a texture replaces the diffuse colour
  bool emission_is_of_diffuse = false;   ///< emission is a factor of the diffuse colour
  bool shininess_is_percentage = false;  ///< shininess is no exponent
  /// Exponents are Blinn-Phong's (of the half vector), as in Direct3D and OpenGL, whatever Assimp calls the
  /// shading. Blinn's always are.
  bool exponent_is_of_half_vector = false;
  bool unlit_has_no_reflection = false;  ///< unlit materials only emit
};

inline constexpr AssimpRules ThreeDsRules = {.source = "3DS",
                                             .root_is_conversion = true,
                                             .places_all_meshes = true,
                                             .map_replaces_diffuse = true,
                                             .emission_is_of_diffuse = true,
                                             .shininess_is_percentage = true};
// Normals of facets are ignored, since the corners define them.
inline constexpr AssimpRules StlRules = {
    .source = "STL", .errors_are_fatal = true, .has_materials = false, .has_normals = false};
// Colours are ignored: Assimp's colour table is not AutoCAD's, and all numbers over 15 wrap around in it.
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
