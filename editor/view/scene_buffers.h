// The GPU holds a scene in buffers.
#pragma once

#include <QImage>
#include <QOpenGLPixelTransferOptions>
#include <QOpenGLTexture>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "editor/document/face_selection.h"
#include "editor/view/geometry_store.h"
#include "editor/view/mesh_buffers.h"
#include "editor/view/surface_tables.h"
#include "renderer/image/image.h"

namespace editor {

class SceneBuffers {
 public:
  SceneBuffers(Gl& gl, const GraphicsLimits& limits);

  /// Uploads the differences from the former objects. Returns whether faces were renumbered or have other
  /// surfaces.
  bool set_objects(std::shared_ptr<const SceneObjects> objects);
  /// Sets the geometry of the meshes and their hidden faces after `set_objects`; buffers of unchanged ones
  /// are kept. Returns whether a mesh changed, and not only its proxy.
  bool set_shapes(const std::vector<MeshShape>& shapes, const FaceSelection& hidden);
  void set_selection(const FaceSelection& selection);
  /// Sets a texture, downscaled to the driver's limit; null if it cannot be read.
  void set_texture(const std::string& path, const image::Image* image);
  /// Drops a texture, so that it can be set again.
  void forget_texture(const std::string& path);

  const std::vector<MeshInstance>& instances() const { return *objects_->instances; }
  const FaceTables& faces() const { return faces_; }
  const SurfaceTables& surfaces() const { return surfaces_; }
  /// Null until the geometry is built, and for meshes that are left out.
  MeshBuffers* mesh(std::uint32_t mesh) const { return meshes_[mesh]; }
  /// The proxy, or the mesh itself.
  MeshBuffers* proxy_mesh(std::uint32_t mesh) const { return proxy_meshes_[mesh]; }
  const MeshGeometry* geometry(std::uint32_t mesh) const { return geometries_[mesh].get(); }
  bool has_proxies() const;
  bool has_selection() const { return has_selection_; }
  /// Textures that were downscaled.
  const std::set<std::string>& reduced_textures() const { return reduced_textures_; }
  /// The number of meshes that are left out, since their face tables would exceed the driver's limit.
  std::size_t left_out() const { return left_out_; }

  /// Binds the tables to texture units from this one on: selected faces, surfaces of faces, surfaces, terms.
  void bind_tables(GLuint first_unit) const;
  /// Binds a texture by its number; a plain one until it is loaded.
  void bind_texture(std::size_t number, GLuint unit);

 private:
  using BuffersKey = std::pair<std::shared_ptr<const TriangleArrays>, FaceSelection::Faces>;

  bool fits(std::size_t mesh) const;
  std::unique_ptr<QOpenGLTexture> texture_of(const image::Image& image) const;
  std::unique_ptr<QOpenGLTexture> squares(QRgb first, QRgb second) const;

  Gl& gl_;
  const GraphicsLimits limits_;
  std::shared_ptr<const SceneObjects> objects_ = std::make_shared<const SceneObjects>();
  FaceTables faces_;
  SurfaceTables surfaces_;
  LayeredBrdfs layered_brdfs_;                                  ///< of `surfaces_`
  std::map<BuffersKey, std::unique_ptr<MeshBuffers>> buffers_;  ///< by geometry and hidden faces
  std::vector<std::shared_ptr<const MeshGeometry>> geometries_;
  std::vector<MeshBuffers*> meshes_;
  std::vector<MeshBuffers*> proxy_meshes_;
  std::map<std::string, std::unique_ptr<QOpenGLTexture>> textures_;
  std::set<std::string> reduced_textures_;
  std::unique_ptr<QOpenGLTexture> awaited_texture_;
  std::size_t left_out_ = 0;
  bool has_selection_ = false;
  BufferTexture selected_table_, face_table_, surface_table_, term_table_;
};

}  // namespace editor
