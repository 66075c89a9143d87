#include "editor/view/scene_buffers.h"

#include <algorithm>
#include <utility>

#include "renderer/transport/scene/texture.h"

namespace editor {

SceneBuffers::SceneBuffers(Gl& gl, const GraphicsLimits& limits)
    : gl_(gl),
      limits_(limits),
      awaited_texture_(squares(qRgb(255, 255, 255), qRgb(255, 255, 255))),
      selected_table_(gl, GL_R8UI),
      face_table_(gl, GL_R32UI),
      surface_table_(gl, GL_RGBA32F),
      term_table_(gl, GL_RGBA32F) {}

bool SceneBuffers::set_objects(std::shared_ptr<const SceneObjects> objects) {
  const auto before = std::exchange(objects_, std::move(objects));
  const bool has_other_faces = !have_same_faces(*before, *objects_);
  if (has_other_faces) {
    faces_ = face_tables_of(*objects_);
    face_table_.upload(std::span<const std::uint32_t>(faces_.surface_of_face));
  }
  surfaces_ = surface_tables_of(*objects_, layered_brdfs_);
  surface_table_.upload(std::span<const Imath::V4f>(surfaces_.surfaces));
  term_table_.upload(std::span<const Imath::V4f>(surfaces_.terms));
  if (!before->instances.shares(objects_->instances)) {
    meshes_.assign(objects_->meshes.size(), nullptr);
    proxy_meshes_ = meshes_;
    geometries_.assign(objects_->meshes.size(), nullptr);
  }
  std::erase_if(textures_, [this](const auto& entry) {
    const auto& named = surfaces_.textures;
    const bool is_named = std::ranges::find(named, entry.first) != named.end();
    if (!is_named) reduced_textures_.erase(entry.first);
    return !is_named;
  });
  return has_other_faces;
}

/// Whether the table entries of a mesh are within the driver's limits.
bool SceneBuffers::fits(std::size_t mesh) const {
  const grf::Mesh& shown = *objects_->meshes[mesh].mesh;
  return faces_.first_face[mesh] + shown.face_count() <= limits_.buffer_texels &&
         surfaces_.ends[mesh] <= limits_.buffer_texels &&
         shown.geometry->triangle_count() <= limits_.buffer_texels;
}

bool SceneBuffers::set_shapes(const std::vector<MeshShape>& shapes, const FaceSelection& hidden) {
  const std::vector<MeshBuffers*> meshes_before = meshes_;
  auto before = std::exchange(buffers_, {});
  const auto buffers_of = [&](std::size_t mesh, const std::shared_ptr<const TriangleArrays>& arrays) {
    const auto number = static_cast<std::uint32_t>(mesh);
    const BuffersKey key(arrays, hidden.count(number) > 0 ? hidden.of_mesh(number) : FaceSelection::Faces());
    auto& buffers = buffers_[key];
    if (buffers == nullptr) buffers = std::move(before[key]);
    if (buffers == nullptr) buffers = std::make_unique<MeshBuffers>(gl_, *arrays, key.second);
    return buffers.get();
  };
  left_out_ = 0;
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const auto& geometry = geometries_[i] = shapes[i].geometry;
    const bool is_left_out = !fits(i);
    if (is_left_out) ++left_out_;
    const bool is_shown = geometry != nullptr && !is_left_out;
    meshes_[i] = is_shown ? buffers_of(i, {geometry, &geometry->arrays()}) : nullptr;
    proxy_meshes_[i] = is_shown && shapes[i].proxy != nullptr ? buffers_of(i, shapes[i].proxy) : meshes_[i];
  }
  return meshes_ != meshes_before;
}

bool SceneBuffers::has_proxies() const { return meshes_ != proxy_meshes_; }

void SceneBuffers::set_selection(const FaceSelection& selection) {
  std::vector<std::uint8_t> flags(faces_.surface_of_face.size());
  for (const std::uint32_t mesh : selection.meshes()) {
    selection.for_each_face(mesh, [&](std::size_t face) { flags[faces_.first_face[mesh] + face] = 1; });
  }
  has_selection_ = !selection.empty();
  selected_table_.upload(std::span<const std::uint8_t>(flags));
}

void SceneBuffers::bind_tables(GLuint first_unit) const {
  selected_table_.bind(first_unit);
  face_table_.bind(first_unit + 1);
  surface_table_.bind(first_unit + 2);
  term_table_.bind(first_unit + 3);
}

void SceneBuffers::set_texture(const std::string& path, const image::Image* image) {
  auto& texture = textures_[path];
  if (texture != nullptr) return;
  if (image == nullptr) {
    texture = squares(qRgb(70, 70, 76), qRgb(215, 120, 205));
    return;
  }
  image::Image smaller;
  while (std::max(image->width, image->height) > limits_.texture_side) {
    smaller = transport::halved(*image);
    image = &smaller;
    reduced_textures_.insert(path);
  }
  texture = texture_of(*image);
}

void SceneBuffers::forget_texture(const std::string& path) {
  textures_.erase(path);
  reduced_textures_.erase(path);
}

void SceneBuffers::bind_texture(std::size_t number, GLuint unit) {
  const auto found = textures_.find(surfaces_.textures[number]);
  (found != textures_.end() ? *found->second : *awaited_texture_).bind(unit);
}

std::unique_ptr<QOpenGLTexture> SceneBuffers::texture_of(const image::Image& image) const {
  auto texture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2D);
  texture->setSize(image.width, image.height);
  const bool has_alpha = !image.alpha.empty();
  const auto layout = has_alpha ? QOpenGLTexture::RGBA : QOpenGLTexture::RGB;
  texture->setFormat(has_alpha ? QOpenGLTexture::RGBA16F : QOpenGLTexture::RGB16F);
  texture->setMipLevels(texture->maximumMipLevels());
  texture->allocateStorage(layout, QOpenGLTexture::Float32);
  // OpenGL's rows start at the bottom.
  std::vector<float> rows;
  rows.reserve((has_alpha ? 4 : 3) * image.pixels.size());
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t y = static_cast<std::size_t>(image.height); y-- > 0;) {
    for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
      const grf::Colour& pixel = image.pixels[i];
      rows.insert(rows.end(), {pixel.x, pixel.y, pixel.z});
      if (has_alpha) rows.push_back(image.alpha[i]);
    }
  }
  QOpenGLPixelTransferOptions options;
  options.setAlignment(1);
  texture->setData(0, layout, QOpenGLTexture::Float32, rows.data(), &options);
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
