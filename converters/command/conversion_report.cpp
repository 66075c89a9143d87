#include "converters/command/conversion_report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "command_line/report_document.h"
#include "converters/embedded_files.h"
#include "converters/scene_building.h"
#include "converters/surface_comparison.h"
#include "grf/relocate.h"
#include "grf/text_file.h"
#include "grf/visit.h"
#include "renderer/image/image.h"
#include "renderer/image/image_error.h"
#include "renderer/image/image_file.h"
#include "renderer/job/camera_path.h"
#include "renderer/job/render_job.h"
#include "renderer/options/op_file.h"
#include "renderer/transport/render.h"

namespace convert {
namespace {

using command_line::ReportDocument;
using Row = ReportDocument::Row;
namespace fs = std::filesystem;

constexpr int PictureWidth = 160;
constexpr int SamplesPerPixel = 64;

/// A rendered image with its estimated error.
struct Rendered {
  image::Image image;
  std::optional<transport::ErrorEstimate> error;
};

/// Makes the pictures and the page.
class ReportWriter {
 public:
  ReportWriter(const ConversionReport& report, grf::Diagnostics& diagnostics)
      : report_(report), diagnostics_(diagnostics) {}

  /// Returns the paths of the page and its pictures.
  std::optional<std::vector<std::string>> write(const grf::Scene& scene);

 private:
  std::string picture(const std::string& what) const {
    fs::path path(report_.page);
    return path.replace_filename(path.stem().string() + "_" + what + ".png").string();
  }
  bool set_view(const grf::Scene& original);
  std::optional<grf::Scene> returned_scene(const ComparedScene& compared);
  std::optional<Rendered> render(grf::Scene scene, const std::string& what);
  bool write_picture(image::Image image, const std::string& what);
  void add_pictures(const Rendered& original, const Rendered& returned, bool is_mapped);
  void add_surfaces(const ComparedScene& compared);

  const ConversionReport& report_;
  grf::Diagnostics& diagnostics_;
  options::RenderOptions view_;
  ReportDocument document_;
  std::vector<std::string> paths_;
};

bool has_light(const grf::Scene& scene) {
  bool found = false;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement&, const grf::Block&) {
    found = found || std::any_of(mesh.surfaces.begin(), mesh.surfaces.end(),
                                 [](const grf::Surface& surface) { return surface.emission.has_value(); });
  };
  visitor.mesh_light = [&](const grf::MeshLight&, const grf::Placement&, const grf::Block&) { found = true; };
  visitor.light = [&](const grf::AreaLight&, const grf::Placement&, const grf::Block&) { found = true; };
  grf::visit(scene, visitor);
  return found;
}

// Both scenes have the view of the original, also where lamps that are lost change the bounds.
bool ReportWriter::set_view(const grf::Scene& original) {
  if (!report_.op_file.empty()) {
    const auto read = options::read_op_file(report_.op_file, diagnostics_);
    if (!read) return false;
    view_ = *read;
  }
  const transport::View framing = job::own_view(view_, bounds_of(original));
  view_.eye = grf::Vec3f(framing.eye);
  view_.target = grf::Vec3f(framing.target);
  const double aspect = double(view_.size.width) / double(view_.size.height);
  view_.size = {PictureWidth, std::max(1, static_cast<int>(std::lround(PictureWidth / aspect)))};
  const bool is_dark = view_.environment.empty() && view_.background == grf::Vec3f(0);
  if (is_dark && !has_light(original)) view_.background = grf::Vec3f(1);
  view_.samples = SamplesPerPixel;
  view_.scene = report_.output;
  view_.target_error.reset();
  view_.max_seconds.reset();
  view_.checkpoint.clear();
  view_.frames = 1;
  view_.shows_window = false;
  return true;
}

std::optional<grf::Scene> ReportWriter::returned_scene(const ComparedScene& compared) {
  if (compared.mapped) return compared.mapped;
  grf::Diagnostics ignored;  // what its reader reports of the file
  auto import = read(*report_.format, report_.output, {}, ignored);
  if (!import) {
    diagnostics_.error(grf::whole_file(report_.output),
                       "the written file cannot be read: " + ignored.to_text());
    return std::nullopt;
  }
  const std::string path = (fs::path(report_.folder) / "returned.grf").string();
  const auto files = write_embedded_files(import->files, path, diagnostics_);
  if (!files) return std::nullopt;
  grf::relocate(import->scene, report_.output, path, files->names);
  return grf::with_absolute_names(import->scene, path);
}

std::optional<Rendered> ReportWriter::render(grf::Scene scene, const std::string& what) {
  const auto job = job::render_job(std::move(scene), view_, diagnostics_);
  if (!job) return std::nullopt;
  transport::Render render(job->scene, job->settings);
  render.run();
  Rendered rendered = {render.film().mean(), render.error_estimate()};
  if (!write_picture(rendered.image, what)) return std::nullopt;
  return rendered;
}

bool ReportWriter::write_picture(image::Image image, const std::string& what) {
  image::ImageFile file{std::move(image)};
  file.image.alpha = {};
  file.exposure = view_.exposure;
  paths_.push_back(picture(what));
  return image::write_image(file, paths_.back(), diagnostics_);
}

image::Image difference_of(const image::Image& a, const image::Image& b) {
  image::Image difference = a;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    for (int k = 0; k < 3; ++k) difference.pixels[i][k] = std::abs(a.pixels[i][k] - b.pixels[i][k]);
  }
  return difference;
}

