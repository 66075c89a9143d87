#pragma once

#include <cstddef>
#include <memory>

#include "editor/view/gl_objects.h"
#include "editor/view/mesh_geometry.h"

namespace editor {

/// Which of a vertex's values shaders get besides position, normal and uv.
enum class VertexValue { Colour, Irradiance };

/// A mesh's arrays on the graphics card.
class MeshBuffers {
 public:
  MeshBuffers(Gl& gl, const TriangleArrays& arrays);

  std::size_t triangle_count() const { return triangle_count_; }
  std::size_t vertex_count() const { return vertex_count_; }
  std::size_t edge_count() const { return edge_count_; }
  bool has_edges() const { return edges_ != nullptr; }
  bool has_face_normals() const { return face_count_ > 0; }

  /// Adds what some modes alone draw.
  void set_edges(const std::vector<MeshGeometry::Edge>& edges);
  void set_face_normals(const MeshGeometry& geometry);

  /// The faces of triangles are bound to texture unit 0. Shaders get a triangle's number from `first` on.
  void draw_triangles(std::size_t first, std::size_t count, VertexValue value);
  void draw_edges(std::size_t first, std::size_t count);
  void draw_vertices();
  void draw_faces_as_points();

 private:
  std::unique_ptr<GlObject> buffer_of(GLenum target, const void* data, std::size_t bytes);
  void attribute(GLuint index, const GlObject* buffer, int components, float constant = 0);

  Gl& gl_;
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
