#include "renderer/job/noise_advice.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace job {
namespace {

using grf::Diagnostics;
using options::RenderOptions;
using transport::NoiseRatios;
using transport::NoiseShare;

constexpr int MostNoiseWidth = 192;
constexpr int MostNoiseSamples = 16;
constexpr int Images = 8;
constexpr int TimedImages = 2;  // every second image
/// Samples that show adaptive sampling, which begins after its pilot.
constexpr int AdaptiveSamples = 64;
/// The share of the noise from which another scheme of a BRDF is worth trying, and that is worth a sentence.
constexpr double WorthTrying = 0.1;
constexpr double WorthSaying = 0.2;
constexpr std::size_t MostBrdfs = 3;

/// The options with an image of at most this width.
RenderOptions small(RenderOptions render_options, int most_width) {
  options::ImageSize& size = render_options.size;
  if (size.width > most_width) {
    size.height = std::max(1, size.height * most_width / size.width);
    size.width = most_width;
  }
  return render_options;
}

NoisePart lamp_part(const transport::CompiledScene& scene, const NoiseShare& share) {
  const std::vector<transport::Lamp>& lamps = scene.geometry().lamps;
  if (share.index >= lamps.size()) {
    return {NoisePart::Kind::Surroundings, "environment and background", share, {}, {}};
  }
  const transport::Lamp& lamp = lamps[share.index];
  std::string name = lamp.name.empty() ? "lamp" : fmt::format("lamp '{}'", lamp.name);
  if (lamp.location.line > 0) name += fmt::format(", line {}", lamp.location.line);
  return {NoisePart::Kind::Lamp, std::move(name), share, lamp, {}};
}

NoisePart bounce_part(const NoiseShare& share) {
  std::string name = share.index == 0   ? "light that the eye sees"
                     : share.index == 1 ? "direct light"
                                        : fmt::format("light of {} bounces", share.index);
  return {NoisePart::Kind::Bounces, std::move(name), share, {}, {}};
}

NoisePart brdf_part(const transport::CompiledScene& scene, const NoiseShare& share) {
  if (share.index >= scene.tables().size()) {
    return {NoisePart::Kind::SeenLight, "none: the eye sees the light", share, {}, {}};
  }
  const transport::TableInfo& table = scene.tables()[share.index];
  std::string name =
      table.scheme.empty() ? table.brdf : fmt::format("{}, sampled by {}", table.brdf, table.scheme);
  return {NoisePart::Kind::Brdf, std::move(name), share, {}, table};
}

/// The words of an option's value: one, or two with a space between them.
std::vector<std::string> words_of(const std::string& value) {
  const std::size_t space = value.find(' ');
  if (space == std::string::npos) return {value};
  return {value.substr(0, space), value.substr(space + 1)};
}

/// The changes of one option to other words than its present one.
void add_options(const RenderOptions& render_options, std::string_view key,
                 const std::vector<std::string>& values, std::vector<NoiseChange>& changes) {
  const options::OptionInfo& option = *options::find_option(key);
  const auto words = options::option_words(render_options, option);
  const std::string before = words.empty() ? "none" : fmt::format("{}", fmt::join(words, " "));
  for (const std::string& value : values) {
    RenderOptions other = render_options;
    if (options::set_option(other, option, words_of(value)) || other == render_options) continue;
    changes.push_back({std::string(key), value, before, {}, 0});
  }
}

void add_schemes(const RenderOptions& render_options, const NoiseReport& report,
                 std::vector<NoiseChange>& changes) {
  if (!render_options.scheme.empty()) {
    return add_options(render_options, "BPT_Pdf_Name", {"Auto", "Adaptive", "Own"}, changes);
  }
  std::size_t brdfs = 0;
  for (const NoisePart& part : report.brdfs) {
    if (part.kind != NoisePart::Kind::Brdf || part.share.noise < WorthTrying || brdfs++ == MostBrdfs)
      continue;
    for (const char* scheme : {"auto", "adaptive", "own"}) {
      const std::string& before = part.tables.scheme;
      if (before.substr(0, before.find(' ')) == scheme) continue;
      changes.push_back({{}, scheme, before, part.tables.brdf, part.share.index});
    }
  }
}

/// Prepares the renders of the images that are measured.
std::optional<RenderJob> measurement(const RenderOptions& render_options, int samples,
                                     const std::optional<transport::SchemeOverride>& scheme,
                                     Diagnostics& diagnostics) {
  auto made = render_job(render_options, diagnostics, scheme);
  if (!made) return std::nullopt;
  made->settings.samples = samples;
  made->settings.target_error.reset();
  made->settings.max_seconds.reset();
  return made;
}

/// The options after a change of an option.
RenderOptions changed(RenderOptions render_options, const NoiseChange& change) {
  if (change.option.empty()) return render_options;
  const options::OptionInfo& option = *options::find_option(change.option);
  options::set_option(render_options, option, words_of(change.value));
  return render_options;
}

/// The scheme of faces that a change of a scheme sets.
std::optional<transport::SchemeOverride> scheme_of(const NoiseChange& change) {
  if (!change.option.empty()) return std::nullopt;
  transport::SchemeOverride scheme;
  scheme.model.keyword = change.value;
  scheme.brdf = change.brdf;
  scheme.scheme = change.before;
  return scheme;
}

std::string percent(double fraction) { return fmt::format("{:.0f} %", 100 * fraction); }

}  // namespace

