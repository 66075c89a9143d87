#include "converters/renderers/written_scene.h"

#include <map>
#include <utility>

#include <fmt/format.h>

#include "converters/ply/write_ply.h"
#include "converters/renderers/shape_geometry.h"
#include "grf/relocate.h"
#include "grf/write.h"
#include "renderer/options/op_file.h"

namespace convert {
namespace {

/// Writes the files of one scene.
class SceneFilesWriter {
 public:
  SceneFilesWriter(WrittenScene& written, const RenderTarget& target, Losses& losses,
                   grf::Diagnostics& diagnostics)
      : written_(written),
        target_(target),
        folder_(written.path, target.suffix),
        losses_(losses),
        diagnostics_(diagnostics) {}

  bool write(const RenderScene& scene);

 private:
  bool write_materials(const std::vector<RenderMaterial>& materials);
  bool write_shape(const RenderShape& shape, std::vector<WrittenShape>& written);
  bool write_opacity(const RenderShape& shape, std::size_t faces, WrittenShape& written);
  bool write_surroundings();

  WrittenScene& written_;
  const RenderTarget& target_;
  SceneFolder folder_;
  Losses& losses_;
  grf::Diagnostics& diagnostics_;
  std::map<std::string, std::string> opacity_images_;  ///< by path and opacity
};

bool SceneFilesWriter::write_materials(const std::vector<RenderMaterial>& materials) {
  for (const RenderMaterial& material : materials) {
    const auto written = write_material(material, target_.material, folder_, losses_, diagnostics_);
    if (!written) return false;
    written_.materials.push_back(*written);
  }
  return true;
}

bool SceneFilesWriter::write_shape(const RenderShape& shape, std::vector<WrittenShape>& shapes) {
  const WrittenMaterial& material = written_.materials[shape.material];
  GeometryNeeds needs;
  // The side to which a face emits must not depend on the normals of its vertices.
  needs.normals = !shape.emission;
  needs.uvs = !material.image.empty() || !shape.alpha.empty() || material.is_anisotropic;
  needs.tangents = material.is_anisotropic;
  if (material.has_vertex_colours) needs.vertex_colours = material.reflectance;
  grf::MeshDraft mesh = geometry_of(shape, needs);
  if (mesh.face_count() == 0) return true;
  WrittenShape written;
  written.name = shape.name;
  written.material = shape.material;
  written.emission = shape.emission;
  if (needs.vertex_colours && !target_.has_mesh_attributes) {
    written.image = folder_.add_image("colours", bake_vertex_colours(mesh), diagnostics_);
    if (written.image.empty()) return false;
  }
  if (!write_opacity(shape, mesh.face_count(), written)) return false;
  written.has_normals = !mesh.normals.empty();
  written.has_uvs = !mesh.uvs.empty();
  const SceneFolder::Name name = folder_.next("mesh", "ply", diagnostics_);
  if (name.path.empty() || !write_ply_mesh(std::move(mesh), name.path, diagnostics_)) return false;
  written.mesh = name.in_scene;
  shapes.push_back(std::move(written));
  return true;
}

/// Returns what the alpha of an image makes of a face, as grey.
image::Image opacity_of(image::Image image, const grf::Opacity& opacity) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float alpha = image.alpha.empty() ? 1 : image.alpha[i];
    const bool is_mask = opacity.kind == grf::Opacity::Kind::Mask;
    image.pixels[i] = grf::Colour(is_mask ? (alpha >= opacity.value ? 1.0F : 0.0F) : alpha * opacity.value);
  }
  image.alpha = {};
  return image;
}

bool SceneFilesWriter::write_opacity(const RenderShape& shape, std::size_t faces, WrittenShape& written) {
  if (shape.opacity == grf::Opacity()) return true;
  if (shape.emission && !target_.masks_emission) losses_.add(Loss::Opacity, faces);
  written.opacity = grf::shortest(shape.opacity.value);
  if (shape.alpha.empty()) return true;
  std::string& name = opacity_images_[fmt::format("{} {}", shape.alpha, grf::to_text(shape.opacity))];
  if (name.empty()) {
    auto image = image::read_image(shape.alpha, diagnostics_, {}, image::Alpha::Kept);
    if (image)
      name = folder_.add_image("opacity", opacity_of(*std::move(image), shape.opacity), diagnostics_);
  }
  written.opacity_image = name;
  return !name.empty();
}

bool SceneFilesWriter::write_surroundings() {
  if (written_.view.has_backplate) losses_.add(Loss::Backplate);
  if (!written_.view.surroundings) return true;
  written_.surroundings =
      folder_.add_image("environment", target_.surroundings(*written_.view.surroundings), diagnostics_);
  return !written_.surroundings.empty();
}

bool SceneFilesWriter::write(const RenderScene& scene) {
  if (!write_materials(scene.materials)) return false;
  for (const RenderShape& shape : scene.shapes) {
    if (!write_shape(shape, written_.shapes)) return false;
  }
  for (const std::vector<RenderShape>& object : scene.objects) {
    std::vector<WrittenShape>& written = written_.objects.emplace_back();
    for (const RenderShape& shape : object) {
      if (!write_shape(shape, written)) return false;
    }
  }
  written_.instances = scene.instances;
  return write_surroundings();
}

/// Returns a distance from the eye within which all of the scene is.
double reach_of(const grf::Vec3d& eye, const grf::Box3d& bounds) {
  return (eye - bounds.center()).length() + bounds.size().length() / 2;
}

}  // namespace

std::optional<WrittenScene> write_scene_files(const grf::Scene& scene, const std::string& path,
                                              const std::string& op_file, const RenderTarget& target,
                                              Losses& losses, grf::Diagnostics& diagnostics) {
  std::optional<options::RenderOptions> render_options;
  if (!op_file.empty()) {
    render_options = options::read_op_file(op_file, diagnostics);
    if (!render_options) return std::nullopt;
  }
  const grf::Scene whole = grf::with_absolute_names(scene, path);
  auto parts = render_scene_of(whole, diagnostics);
  if (!parts) return std::nullopt;
  if (parts->shapes.empty() && parts->instances.empty()) {
    diagnostics.error(grf::whole_file(path), "cannot write the file: the scene has no faces");
    return std::nullopt;
  }
  auto view = render_view(render_options, parts->bounds, diagnostics);
  if (!view) return std::nullopt;
  WrittenScene written;
  written.path = path;
  written.view = *std::move(view);
  written.reach = reach_of(written.view.eye, parts->bounds);
  losses = parts->losses;
  if (!SceneFilesWriter(written, target, losses, diagnostics).write(*parts)) return std::nullopt;
  return written;
}

}  // namespace convert
