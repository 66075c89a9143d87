#include "renderer/farm/stages.h"

#include <algorithm>

#include "renderer/transport/adaptive_sampling.h"
#include "renderer/transport/forecast.h"

namespace farm {
namespace {

using transport::AdaptiveSampling;
using transport::Film;
using transport::FilmTile;
using transport::RenderSettings;

constexpr int Pilot = AdaptiveSampling::PilotSamples;

bool is_complete(const RenderSettings& settings, int end, const Film& film) {
  if (end == settings.samples) return true;
  if (!settings.target_error) return false;
  const auto sampled = film.sampled_error();
  return sampled && transport::error_against_target(transport::with_bias(sampled->estimate, settings.bias)) <=
                        *settings.target_error;
}

/// Returns the sample counts of each tile at this many samples per pixel.
std::vector<FilmTile::Counts> counts_at(const RenderSettings& settings, int samples, const Film* film) {
  if (settings.is_adaptive() && samples > Pilot) return AdaptiveSampling(*film).counts(samples);
  return std::vector<FilmTile::Counts>(static_cast<std::size_t>(tile_count_of(settings)),
                                       transport::uniform_counts(samples));
}

}  // namespace

int tile_count_of(const RenderSettings& settings) {
  const auto tiles = [](int pixels) { return (pixels + Film::TileSize - 1) / Film::TileSize; };
  return tiles(settings.width) * tiles(settings.height);
}

std::optional<Stage> next_stage(const RenderSettings& settings, int end, const Film* film) {
  if (end > 0 && is_complete(settings, end, *film)) return std::nullopt;
  Stage stage;
  stage.end = transport::stage_end(settings, end > 0 ? end + 1 : 0);
  // A pilot has two halves, after the first of which only a target error is looked at.
  if (settings.is_adaptive() && end == 0 && !settings.target_error) {
    stage.end = std::min(Pilot, settings.samples);
  }
  stage.is_pilot = settings.is_adaptive() && stage.end == Pilot;
  stage.starts_over = stage.is_pilot && end > 0;
  const auto first = counts_at(settings, stage.starts_over ? 0 : end, film);
  const auto last = counts_at(settings, stage.end, film);
  for (std::size_t tile = 0; tile < first.size(); ++tile) {
    stage.samples.push_back(
        {first[tile], {std::max(first[tile][0], last[tile][0]), std::max(first[tile][1], last[tile][1])}});
  }
  return stage;
}

}  // namespace farm