double mean_radiance(const image::Image& image) {
  double sum = 0;
  for (const grf::Colour& pixel : image.pixels) sum += double(pixel.x) + double(pixel.y) + double(pixel.z);
  return sum / 3 / double(std::max<std::size_t>(1, image.pixels.size()));
}

std::string percent(double fraction) { return fmt::format("{:.3g} %", 100 * fraction); }

void ReportWriter::add_pictures(const Rendered& original, const Rendered& returned, bool is_mapped) {
  document_.add_heading(2, "Pictures");
  document_.add_paragraph(
      is_mapped ? "The format is only written, so the second picture is not of its file: it is the original "
                  "scene with the BRDFs that the format has in place of its own."
                : "The second picture is of the written file, as it is read back.");
  document_.add_paragraph(fmt::format(
      "Both have {} x {} pixels, {} samples per pixel and the same random numbers. The third is the absolute "
      "difference, with the same exposure.",
      view_.size.width, view_.size.height, SamplesPerPixel));
  for (const auto& [what, title] :
       {std::pair("original", "The original"), std::pair("returned", "What comes back"),
        std::pair("difference", "The difference")}) {
    document_.add_picture(fs::path(picture(what)).filename().string(), title);
  }
  const auto error_text = [](const Rendered& one) {
    return one.error ? fmt::format("{} ({} to {})", percent(one.error->error), percent(one.error->low),
                                   percent(one.error->high))
                     : "not known";
  };
  const auto most_error = [](const Rendered& one) { return one.error ? one.error->high : 0; };
  const image::ImageError difference = image::error_of(returned.image, original.image);
  document_.add_table(
      {{"", "original", "what comes back"},
       {"mean radiance", fmt::format("{:.4g}", mean_radiance(original.image)),
        fmt::format("{:.4g}", mean_radiance(returned.image))},
       {"estimated error (95 % interval)", error_text(original), error_text(returned)},
       {"difference, sqrt(relMSE)", "", percent(std::sqrt(difference.relmse))},
       {"of noise alone, at most", "", percent(std::hypot(most_error(original), most_error(returned)))}});
}

void ReportWriter::add_surfaces(const ComparedScene& compared) {
  document_.add_heading(2, "Surfaces");
  document_.add_paragraph(
      "Albedos are means of the channels, of the original and of what comes back, by the angle of the view "
      "from the normal. The error of the lobe is the mean of the difference of both BRDFs times the cosine, "
      "over all directions of the light and those views, as a fraction of the original. Textures are not "
      "part "
      "of it.");
  std::vector<Row> rows = {{"surface", "faces", "what comes back"}};
  for (const double degrees : ComparedDegrees) rows[0].push_back(fmt::format("albedo at {}°", degrees));
  rows[0].insert(rows[0].end(), {"largest change", "error of the lobe"});
  for (const SurfaceComparison& one : compared.surfaces) {
    Row& row = rows.emplace_back(Row{one.original, std::to_string(one.faces),
                                     one.returned == one.original ? "the same" : one.returned});
    for (std::size_t i = 0; i < one.albedos.size(); ++i)
      row.push_back(fmt::format("{:.3f}, {:.3f}", one.albedos[i], one.returned_albedos[i]));
    row.push_back(fmt::format("{:.3f}", one.albedo_change()));
    row.push_back(one.lobe_error ? percent(*one.lobe_error) : "none: it is black");
  }
  document_.add_table(std::move(rows));
  if (compared.surfaces_left_out > 0)
    document_.add_paragraph(
        fmt::format("{} more surfaces, of fewer faces, are not listed.", compared.surfaces_left_out));
}

std::optional<std::vector<std::string>> ReportWriter::write(const grf::Scene& scene) {
  const grf::Scene whole = grf::with_absolute_names(scene, report_.output);
  const auto compared = compare_surfaces(whole, *report_.format, report_.folder, diagnostics_);
  if (!compared || !set_view(whole)) return std::nullopt;
  auto back = returned_scene(*compared);
  const auto original = back ? render(whole, "original") : std::nullopt;
  const auto returned = original ? render(*std::move(back), "returned") : std::nullopt;
  const bool has_pictures =
      returned && write_picture(difference_of(original->image, returned->image), "difference");
  if (!has_pictures) return std::nullopt;
  document_.add_heading(
      1, fmt::format("{} as {}", fs::path(report_.input).filename().string(), report_.format->title));
  document_.add_paragraph(
      fmt::format("The format keeps {}. It loses {}.", report_.format->keeps, report_.format->loses));
  if (!report_.losses.empty()) {
    std::vector<Row> rows = {{"lost of this scene"}};
    for (const std::string& loss : report_.losses) rows.push_back({loss});
    document_.add_table(std::move(rows));
  }
  add_pictures(*original, *returned, compared->mapped.has_value());
  add_surfaces(*compared);
  const bool is_html = image::has_extension(report_.page, "html");
  const std::string page = is_html ? document_.html() : document_.markdown();
  if (!grf::replace_file(report_.page, page, diagnostics_)) return std::nullopt;
  paths_.insert(paths_.begin(), report_.page);
  return paths_;
}

}  // namespace

bool is_report_page(const std::string& path) {
  return image::has_extension(path, "html") || image::has_extension(path, "md");
}

std::optional<std::vector<std::string>> write_report(const ConversionReport& report, const grf::Scene& scene,
                                                     grf::Diagnostics& diagnostics) {
  return ReportWriter(report, diagnostics).write(scene);
}

}  // namespace convert
