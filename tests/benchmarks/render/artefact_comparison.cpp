// Renders scenes that are prone to artefacts with bpt, and with Blender's Cycles if it is installed: see
// tests/benchmarks/README.md.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "renderer/reflectance/geometry.h"
#include "tests/benchmarks/render/command_line.h"
#include "tests/benchmarks/render/pictures.h"
#include "tests/benchmarks/render/renderers.h"
#include "tests/benchmarks/render/scenes.h"

namespace {

namespace fs = std::filesystem;
using benchmark::Renderer;
using benchmark::SceneFiles;
using image::Image;

struct Arguments {
  fs::path folder = "build/benchmarks/render/artefacts";
  int size = 256;
  int samples = 256;
  int threads = 2;
};

Image render(const SceneFiles& scene, Renderer renderer, const Arguments& arguments) {
  benchmark::Job job;
  job.op = scene.op;
  job.image = arguments.folder / fmt::format("{}-{}.exr", scene.name, name_of(renderer));
  job.size = arguments.size;
  job.samples = arguments.samples;
  job.seed = 1;
  job.threads = arguments.threads;
  benchmark::render(renderer, job);
  return benchmark::read_picture(job.image);
}

float brightness(const Image& image, std::size_t pixel) { return reflectance::mean(image.pixels[pixel]); }

/// Pixels around the terminator in the scene `terminator`, away from the silhouette, which differs for a
/// coarse mesh. The picture shows 1.1 times the sphere, whose light is at +x.
std::vector<std::size_t> terminator_band(int size) {
  std::vector<std::size_t> band;
  const auto place = [&](int i) { return 1.1 * (2 * (i + 0.5) / size - 1); };
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if (place(x) < -0.4 || place(x) > 0.5 || std::hypot(place(x), place(y)) > 0.85) continue;
      band.push_back(static_cast<std::size_t>(y * size + x));
    }
  }
  return band;
}

/// The RMS difference in brightness within the band.
double root_mean_square(const Image& image, const Image& reference) {
  double sum = 0;
  const auto band = terminator_band(image.width);
  for (const std::size_t i : band) {
    const double difference = brightness(image, i) - brightness(reference, i);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(band.size()));
}

double brightest(const Image& image) {
  double most = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) most = std::max<double>(most, brightness(image, i));
  return most;
}

std::size_t count_pixels(const Image& image, const std::function<bool(std::size_t)>& function) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) count += function(i) ? 1 : 0;
  return count;
}

/// Counts lit pixels whose neighbourhood is unlit in the other image: the outlines of shadows may differ by a
/// pixel.
std::size_t lit_alone(const Image& image, const Image& other) {
  const auto is_dark_around = [&](std::size_t i) {
    const int x = static_cast<int>(i) % other.width;
    const int y = static_cast<int>(i) / other.width;
    for (int v = std::max(0, y - 1); v <= std::min(other.height - 1, y + 1); ++v) {
      for (int u = std::max(0, x - 1); u <= std::min(other.width - 1, x + 1); ++u) {
        if (reflectance::mean(other.at(u, v)) > 0) return false;
      }
    }
    return true;
  };
  return count_pixels(image, [&](std::size_t i) { return brightness(image, i) > 0 && is_dark_around(i); });
}

/// Reports on the images of each renderer; the first are bpt's.
void report(const std::vector<Renderer>& renderers, const std::vector<std::vector<Image>>& images) {
  fmt::print(
      "| renderer | terminator: RMS difference to the fine mesh | closed room: brightest pixel, "
      "lit pixels | contact: pixels lit only here |\n|---|--:|--:|--:|\n");
  for (std::size_t i = 0; i < renderers.size(); ++i) {
    const Image& room = images[i][2];
    const std::size_t lit = count_pixels(room, [&](std::size_t k) { return brightness(room, k) > 0; });
    const std::size_t other = renderers.size() - 1 - i;
    const std::string alone = other == i ? "" : std::to_string(lit_alone(images[i][3], images[other][3]));
    fmt::print("| {} | {:.4f} | {:.3g}, {} | {} |\n", name_of(renderers[i]),
               root_mean_square(images[i][0], images[i][1]), brightest(room), lit, alone);
  }
}

int run(const Arguments& arguments) {
  std::vector<Renderer> renderers = {Renderer::Bpt};
  if (const auto version = benchmark::blender_version()) {
    fmt::print("{}\n\n", *version);
    renderers.push_back(Renderer::Cycles);
  }
  const auto scenes = benchmark::make_artefact_scenes(arguments.folder / "scenes");
  std::vector<std::vector<Image>> images(renderers.size());
  for (const SceneFiles& scene : scenes) {
    std::vector<Image> row;
    for (std::size_t i = 0; i < renderers.size(); ++i) {
      row.push_back(render(scene, renderers[i], arguments));
      images[i].push_back(row.back());
    }
    benchmark::write_side_by_side(row, arguments.folder / (scene.name + ".png"));
  }
  report(renderers, images);
  return brightest(images[0][2]) == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares bpt with Cycles on scenes prone to artefacts; fails if light leaks into bpt's room");
  Arguments arguments;
  app.add_option("--folder", arguments.folder, "folder for scenes and images")->capture_default_str();
  app.add_option("--size", arguments.size, "width and height, pixels")->check(CLI::Range(8, 8192));
  app.add_option("--samples", arguments.samples, "samples per pixel")->check(CLI::Range(1, 1'000'000));
  app.add_option("--threads", arguments.threads)->check(CLI::Range(1, 1024));
  return benchmark::run_command_line(app, argc, argv, [&] { return run(arguments); });
}
