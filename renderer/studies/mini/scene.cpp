#include "renderer/studies/mini/scene.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <system_error>

#include "grf/read.h"
#include "grf/relocate.h"
#include "grf/summary.h"
#include "renderer/image/image.h"
#include "renderer/options/op_file.h"
#include "samples/shapes/shape.h"

namespace studies {
namespace {

using reflectance::boolean_parameter;
using reflectance::number_parameter;
using reflectance::whole;
using reflectance::word_parameter;

constexpr float Any = std::numeric_limits<float>::max();
constexpr int ShapeTriangles = 20'000;
constexpr std::size_t ObjectBlock = 1;  // of a built-in scene; the floor is the first one
constexpr float MinimumSize = 1e-30F;   // of a model, so that a point has a scale, too

enum class FileKind { Scene, Options, Environment, Model };
constexpr std::size_t FileKinds = 4;

FileKind kind_of(const ToolState::File& file) {
  const auto is_one_of = [&](std::initializer_list<std::string_view> extensions) {
    return std::ranges::any_of(extensions,
                               [&](std::string_view each) { return image::has_extension(file.path, each); });
  };
  if (is_one_of({"grf", "igrf"})) return FileKind::Scene;
  if (is_one_of({"op"})) return FileKind::Options;
  return is_one_of({"exr", "hdr", "pic", "pfm", "png", "jpg", "jpeg", "tga", "webp"}) ? FileKind::Environment
                                                                                      : FileKind::Model;
}

/// The files of a state by their kinds; empty for none.
class MiniFiles {
 public:
  MiniFiles(const ToolState& state, grf::Diagnostics& diagnostics) {
    for (const ToolState::File& file : state.files) {
      ToolState::File& known = files_[static_cast<std::size_t>(kind_of(file))];
      if (!known.path.empty())
        diagnostics.error(file.location, "found a second file of this kind: " + file.path);
      known = file;
    }
  }
  const ToolState::File& operator[](FileKind kind) const { return files_[static_cast<std::size_t>(kind)]; }
  bool has(FileKind kind) const { return !(*this)[kind].path.empty(); }

 private:
  std::array<ToolState::File, FileKinds> files_;
};

grf::Block block_of(grf::MeshDraft&& draft) {
  grf::Block block;
  block.content = grf::Shared<grf::Mesh>(grf::Mesh(std::move(draft)));
  return block;
}

grf::BrdfModel diffuse(float kd) {
  grf::BrdfModel model;
  model.keyword = "diffuse";
  model.arguments.push_back({"kd", kd, {}});
  return model;
}

/// A floor of tiles in two shades, which show what the shape reflects.
grf::MeshDraft floor() {
  constexpr int Tiles = 12;
  constexpr float Side = 1;
  grf::MeshDraft mesh;
  mesh.name = "floor";
  mesh.surfaces.resize(2);
  mesh.surfaces[0].brdf = diffuse(0.55F);
  mesh.surfaces[1].brdf = diffuse(0.25F);
  for (int z = 0; z <= Tiles; ++z) {
    for (int x = 0; x <= Tiles; ++x)
      mesh.positions.emplace_back(Side * static_cast<float>(x - Tiles / 2), 0,
                                  Side * static_cast<float>(z - Tiles / 2));
  }
  const auto vertex = [](int x, int z) { return static_cast<std::uint32_t>(z * (Tiles + 1) + x); };
  for (int z = 0; z < Tiles; ++z) {
    for (int x = 0; x < Tiles; ++x) {
      const std::array corners = {vertex(x, z), vertex(x, z + 1), vertex(x + 1, z + 1), vertex(x + 1, z)};
      mesh.add_face(corners, static_cast<std::uint32_t>((x + z) % 2));
    }
  }
  return mesh;
}

/// A plane that leans back, so that the eye sees it and the light at grazing angles, too.
grf::MeshDraft leaning_plane() {
  grf::MeshDraft mesh;
  mesh.positions = {{-1.2F, 0.02F, 0.9F}, {1.2F, 0.02F, 0.9F}, {1.2F, 1.6F, -0.9F}, {-1.2F, 1.6F, -0.9F}};
  mesh.add_face(std::array{0U, 1U, 2U, 3U}, 0);
  return mesh;
}

grf::MeshDraft shape_of(int shape) {
  switch (shape) {
    case MiniRenderSettings::Plane:
      return leaning_plane();
    case MiniRenderSettings::Jug:
      return grf::MeshDraft(shape::jug(ShapeTriangles));
    case MiniRenderSettings::Dragon:
      return grf::MeshDraft(shape::dragon(ShapeTriangles));
    case MiniRenderSettings::Knot:
      return grf::MeshDraft(shape::knot(ShapeTriangles));
    default:
      return grf::MeshDraft(shape::sphere(ShapeTriangles));
  }
}

/// Stands a model on the floor, with a longest side of 2 as the shapes have.
grf::Block placed(grf::Scene model) {
  const grf::Box3f bounds = grf::summarize(model).bounds;
  const grf::Vec3f size = bounds.size();
  const grf::Vec3f foot(bounds.center().x, bounds.min.y, bounds.center().z);
  grf::Transform transform;
  transform.steps = {
      {grf::TransformStep::Kind::Translation, -foot},
      {grf::TransformStep::Kind::Scale, grf::Vec3f(2 / std::max({size.x, size.y, size.z, MinimumSize}))}};
  transform.body = std::move(model.contents);
  grf::Block block;
  block.content = std::move(transform);
  return block;
}

/// Makes a floor with an object on it; the light is that of the environment if there is one.
grf::Scene scene_of(grf::Block object, bool has_environment) {
  grf::Scene scene;
  scene.contents.blocks.push_back(block_of(floor()));
  scene.contents.blocks.push_back(std::move(object));
  if (has_environment) return scene;
  grf::Block light;
  light.content =
      grf::AreaLight{{-2.6F, 4.2F, 2.2F}, {0, 0, -1.6F}, {1.4F, 0.8F, 0}, grf::Colour(22, 21, 20)};
  scene.contents.blocks.push_back(std::move(light));
  return scene;
}

/// Calls a function for the surfaces of all meshes in these blocks and those in them.
template <class Edit>
void edit_surfaces(grf::BlockList& list, const Edit& edit) {
  const auto edit_mesh = [&](grf::Shared<grf::Mesh>& mesh) {
    for (grf::Surface& surface : mesh.edit().surfaces) edit(surface);
  };
  for (grf::Block& block : list.blocks) {
    if (auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&block.content)) edit_mesh(*mesh);
    if (auto* transform = std::get_if<grf::Transform>(&block.content)) edit_surfaces(transform->body, edit);
    if (auto* scope = std::get_if<grf::DefinitionScope>(&block.content)) {
      for (grf::Definition& definition : scope->definitions) {
        if (auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body)) edit_mesh(*mesh);
      }
      edit_surfaces(scope->body, edit);
    }
  }
}

