#include "renderer/studies/mini/scene.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>

#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/relocate.h"
#include "renderer/options/op_file.h"
#include "renderer/transport/image/image.h"
#include "samples/shapes/shape.h"

namespace studies {
namespace {

using reflectance::boolean_parameter;
using reflectance::number_parameter;
using reflectance::word_parameter;

constexpr float Any = std::numeric_limits<float>::max();
constexpr int ShapeTriangles = 20'000;

/// The files of a state by their kinds; empty for none.
struct MiniFiles {
  ToolState::File scene, options, environment;
};

MiniFiles files_of(const ToolState& state, grf::Diagnostics& diagnostics) {
  MiniFiles files;
  for (const ToolState::File& file : state.files) {
    const std::string extension = grf::lower_case(std::filesystem::path(file.path).extension().string());
    ToolState::File& kind = extension == ".grf" || extension == ".igrf" ? files.scene
                            : extension == ".op"                        ? files.options
                                                                        : files.environment;
    if (!kind.path.empty())
      diagnostics.error(file.location, "found a second file of this kind: " + file.path);
    kind = file;
  }
  return files;
}

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

grf::Scene built_in_scene(int shape, bool has_environment) {
  grf::Scene scene;
  scene.contents.blocks.push_back(block_of(floor()));
  grf::MeshDraft object = shape_of(shape);
  object.name = "shape";
  scene.contents.blocks.push_back(block_of(std::move(object)));
  if (has_environment) return scene;
  grf::Block light;
  light.content =
      grf::AreaLight{{-2.6F, 4.2F, 2.2F}, {0, 0, -1.6F}, {1.4F, 0.8F, 0}, grf::Colour(22, 21, 20)};
  scene.contents.blocks.push_back(std::move(light));
  return scene;
}

/// Assigns to all surfaces that reflect, in these blocks and those in them.
void assign(const grf::Surface& surface, grf::BlockList& list, std::string_view only) {
  const auto assign_to = [&](grf::Shared<grf::Mesh>& mesh) {
    if (!only.empty() && mesh->name != only) return;
    for (grf::Surface& each : mesh.edit().surfaces) {
      if (each.emission) continue;
      each.brdf = surface.brdf;
      each.pdf = surface.pdf;
    }
  };
  for (grf::Block& block : list.blocks) {
    if (auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&block.content)) assign_to(*mesh);
    if (auto* transform = std::get_if<grf::Transform>(&block.content)) assign(surface, transform->body, only);
    if (auto* scope = std::get_if<grf::DefinitionScope>(&block.content)) {
      for (grf::Definition& definition : scope->definitions) {
        if (auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body)) assign_to(*mesh);
      }
      assign(surface, scope->body, only);
    }
  }
}

}  // namespace

reflectance::ModelTable<MiniRenderSettings> MiniRenderSettings::table() {
  using Self = MiniRenderSettings;
  using grf::ParameterScale;
  return {
      .keyword = "minibpt",
      .title = "Mini bpt",
      .parameters = {number_parameter(&Self::viewer_x, "viewer_x", -Any, Any, "x of the eye (BPT_Viewer)"),
                     number_parameter(&Self::viewer_y, "viewer_y", -Any, Any, "y of the eye, upwards"),
                     number_parameter(&Self::viewer_z, "viewer_z", -Any, Any, "z of the eye"),
                     number_parameter(&Self::vlook_x, "vlook_x", -Any, Any,
                                      "x of the point looked at (BPT_VLook)"),
                     number_parameter(&Self::vlook_y, "vlook_y", -Any, Any, "y of the point looked at"),
                     number_parameter(&Self::vlook_z, "vlook_z", -Any, Any, "z of the point looked at"),
                     word_parameter(&Self::shape, "shape", {"sphere", "plane", "jug", "dragon", "knot"},
                                    "the shape on the floor, unless a scene is open"),
                     boolean_parameter(&Self::replace, "replace",
                                       "BRDF A replaces those of all faces of the open scene"),
                     word_parameter(&Self::compare, "compare", {"nothing", "brdfs", "schemes"},
                                    "what B has instead of A beside it, in equal time"),
                     number_parameter(&Self::samples, "samples", 1, 65536, "samples per pixel (BPT_Samples)",
                                      ParameterScale::Logarithmic),
                     number_parameter(&Self::width, "width", 32, 4096, "width of the image in pixels",
                                      ParameterScale::Logarithmic),
                     number_parameter(&Self::depth, "depth", 1, 100, "the most bounces of a path (BPT_Depth)",
                                      ParameterScale::Logarithmic),
                     number_parameter(&Self::seed, "seed", 0, 1e6F, "seed of the random numbers")},
      .description =
          "Renders a BRDF on a shape, or a scene with its options and environment map, and compares two "
          "BRDFs or sampling schemes in equal time."};
}

