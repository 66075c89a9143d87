#include "renderer/studies/mini/render.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "grf/read.h"
#include "grf/text_file.h"
#include "grf/wording.h"
#include "grf/write.h"
#include "renderer/image/encoders.h"
#include "renderer/job/preview_scene.h"
#include "renderer/studies/angles.h"
#include "renderer/studies/mini/scene.h"

namespace studies {
namespace {

using image::Image;
using plot::Anchor;

constexpr double Margin = 20;
constexpr double Top = 50;
constexpr double CaptionHeight = 64;
// The largest sizes of images in the figure.
constexpr double LargestHeight = 520;
constexpr double LargestWidth = 820;
constexpr double WidthOfTwo = 510;
constexpr auto RefineEvery = std::chrono::milliseconds(250);

/// One of the images of the study, so far.
struct MiniImage {
  std::string name;  ///< `A`, or empty if there is only one
  std::string brdf;
  std::string scheme;
  std::shared_ptr<const Image> image;
  double samples = 0;
  double seconds = 0;
  std::optional<double> error;
};

std::string caption_of(const MiniImage& image) {
  std::string text = fmt::format("{:.4g} samples per pixel, {:.3g} s", image.samples, image.seconds);
  if (image.error) {
    const double percent = 100 * *image.error;
    text += percent < 99.5 ? fmt::format(", estimated error {:.2g} %", percent)
                           : fmt::format(", estimated error {:.0f} %", percent);
  }
  return text;
}

/// The size of an image in the figure.
plot::Point shown_size(const Image& image, double largest_width) {
  const double aspect = static_cast<double>(image.width) / image.height;
  const double width = std::min(largest_width, LargestHeight * aspect);
  return {width, width / aspect};
}

void draw_image(const MiniImage& image, double x, const plot::Point& size, plot::Svg& svg) {
  svg.image({x, Top}, size.x, size.y, image::encode_png({*image.image}));
  double y = Top + size.y;
  const auto line = [&](const std::string& words, std::string_view colour) {
    y += 18;
    svg.text({x, y}, words, {plot::fitting_size(12, words, size.x), colour, Anchor::Start, 0});
  };
  line((image.name.empty() ? "" : image.name + ":  ") + image.brdf, "#111");
  line("sampled by " + image.scheme, "#333");
  line(caption_of(image), "#333");
}

plot::Svg figure_of(const std::vector<MiniImage>& images, const std::string& title,
                    const StudyContext& context) {
  const bool is_pair = !images.front().name.empty();
  const plot::Point size = shown_size(*images.front().image, is_pair ? WidthOfTwo : LargestWidth);
  const double width = is_pair ? 2 * size.x + 3 * Margin : size.x + 2 * Margin;
  plot::Svg svg(width, Top + size.y + CaptionHeight + Margin / 2, context.paper);
  svg.text({Margin, 30}, title,
           {plot::fitting_size(17, title, width - 2 * Margin), "#111", Anchor::Start, 0});
  double x = Margin;
  for (const MiniImage& image : images) {
    if (image.image) draw_image(image, x, size, svg);
    x += size.x + Margin;
  }
  return svg;
}

/// Renders, and reports an image a few times a second.
class Renderer {
 public:
  Renderer(const StudyContext& context, std::vector<MiniImage>& images, const std::function<void()>& refined)
      : context_(context), images_(images), refined_(refined) {}

  /// Renders to the last of the images; returns false if it was stopped.
  bool render(const transport::CompiledScene& scene, const transport::RenderSettings& settings) const {
    transport::RenderSettings first = settings;
    first.samples = 1;
    first.max_seconds.reset();
    if (settings.samples > 1 && context_.refined && !run(scene, first)) return false;
    return run(scene, settings);
  }

