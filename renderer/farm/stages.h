// An image is rendered in stages: what is rendered in one follows from what was rendered before.
#pragma once

#include <optional>
#include <vector>

#include "renderer/transport/render.h"

namespace farm {

/// Samples of an image that can be rendered at the same time.
struct Stage {
  int end = 0;  ///< samples per pixel when it is done; of an adaptive image, their mean
  std::vector<transport::TileSamples> samples;  ///< by tile, in the order of Film
  /// Whether they are the pilot of an adaptive image, see transport::AdaptiveSampling: one process renders
  /// all of those of a tile.
  bool is_pilot = false;
  bool starts_over = false;  ///< whether they include those of all earlier stages
};

/// Returns the number of tiles of the film of an image.
int tile_count_of(const transport::RenderSettings& settings);

/// Returns the stage that follows a stage with this end, or the first one for 0, as `transport::Render` has
/// them. The film has the samples of the stages before, and is null for the first one. Empty if the image is
/// complete: it has its samples, or its target error.
std::optional<Stage> next_stage(const transport::RenderSettings& settings, int end,
                                const transport::Film* film);

}  // namespace farm
