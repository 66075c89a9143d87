#include "converters/gltf/gltf_reader.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "converters/gltf/gltf_accessors.h"
#include "converters/gltf/gltf_cameras.h"
#include "converters/gltf/gltf_grf.h"
#include "converters/gltf/gltf_images.h"
#include "converters/gltf/gltf_lights.h"
#include "converters/gltf/gltf_materials.h"
#include "converters/gltf/gltf_meshes.h"
#include "converters/gltf/gltf_nodes.h"
#include "converters/gltf/gltf_variants.h"
#include "converters/scene_building.h"
#include "converters/text_encoding.h"
#include "converters/wording.h"
#include "grf/vertex_tree.h"
#include "grf/visit.h"
#include "grf/write.h"

namespace convert {
namespace {

/// The key of instances: nodes with the same mesh in the same pose.
struct Form {
  int mesh = -1;
  std::vector<double> weights;

  auto operator<=>(const Form&) const = default;
};

/// A mesh in a pose, which becomes a definition if several nodes use it.
struct Shape {
  std::size_t uses = 0;
  std::string name;  ///< name of the definition; empty: its mesh has no faces
};

class SceneReader {
 public:
  SceneReader(const GltfFile& file, GltfAccessors& accessors, GltfImages& images,
              grf::Diagnostics& diagnostics)
      : file_(file),
        location_(grf::whole_file(file.path)),
        accessors_(accessors),
        diagnostics_(diagnostics),
        materials_(file, images, names_),
        nodes_(file, accessors),
        lights_(file, losses_) {}

  /// Reads the scene and its cameras; nothing after an error.
  std::optional<Import> run() {
    if (!nodes_.load()) return std::nullopt;
    for (const int root : nodes_.roots()) count_uses(root);
    std::vector<grf::Block> blocks;
    for (const int root : nodes_.roots()) {
      auto some = read_node(root);
      if (!some) return std::nullopt;
      std::move(some->begin(), some->end(), std::back_inserter(blocks));
    }
    std::move(skinned_.begin(), skinned_.end(), std::back_inserter(blocks));
    if (blocks.empty()) {
      report();
      return accessors_.fail("the file has no faces, and only faces can be imported");
    }
    std::vector<grf::Definition> definitions = materials_.definitions();
    std::move(shared_.begin(), shared_.end(), std::back_inserter(definitions));
    Import import;
    if (!lights_.empty() || !file_.model.cameras.empty()) {
      const grf::Box3d bounds = bounds_of(scene_of(definitions, blocks, location_));
      import.cameras = read_cameras(file_, nodes_, bounds, losses_);
      auto lights = lights_.blocks(bounds, location_);
      std::move(lights.begin(), lights.end(), std::back_inserter(blocks));
    }
    report();
    import.scene = scene_of(std::move(definitions), std::move(blocks), location_);
    return import;
  }

 private:
  const tinygltf::Node& node(int index) const { return file_.model.nodes[static_cast<std::size_t>(index)]; }
  const tinygltf::Mesh* mesh_of(const tinygltf::Node& node) const {
    const auto index = static_cast<std::size_t>(node.mesh);
    return node.mesh < 0 || index >= file_.model.meshes.size() ? nullptr : &file_.model.meshes[index];
  }

  // Weights are ignored for a mesh without morph targets.
  Form form_of(const tinygltf::Node& node) const {
    const tinygltf::Mesh* mesh = mesh_of(node);
    if (mesh == nullptr) return {node.mesh, {}};
    const bool has_targets = std::any_of(mesh->primitives.begin(), mesh->primitives.end(),
                                         [](const auto& primitive) { return !primitive.targets.empty(); });
    if (!has_targets) return {node.mesh, {}};
    return {node.mesh, node.weights.empty() ? mesh->weights : node.weights};
  }

