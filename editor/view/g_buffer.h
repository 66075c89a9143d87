#pragma once

#include <QSize>
#include <array>
#include <vector>

#include <ImathVec.h>

#include "editor/view/gl_objects.h"

namespace editor {

/// The G-buffer has what is seen from one place, pixel by pixel: first what is there, then how it looks.
///
/// Faces: two integers a pixel, the instance's number plus 1 (0: nothing; the highest bit: seen from behind)
/// and the face's number among those of all meshes. Normals: in the camera's coordinates, towards the eye, as
/// an octahedron, and the angle of the tangent about it. Values: the vertices' colour and log2 of the width
/// of a pixel in uv, or their irradiance and whether it is there. Light: radiance. Colour: what is shown,
/// premultiplied, in the screen's encoding.
class GBuffer {
 public:
  GBuffer(Gl& gl, const QSize& size);

  const QSize& size() const { return size_; }

  enum class Target {
    Geometry,  ///< faces, normals, values, uv and depth
    Values,    ///< alone, to multiply them
    Light,
    Colour,  ///< tests against depth are possible
  };
  /// Draws to this from now on, or reads the first of it.
  void begin(Target target);

  /// For shaders: faces, normals, values, uv, depth, light, colour from this texture unit on.
  void bind_textures(GLuint first_unit) const;

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
  enum Layer { Faces, Normals, Values, Uvs, Depth, Light, Colour, LayerCount };

  void make_texture(Layer layer, GLenum format, GLenum layout, GLenum type);
  void attach(Target target, std::initializer_list<Layer> colours, bool has_depth);

  Gl& gl_;
  QSize size_;
  std::array<GlObject, LayerCount> textures_;
  std::array<GlObject, 4> targets_;
};

}  // namespace editor
