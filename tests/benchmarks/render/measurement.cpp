#include "tests/benchmarks/render/measurement.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "renderer/image/image_error.h"
#include "tests/benchmarks/render/pictures.h"

namespace benchmark {
namespace {

namespace fs = std::filesystem;
using grf::Colour;
using image::Image;

constexpr int ReferenceFactor = 64;
constexpr std::uint32_t ReferenceSeed = 1000;

/// Hashes the contents of files (FNV-1a), so that a changed scene is not compared with its old reference.
std::uint64_t fingerprint(const fs::path& folder) {
  std::vector<fs::path> files(fs::directory_iterator(folder), {});
  std::sort(files.begin(), files.end());
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const fs::path& path : files) {
    std::ifstream file(path, std::ios::binary);
    for (std::istreambuf_iterator<char> byte(file), end; byte != end; ++byte) {
      sum = (sum ^ static_cast<unsigned char>(*byte)) * 0x100000001b3;
    }
  }
  return sum;
}

image::ImageError error_of_file(const fs::path& path, const Image& reference) {
  const Image image = read_picture(path);
  if (image.width != reference.width || image.height != reference.height) {
    throw std::runtime_error(path.string() + " differs in size from its reference");
  }
  const image::ImageError error = image::error_of(image, reference);
  if (error.nan_pixels > 0) throw std::runtime_error(path.string() + " has pixels that are not finite");
  return error;
}

class SceneMeasurement {
 public:
  SceneMeasurement(const SceneFiles& scene, const Settings& settings,
                   const std::function<void(const std::string&)>& say)
      : scene_(scene), settings_(settings), say_(say), fingerprint_(fingerprint(scene.op.parent_path())) {
    fs::create_directories(settings.folder);
    for (const Renderer renderer : settings.renderers) {
      if (renderer == Renderer::Cycles && !scene.is_in_cycles) continue;
      references_.push_back(reference(renderer));
      Measurement measurement;
      measurement.scene = scene.name;
      measurement.renderer = renderer;
      measurement.mean = mean_of(references_.back());
      measurements_.push_back(measurement);
    }
    write_side_by_side(references_, settings.folder / (scene.name + ".png"));
  }

  std::vector<Measurement> run() {
    for (int round = 0; round < settings_.rounds; ++round) {
      for (std::size_t i = 0; i < measurements_.size(); ++i) measure_round(round, i);
    }
    for (Measurement& measurement : measurements_) {
      measurement.relmse /= settings_.rounds;
      measurement.paths_per_second =
          static_cast<double>(settings_.size) * settings_.size * settings_.samples / measurement.seconds;
      if (settings_.measures_embree) measure_embree(measurement);
    }
    return measurements_;
  }

 private:
  static Colour mean_of(const Image& image) {
    Imath::V3d sum(0);
    for (const Colour& pixel : image.pixels) sum += Imath::V3d(pixel);
    return Colour(sum / static_cast<double>(image.pixels.size()));
  }

  Job job(Renderer renderer) const {
    Job job;
    job.op = scene_.op;
    job.image = settings_.folder / fmt::format("{}-{}.exr", scene_.name, name_of(renderer));
    job.size = settings_.size;
    job.samples = settings_.samples;
    job.threads = settings_.threads;
    return job;
  }

  Image reference(Renderer renderer) const {
    Job reference = job(renderer);
    reference.samples *= ReferenceFactor;
    reference.seed = ReferenceSeed;
    const fs::path kept =
        settings_.folder / fmt::format("{}-{}-reference-{}-{}-{:016x}.exr", scene_.name, name_of(renderer),
                                       settings_.size, reference.samples, fingerprint_);
    if (settings_.fresh || !fs::exists(kept)) {
      say_(fmt::format("{}: reference by {}", scene_.name, name_of(renderer)));
      render(renderer, reference);
      fs::rename(reference.image, kept);
    }
    return read_picture(kept);
  }

  void measure_round(int round, std::size_t index) {
    Measurement& measurement = measurements_[index];
    Job timed = job(measurement.renderer);
    timed.seed = static_cast<std::uint32_t>(round) + 1;
    const Outcome outcome = render(measurement.renderer, timed);
    const image::ImageError error = error_of_file(timed.image, references_[index]);
    say_(fmt::format("{}: round {}, {}: {:.2f} s, relMSE {:.3g}", scene_.name, round + 1,
                     name_of(measurement.renderer), outcome.seconds, error.relmse));
    measurement.relmse += error.relmse;
    measurement.fireflies += error.fireflies;
    if (round == 0 || outcome.seconds < measurement.seconds) {
      measurement.seconds = outcome.seconds;
      if (outcome.rays) measurement.rays_per_second = *outcome.rays / outcome.seconds;
    }
    measurement.peak_memory_bytes = std::max(measurement.peak_memory_bytes, outcome.peak_memory_bytes);
  }

  void measure_embree(Measurement& measurement) const {
    Job metered = job(measurement.renderer);
    metered.measures_embree = true;
    const Outcome outcome = render(measurement.renderer, metered);
    measurement.embree_share = outcome.embree->share;
    if (!measurement.rays_per_second) {
      measurement.rays_per_second = outcome.embree->queries / measurement.seconds;
    }
    if (measurement.renderer == Renderer::Bpt) record_rays(measurement);
  }

  void record_rays(Measurement& measurement) const {
    Job recorded = job(measurement.renderer);
    recorded.records_rays = true;
    const Outcome outcome = render(measurement.renderer, recorded);
    measurement.ray_kinds = outcome.ray_kinds;
    measurement.counted_rays = outcome.rays;
  }

  const SceneFiles& scene_;
  const Settings& settings_;
  const std::function<void(const std::string&)>& say_;
  std::uint64_t fingerprint_;
  std::vector<Image> references_;
  std::vector<Measurement> measurements_;
};

}  // namespace

std::vector<Measurement> measure(const SceneFiles& scene, const Settings& settings,
                                 const std::function<void(const std::string&)>& say) {
  return SceneMeasurement(scene, settings, say).run();
}

}  // namespace benchmark
