// A scene is the scene graph as its author wrote it: a plain value, a tree of blocks. A copy is a snapshot;
// meshes and included files are copy-on-write.
//
// Invariants for a scene that can be written and read back, besides those of each type: numbers are finite; a
// reference names a definition of its kind that is in scope; names and comments have no line ends and no zero
// bytes; a file that is included twice has one text.
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

/// The blocks between the `begin` and `end` of a scope, or of a file.
struct BlockList {
  std::vector<Block> blocks;
  std::vector<std::string> end_comments;  ///< after the last block

  friend bool operator==(const BlockList& a, const BlockList& b);
};

/// A parallelogram area light that emits from the side to which edge1 x edge2 points.
struct AreaLight {
  Vec3f corner = Vec3f(0);
  Vec3f edge1 = Vec3f(0);
  Vec3f edge2 = Vec3f(0);
  std::optional<Colour> radiance;  ///< W/(sr m2); absent: 1

  bool operator==(const AreaLight&) const = default;
};

/// A mesh light: polygons that emit from their front and reflect nothing. The colour of a surface is its
/// radiance in W/(sr m2), absent: 1. Surfaces have no other attribute, and the mesh has no name.
struct MeshLight {
  Shared<Mesh> mesh;

  bool operator==(const MeshLight&) const = default;
};

/// An instance of a mesh definition.
struct Use {
  Reference mesh;

  bool operator==(const Use&) const = default;
};

/// Parameters of the scene as a whole.
struct Params {
  /// The positions of the observers for whom view-dependent irradiance was computed.
  std::vector<Vec3f> views;

  bool operator==(const Params&) const = default;
};

/// The contents of an included file as it was read, so that saving rewrites only files that changed.
struct IncludeOrigin {
  std::string path;  ///< canonical; empty for an include that was not read from a file
  Shared<BlockList> contents;
  std::size_t hash = 0;  ///< std::hash of the file's bytes

  /// Origins do not take part in equality.
  bool operator==(const IncludeOrigin&) const { return true; }
};

/// An include: a file whose blocks take the place of the include.
struct Include {
  /// The path as written, relative to the folder of the file that names it; quotes as in a mesh's name.
  std::string file;
  Shared<BlockList> contents;
  IncludeOrigin origin;

  bool operator==(const Include&) const = default;
};

/// One step of a transform: scale factors, rotation angles in radians about x, then y, then z, or an offset.
struct TransformStep {
  enum class Kind { Scale, Rotation, Translation };  ///< What the step does.
  Kind kind = Kind::Translation;
  Vec3f value = Vec3f(0);

  bool operator==(const TransformStep&) const = default;
};

/// A transform of its body: one or more steps, applied in the order written.
struct Transform {
  std::vector<TransformStep> steps;
  BlockList body;

  bool operator==(const Transform&) const = default;
};

/// A named colour, BRDF, sampling scheme, texture or mesh.
struct Definition {
  using Body = std::variant<Colour, BrdfModel, PdfModel, Texture, Shared<Mesh>>;

  std::string name;
  Body body;
  Comments comments;
  SourceLocation location;

  bool operator==(const Definition&) const = default;
};

/// A scope of definitions, visible in the definitions after them, in the body, and in files included from
/// there. There is at least one; names are identifiers and unique.
struct DefinitionScope {
  std::vector<Definition> definitions;
  BlockList body;

  bool operator==(const DefinitionScope&) const = default;
};

/// A node of the scene graph, with its comments and its place in the file.
struct Block {
  std::variant<Shared<Mesh>, MeshLight, AreaLight, Include, Transform, DefinitionScope, Params, Use> content;
  Comments comments;
  SourceLocation location;

  bool operator==(const Block&) const = default;
};

/// A scene as its author wrote it.
struct Scene {
  BlockList contents;

  bool operator==(const Scene&) const = default;
};

/// Returns the kind of a definition, for messages: `colour`, `BRDF`, `PDF`, `texture` or `mesh`.
std::string_view kind_of(const Definition::Body& body);

/// Returns whether vertices of these blocks, not of included files, have irradiance: their file is then an
/// IGRF file.
bool has_irradiance(const BlockList& contents);

/// The maximum nesting depth of blocks: readers and writers refuse deeper nesting.
inline constexpr std::size_t DeepestNesting = 1000;

/// Returns the maximum nesting depth of `transform` and `def` blocks. An include itself adds no level, but
/// its blocks count.
std::size_t nesting_of(const BlockList& contents);

/// Computes the matrix of a list of transform steps, in double so that nested transforms stay accurate.
Matrix44d matrix_of(const std::vector<TransformStep>& steps);

}  // namespace grf
