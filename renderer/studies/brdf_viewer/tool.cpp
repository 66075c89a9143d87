#include "renderer/studies/brdf_viewer/tool.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/srgb.h"
#include "grf/text_file.h"
#include "grf/wording.h"
#include "grf/write.h"
#include "renderer/image/encoders.h"
#include "renderer/plot/chart.h"
#include "renderer/reflectance/brdf_instance.h"
#include "renderer/reflectance/model.h"
#include "renderer/reflectance/scheme.h"
#include "renderer/studies/angles.h"

namespace studies {
namespace {

using plot::Anchor;
using plot::Point;
using plot::Rectangle;
using Settings = BrdfViewerSettings;

constexpr double Width = 1040;
constexpr double Height = 620;
constexpr Rectangle Place = {{20, 20}, 720, 580};
constexpr int Columns = static_cast<int>(Place.width);
constexpr int Rows = static_cast<int>(Place.height);
constexpr int MostPasses = 8;  // each is shifted by a part of a pixel, for antialiased edges

/// The shaded picture: the mean of the passes, and how much of each pixel the object covers.
struct Shaded {
  std::vector<Rgb> radiance;
  std::vector<float> cover;
  std::vector<SurfacePixel> pixels;  ///< at their centres
  int split = 0;                     ///< the first column of B
};

std::optional<grf::Scene> scene_of(const ToolState& state, const Settings& settings, const ViewerFiles& files,
                                   const StudyContext& context, grf::Diagnostics& diagnostics) {
  if (settings.shape != Settings::Model) return scene_of_shape(settings.shape);
  if (files.model == nullptr) {
    diagnostics.error(state.settings.location, "no model is open: open one, or name it as 'file NAME.grf'");
    return std::nullopt;
  }
  return read_model(*files.model, context, diagnostics);
}

/// Compiles what rays need of a scene, whose surfaces are all black.
std::optional<transport::CompiledScene> compiled(const grf::Scene& scene, grf::Diagnostics& diagnostics) {
  transport::CompileSettings settings;
  settings.effects.remove(transport::Effect::Textures);
  settings.reflecting = std::make_shared<const transport::ReflectingSurfaces>();
  return transport::compile(scene, diagnostics, settings);
}

std::optional<Lighting> lighting_of(const ToolState& state, const Settings& settings,
                                    const ViewerFiles& files, grf::Diagnostics& diagnostics) {
  Lighting lighting;
  lighting.lights = settings.lights();
  lighting.samples = settings.sample_count();
  lighting.environment = {static_cast<Environment::Kind>(settings.sky), settings.radiance,
                          static_cast<float>(settings.turned * Degree)};
  if (settings.sky != Settings::Map) return lighting;
  if (files.environment == nullptr) {
    diagnostics.error(state.settings.location,
                      "no environment map is open: open one, or name it as 'file NAME.exr'");
    return std::nullopt;
  }
  auto map =
      transport::read_environment_map(files.environment->path, diagnostics, files.environment->location);
  if (!map) return std::nullopt;
  lighting.environment.set_map(std::make_shared<const transport::EnvironmentMap>(*std::move(map)));
  return lighting;
}

/// Shades in passes, which share the samples of the environment.
Shaded shaded(const transport::CompiledScene& scene, const std::array<LitBrdf, 2>& brdfs,
              const Settings& settings, const Lighting& lighting, const StudyContext& context) {
  Shaded result;
  result.split = static_cast<int>(std::lround(settings.split * Columns));
  result.radiance.assign(static_cast<std::size_t>(Columns) * Rows, Rgb(0));
  result.cover.assign(result.radiance.size(), 0);
  const transport::View view = settings.view(scene.bounds(), Place.width / Place.height);
  const int count = std::max(4, lighting.samples / MostPasses / 4 * 4);
  const int passes = std::clamp(lighting.samples / count, 4, MostPasses);
  for (int pass = 0; pass < passes; ++pass) {
    const auto shift = [pass](double step) {
      return static_cast<float>(std::fmod(0.5 + step * pass, 1) - 0.5);
    };
    const auto pixels =
        surface_pixels(scene, view, Columns, Rows, {shift(0.7548776662), shift(0.5698402910)});
    const auto image = shade(pixels, Columns, 0, brdfs[0], brdfs[1], result.split, lighting, pass * count,
                             count, context.is_stopped);
    if (image.empty()) return result;
    for (std::size_t i = 0; i < image.size(); ++i) {
      result.radiance[i] += image[i] / static_cast<float>(passes);
      result.cover[i] += pixels[i].normal == Vec3f(0) ? 0 : 1 / static_cast<float>(passes);
    }
    if (pass == 0) result.pixels = pixels;
  }
  return result;
}

std::string png_of(const Shaded& shaded, const transport::View& view, const Settings& settings,
                   const Lighting& lighting, const Rgb& background) {
  image::ImageFile file;
  file.image = {Columns, Rows, shaded.radiance};
  file.exposure = settings.exposure;
  const transport::Camera camera(view, Columns, Rows);
  for (int row = 0; row < Rows; ++row) {
    for (int column = 0; column < Columns; ++column) {
      const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(Columns) +
                     static_cast<std::size_t>(column);
      const float free = 1 - shaded.cover[i];
      if (free <= 0) continue;
      // The paper is as bright at any exposure.
      const auto ray = camera.ray(static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F);
      file.image.pixels[i] += free * (settings.backdrop ? lighting.environment(ray.direction)
                                                        : background * std::exp2(-settings.exposure));
    }
  }
  return image::encode_png(file);
}

/// Writes a BRDF as lines of its model and its parameters, and returns the height below them.
double list_brdf(const grf::BrdfModel& model, std::string_view title, double y, plot::Svg& svg) {
  constexpr double X = 764;
  constexpr double Line = 17;
  svg.text({X, y}, title, {11, "#666", Anchor::Start, 0});
  const std::vector<grf::ModelInfo> infos = reflectance::brdf_infos();
  const grf::ModelInfo* info = grf::find_model(infos, model.keyword);
  y += Line + 3;
  svg.text({X, y}, info != nullptr ? fmt::format("{} ({})", info->title, info->keyword) : model.keyword,
           {14, "#111", Anchor::Start, 0});
  if (!model.data_file.empty()) {
    y += Line;
    svg.text({X, y}, grf::file_name(model.data_file), {12, "#333", Anchor::Start, 0});
  }
  for (const grf::Argument& argument : model.arguments) {
    grf::BrdfModel one;
    one.keyword = model.keyword;
    one.arguments = {argument};
    y += Line;
    svg.text({X, y}, grf::to_text(one).substr(model.keyword.size() + 1), {12, "#333", Anchor::Start, 0});
  }
  if (model.arguments.empty() && model.data_file.empty()) {
    y += Line;
    svg.text({X, y}, "default parameters", {12, "#666", Anchor::Start, 0});
  }
  return y + 1.6 * Line;
}

void list_settings(const Settings& settings, const ViewerFiles& files, double y, plot::Svg& svg) {
  const auto line = [&](std::string_view words, std::string_view colour) {
    svg.text({764, y}, words, {12, colour, Anchor::Start, 0});
    y += 17;
  };
  const auto rgb = [](const Rgb& value) {
    return value == Rgb(value.x) ? fmt::format("{:.3g}", value.x)
                                 : fmt::format("({:.3g}, {:.3g}, {:.3g})", value.x, value.y, value.z);
  };
  const auto light = [&](const Rgb& radiance, float azimuth, float elevation) {
    if (reflectance::is_black(radiance)) return;
    line(fmt::format("light of {} from {}, elevation {}", rgb(radiance), degrees_text(azimuth),
                     degrees_text(elevation)),
         "#333");
  };
  svg.text({764, y}, "Lights and environment", {11, "#666", Anchor::Start, 0});
  y += 19;
  light(settings.light1, settings.azimuth1, settings.elevation1);
  light(settings.light2, settings.azimuth2, settings.elevation2);
  light(settings.light3, settings.azimuth3, settings.elevation3);
  constexpr std::array<std::string_view, 4> Skies = {"no environment", "constant environment",
                                                     "studio environment", "environment "};
  std::string sky(Skies[static_cast<std::size_t>(settings.sky)]);
  if (settings.sky == Settings::Map && files.environment != nullptr)
    sky += grf::file_name(files.environment->path);
  line(sky, "#333");
  if (settings.sky == Settings::Black) return;
  line(fmt::format("radiance {}, turned by {}", rgb(settings.radiance), degrees_text(settings.turned)),
       "#333");
  line(fmt::format("diffuseness {:.3g}, specularity {:.3g}", settings.diffuseness, settings.specularity),
       "#333");
  line(fmt::format("{} directions per pixel", settings.sample_count()), "#333");
}

/// The radiance along the middle row of the picture.
std::string csv_of(const Shaded& shaded) {
  std::string text = "column,cos_eye,r,g,b\n";
  for (int column = 0; column < Columns; ++column) {
    const auto i = static_cast<std::size_t>(Rows / 2) * static_cast<std::size_t>(Columns) +
                   static_cast<std::size_t>(column);
    const SurfacePixel& pixel = shaded.pixels[i];
    if (pixel.normal == Vec3f(0)) continue;
    const Rgb& c = shaded.radiance[i];
    text += fmt::format("{},{},{},{},{}\n", column, pixel.normal.dot(pixel.to_eye), c.x, c.y, c.z);
  }
  return text;
}

std::string described(const Shaded& shaded, const Point& at) {
  const Point inside = at - Place.corner;
  if (inside.x < 0 || inside.y < 0 || inside.x >= Place.width || inside.y >= Place.height) return {};
  const auto i = static_cast<std::size_t>(inside.y) * static_cast<std::size_t>(Columns) +
                 static_cast<std::size_t>(inside.x);
  const SurfacePixel& pixel = shaded.pixels[i];
  if (pixel.normal == Vec3f(0)) return {};
  const Rgb& c = shaded.radiance[i];
  return fmt::format("BRDF {}: radiance ({:.4g}, {:.4g}, {:.4g}), viewed at \u03B8 = {:.4g}\u00B0",
                     static_cast<int>(inside.x) < shaded.split ? 'A' : 'B', c.x, c.y, c.z,
                     std::acos(std::clamp(pixel.normal.dot(pixel.to_eye), -1.0F, 1.0F)) / Degree);
}

void draw_split(int split, plot::Svg& svg) {
  if (split <= 0 || split >= Columns) return;
  const double x = Place.corner.x + split;
  svg.line({x, Place.corner.y}, {x, Place.corner.y + Place.height}, {"#888", 1, "4 3"});
  svg.text({x - 8, Place.corner.y + 16}, "A", {14, "#666", Anchor::End, 0});
  svg.text({x + 8, Place.corner.y + 16}, "B", {14, "#666", Anchor::Start, 0});
}

std::optional<Study> make_study(const ToolState& state, const StudyContext& context,
                                grf::Diagnostics& diagnostics) {
  const auto settings = reflectance::make<Settings>(state.settings);
  const auto files = files_of(state, diagnostics);
  if (!files) return std::nullopt;
  std::array<LitBrdf, 2> brdfs;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto brdf = reflectance::make_brdf(state.brdfs[i], diagnostics, state.definitions);
    if (!brdf) return std::nullopt;
    brdfs[i] = lit_brdf(*brdf, settings.diffuseness, settings.specularity);
  }
  const auto lighting = lighting_of(state, settings, *files, diagnostics);
  const auto authored = lighting ? scene_of(state, settings, *files, context, diagnostics) : std::nullopt;
  const auto scene = authored ? compiled(*authored, diagnostics) : std::nullopt;
  if (!scene) return std::nullopt;
  if (scene->triangle_count() == 0) {
    diagnostics.error(files->model != nullptr ? files->model->location : state.settings.location,
                      "the model has no faces to show");
    return std::nullopt;
  }
  auto picture = std::make_shared<Shaded>(shaded(*scene, brdfs, settings, *lighting, context));
  if (picture->pixels.empty()) return std::nullopt;
  plot::Svg svg(Width, Height, context.paper);
  const Rgb background = grf::srgb_decoded(svg.shaded(grf::Colour(1)));
  const transport::View view = settings.view(scene->bounds(), Place.width / Place.height);
  svg.image(Place.corner, Place.width, Place.height, png_of(*picture, view, settings, *lighting, background));
  draw_split(picture->split, svg);
  const bool has_a = picture->split > 0;
  const bool has_b = picture->split < Columns;
  double y = 36;
  if (has_a) y = list_brdf(state.brdfs[0], has_b ? "BRDF A, on the left" : "BRDF", y, svg);
  if (has_b) y = list_brdf(state.brdfs[1], has_a ? "BRDF B, on the right" : "BRDF B", y, svg);
  list_settings(settings, *files, y, svg);
  const std::string summary = fmt::format("{} on {}, {}", grf::to_text(state.brdfs[has_a ? 0 : 1]),
                                          grf::counted(scene->triangle_count(), "triangle", "triangles"),
                                          grf::counted(lighting->lights.size(), "light", "lights"));
  Study study{std::move(svg), summary, csv_of(*picture), {}};
  study.describe = [picture](const Point& point) { return described(*picture, point); };
  return study;
}

/// Shows the files that were opened last: a model instead of the shape, and a map as the environment.
void show_opened(ToolState& state, grf::Diagnostics&) {
  std::vector<ToolState::File> last;
  for (bool is_environment : {false, true}) {
    const auto found = std::ranges::find_if(state.files.rbegin(), state.files.rend(), [&](const auto& file) {
      return is_environment_map(file.path) == is_environment;
    });
    if (found == state.files.rend()) continue;
    if (is_environment) {
      set_value(state.settings, "sky", grf::Word{"map"});
    } else {
      set_value(state.settings, "shape", grf::Word{"model"});
    }
    last.push_back(*found);
  }
  state.files = last;
}

/// Returns the model that is shown instead of a shape.
const ToolState::File* model_of(const ToolState& state) {
  if (reflectance::make<Settings>(state.settings).shape != Settings::Model) return nullptr;
  const auto found = std::ranges::find_if(
      state.files, [](const ToolState::File& file) { return !is_environment_map(file.path); });
  return found != state.files.end() ? &*found : nullptr;
}

}  // namespace

StudyTool brdf_viewer_tool() {
  StudyTool tool;
  tool.settings = reflectance::info_of<Settings>();
  tool.initial.settings.keyword = tool.settings.keyword;
  for (const char* keyword : {"ward", "diffuse"}) {
    grf::BrdfModel model;
    model.keyword = keyword;
    tool.initial.brdfs.push_back(model);
  }
  tool.brdfs = 2;
  tool.files = "grf igrf exr hdr pfm";
  tool.takes_many_files = true;
  tool.azimuth = "azimuth";
  tool.elevation = "elevation";
  tool.animated = "azimuth";
  tool.model = model_of;
  tool.open = show_opened;
  tool.make = make_study;
  return tool;
}

}  // namespace studies