std::string NoiseChange::word() const {
  return option.empty() ? fmt::format("brdf{}={}", reflector, value) : option + "=" + value;
}

std::optional<NoiseReport> noise_report(const RenderOptions& render_options, const std::atomic<bool>& stopped,
                                        Diagnostics& diagnostics) {
  const auto made = render_job(small(render_options, MostNoiseWidth), diagnostics);
  if (!made) return std::nullopt;
  const transport::RenderSettings& settings = made->settings;
  if (settings.integrator.integrator != transport::Integrator::Path) {
    diagnostics.error({}, "noise is shared out for the integrator `path` only");
    return std::nullopt;
  }
  const transport::NoiseSettings noise = {Images, std::min(settings.samples, MostNoiseSamples)};
  const auto shares = transport::noise_shares(made->scene, settings, noise, stopped);
  if (!shares) {
    if (!stopped) diagnostics.error({}, "the image has no noise");
    return std::nullopt;
  }
  NoiseReport report{settings.width, settings.height, shares->samples, shares->error, {}, {}, {}};
  for (const NoiseShare& share : shares->lamps) report.lamps.push_back(lamp_part(made->scene, share));
  for (const NoiseShare& share : shares->bounces) report.bounces.push_back(bounce_part(share));
  for (const NoiseShare& share : shares->reflectors) report.brdfs.push_back(brdf_part(made->scene, share));
  return report;
}

std::vector<NoiseChange> noise_changes(const RenderOptions& render_options, const NoiseReport& report) {
  std::vector<NoiseChange> changes;
  add_schemes(render_options, report, changes);
  // One bounce ends at the light, so that nothing is split.
  if (render_options.depth > 1) add_options(render_options, "BPT_Branches", {"1", "2", "4", "8"}, changes);
  add_options(render_options, "BPT_Points", {"sobol"}, changes);
  const bool has_noisy_map =
      !render_options.environment.empty() &&
      std::any_of(report.lamps.begin(), report.lamps.end(), [](const NoisePart& part) {
        return part.kind == NoisePart::Kind::Surroundings && part.share.noise >= WorthTrying;
      });
  if (has_noisy_map) add_options(render_options, "BPT_RIS", {"8 1"}, changes);
  if (!render_options.adaptive) add_options(render_options, "BPT_Adaptive", {"true"}, changes);
  return changes;
}

/// Measures the images before a change, once; null after an error, if `stopped` was set, or without noise.
const NoiseTrials::Before* NoiseTrials::before(const RenderOptions& base, int samples,
                                               const std::atomic<bool>& stopped, Diagnostics& diagnostics) {
  const auto known = before_.find(samples);
  if (known != before_.end()) return &known->second;
  auto made = measurement(base, samples, std::nullopt, diagnostics);
  if (!made) return nullptr;
  auto noise = transport::measure_noise(made->scene, made->settings, Images, stopped);
  if (!noise) {
    if (!stopped) diagnostics.error({}, "the image has no noise");
    return nullptr;
  }
  Before before{std::make_unique<RenderJob>(std::move(*made)), std::move(*noise)};
  return &before_.emplace(samples, std::move(before)).first->second;
}