 private:
  bool run(const transport::CompiledScene& scene, const transport::RenderSettings& settings) const {
    transport::Render render(scene, settings);
    std::thread thread([&] { render.run(); });
    auto shown_at = std::chrono::steady_clock::now();
    while (render.end() == transport::RenderEnd::NotYet) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      if (context_.is_stopped && context_.is_stopped()) render.stop();
      if (!context_.refined || settings.samples == 1) continue;
      if (std::chrono::steady_clock::now() - shown_at < RefineEvery) continue;
      shown_at = std::chrono::steady_clock::now();
      take(render, render.progress().estimated_error);
      refined_();
    }
    thread.join();
    if (render.is_stopped()) return false;
    const auto estimate = render.error_estimate();
    take(render, estimate ? std::optional(estimate->error) : std::nullopt);
    if (context_.refined) refined_();
    return true;
  }

  void take(const transport::Render& render, const std::optional<double>& error) const {
    MiniImage& image = images_.back();
    image.image = std::make_shared<const Image>(render.snapshot().mean);
    image.samples = render.samples_per_pixel();
    image.seconds = render.seconds();
    image.error = error;
  }

  const StudyContext& context_;
  std::vector<MiniImage>& images_;
  const std::function<void()>& refined_;
};

std::string csv_of(const std::vector<MiniImage>& images) {
  std::string text = "image,brdf,scheme,samples,seconds,estimated_error\n";
  for (const MiniImage& image : images) {
    text += fmt::format("{},\"{}\",\"{}\",{:.6g},{:.6g},{}\n", image.name.empty() ? "A" : image.name,
                        image.brdf, image.scheme, image.samples, image.seconds,
                        image.error ? fmt::format("{:.6g}", *image.error) : "");
  }
  return text;
}

/// The text of an OP file with the options of the study, for a scene of this name.
std::string op_text(const options::RenderOptions& options, const std::string& scene,
                    const std::string& image) {
  const auto point = [](const grf::Vec3f& p) { return fmt::format("{} {} {}", p.x, p.y, p.z); };
  std::string text = fmt::format(
      "BPT_Scene             \"{}\"\nBPT_Output_Image      \"{}\"\nBPT_Image_Resolution  {} {}\n"
      "BPT_Viewer            {}\nBPT_VLook             {}\nBPT_Up                {}\nBPT_FieldOfView       "
      "{}\n"
      "BPT_Background        {}\nBPT_Depth             {}\nBPT_Samples           {}\nBPT_Seed              "
      "{}\n",
      scene, image, options.size.width, options.size.height, point(*options.eye), point(*options.target),
      point(options.up), options.field_of_view, point(options.background), options.depth,
      options.samples.value_or(1), options.seed);
  if (!options.environment.empty())
    text += fmt::format("BPT_EM_Background     \"{}\"\n", options.environment);
  return text;
}

std::vector<DataFile> data_files(const MiniScene& scene, const std::vector<MiniImage>& images) {
  std::vector<DataFile> files;
  const auto image = images.front().image;
  for (const image::ImageFormat& format : image::image_formats()) {
    files.push_back({std::string(format.extension), std::string(format.title),
                     [image](const std::string& path, grf::Diagnostics& diagnostics) {
                       return image::write_image({*image}, path, diagnostics);
                     }});
  }
  files.push_back(
      {"grf", "GRF scene", [scene = scene.scene](const std::string& path, grf::Diagnostics& diagnostics) {
         return grf::write(scene, path, diagnostics);
       }});
  files.push_back(
      {"op", "OP options", [options = scene.options](const std::string& path, grf::Diagnostics& diagnostics) {
         const std::string base = grf::file_name(path);
         const std::string name = base.substr(0, base.find_last_of('.'));
         return grf::replace_file(path, op_text(options, name + ".grf", name + ".exr"), diagnostics);
       }});
  return files;
}

/// Sets the options of the study on those of the scene.
void adapt(options::RenderOptions& options, const MiniRenderSettings& settings) {
  const auto whole = [](float number) { return static_cast<int>(std::lround(number)); };
  const double aspect = static_cast<double>(options.size.width) / options.size.height;
  options.size.width = whole(settings.width);
  options.size.height = std::max(1, static_cast<int>(std::lround(settings.width / aspect)));
  options.eye = grf::Vec3f(settings.viewer_x, settings.viewer_y, settings.viewer_z);
  options.target = grf::Vec3f(settings.vlook_x, settings.vlook_y, settings.vlook_z);
  options.samples = whole(settings.samples);
  options.depth = whole(settings.depth);
  options.seed = static_cast<std::uint32_t>(whole(settings.seed));
  options.target_error.reset();
  options.max_seconds.reset();
  options.adaptive = false;
}

/// The names of the BRDF and the scheme of an image.
MiniImage named_image(const ToolState& state, std::size_t brdf, std::size_t pdf, bool is_assigned) {
  MiniImage image;
  image.brdf = is_assigned ? grf::to_text(state.brdfs[brdf]) : "BRDFs of the scene";
  image.scheme = is_assigned ? grf::to_text(state.pdfs[pdf]) : "the scene's schemes";
  return image;
}

std::string title_of(const ToolState& state, const MiniRenderSettings& settings, const MiniScene& scene) {
  constexpr std::array<const char*, 5> Shapes = {"A sphere", "A plane", "A jug", "A dragon", "A knot"};
  if (scene.is_opened) return grf::file_name(state.files.front().path);
  const ToolState::File* model = model_of(state);
  const std::string shape =
      model != nullptr ? grf::file_name(model->path) : Shapes.at(static_cast<std::size_t>(settings.shape));
  return shape + " on a floor";
}

/// The compiled scenes of the images, which the window's next study uses again as far as possible.
class PreparedScenes {
 public:
  explicit PreparedScenes(StudyCache* cache) : cache_(cache) {}

