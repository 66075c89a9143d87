#pragma once

#include <QSize>
#include <array>
#include <vector>

#include <ImathVec.h>

#include "editor/view/gl_objects.h"

namespace editor {

/// The G-buffer of a view: for each pixel the geometry, then the light and the colour.
///
/// Faces: two integers per pixel, the instance's number plus 1 (0: background; the highest bit: back face)
/// and the face's number among those of all meshes. Normals: in camera space, towards the eye, octahedrally
/// encoded, and the angle of the tangent about it. Values: the vertex colour and log2 of the pixel footprint
/// in uv, or the irradiance and whether it exists. Light: radiance. Colour: the displayed colour,
/// premultiplied, in the screen's encoding.
class GBuffer {
 public:
  GBuffer(Gl& gl, const QSize& size);

  const QSize& size() const { return size_; }

  enum class Target {
    Geometry,  ///< faces, normals, values, uv and depth
    Values,    ///< only values, for multiplication
    Light,
    Colour,  ///< with depth test
  };
  /// Binds a target for drawing, or reads its first texture.
  void begin(Target target);

  /// Binds faces, normals, values, uv, depth, light and colour to texture units from this one on.
  void bind_textures(GLuint first_unit) const;

  /// The shading inputs of some rows, pixel by pixel, from the bottom. Values are rgb, and normals are
  /// encoded.
  struct Rows {
    std::vector<std::array<GLuint, 2>> faces;
    std::vector<Imath::V4f> normals;
    std::vector<Imath::V4f> values;
    std::vector<Imath::V3f> light;
  };
  Rows read_rows(int first, int count);
  /// Replaces the light of as many rows.
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