  void count_uses(int index) {
    const tinygltf::Node& source = node(index);
    if (source.mesh >= 0 && source.skin < 0) ++shapes_[form_of(source)].uses;
    if (source.mesh >= 0) meshes_placed_.insert(source.mesh);
    if (GltfLights::has_light(source)) lights_.take(source, nodes_.to_scene(index));
    for (const int child : source.children) count_uses(child);
  }

  std::optional<std::vector<grf::Block>> read_node(int index) {
    const tinygltf::Node& source = node(index);
    std::vector<grf::Block> blocks;
    if (source.mesh >= 0 && !read_mesh_of(source, blocks)) return std::nullopt;
    for (const int child : source.children) {
      auto some = read_node(child);
      if (!some) return std::nullopt;
      std::move(some->begin(), some->end(), std::back_inserter(blocks));
    }
    const grf::Matrix44d& matrix = nodes_.to_parent(index);
    if (!blocks.empty() && !has_inverse(matrix)) {
      losses_.add(Loss::SingularTransform, blocks.size());
      return std::vector<grf::Block>();
    }
    blocks = placed(std::move(blocks), matrix, location_);
    if (blocks.size() == 1 && std::holds_alternative<grf::Transform>(blocks[0].content) &&
        !source.name.empty() && blocks[0].comments.empty()) {
      blocks[0].comments.before.push_back(" " + on_one_line(source.name));
    }
    return blocks;
  }

  /// The tolerance allows for float rounding.
  static bool has_inverse(const grf::Matrix44d& matrix) {
    const double volume = matrix.determinant();
    if (!std::isfinite(volume) || volume == 0) return false;
    const auto steps = transform_steps(matrix);
    return std::all_of(steps.begin(), steps.end(), [](const grf::TransformStep& step) {
      const grf::Vec3f& v = step.value;
      const bool finite = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
      return finite && (step.kind != grf::TransformStep::Kind::Scale || v.x * v.y * v.z != 0);
    });
  }

  bool read_mesh_of(const tinygltf::Node& source, std::vector<grf::Block>& blocks) {
    const tinygltf::Mesh* mesh = mesh_of(source);
    if (mesh == nullptr) return accessors_.fail(fmt::format("there is no mesh {}", source.mesh)), false;
    Form form = form_of(source);
    if (source.skin >= 0) return read_skinned(source, *mesh, std::move(form));
    Shape& shape = shapes_[form];
    if (shape.uses > 1) return use(*mesh, form, shape, blocks);
    auto read = read_form(*mesh, {form.weights, {}}, source.name);
    if (!read) return false;
    add_block(std::move(*read), blocks);
    return true;
  }

  // Section 3.7.3.1: joints place a skinned mesh, and the transforms of its node and of ancestors are
  // ignored.
  bool read_skinned(const tinygltf::Node& source, const tinygltf::Mesh& mesh, Form form) {
    auto joints = nodes_.joints(source.skin);
    if (!joints) return false;
    auto read = read_form(mesh, {std::move(form.weights), std::move(*joints)}, source.name);
    if (!read) return false;
    add_block(std::move(*read), skinned_);
    return true;
  }

  bool use(const tinygltf::Mesh& mesh, const Form& form, Shape& shape, std::vector<grf::Block>& blocks) {
    if (!known_.contains(form)) {
      auto read = read_form(mesh, {form.weights, {}}, "");
      if (!read) return false;
      known_.insert(form);
      if (read->face_count() > 0) {
        shape.name =
            names_.take(mesh.name.empty() ? name_of_file(location_.file->path) : on_one_line(mesh.name));
        grf::Definition definition;
        definition.name = shape.name;
        definition.body = grf::Shared<grf::Mesh>(std::move(*read));
        definition.location = location_;
        shared_.push_back(std::move(definition));
      }
    }
    if (shape.name.empty()) return true;
    grf::Block block;
    block.content = grf::Use{{shape.name, location_}};
    block.location = location_;
    blocks.push_back(std::move(block));
    return true;
  }

