#pragma once

#include <QSize>
#include <array>
#include <vector>

#include <ImathVec.h>

#include "editor/view/gl_objects.h"

namespace editor {

/// What is seen from one place, pixel by pixel: first what is there, then how it looks.
///
/// Faces: two integers a pixel, the instance's number plus 1 (0: nothing; the highest bit: seen from behind)
/// and the face's number among those of all meshes. Normals: in the camera's coordinates, towards the eye, as
/// an octahedron, and the angle of the tangent about it. Values: the vertices' colour and log2 of the width
/// of a pixel in uv, or their irradiance and whether it is there. Light: radiance. Colour: what is shown,
/// premultiplied, in the screen's encoding.
class Picture {
 public:
  Picture(Gl& gl, const QSize& size);

  const QSize& size() const { return size_; }

  /// Draws to faces, normals, values, uv and depth from now on.
  void begin_geometry();
  /// Draws to values alone, to multiply them.
  void begin_values();
  /// Draws to light alone.
  void begin_light();
  /// Draws to colour; tests against depth are possible.
  void begin_colour();

  /// For shaders: faces, normals, values, uv, depth, light, colour from this texture unit on.
  void bind_textures(GLuint first_unit) const;
  /// Binds faces to be read.
  void begin_reading_faces();

  /// Some rows of what shading needs, pixel by pixel, from the bottom. Values are rgb, and normals as they
  /// are encoded.
  struct Rows {
    std::vector<std::array<GLuint, 2>> faces;
    std::vector<Imath::V4f> normals;
    std::vector<Imath::V4f> values;
    std::vector<Imath::V3f> light;
  };
  Rows read_rows(int first, int count);
  /// Replaces the light of as many rows as these are.
  void set_light(int first, const std::vector<Imath::V3f>& light);

 private:
  void make_texture(const GlObject& texture, GLenum format, GLenum layout, GLenum type, GLenum filter);
  void attach(const GlObject& target, std::initializer_list<const GlObject*> colours, bool has_depth);
  void begin(const GlObject& target);

  Gl& gl_;
  QSize size_;
  GlObject faces_, normals_, values_, uvs_, depth_, light_, colour_;  // textures
  GlObject geometry_target_, values_target_, light_target_, colour_target_;
};

}  // namespace editor
