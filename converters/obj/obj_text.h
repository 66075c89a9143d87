// The text of an OBJ file, checked statement by statement before Assimp sees it. Assimp passes over what it
// does not understand, so that one bad vertex shifts every index behind it and nobody hears of it; it takes a
// file that was cut off for a whole one; and it rounds some numbers to the float next to the nearest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converters/obj/obj_corner.h"
#include "converters/obj/wavefront_text.h"
#include "grf/diagnostics.h"
#include "grf/math.h"
#include "grf/mesh.h"

namespace convert {

/// The name of a material library, and where it was named.
struct LibraryName {
  std::string name;
  grf::SourceLocation location;
};

/// Faces from one on, up to those of the next run, that have a number in common.
struct FaceRun {
  std::size_t first_face = 0;
  std::uint32_t number = 0;
};

struct ObjText {
  // Each number is the float nearest to its text.
  std::vector<grf::Vec3f> positions;
  grf::OptionalVertexValues<grf::Colour> colours;
  std::vector<grf::Vec2f> texture_coordinates;
  std::vector<grf::Vec3f> normals;

  /// The different corners that faces have.
  std::vector<ObjCorner> corners;
  /// The faces as statements for Assimp, whose vertices are those corners: the coordinates of a vertex are
  /// the number of the corner, as `corner_at` understands it. A group is called by its index below. Materials
  /// are not among them: Assimp would take n^2 for n of them.
  std::string statements;
  std::vector<std::string> meshes;     ///< their names: of `o` and `g` statements that faces follow
  std::vector<std::string> materials;  ///< their names; the first one stands for none
  std::vector<FaceRun> material_runs;  ///< indices of materials
  std::vector<FaceRun> smoothing;      ///< groups, 0 for none; empty where no face has a group and no normals
  std::vector<LibraryName> libraries;

  std::size_t faces = 0;  ///< among the statements
  // What is left out.
  std::size_t lines = 0;
  std::size_t points = 0;
  std::size_t short_faces = 0;  ///< of one or two corners
  std::size_t loose_vertices = 0;
  std::size_t deep_texture_coordinates = 0;   ///< with a third number that is not 0
  std::map<std::string, std::size_t> unread;  ///< statements that are not read, by keyword
};

/// Checks all statements. Returns nothing after an error.
std::optional<ObjText> check_obj(const SourceText& source, grf::Diagnostics& diagnostics);

/// The number of the corner that a vertex of `ObjText::statements` stands for. Floats are exact up to 2^24,
/// which is less than there may be corners, so that two coordinates hold it.
std::uint32_t corner_at(const grf::Vec3f& coordinates);

}  // namespace convert
