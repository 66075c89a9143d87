#pragma once

#include <string>
#include <vector>

#include "grf/scene.h"
#include "grf/visit.h"

namespace grf {

/// Generates random scenes that use every feature of a scene, inside a rapidcheck property: each choice is a
/// value from rapidcheck, so that a failing scene shrinks to a small one.
///
/// The scenes satisfy the invariants of the types: numbers are finite, references name a definition in scope,
/// text on one line has no line end, and so on.
class SceneGenerator {
 public:
  explicit SceneGenerator(bool with_includes) : with_includes_(with_includes) {}

  Scene scene();
  /// Generates any finite float, including special ones.
  static float number();

 private:
  BlockList block_list(int depth);
  Block block(int depth);
  AreaLight light();
  Transform transform(int depth);
  DefinitionScope definitions(int depth);
  Include include(int depth);
  Use use(const std::vector<std::string>& names);
  Params params();
  Mesh mesh();
  MeshLight mesh_light();
  void fill_vertices(MeshDraft& mesh);
  Irradiance irradiance();
  void fill_faces(MeshDraft& mesh, Surface (SceneGenerator::*make)());
  Surface surface();
  Surface light_surface();
  template <class Body>
  std::optional<std::variant<Body, Reference>> attribute();
  Colour colour();
  template <class ModelOfKind>
  ModelOfKind model();
  BrdfModel combine(const std::vector<std::string>& names);
  BrdfModel layered(const std::vector<std::string>& names);
  template <class Body>
  std::vector<std::string> names_of() const;
  Argument argument();
  Texture texture();
  Value value();
  Comments comments();
  std::vector<std::string> comment_lines();
  std::string comment();
  std::string quotable();

  bool with_includes_;
  int file_count_ = 0;
  ScopeStack scope_;
};

}  // namespace grf
