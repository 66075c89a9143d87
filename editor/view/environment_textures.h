#pragma once

#include <memory>

#include "editor/view/gl_objects.h"
#include "renderer/studies/brdf_viewer/lit_object.h"

namespace editor {

/// The functions that object_environment.glsl needs, and it: for programs without a BRDF's text.
QByteArray environment_text();

/// Returns the preface of a program with view_environment.glsl, with or without an environment map: it
/// precedes the other texts, except for functions of BRDFs.
QByteArray view_environment_preface(bool has_map);

/// The textures of an environment for object_environment.glsl. They are created, used and destroyed while
/// their context is current.
class EnvironmentTextures {
 public:
  explicit EnvironmentTextures(Gl& gl)
      : gl_(gl), map_(gl, GlKind::Texture), directions_(gl, GlKind::Texture) {}

  /// Uploads the map of an environment, unless it is loaded, if a texture of the driver can hold it.
  void load(const studies::Environment& sky, int most_side);
  /// Sets the uniforms of an environment, whose map is loaded, in the bound program. It uses the texture unit
  /// `first_unit` and the next one.
  void set(QOpenGLShaderProgram& program, const studies::Environment& sky, GLuint first_unit);

 private:
  Gl& gl_;
  GlObject map_, directions_;
  std::shared_ptr<const transport::EnvironmentMap> loaded_;
};

}  // namespace editor
