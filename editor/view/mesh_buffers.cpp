#include "editor/view/mesh_buffers.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <utility>

namespace editor {
namespace {

/// The triangles of visible faces, with their faces.
struct VisibleTriangles {
  std::vector<TriangleArrays::Triangle> triangles;
  std::vector<std::uint32_t> face_of_triangle;
};

VisibleTriangles visible_triangles(const TriangleArrays& arrays, const FaceSelection::Faces& hidden) {
  VisibleTriangles visible;
  for (std::size_t i = 0; i < arrays.triangles.size(); ++i) {
    if (hidden[arrays.face_of_triangle[i]]) continue;
    visible.triangles.push_back(arrays.triangles[i]);
    visible.face_of_triangle.push_back(arrays.face_of_triangle[i]);
  }
  return visible;
}

/// The values of the visible faces, of a value per face.
std::vector<grf::Vec3f> visible_values(const std::vector<grf::Vec3f>& values,
                                       const FaceSelection::Faces& hidden) {
  std::vector<grf::Vec3f> visible;
  for (std::size_t face = 0; face < values.size(); ++face) {
    if (hidden.empty() || !hidden[face]) visible.push_back(values[face]);
  }
  return visible;
}

}  // namespace

MeshBuffers::MeshBuffers(Gl& gl, const TriangleArrays& arrays, FaceSelection::Faces hidden)
    : gl_(gl),
      hidden_(std::move(hidden)),
      triangle_count_(arrays.triangles.size()),
      vertex_count_(arrays.positions.size()),
      face_of_triangle_(gl, GL_R32UI),
      shaded_(gl, GlKind::VertexArray),
      edged_(gl, GlKind::VertexArray),
      faces_(gl, GlKind::VertexArray) {
  const auto upload = [this]<class T>(const std::vector<T>& values) {
    return values.empty() ? nullptr : buffer_of(GL_ARRAY_BUFFER, values.data(), values.size() * sizeof(T));
  };
  gl_.glBindVertexArray(shaded_.name());
  positions_ = upload(arrays.positions);
  normals_ = upload(arrays.normals);
  colours_ = upload(arrays.colours);
  irradiance_ = upload(arrays.irradiance);
  uvs_ = upload(arrays.uvs);
  if (hidden_.empty()) {
    triangles_ = upload(arrays.triangles);
    face_of_triangle_.upload(std::span(arrays.face_of_triangle));
  } else {
    const VisibleTriangles visible = visible_triangles(arrays, hidden_);
    triangle_count_ = visible.triangles.size();
    triangles_ = upload(visible.triangles);
    face_of_triangle_.upload(std::span(visible.face_of_triangle));
  }
  attribute(0, positions_.get(), 3);
  attribute(1, normals_.get(), 4);
  if (triangles_) gl_.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_->name());
  gl_.glBindVertexArray(0);
}

std::unique_ptr<GlObject> MeshBuffers::buffer_of(GLenum target, const void* data, std::size_t bytes) {
  auto buffer = std::make_unique<GlObject>(gl_, GlKind::Buffer);
  gl_.glBindBuffer(target, buffer->name());
  gl_.glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  return buffer;
}

/// Sets an attribute of the bound vertex array; the constant of an attribute without buffer is not part of
/// that.
void MeshBuffers::attribute(GLuint index, const GlObject* buffer, int components, float constant) {
  if (buffer == nullptr) {
    gl_.glDisableVertexAttribArray(index);
    QOpenGLContext::currentContext()->functions()->glVertexAttrib4f(index, constant, constant, constant,
                                                                    constant);
    return;
  }
  gl_.glBindBuffer(GL_ARRAY_BUFFER, buffer->name());
  gl_.glEnableVertexAttribArray(index);
  gl_.glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void MeshBuffers::set_edges(const MeshGeometry& geometry) {
  const std::vector<MeshGeometry::Edge> edges = geometry.edges(hidden_);
  gl_.glBindVertexArray(edged_.name());
  attribute(0, positions_.get(), 3);
  edges_ = buffer_of(GL_ELEMENT_ARRAY_BUFFER, edges.data(), edges.size() * sizeof(MeshGeometry::Edge));
  edge_count_ = edges.size();
  gl_.glBindVertexArray(0);
}

void MeshBuffers::set_face_normals(const MeshGeometry& geometry) {
  gl_.glBindVertexArray(faces_.name());
  const std::vector<grf::Vec3f> centres = visible_values(geometry.centres(), hidden_);
  face_count_ = centres.size();
  const std::size_t bytes = face_count_ * sizeof(grf::Vec3f);
  face_centres_ = buffer_of(GL_ARRAY_BUFFER, centres.data(), bytes);
  face_normals_ = buffer_of(GL_ARRAY_BUFFER, visible_values(geometry.normals(), hidden_).data(), bytes);
  attribute(0, face_centres_.get(), 3);
  attribute(1, face_normals_.get(), 3);
  gl_.glBindVertexArray(0);
}

void MeshBuffers::draw_triangles(std::size_t first, std::size_t count, VertexValue value) {
  face_of_triangle_.bind(0);
  const bool is_colour = value == VertexValue::Colour;
  gl_.glBindVertexArray(shaded_.name());
  attribute(2, (is_colour ? colours_ : irradiance_).get(), 4, is_colour ? 1 : 0);
  attribute(3, uvs_.get(), 2);
  gl_.glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                     gl_offset(first * sizeof(TriangleArrays::Triangle)));
}

void MeshBuffers::draw_edges(std::size_t first, std::size_t count) {
  gl_.glBindVertexArray(edged_.name());
  gl_.glDrawElements(GL_LINES, static_cast<GLsizei>(2 * count), GL_UNSIGNED_INT,
                     gl_offset(first * sizeof(MeshGeometry::Edge)));
}

void MeshBuffers::draw_vertices() {
  gl_.glBindVertexArray(shaded_.name());
  if (hidden_.empty()) return gl_.glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(vertex_count_));
  gl_.glDrawElements(GL_POINTS, static_cast<GLsizei>(3 * triangle_count_), GL_UNSIGNED_INT, gl_offset(0));
}

void MeshBuffers::draw_faces_as_points() {
  gl_.glBindVertexArray(faces_.name());
  gl_.glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(face_count_));
}

}  // namespace editor