  std::optional<grf::Mesh> read_form(const tinygltf::Mesh& mesh, const GltfPose& pose,
                                     const std::string& other_name) {
    auto read = read_mesh(mesh, pose, accessors_, materials_, losses_);
    if (read) read->name = on_one_line(mesh.name.empty() ? other_name : mesh.name);
    return read;
  }

  void add_block(grf::Mesh mesh, std::vector<grf::Block>& blocks) {
    if (mesh.face_count() == 0) return;
    grf::Block block;
    block.content = grf::Shared<grf::Mesh>(std::move(mesh));
    block.location = location_;
    blocks.push_back(std::move(block));
  }

  void report() {
    losses_.add(Loss::Animation, file_.model.animations.size());
    materials_.report(location_, diagnostics_);
    losses_.report(location_, diagnostics_);
    if (file_.model.scenes.size() > 1) {
      diagnostics_.warning(location_, fmt::format("{} left out: the file's default scene is read",
                                                  counted(file_.model.scenes.size() - 1, "further scene was",
                                                          "further scenes were")));
    }
    std::vector<std::string> unplaced;
    for (std::size_t i = 0; i < file_.model.meshes.size(); ++i) {
      if (!meshes_placed_.contains(static_cast<int>(i))) unplaced.push_back(file_.model.meshes[i].name);
    }
    if (unplaced.empty()) return;
    diagnostics_.warning(location_,
                         fmt::format("{} left out that no node of the scene uses: {}",
                                     counted(unplaced.size(), "mesh was", "meshes were"), listed(unplaced)));
  }

  const GltfFile& file_;
  grf::SourceLocation location_;
  GltfAccessors& accessors_;
  grf::Diagnostics& diagnostics_;
  DefinitionNames names_;
  GltfMaterials materials_;
  GltfNodes nodes_;
  Losses losses_;
  GltfLights lights_;
  std::map<Form, Shape> shapes_;
  std::set<Form> known_;
  std::set<int> meshes_placed_;
  std::vector<grf::Definition> shared_;
  std::vector<grf::Block> skinned_;
};

std::optional<grf::Scene> scene_in_extras(const GltfFile& file, grf::Diagnostics& diagnostics) {
  grf::Diagnostics problems;
  GltfAccessors accessors(file, problems);
  auto scene = read_grf_extras(file, accessors, problems);
  if (scene) return scene;
  diagnostics.warning(
      grf::whole_file(file.path),
      fmt::format("the GRF scene in the extras cannot be read ({}): the glTF model itself is read",
                  problems.entries().front().message));
  return std::nullopt;
}

/// Reads the cameras of a file whose extras have the scene.
std::vector<options::NamedCamera> cameras_beside(const grf::Scene& scene, const GltfFile& file) {
  if (file.model.cameras.empty()) return {};
  grf::Diagnostics ignored_diagnostics;  // nodes may be deeper than the scene is
  GltfAccessors accessors(file, ignored_diagnostics);
  GltfNodes nodes(file, accessors);
  if (!nodes.load()) return {};
  Losses losses;
  return read_cameras(file, nodes, bounds_of(scene), losses);
}

}  // namespace

std::optional<Import> read_gltf(const std::string& path, const ReadOptions& options,
                                grf::Diagnostics& diagnostics) {
  auto file = load_gltf(path, diagnostics);
  if (!file || !choose_variant(*file, options.variant, diagnostics)) return std::nullopt;
  GltfAccessors accessors(*file, diagnostics);
  GltfImages images(*file, accessors);
  if (!images.load()) return std::nullopt;
  if (file->is_unchanged_grf) {
    if (auto scene = scene_in_extras(*file, diagnostics)) {
      Import import{std::move(*scene), images.take_files(), true};
      import.cameras = cameras_beside(import.scene, *file);
      return import;
    }
  }
  auto import = SceneReader(*file, accessors, images, diagnostics).run();
  if (import) import->files = images.take_files();
  return import;
}

}  // namespace convert