std::optional<NoiseRatios> NoiseTrials::measured(const NoiseChange& change, const std::atomic<bool>& stopped,
                                                 Diagnostics& diagnostics) {
  const bool is_adaptive = change.option == "BPT_Adaptive";
  const RenderOptions base = small(render_options_, is_adaptive ? MostNoiseWidth / 2 : MostNoiseWidth);
  const int samples = is_adaptive ? AdaptiveSamples : std::min(base.samples_per_pixel(), MostNoiseSamples);
  const Before* now = before(base, samples, stopped, diagnostics);
  if (now == nullptr) return std::nullopt;
  const auto made = measurement(changed(base, change), samples, scheme_of(change), diagnostics);
  if (!made) return std::nullopt;
  // The times of images in turn: the machine's speed varies.
  transport::MeasuredNoise before = now->noise;
  before.seconds_of_images.clear();
  const auto time_before = [&](int image) {
    if (image % TimedImages != 0) return;
    before.seconds_of_images.push_back(
        transport::seconds_of_image(now->job->scene, now->job->settings, image));
  };
  auto after = transport::measure_noise(made->scene, made->settings, Images, stopped, time_before);
  if (!after) {
    if (!stopped) diagnostics.error({}, "the image has no noise");
    return std::nullopt;
  }
  std::vector<double> seconds;
  for (std::size_t i = 0; i < after->seconds_of_images.size(); i += TimedImages) {
    seconds.push_back(after->seconds_of_images[i]);
  }
  after->seconds_of_images = std::move(seconds);
  return transport::ratios_of(before, *after);
}

std::optional<NoiseRatios> NoiseTrials::with(const NoiseChange& change, const std::atomic<bool>& stopped,
                                             Diagnostics& diagnostics) {
  Diagnostics messages;  // warnings about the scene are known from the report
  const auto ratios = measured(change, stopped, messages);
  if (ratios) return ratios;
  for (const grf::Diagnostic& entry : messages.entries()) {
    if (entry.severity == grf::Severity::Error) diagnostics.error(entry.location, entry.message);
  }
  return std::nullopt;
}

bool pays(const NoiseRatios& ratios) {
  constexpr double LeastGain = 0.05;
  return ratios.cost.high < 1 && ratios.cost.value < 1 - LeastGain;
}

std::vector<std::string> advice_of(const NoiseReport& report) {
  std::vector<std::string> sentences;
  for (const auto* parts : {&report.lamps, &report.bounces, &report.brdfs}) {
    if (parts->size() < 2 || parts->front().share.noise < WorthSaying) continue;
    const NoisePart& first = parts->front();
    const std::string subject = first.kind == NoisePart::Kind::Brdf   ? "Light reflected first by "
                                : first.kind == NoisePart::Kind::Lamp ? "The "
                                                                      : "";
    std::string name = subject + first.name;
    if (const std::size_t line = name.find(", line "); line != std::string::npos)
      name.replace(line, 1, " in");
    name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    sentences.push_back(fmt::format("{} makes {} of the noise and {} of the light.", name,
                                    percent(first.share.noise), percent(first.share.light)));
  }
  return sentences;
}

std::string advice_of(const NoiseChange& change, const NoiseRatios& ratios) {
  const std::string what =
      change.option.empty()
          ? fmt::format("'{}' sampled by '{}' instead of '{}'", change.brdf, change.value, change.before)
          : fmt::format("{} {} instead of {}", change.option, change.value, change.before);
  const std::string_view verdict = pays(ratios)          ? "it pays"
                                   : ratios.cost.low > 1 ? "it does not pay"
                                                         : "no clear difference";
  return fmt::format(
      "{}: {:.2f} of the variance in {:.2f} of the time, so the same error in {:.2f} ({:.2f} to "
      "{:.2f}) of the time: {}.",
      what, ratios.variance.value, ratios.time.value, ratios.cost.value, ratios.cost.low, ratios.cost.high,
      verdict);
}

}  // namespace job
