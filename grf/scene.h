// A scene as its author wrote it: a plain value, a tree of blocks. A copy is a snapshot; meshes and
// included files are shared by copies until one of them is edited.
//
// Every scene can be written and read back if whoever builds it keeps to this, besides what is said at each
// type: numbers are finite; a reference names a definition of its kind that is in scope; names and comments
// have no line ends and no zero bytes; a file that is included twice has one text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grf/comments.h"
#include "grf/math.h"
#include "grf/mesh.h"
#include "grf/model.h"
#include "grf/shared.h"
#include "grf/source_location.h"

namespace grf {

struct Block;

/// What stands between the `begin` and `end` of a scope, or in a file.
struct BlockList {
  std::vector<Block> blocks;
  std::vector<std::string> end_comments;  ///< after the last block

  friend bool operator==(const BlockList& a, const BlockList& b);
};

/// A parallelogram that emits from the side to which edge1 x edge2 points.
struct AreaLight {
  Vec3f corner = Vec3f(0);
  Vec3f edge1 = Vec3f(0);
  Vec3f edge2 = Vec3f(0);
  std::optional<Colour> radiance;  ///< W/(sr m2); absent: 1

  bool operator==(const AreaLight&) const = default;
};

/// Polygons whose fronts emit and that reflect nothing. The colour of a surface is its radiance in W/(sr m2),
/// absent: 1. The surfaces have no other attribute, and the mesh has no name.
struct MeshLight {
  Shared<Mesh> mesh;

  bool operator==(const MeshLight&) const = default;
};

/// Places a mesh that was defined by name once more.
struct Use {
  Reference mesh;

  bool operator==(const Use&) const = default;
};

/// What holds for the scene as a whole.
struct Params {
  /// Where the observers are for whom irradiance that depends on the view was computed.
  std::vector<Vec3f> views;

  bool operator==(const Params&) const = default;
};

/// What an included file held when it was read, so that saving rewrites only files that hold something else.
struct IncludeOrigin {
  std::string path;  ///< canonical; empty for an include that was not read from a file
  Shared<BlockList> contents;
  std::size_t hash = 0;  ///< std::hash of the file's bytes

  /// Where a thing came from makes it no other thing.
  bool operator==(const IncludeOrigin&) const { return true; }
};

/// A file whose blocks stand in the place of the include.
struct Include {
  /// As written, relative to the folder of the file that names it; quotes as in a mesh's name.
  std::string file;
  Shared<BlockList> contents;
  IncludeOrigin origin;

  bool operator==(const Include&) const = default;
};

/// One step of a transform: factors, angles in radians about x, then y, then z, or an offset.
struct TransformStep {
  enum class Kind { Scale, Rotation, Translation };
  Kind kind = Kind::Translation;
  Vec3f value = Vec3f(0);

  bool operator==(const TransformStep&) const = default;
};

/// Steps, of which there is one at least, act on the body in the order written.
struct Transform {
  std::vector<TransformStep> steps;
  BlockList body;

  bool operator==(const Transform&) const = default;
};

struct Definition {
  using Body = std::variant<Colour, BrdfModel, PdfModel, Texture, Shared<Mesh>>;

  std::string name;
  Body body;
  Comments comments;
  SourceLocation location;

  bool operator==(const Definition&) const = default;
};

/// Names that hold for the definitions after them, for the body, and for the files included from there. There
/// is one at least; each is an identifier, and no two are the same.
struct DefinitionScope {
  std::vector<Definition> definitions;
  BlockList body;

  bool operator==(const DefinitionScope&) const = default;
};

struct Block {
  std::variant<Shared<Mesh>, MeshLight, AreaLight, Include, Transform, DefinitionScope, Params, Use> content;
  Comments comments;
  SourceLocation location;

  bool operator==(const Block&) const = default;
};

struct Scene {
  BlockList contents;

  bool operator==(const Scene&) const = default;
};

/// What a definition defines, as messages say it: `colour`, `BRDF`, `PDF`, `texture` or `mesh`.
std::string_view kind_of(const Definition::Body& body);

/// Whether vertices of these blocks have irradiance. A file that holds them is then an IGRF file; included
/// files are files of their own.
bool has_irradiance(const BlockList& contents);

/// Blocks stand in no more blocks than these: readers and writers refuse what is nested deeper.
inline constexpr std::size_t DeepestNesting = 1000;

/// The number of `transform` and `def` blocks around the innermost block, at most. Includes add none of their
/// own, and what they hold counts.
std::size_t nesting_of(const BlockList& contents);

/// The matrix of a list of transform steps, in double so that nested ones lose nothing.
Matrix44d matrix_of(const std::vector<TransformStep>& steps);

}  // namespace grf