/// Returns the object of the state: a shape, or a model without its materials. Nothing after an error.
std::optional<grf::Block> object_of(const MiniRenderSettings& settings, const MiniFiles& files,
                                    const ToolState& state, const StudyContext& context,
                                    grf::Diagnostics& diagnostics) {
  if (settings.shape != MiniRenderSettings::Model) return block_of(shape_of(settings.shape));
  if (!files.has(FileKind::Model)) {
    diagnostics.error(state.settings.location, "no model is open: open one, or name it as 'file NAME.obj'");
    return std::nullopt;
  }
  auto model = read_model(files[FileKind::Model], context, diagnostics);
  if (!model) return std::nullopt;
  edit_surfaces(model->contents, [](grf::Surface& surface) { surface = {}; });
  return placed(std::move(*model));
}

}  // namespace

reflectance::ModelTable<MiniRenderSettings> MiniRenderSettings::table() {
  using Self = MiniRenderSettings;
  using grf::ParameterScale;
  return {.keyword = "minibpt",
          .title = "Mini bpt",
          .parameters =
              {number_parameter(&Self::viewer_x, "viewer_x", -Any, Any, "x of the eye (BPT_Viewer)"),
               number_parameter(&Self::viewer_y, "viewer_y", -Any, Any, "y of the eye, upwards"),
               number_parameter(&Self::viewer_z, "viewer_z", -Any, Any, "z of the eye"),
               number_parameter(&Self::vlook_x, "vlook_x", -Any, Any, "x of the point looked at (BPT_VLook)"),
               number_parameter(&Self::vlook_y, "vlook_y", -Any, Any, "y of the point looked at"),
               number_parameter(&Self::vlook_z, "vlook_z", -Any, Any, "z of the point looked at"),
               word_parameter(&Self::shape, "shape", {"sphere", "plane", "jug", "dragon", "knot", "model"},
                              "the shape on the floor, unless a scene is open; `model` is that of "
                              "the file"),
               boolean_parameter(&Self::replace, "replace",
                                 "BRDF A replaces those of all faces of the open scene"),
               word_parameter(&Self::compare, "compare", {"nothing", "brdfs", "schemes"},
                              "what B has instead of A beside it, in equal time"),
               whole(number_parameter(&Self::samples, "samples", 1, 65536, "samples per pixel (BPT_Samples)",
                                      ParameterScale::Logarithmic)),
               whole(number_parameter(&Self::width, "width", 32, 4096, "width of the image in pixels",
                                      ParameterScale::Logarithmic)),
               whole(number_parameter(&Self::depth, "depth", 1, 100, "the most bounces of a path (BPT_Depth)",
                                      ParameterScale::Logarithmic)),
               whole(number_parameter(&Self::seed, "seed", 0, 1e6F, "seed of the random numbers"))},
          .description =
              "Renders a BRDF on a shape, or a scene with its options and environment map, and compares two "
              "BRDFs or sampling schemes in equal time."};
}

