// The text of an OBJ file, checked statement by statement before Assimp sees it. Assimp passes over what it
// does not understand, so that one bad vertex shifts every index behind it and nobody hears of it; and it
// takes a file that was cut off for a whole one.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converters/obj/wavefront_text.h"
#include "grf/diagnostics.h"

namespace convert {

/// The name of a material library, and where it was named.
struct LibraryName {
  std::string name;
  grf::SourceLocation location;
};

/// What Assimp calls the material of faces that have none. A library may define one of that name.
inline constexpr std::string_view NoMaterial = "DefaultMaterial";

struct ObjText {
  /// What makes up the faces: sound statements v, vt, vn, f, g (for o too) and usemtl, one a line. Faces
  /// without a material are of the material `NoMaterial`.
  std::string statements;
  std::vector<LibraryName> libraries;

  std::size_t faces = 0;  ///< faces among the statements
  // What the statements leave out.
  std::size_t lines = 0;
  std::size_t points = 0;
  std::size_t short_faces = 0;                ///< faces of one or two corners
  std::size_t smooth_faces = 0;               ///< faces of smoothing groups that have no normals
  std::map<std::string, std::size_t> unread;  ///< statements that are not read, by keyword
  // What the statements have that a scene cannot hold.
  std::size_t textured_faces = 0;  ///< faces with texture coordinates
  // What Assimp confuses where a file has both.
  std::size_t coloured_vertices = 0;
  std::size_t uncoloured_vertices = 0;
};

/// Checks all statements. Returns nothing after an error.
std::optional<ObjText> check_obj(const SourceText& source, grf::Diagnostics& diagnostics);

}  // namespace convert
