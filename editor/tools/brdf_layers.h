#pragma once

#include <QRect>
#include <QSize>
#include <vector>

#include "editor/view/gl_objects.h"
#include "renderer/reflectance/geometry.h"

namespace editor {

/// The textures of an image of the BRDF viewer: normals in world space with the object's opacity, and the sum
/// of the radiance and of the opacity over the passes.
class BrdfLayers {
 public:
  BrdfLayers(Gl& gl, const QSize& size);

  const QSize& size() const { return size_; }
  /// Binds a target for drawing. The normals have a depth test.
  void begin_normals();
  void begin_radiance();
  void clear_radiance();
  void bind_normals(GLuint unit) const { bind(normals_, unit); }
  void bind_radiance(GLuint unit) const { bind(radiance_, unit); }

  /// Reads four floats per pixel of a rectangle from the lower left corner, rows from the bottom.
  std::vector<float> read_normals(const QRect& place);
  std::vector<float> read_radiance(const QRect& place);
  /// Replaces the radiance of a rectangle.
  void set_radiance(const QRect& place, const std::vector<float>& values);

 private:
  void bind(const GlObject& texture, GLuint unit) const;
  void make(const GlObject& texture, GLenum format, GLenum layout);
  std::vector<float> read(const QRect& place);

  Gl& gl_;
  QSize size_;
  GlObject normals_, depth_, radiance_;
  GlObject normal_target_, radiance_target_;
};

}  // namespace editor