std::optional<MiniScene> mini_scene(const ToolState& state, const MiniRenderSettings& settings,
                                    const StudyContext& context, grf::Diagnostics& diagnostics) {
  const MiniFiles files(state, diagnostics);
  MiniScene result;
  if (files.has(FileKind::Options)) {
    auto options = options::read_op_file(files[FileKind::Options].path, diagnostics);
    if (!options) return std::nullopt;
    result.options = std::move(*options);
  } else if (!files.has(FileKind::Scene)) {
    result.options.background = grf::Vec3f(0.16F, 0.18F, 0.22F);
    result.options.field_of_view = 34;
  }
  if (files.has(FileKind::Environment)) result.options.environment = files[FileKind::Environment].path;
  const std::string path = files.has(FileKind::Scene) ? files[FileKind::Scene].path : result.options.scene;
  result.is_opened = !path.empty();
  if (result.is_opened) {
    const auto scene = grf::read(path, diagnostics);
    if (!scene) return std::nullopt;
    result.scene = grf::with_absolute_names(*scene, path);
  } else {
    auto object = object_of(settings, files, state, context, diagnostics);
    if (!object) return std::nullopt;
    result.scene = scene_of(std::move(*object), !result.options.environment.empty());
  }
  return diagnostics.has_errors() ? std::nullopt : std::optional(std::move(result));
}

void assign(const grf::BrdfModel& brdf, const grf::PdfModel& pdf,
            const std::vector<grf::Definition>& definitions, MiniScene& scene) {
  const auto edit = [&](grf::Surface& surface) {
    if (surface.emission) return;
    surface.brdf = brdf;
    surface.pdf = pdf;
  };
  grf::BlockList& contents = scene.scene.contents;
  if (scene.is_opened) {
    edit_surfaces(contents, edit);
  } else {
    grf::BlockList object;
    object.blocks.push_back(std::move(contents.blocks[ObjectBlock]));
    edit_surfaces(object, edit);
    contents.blocks[ObjectBlock] = std::move(object.blocks.front());
  }
  // The terms of a `combine` are in scope everywhere.
  if (definitions.empty()) return;
  grf::DefinitionScope scope{definitions, std::move(contents)};
  contents = {};
  contents.blocks.push_back({std::move(scope), {}, {}});
}

const ToolState::File* model_of(const ToolState& state) {
  if (reflectance::make<MiniRenderSettings>(state.settings).shape != MiniRenderSettings::Model)
    return nullptr;
  const auto has_kind = [](FileKind kind) {
    return [kind](const ToolState::File& file) { return kind_of(file) == kind; };
  };
  if (std::ranges::any_of(state.files, has_kind(FileKind::Scene))) return nullptr;
  const auto found = std::ranges::find_if(state.files, has_kind(FileKind::Model));
  return found != state.files.end() ? &*found : nullptr;
}

void show_opened_files(ToolState& state, grf::Diagnostics& diagnostics) {
  std::vector<ToolState::File> shown;
  const auto forget = [&](FileKind kind) {
    std::erase_if(shown, [&](const ToolState::File& file) { return kind_of(file) == kind; });
  };
  for (const ToolState::File& file : state.files) {
    const FileKind kind = kind_of(file);
    forget(kind);
    const bool is_subject = kind == FileKind::Scene || kind == FileKind::Model;
    if (is_subject) {
      // The options are those of another scene.
      for (const FileKind other : {FileKind::Scene, FileKind::Model, FileKind::Options}) forget(other);
    }
    if (kind == FileKind::Model) set_value(state.settings, "shape", grf::Word{"model"});
    shown.push_back(file);
  }
  state.files = std::move(shown);
  const MiniFiles files(state, diagnostics);
  ToolState::File options_file = files[FileKind::Options];
  std::error_code error;
  if (options_file.path.empty() && files.has(FileKind::Scene)) {
    const std::string beside =
        std::filesystem::path(files[FileKind::Scene].path).replace_extension(".op").string();
    if (!std::filesystem::exists(beside, error)) return;
    options_file = {beside, {}};
    state.files.push_back(options_file);
  }
  if (options_file.path.empty()) return;
  const auto options = options::read_op_file(options_file.path, diagnostics);
  if (!options) return;
  set_value(state.settings, "width", static_cast<float>(options->size.width));
  set_value(state.settings, "depth", static_cast<float>(options->depth));
  const auto set_point = [&](const std::optional<grf::Vec3f>& point,
                             const std::array<const char*, 3>& names) {
    for (std::size_t i = 0; point && i < names.size(); ++i)
      set_value(state.settings, names[i], (*point)[static_cast<int>(i)]);
  };
  set_point(options->eye, {"viewer_x", "viewer_y", "viewer_z"});
  set_point(options->target, {"vlook_x", "vlook_y", "vlook_z"});
}

}  // namespace studies
