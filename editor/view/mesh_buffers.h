#pragma once

#include <cstddef>
#include <memory>

#include "editor/view/gl_objects.h"
#include "editor/view/mesh_geometry.h"

namespace editor {

/// The vertex attribute that shaders get besides position, normal and uv.
enum class VertexValue { Colour, Irradiance };

/// The vertex and index buffers of a mesh without its hidden faces.
class MeshBuffers {
 public:
  /// One bit per face tells whether it is hidden; without bits none is.
  MeshBuffers(Gl& gl, const TriangleArrays& arrays, FaceSelection::Faces hidden = {});

  std::size_t triangle_count() const { return triangle_count_; }
  std::size_t vertex_count() const { return vertex_count_; }
  std::size_t edge_count() const { return edge_count_; }
  bool has_edges() const { return edges_ != nullptr; }
  bool has_face_normals() const { return face_count_ > 0; }

  /// Adds the edges of visible faces, which only some display modes draw.
  void set_edges(const MeshGeometry& geometry);
  void set_face_normals(const MeshGeometry& geometry);

  /// Draws triangles with their faces bound to texture unit 0. Shaders number triangles from `first` on.
  void draw_triangles(std::size_t first, std::size_t count, VertexValue value);
  void draw_edges(std::size_t first, std::size_t count);
  /// Draws all vertices, or those of visible faces if some are hidden.
  void draw_vertices();
  void draw_faces_as_points();

 private:
  std::unique_ptr<GlObject> buffer_of(GLenum target, const void* data, std::size_t bytes);
  void attribute(GLuint index, const GlObject* buffer, int components, float constant = 0);

  Gl& gl_;
  const FaceSelection::Faces hidden_;
  std::size_t triangle_count_ = 0;
  std::size_t vertex_count_ = 0;
  std::size_t edge_count_ = 0;
  std::size_t face_count_ = 0;
  std::unique_ptr<GlObject> positions_, normals_, colours_, irradiance_, uvs_, triangles_, edges_;
  std::unique_ptr<GlObject> face_centres_, face_normals_;
  BufferTexture face_of_triangle_;
  GlObject shaded_, edged_, faces_;  // vertex arrays
};

}  // namespace editor
