// Advice against noise: where an image's noise comes from, and what changes of settings do to it, measured.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grf/diagnostics.h"
#include "renderer/job/render_job.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/noise.h"
#include "renderer/transport/scene/compiled_scene.h"

namespace job {

/// A part of the light of an image.
struct NoisePart {
  enum class Kind { Lamp, Surroundings, Bounces, Brdf, SeenLight };
  Kind kind = Kind::Lamp;
  std::string name;  ///< as `lamp 'window', line 3`
  transport::NoiseShare share;
  transport::Lamp lamp;         ///< of a lamp
  transport::TableInfo tables;  ///< of a BRDF
};

/// Where the noise of an image comes from. Each list begins with the largest noise.
struct NoiseReport {
  int width = 0;
  int height = 0;
  int samples = 0;
  double error = 0;  ///< sqrt(relMSE)
  std::vector<NoisePart> lamps;
  std::vector<NoisePart> bounces;
  std::vector<NoisePart> brdfs;
};

/// Shares out the noise of an image of at most 192 pixels' width and 16 samples per pixel; see
/// transport::noise_shares. Empty after an error, or if `stopped` was set.
std::optional<NoiseReport> noise_report(const options::RenderOptions& render_options,
                                        const std::atomic<bool>& stopped, grf::Diagnostics& diagnostics);

/// A change of settings that may lower the noise: of a render option, or of the sampling scheme of the faces
/// that have one BRDF.
struct NoiseChange {
  std::string option;           ///< its key, such as `BPT_Branches`; empty for a scheme
  std::string value;            ///< the new word of the option, or keyword of the scheme
  std::string before;           ///< the present one; of a scheme, with its parameters
  std::string brdf;             ///< whose scheme it is, as written in the scene
  std::uint32_t reflector = 0;  ///< the share index of that BRDF

  /// A word for the command line: `BPT_Branches=4` or `brdf3=adaptive`.
  std::string word() const;
};

/// Lists changes that may help: other split counts, another sampling scheme of BRDFs that make a tenth of the
/// noise, or of all if the options name one, low-discrepancy points, resampling of the environment, and
/// adaptive sampling. Of the integrator `path` only.
std::vector<NoiseChange> noise_changes(const options::RenderOptions& render_options,
                                       const NoiseReport& report);

/// Measures what changes of some options do: eight images before, and as many after each, of the size and
/// the samples of the report; adaptive sampling, which begins at 32 samples, with 64 samples per pixel and
/// half that size.
class NoiseTrials {
 public:
  explicit NoiseTrials(options::RenderOptions render_options) : render_options_(std::move(render_options)) {}

  /// Returns nothing after an error, if `stopped` was set, or if there is no noise.
  std::optional<transport::NoiseRatios> with(const NoiseChange& change, const std::atomic<bool>& stopped,
                                             grf::Diagnostics& diagnostics);

 private:
  struct Before {
    std::unique_ptr<const RenderJob> job;
    transport::MeasuredNoise noise;
  };

  const Before* before(const options::RenderOptions& base, int samples, const std::atomic<bool>& stopped,
                       grf::Diagnostics& diagnostics);
  std::optional<transport::NoiseRatios> measured(const NoiseChange& change, const std::atomic<bool>& stopped,
                                                 grf::Diagnostics& diagnostics);

  options::RenderOptions render_options_;
  std::map<int, Before> before_;  ///< by samples per pixel
};

/// Whether a change pays: its cost is below 1 with 97.5 % confidence, and lower by 5 % at least.
bool pays(const transport::NoiseRatios& ratios);

/// Says which lamp, bounce and BRDF make most of the noise, if it is a fifth at least.
std::vector<std::string> advice_of(const NoiseReport& report);
/// Says what a change that was tried does.
std::string advice_of(const NoiseChange& change, const transport::NoiseRatios& ratios);

}  // namespace job