  /// Prepares the scene of an image, by default from that of the last image: they share geometry.
  std::optional<transport::RenderSettings> prepare(const std::string& image, const MiniScene& scene,
                                                   grf::Diagnostics& diagnostics) {
    const std::string key = MiniRenderSettings::table().keyword.data() + (" " + image);
    if (const auto kept = cache_ != nullptr ? cache_->find<job::PreviewScene>(key) : nullptr)
      last_ = std::make_unique<job::PreviewScene>(*kept);
    auto settings = last_->prepare({scene.scene, "", scene.options, {}}, {}, diagnostics);
    if (settings && cache_ != nullptr)
      cache_->keep(key, std::make_shared<const job::PreviewScene>(*last_), compiled().bytes());
    return settings;
  }
  const transport::CompiledScene& compiled() const { return last_->compiled(); }

 private:
  StudyCache* cache_;  ///< may be null
  std::unique_ptr<job::PreviewScene> last_ = std::make_unique<job::PreviewScene>();
};

/// Renders one image of the study; returns false after an error, or if it was stopped.
bool render_image(const MiniScene& scene, const std::optional<double>& seconds, const Renderer& renderer,
                  const std::string& name, PreparedScenes& prepared, grf::Diagnostics& diagnostics) {
  auto settings = prepared.prepare(name, scene, diagnostics);
  if (!settings) return false;
  if (seconds) {
    settings->samples = transport::RenderSettings::Unlimited;
    settings->max_seconds = seconds;
  }
  return renderer.render(prepared.compiled(), *settings);
}

std::optional<Study> make_study(const ToolState& state, const StudyContext& context,
                                grf::Diagnostics& diagnostics) {
  const auto settings = reflectance::make<MiniRenderSettings>(state.settings);
  auto scene = mini_scene(state, settings, context, diagnostics);
  if (!scene) return std::nullopt;
  adapt(scene->options, settings);
  const bool is_assigned = !scene->is_opened || settings.replace;
  if (settings.compare != MiniRenderSettings::Nothing && !is_assigned) {
    diagnostics.error(state.settings.location,
                      "A and B are alike while the scene keeps its own BRDFs: set 'replace' to compare them");
    return std::nullopt;
  }
  std::vector<MiniImage> images;
  const std::string title = title_of(state, settings, *scene);
  const std::function<void()> refined = [&] {
    if (images.front().image) context.refined({figure_of(images, title, context), {}, {}, {}});
  };
  const Renderer renderer(context, images, refined);
  PreparedScenes prepared(context.cache.get());
  MiniScene first = *scene;
  if (is_assigned) assign(state.brdfs[0], state.pdfs[0], state.definitions, first);
  images.push_back(named_image(state, 0, 0, is_assigned));
  if (settings.compare != MiniRenderSettings::Nothing) images.back().name = "A";
  if (!render_image(first, {}, renderer, "A", prepared, diagnostics)) return std::nullopt;
  if (settings.compare != MiniRenderSettings::Nothing) {
    const std::size_t brdf = settings.compare == MiniRenderSettings::Brdfs ? 1 : 0;
    MiniScene second = *scene;
    assign(state.brdfs[brdf], state.pdfs[1 - brdf], state.definitions, second);
    const double seconds = images.front().seconds;
    images.push_back(named_image(state, brdf, 1 - brdf, true));
    images.back().name = "B";
    if (!render_image(second, seconds, renderer, "B", prepared, diagnostics)) return std::nullopt;
  }
  Study study{figure_of(images, title, context), {}, csv_of(images), {}};
  for (const MiniImage& image : images) {
    if (!study.summary.empty()) study.summary += "; ";
    study.summary += (image.name.empty() ? "" : image.name + ": ") + caption_of(image);
  }
  study.files = data_files(first, images);
  return study;
}

/// Turns the eye about the vertical axis through the point looked at, and up or down.
void turn(ToolState& state, double azimuth, double elevation) {
  const auto settings = reflectance::make<MiniRenderSettings>(state.settings);
  const grf::Vec3d target(settings.vlook_x, settings.vlook_y, settings.vlook_z);
  const grf::Vec3d away = grf::Vec3d(settings.viewer_x, settings.viewer_y, settings.viewer_z) - target;
  const double distance = away.length();
  if (!(distance > 0)) return;
  const double phi = std::atan2(away.x, away.z) + azimuth * Degree;
  const double theta = std::clamp(std::asin(std::clamp(away.y / distance, -1.0, 1.0)) + elevation * Degree,
                                  -89 * Degree, 89 * Degree);
  const grf::Vec3d eye = target + distance * grf::Vec3d(std::cos(theta) * std::sin(phi), std::sin(theta),
                                                        std::cos(theta) * std::cos(phi));
  set_value(state.settings, "viewer_x", static_cast<float>(eye.x));
  set_value(state.settings, "viewer_y", static_cast<float>(eye.y));
  set_value(state.settings, "viewer_z", static_cast<float>(eye.z));
}

grf::BrdfModel brdf_of(const char* text) {
  grf::Diagnostics diagnostics;
  return grf::read_brdf(text, "BRDF", diagnostics).value();
}

}  // namespace

StudyTool mini_render_tool() {
  StudyTool tool;
  tool.settings = reflectance::info_of<MiniRenderSettings>();
  tool.initial.settings.keyword = tool.settings.keyword;
  tool.initial.brdfs = {brdf_of("ward sx=0.15 sy=0.15 ks=0.4 kd=0.3"), brdf_of("phong n=40 ks=0.4 kd=0.3")};
  tool.initial.pdfs.resize(2);
  tool.initial.pdfs[0].keyword = "auto";
  tool.initial.pdfs[1].keyword = "diffuse";
  tool.brdfs = 2;
  tool.pdfs = 2;
  tool.files = "grf igrf op exr hdr pfm png jpg tga webp";
  tool.takes_many_files = true;
  tool.model = model_of;
  tool.turn = turn;
  tool.open = show_opened_files;
  tool.make = make_study;
  return tool;
}

}  // namespace studies