std::optional<MiniScene> mini_scene(const ToolState& state, const MiniRenderSettings& settings,
                                    grf::Diagnostics& diagnostics) {
  const MiniFiles files = files_of(state, diagnostics);
  MiniScene result;
  if (!files.options.path.empty()) {
    auto options = options::read_op_file(files.options.path, diagnostics);
    if (!options) return std::nullopt;
    result.options = std::move(*options);
  } else if (files.scene.path.empty()) {
    result.options.background = grf::Vec3f(0.16F, 0.18F, 0.22F);
    result.options.field_of_view = 34;
  }
  if (!files.environment.path.empty()) result.options.environment = files.environment.path;
  const std::string path = !files.scene.path.empty() ? files.scene.path : result.options.scene;
  result.is_opened = !path.empty();
  if (result.is_opened) {
    const auto scene = grf::read(path, diagnostics);
    if (!scene) return std::nullopt;
    result.scene = grf::with_absolute_names(*scene, path);
  } else {
    result.scene = built_in_scene(settings.shape, !result.options.environment.empty());
  }
  // The terms of a `combine` are in scope everywhere.
  if (!state.definitions.empty()) {
    grf::DefinitionScope scope{state.definitions, std::move(result.scene.contents)};
    result.scene.contents = {};
    result.scene.contents.blocks.push_back({std::move(scope), {}, {}});
  }
  return diagnostics.has_errors() ? std::nullopt : std::optional(std::move(result));
}

void assign(const grf::BrdfModel& brdf, const grf::PdfModel& pdf, MiniScene& scene) {
  grf::Surface surface;
  surface.brdf = brdf;
  surface.pdf = pdf;
  assign(surface, scene.scene.contents, scene.is_opened ? "" : "shape");
}

void adopt_options(ToolState& state, grf::Diagnostics& diagnostics) {
  MiniFiles files = files_of(state, diagnostics);
  std::error_code error;
  const std::string beside = std::filesystem::path(files.scene.path).replace_extension(".op").string();
  if (files.options.path.empty() && !files.scene.path.empty() && std::filesystem::exists(beside, error)) {
    files.options = {beside, {}};
    state.files.push_back(files.options);
  }
  if (files.options.path.empty()) return;
  const auto options = options::read_op_file(files.options.path, diagnostics);
  if (!options) return;
  set_number(state.settings, "width", static_cast<float>(options->size.width));
  set_number(state.settings, "depth", static_cast<float>(options->depth));
  const auto set_point = [&](const std::optional<grf::Vec3f>& point,
                             const std::array<const char*, 3>& names) {
    for (std::size_t i = 0; point && i < names.size(); ++i)
      set_number(state.settings, names[i], (*point)[static_cast<int>(i)]);
  };
  set_point(options->eye, {"viewer_x", "viewer_y", "viewer_z"});
  set_point(options->target, {"vlook_x", "vlook_y", "vlook_z"});
}

}  // namespace studies
