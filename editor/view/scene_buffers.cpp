#include "editor/view/scene_buffers.h"

#include <algorithm>
#include <utility>

namespace editor {
namespace {

/// Buffers of this key: those of before, or new ones.
template <class Key, class Make>
MeshBuffers* keep_or_make(std::map<Key, std::unique_ptr<MeshBuffers>>& before,
                          std::map<Key, std::unique_ptr<MeshBuffers>>& now, const Key& key,
                          const Make& make) {
  auto& entry = now[key];
  if (entry == nullptr) {
    const auto found = before.find(key);
    entry = found != before.end() ? std::move(found->second) : make();
  }
  return entry.get();
}

}  // namespace

SceneBuffers::SceneBuffers(Gl& gl)
    : gl_(gl),
      awaited_texture_(squares(qRgb(255, 255, 255), qRgb(255, 255, 255))),
      selected_(gl, GL_R8UI),
      surface_of_face_(gl, GL_R32UI),
      surfaces_(gl, GL_RGBA32F),
      terms_(gl, GL_RGBA32F) {}

void SceneBuffers::set_objects(const SceneObjects& objects) {
  tables_ = tables_of(objects);
  instances_.clear();
  for (const MeshInstance& instance : objects.instances) {
    instances_.push_back({instance.mesh, instance.to_world});
  }
  surface_of_face_.upload(std::span<const std::uint32_t>(tables_.surface_of_face));
  surfaces_.upload(std::span<const Imath::V4f>(tables_.surfaces));
  terms_.upload(std::span<const Imath::V4f>(tables_.terms));
  meshes_.assign(objects.meshes.size(), nullptr);
  quick_meshes_ = meshes_;
  geometries_.assign(objects.meshes.size(), nullptr);
  std::erase_if(textures_, [this](const auto& entry) {
    return std::find(tables_.textures.begin(), tables_.textures.end(), entry.first) == tables_.textures.end();
  });
}

bool SceneBuffers::set_shapes(const std::vector<MeshShape>& shapes) {
  const std::vector<MeshBuffers*> meshes_before = meshes_;
  auto before = std::exchange(geometry_buffers_, {});
  auto quick_before = std::exchange(quick_buffers_, {});
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    geometries_[i] = shapes[i].geometry;
    if (geometries_[i] == nullptr) continue;
    meshes_[i] = keep_or_make(before, geometry_buffers_, geometries_[i],
                              [&] { return std::make_unique<MeshBuffers>(gl_, geometries_[i]->arrays()); });
    quick_meshes_[i] = meshes_[i];
    const auto& quick = shapes[i].quick;
    if (quick == nullptr) continue;
    quick_meshes_[i] = keep_or_make(quick_before, quick_buffers_, quick,
                                    [&] { return std::make_unique<MeshBuffers>(gl_, *quick); });
  }
  return meshes_ != meshes_before;
}

bool SceneBuffers::has_stand_ins() const { return meshes_ != quick_meshes_; }

void SceneBuffers::set_selection(const FaceSelection& selection) {
  std::vector<std::uint8_t> flags(tables_.surface_of_face.size());
  auto flag = flags.begin();
  for (std::uint32_t mesh = 0; mesh < selection.mesh_count(); ++mesh) {
    const std::vector<bool>& faces = selection.of_mesh(mesh);
    flag = std::copy(faces.begin(), faces.end(), flag);
  }
  has_selection_ = !selection.empty();
  selected_.upload(std::span<const std::uint8_t>(flags));
}

void SceneBuffers::bind_tables(GLuint first_unit) const {
  selected_.bind(first_unit);
  surface_of_face_.bind(first_unit + 1);
  surfaces_.bind(first_unit + 2);
  terms_.bind(first_unit + 3);
}

void SceneBuffers::set_texture(const std::string& path, const transport::Image* image) {
  auto& texture = textures_[path];
  if (texture != nullptr) return;
  texture = image != nullptr ? texture_of(*image) : squares(qRgb(70, 70, 76), qRgb(215, 120, 205));
}

void SceneBuffers::bind_texture(std::size_t number, GLuint unit) {
  const auto found = textures_.find(tables_.textures[number]);
  (found != textures_.end() ? *found->second : *awaited_texture_).bind(unit);
}

std::unique_ptr<QOpenGLTexture> SceneBuffers::texture_of(const transport::Image& image) const {
  auto texture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2D);
  texture->setSize(image.width, image.height);
  texture->setFormat(QOpenGLTexture::RGB16F);
  texture->setMipLevels(texture->maximumMipLevels());
  texture->allocateStorage(QOpenGLTexture::RGB, QOpenGLTexture::Float32);
  // OpenGL has rows from the bottom.
  std::vector<reflectance::Rgb> rows(image.pixels.size());
  const auto width = static_cast<std::ptrdiff_t>(image.width);
  for (std::ptrdiff_t y = 0; y < image.height; ++y) {
    std::copy_n(image.pixels.begin() + y * width, width, rows.begin() + (image.height - 1 - y) * width);
  }
  QOpenGLPixelTransferOptions options;
  options.setAlignment(1);
  texture->setData(0, QOpenGLTexture::RGB, QOpenGLTexture::Float32, rows.data(), &options);
  texture->generateMipMaps();
  texture->setMinMagFilters(QOpenGLTexture::LinearMipMapLinear, QOpenGLTexture::Linear);
  texture->setWrapMode(QOpenGLTexture::Repeat);
  return texture;
}

std::unique_ptr<QOpenGLTexture> SceneBuffers::squares(QRgb first, QRgb second) const {
  constexpr int Size = 8;
  QImage image(Size, Size, QImage::Format_RGBA8888);
  for (int y = 0; y < Size; ++y) {
    for (int x = 0; x < Size; ++x) image.setPixel(x, y, (x + y) % 2 == 0 ? first : second);
  }
  auto texture = std::make_unique<QOpenGLTexture>(image, QOpenGLTexture::GenerateMipMaps);
  texture->setMinMagFilters(QOpenGLTexture::LinearMipMapLinear, QOpenGLTexture::Nearest);
  texture->setWrapMode(QOpenGLTexture::Repeat);
  return texture;
}

}  // namespace editor
